#include "core/io/common/domain_builder.hpp"
#include "core/io/common/line_outline.hpp"
#include "core/io/svg/svg.hpp"
#include "core/io/svg/svg_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace forefront {

namespace {

constexpr double kSameNode = 1e-6; ///< of the drawing's size: what relative path data loses by rounding

/// Closes a path that ends where it begins.
void joinEnds(SvgPath &path, double tolerance) {
    std::vector<Vec2> &nodes = path.nodes;
    while (nodes.size() > 1 && distance(nodes.front(), nodes.back()) <= tolerance) {
        path.closed = path.closed || nodes.size() > 3;
        nodes.pop_back();
    }
}

/// Lets the ends of lines meet that differ by the rounding of relative path data or transforms.
void weldEnds(std::vector<SvgPath> &paths, double tolerance) {
    std::map<std::pair<double, double>, std::vector<Vec2>> ends; // by cells of that size
    const auto metBefore = [&](double column, double row, Vec2 end) -> const Vec2 * {
        for (const double i : {column - 1.0, column, column + 1.0}) {
            for (const double j : {row - 1.0, row, row + 1.0}) {
                const auto cell = ends.find({i, j});
                for (std::size_t k = 0; cell != ends.end() && k < cell->second.size(); ++k) {
                    if (distance(cell->second[k], end) <= tolerance) {
                        return &cell->second[k];
                    }
                }
            }
        }
        return nullptr;
    };
    for (SvgPath &path : paths) {
        for (Vec2 *const end : {&path.nodes.front(), &path.nodes.back()}) {
            const double column = std::floor(end->x / tolerance), row = std::floor(end->y / tolerance);
            if (const Vec2 *const met = metBefore(column, row, *end)) {
                *end = *met;
            } else {
                ends[{column, row}].push_back(*end);
            }
        }
    }
}

bool isLoop(const SvgPath &path) {
    return path.closed && path.nodes.size() > 2;
}

Domain domainOf(SvgPaths drawing, const SourceText &source) {
    std::vector<SvgPath> &paths = drawing.paths;
    const double tolerance = kSameNode * drawing.size;
    for (SvgPath &path : paths) {
        joinEnds(path, tolerance);
    }
    const bool anyLoop = std::any_of(paths.begin(), paths.end(), isLoop);
    if (!anyLoop) {
        weldEnds(paths, tolerance);
    }
    TagAllocator tags;
    DomainBuilder builder(source.origin);
    if (source.origin != nullptr) {
        source.origin->showsColumns = true;
    }
    for (const SvgPath &path : paths) {
        if (path.nodes.size() < 2) {
            continue;
        }
        const std::int32_t tag = tags.of(path.name);
        builder.from({path.offset});
        if (isLoop(path)) {
            builder.addLoop(path.nodes, tag, SegmentRole::Boundary);
        } else {
            builder.addChain(path.nodes, tag);
        }
    }
    Domain domain = builder.finish();
    if (const std::size_t segments = anyLoop ? 0 : boundByLines(domain); segments > 0) {
        source.note("lines-as-outline",
                    "the drawing has no closed path: its lines that form closed loops are the outline (" +
                        std::to_string(segments) + " segments)",
                    paths.front().offset);
    }
    domain.boundaryNames = tags.names();
    return domain;
}

} // namespace

bool looksLikeSvg(std::string_view head) {
    return head.find("<svg") != std::string_view::npos;
}

Result<Domain> readSvg(const SourceText &source) {
    Result<SvgPaths> drawing = drawnPaths(source);
    if (!drawing) {
        return drawing.faults();
    }
    return domainOf(std::move(*drawing), source);
}

} // namespace forefront
