#include "core/io/common/drawing_builder.hpp"
#include "core/io/common/tag_allocator.hpp"
#include "core/io/svg/svg.hpp"
#include "core/io/svg/svg_drawing.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace forefront {

namespace {

constexpr double kSameNode = 1e-6; ///< fraction of the drawing's size: the rounding error of relative path data

/// Closes a path that ends where it begins.
void joinEnds(SvgPath &path, double tolerance) {
    std::vector<Vec2> &nodes = path.nodes;
    while (nodes.size() > 1 && distance(nodes.front(), nodes.back()) <= tolerance) {
        path.closed = path.closed || nodes.size() > 3;
        nodes.pop_back();
        // The segment that led to the removed node now leads to the first one.
        path.stretches.resize(std::min(path.stretches.size(), nodes.size()));
    }
}

/// The role of an SVG path in the domain.
enum class Part : std::uint8_t { Painted, Outline, Line, Nothing };

class SvgBuilder {
  public:
    SvgBuilder(SvgPaths drawing, const SourceText &source)
        : source_(source), paths_(std::move(drawing.paths)), builder_(source) {
        for (SvgPath &path : paths_) {
            joinEnds(path, kSameNode * drawing.size);
        }
        anyPainted_ = std::any_of(paths_.begin(), paths_.end(), isPainted);
    }

    Result<Domain> run() {
        const std::uint32_t feature = builder_.addFeature(1);
        for (SvgPath &path : paths_) {
            const std::int32_t tag = path.nodes.size() < 2 ? 0 : tags_.of(path.name);
            builder_.from({path.offset});
            builder_.addCurves(path.curves, path.stretches);
            const Part part = partOf(path);
            noteReading(path, part);
            switch (part) {
            case Part::Painted:
                if (painted_ != path.element) {
                    painted_ = path.element;
                    contour_ = builder_.addContour(builder_.addShape(feature, path.name), path.paint.rule);
                }
                builder_.addRing(contour_, path.nodes, tag, path.stretches);
                if (path.paint.stroked && !path.closed) {
                    builder_.addChain(path.nodes, tag, path.stretches);
                }
                break;
            case Part::Outline:
                if (painted_ == kNone) { // all of them are one shape
                    painted_ = path.element;
                    contour_ = builder_.addContour(builder_.addShape(feature), FillRule::EvenOdd);
                }
                builder_.addRing(contour_, path.nodes, tag, path.stretches);
                break;
            case Part::Line:
                addLine(path, tag);
                break;
            case Part::Nothing:
                break;
            }
        }
        Result<Domain> domain = builder_.finish();
        if (domain) {
            domain->boundaryNames = tags_.names();
            domain->curveTolerance = source_.options.curveTolerance;
        }
        return domain;
    }

  private:
    static constexpr auto kNone = static_cast<std::size_t>(-1);

    /// Returns true if a path is painted. Lines are often drawn without fill="none".
    static bool isPainted(const SvgPath &path) {
        const bool drawnLine = path.isLine && !path.closed && !path.paint.fillGiven;
        return path.paint.filled && path.nodes.size() > 2 && !drawnLine;
    }

    /// Returns the role of a path. Filled shapes, if any, are the domain, and strokes are lines in it; otherwise closed
    /// strokes are outlines.
    Part partOf(const SvgPath &path) {
        if (path.nodes.size() < 2) {
            return Part::Nothing;
        }
        if (isPainted(path)) {
            return Part::Painted;
        }
        const bool loop = path.closed && path.nodes.size() > 2;
        if (!anyPainted_) {
            return loop ? Part::Outline : Part::Line;
        }
        return loop && !path.paint.stroked ? Part::Nothing : Part::Line;
    }

    /// Reports, once per element, how it is read if that differs from how it looks.
    void noteReading(const SvgPath &path, Part part) {
        const bool loop = path.closed && path.nodes.size() > 2;
        const bool first = std::exchange(noted_, path.element) != path.element;
        if (!first || path.nodes.size() < 2) {
            return;
        }
        if (part == Part::Outline) {
            source_.note("svg-outlines",
                         "nothing is filled: closed lines are outlines, and a closed line inside another is a hole",
                         path.offset);
        } else if (part == Part::Nothing) {
            source_.note("svg-unpainted",
                         "shapes with neither fill nor stroke are ignored, because other shapes have a fill or stroke",
                         path.offset);
        } else if (part == Part::Line && loop) {
            source_.note("svg-unfilled", "shapes without fill are read as lines, because other shapes are filled",
                         path.offset);
        }
        if (path.paint.stroked && part != Part::Nothing) {
            source_.note("svg-stroke", "stroke widths are ignored: shapes end at the middle of their stroke",
                         path.offset);
        }
    }

    void addLine(const SvgPath &path, std::int32_t tag) {
        std::vector<Vec2> nodes = path.nodes;
        if (path.closed && nodes.size() > 2) {
            nodes.push_back(nodes.front());
        }
        builder_.addChain(nodes, tag, path.stretches);
    }

    const SourceText &source_;
    std::vector<SvgPath> paths_;
    DrawingBuilder builder_;
    TagAllocator tags_;
    bool anyPainted_ = false;
    std::size_t painted_ = kNone; ///< the element of the last contour
    std::size_t noted_ = kNone;   ///< the element of the last path
    std::uint32_t contour_ = 0;
};

} // namespace

bool looksLikeSvg(std::string_view head) {
    return head.find("<svg") != std::string_view::npos;
}

Result<Domain> readSvg(const SourceText &source) {
    Result<SvgPaths> drawing = drawnPaths(source);
    if (!drawing) {
        return drawing.faults();
    }
    return SvgBuilder(std::move(*drawing), source).run();
}

} // namespace forefront
