#include "core/drawing_files/common/drawing_builder.hpp"
#include "core/drawing_files/dxf/dxf.hpp"
#include "core/drawing_files/dxf/dxf_drawing.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/tag_allocator.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace forefront {

namespace {

constexpr double kFineness = 2000.0;   ///< sizes of the drawing in the tolerance of chords
constexpr double kPathFineness = 50.0; ///< the same for the size of one path, which may be small
constexpr double kSameEnd = 1e-9;      ///< of the size: ends of a path this close to each other close it

/// A path as nodes along its curves.
struct Polyline {
    std::vector<Vec2> nodes;
    std::vector<CurveStretch> stretches;
};

class DxfReader {
  public:
    DxfReader(const DxfFile &file, const DxfPaths &drawn, const SourceText &source)
        : file_(file), drawn_(drawn), source_(source), builder_(source) {}

    Result<Domain> read() {
        if (Status fault = chooseLayers(); !fault.empty()) {
            return fault;
        }
        noteUnits();
        for (const Curve &curve : drawn_.curves) {
            const Box2 box = curve.bounds();
            box_.add(box.min);
            box_.add(box.max);
        }
        builder_.letLinesBound();
        shape_ = builder_.addShape(builder_.addFeature(1));
        for (const DxfPath &path : drawn_.paths) {
            if (chosen_[path.layer]) {
                add(path);
            }
        }
        if (!any_) {
            return Diagnostics{faultAt(source_, 0, "empty-domain", "the drawing has no lines or curves to read",
                                       "export outlines as lines, polylines, arcs or splines in the model space")};
        }
        Result<Domain> domain = builder_.finish();
        if (domain) {
            domain->boundaryNames = tags_.names();
            domain->curveTolerance = source_.options.curveTolerance;
        }
        return domain;
    }

  private:
    Status chooseLayers() {
        const std::optional<std::string> &wanted = source_.options.layer;
        std::set<std::string> names;
        for (std::size_t at = 0; wanted && at <= wanted->size();) {
            const std::size_t end = std::min(wanted->find(',', at), wanted->size());
            names.insert(lowerCase(cleanName(wanted->substr(at, end - at))));
            at = end + 1;
        }
        for (const std::string &layer : drawn_.layers) {
            const auto known = file_.layers.find(lowerCase(layer));
            const bool hidden = known != file_.layers.end() && (known->second.frozen || known->second.off);
            const bool chosen = wanted ? names.erase(lowerCase(layer)) > 0 : !hidden && lowerCase(layer) != "defpoints";
            chosen_.push_back(chosen);
            if (!chosen && !wanted) {
                source_.note("dxf-layers", "the layer " + inQuotes(layer) + " is left out: it is not shown or printed",
                             0);
            }
        }
        if (!names.empty()) {
            return {faultAt(source_, 0, "unknown-layer", "unknown layer " + inQuotes(*names.begin()),
                            "expected one of " + listed(drawn_.layers, 12))};
        }
        return {};
    }

    void noteUnits() const {
        constexpr const char *kUnits[] = {"", "inches", "feet", "miles", "millimetres", "centimetres", "metres"};
        if (file_.units >= 1 && file_.units <= 6) {
            source_.note("dxf-units", std::string("coordinates are ") + kUnits[file_.units] + " ($INSUNITS)",
                         file_.unitsOffset);
        }
    }

    void add(const DxfPath &path) {
        any_ = true;
        Polyline line = polylineOf(path);
        const double gap = distance(line.nodes.front(), line.nodes.back());
        const bool closed = path.closed || (line.nodes.size() > 3 && gap <= kSameEnd * box_.diagonal());
        if (closed && gap <= kSameEnd * box_.diagonal()) {
            line.nodes.pop_back();
        }
        const std::span curves = std::span(drawn_.curves).subspan(path.first, path.count);
        builder_.from({path.offset});
        builder_.addCurves(curves, line.stretches);
        const std::int32_t tag = tags_.of(drawn_.layers[path.layer]);
        if (closed && line.nodes.size() > 2) {
            if (!contour_) { // one for all, for the even-odd rule
                contour_ = builder_.addContour(shape_, FillRule::EvenOdd);
            }
            builder_.addRing(*contour_, line.nodes, tag, line.stretches);
        } else {
            builder_.addChain(line.nodes, tag, line.stretches);
        }
    }

    Polyline polylineOf(const DxfPath &path) const {
        Box2 box;
        for (std::size_t k = path.first; k < path.first + path.count; ++k) {
            const Box2 bounds = drawn_.curves[k].bounds();
            box.add(bounds.min);
            box.add(bounds.max);
        }
        const double wanted = source_.options.curveTolerance;
        const double tolerance =
            wanted > 0.0 ? wanted : std::min(box_.diagonal() / kFineness, box.diagonal() / kPathFineness);
        Polyline line;
        line.nodes.push_back(drawn_.curves[path.first].point(0.0));
        for (std::size_t k = 0; k < path.count; ++k) {
            const Curve &curve = drawn_.curves[path.first + k];
            if (curve.kind() == CurveKind::Line) {
                line.nodes.push_back(curve.point(1.0));
                line.stretches.emplace_back();
                continue;
            }
            double from = 0.0;
            for (const double to : curve.flatten(tolerance)) {
                line.nodes.push_back(curve.point(to));
                line.stretches.push_back({static_cast<std::uint32_t>(k), from, to});
                from = to;
            }
        }
        return line;
    }

    const DxfFile &file_;
    const DxfPaths &drawn_;
    const SourceText &source_;
    DrawingBuilder builder_;
    TagAllocator tags_;
    std::vector<bool> chosen_; ///< by layer
    std::uint32_t shape_ = 0;
    std::optional<std::uint32_t> contour_; ///< of all closed curves
    Box2 box_;
    bool any_ = false;
};

} // namespace

Result<Domain> readDxf(const SourceText &source) {
    const Result<DxfFile> file = readDxfFile(source);
    if (!file) {
        return file.faults();
    }
    const Result<DxfPaths> drawn = drawDxf(*file, source);
    return drawn ? DxfReader(*file, *drawn, source).read() : drawn.faults();
}

bool looksLikeDxf(std::string_view head) {
    constexpr std::string_view kBlanks = " \t\r\n";
    const auto word = [&] {
        head.remove_prefix(std::min(head.find_first_not_of(kBlanks), head.size()));
        const std::string_view found = head.substr(0, head.find_first_of(kBlanks));
        head.remove_prefix(found.size());
        return found;
    };
    std::string_view code = word();
    while (code == "999") { // a comment, which is the next line
        head.remove_prefix(std::min(head.find('\n'), head.size()));
        head.remove_prefix(head.empty() ? 0 : 1);
        head.remove_prefix(std::min(head.find('\n'), head.size()));
        code = word();
    }
    return code == "0" && word() == "SECTION";
}

} // namespace forefront
