#include "core/drawing_files/common/drawing_builder.hpp"
#include "core/drawing_files/dxf/dxf.hpp"
#include "core/drawing_files/dxf/dxf_drawing.hpp"
#include "core/engine/base/letter_case.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/repeated_loops.hpp"
#include "core/files/common/tag_allocator.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr double kFineness = 2000.0;   ///< sizes of the drawing in the tolerance of chords
constexpr double kPathFineness = 50.0; ///< the same for the size of one path, which may be small
constexpr double kSameLoop = 1e-7;     ///< of the size: loops whose nodes are this close repeat each other
constexpr double kSameEnd = 1e-9;      ///< of the size: ends of a path this close to each other close it

/// A path as nodes along its curves.
struct Polyline {
    const DxfPath *path = nullptr;
    bool closed = false; ///< its first node is not repeated at the end
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
        reportContents();
        std::vector<Polyline> lines;
        for (const DxfPath &path : drawn_.paths) {
            if (chosen_[path.layer]) {
                box_.add(boxOf(path));
            }
        }
        builder_.letLinesBound(tags_);
        shape_ = builder_.addShape(builder_.addFeature(1));
        for (const DxfPath &path : drawn_.paths) {
            if (chosen_[path.layer]) {
                lines.push_back(polylineOf(path));
            }
        }
        const std::vector<std::uint8_t> repeated = repeatedLoops(lines);
        noteRepeatedLines(lines);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (repeated[k] == 0) {
                add(lines[k]);
            }
        }
        if (lines.empty()) {
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
        std::map<std::string, std::string> names; // in lower case: as they were given
        for (std::size_t at = 0; wanted && at <= wanted->size();) {
            const std::size_t end = std::min(wanted->find(',', at), wanted->size());
            const std::string name = cleanName(wanted->substr(at, end - at));
            names.emplace(lowerCase(name), name);
            at = end + 1;
        }
        for (const std::string &layer : drawn_.layers) {
            const auto known = file_.layers.find(lowerCase(layer));
            const bool hidden = known != file_.layers.end() && (known->second.frozen || known->second.off);
            const bool dimensions = lowerCase(layer) == "defpoints"; // which programs never print
            const bool chosen = wanted ? names.erase(lowerCase(layer)) > 0 : !hidden && !dimensions;
            chosen_.push_back(chosen);
            if (!chosen && !wanted) {
                source_.note("dxf-layers",
                             "the layer " + inQuotes(layer) + " is left out: it " +
                                 (hidden ? "is frozen or switched off" : "belongs to dimensions"),
                             0);
            }
        }
        if (!names.empty()) {
            const auto &[lower, given] = *names.begin();
            const std::string problem = file_.layers.contains(lower)
                                            ? "the layer " + inQuotes(given) + " has no lines or curves to read"
                                            : "unknown layer " + inQuotes(given);
            return {faultAt(source_, 0, "unknown-layer", problem, "expected one of " + listed(drawn_.layers, 12))};
        }
        return {};
    }

    /// Returns the name of $INSUNITS; empty: none, or unknown.
    std::string unit() const {
        constexpr const char *kUnits[] = {"",
                                          "inches",
                                          "feet",
                                          "miles",
                                          "millimetres",
                                          "centimetres",
                                          "metres",
                                          "kilometres",
                                          "microinches",
                                          "mils",
                                          "yards",
                                          "angstroms",
                                          "nanometres",
                                          "micrometres",
                                          "decimetres",
                                          "decametres",
                                          "hectometres",
                                          "gigametres",
                                          "astronomical units",
                                          "light years",
                                          "parsecs",
                                          "US survey feet",
                                          "US survey inches",
                                          "US survey yards",
                                          "US survey miles"};
        return file_.units > 0 && file_.units < static_cast<int>(std::size(kUnits)) ? kUnits[file_.units] : "";
    }

    /// Returns the unit of a drawing in units that LengthUnit has.
    LengthUnit lengthUnit() const {
        constexpr LengthUnit kKnown[] = {LengthUnit::None,  LengthUnit::Inch,       LengthUnit::Foot,
                                         LengthUnit::None,  LengthUnit::Millimetre, LengthUnit::Centimetre,
                                         LengthUnit::Metre, LengthUnit::Kilometre};
        return file_.units > 0 && file_.units < static_cast<int>(std::size(kKnown)) ? kKnown[file_.units]
                                                                                    : LengthUnit::None;
    }

    void reportContents() const {
        source_.measured(lengthUnit());
        DrawingContents contents;
        contents.layers = drawn_.layers;
        contents.severalLayers = true;
        contents.unit = unit();
        for (std::size_t k = 0; k < chosen_.size(); ++k) {
            if (chosen_[k]) {
                contents.layer += (contents.layer.empty() ? "" : ",") + drawn_.layers[k];
            }
        }
        source_.reportContents(contents);
        if (!contents.unit.empty()) {
            source_.note("dxf-units", "the coordinates are " + contents.unit, file_.unitsOffset);
        } else if (file_.units != 0) {
            source_.note("dxf-units",
                         "the unit " + std::to_string(file_.units) + " of the coordinates ($INSUNITS) is not known",
                         file_.unitsOffset);
        }
    }

    Box2 boxOf(const DxfPath &path) const {
        Box2 box;
        for (const Curve &curve : curvesOf(path)) {
            box.add(curve.bounds());
        }
        return box;
    }

    std::span<const Curve> curvesOf(const DxfPath &path) const {
        return std::span(drawn_.curves).subspan(path.first, path.count);
    }

    /// Returns, per line, 1 for a closed one that repeats an earlier one, with which it would enclose nothing.
    std::vector<std::uint8_t> repeatedLoops(const std::vector<Polyline> &lines) const {
        std::vector<std::span<const Vec2>> loops;
        std::vector<std::size_t> places;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (lines[k].closed) {
                loops.emplace_back(lines[k].nodes);
                places.push_back(k);
            }
        }
        const std::vector<std::uint8_t> found = findRepeatedLoops(loops, kSameLoop * box_.diagonal());
        std::vector<std::uint8_t> repeated(lines.size(), 0);
        for (std::size_t k = 0; k < places.size(); ++k) {
            repeated[places[k]] = found[k];
            if (found[k] != 0) {
                source_.note("dxf-repeated", "closed curves drawn twice are used once", lines[places[k]].path->offset);
            }
        }
        return repeated;
    }

    /// Reports open lines that repeat an earlier one, from either end; joining merges them.
    void noteRepeatedLines(const std::vector<Polyline> &lines) const {
        const auto before = [](Vec2 a, Vec2 b) { return comesBefore(a, b); };
        const auto less = [&](const std::vector<Vec2> &one, const std::vector<Vec2> &other) {
            return std::lexicographical_compare(one.begin(), one.end(), other.begin(), other.end(), before);
        };
        std::set<std::vector<Vec2>, decltype(less)> known(less);
        for (const Polyline &line : lines) {
            std::vector<Vec2> nodes = line.nodes;
            if (!nodes.empty() && comesBefore(nodes.back(), nodes.front())) {
                std::reverse(nodes.begin(), nodes.end());
            }
            if (!line.closed && !known.insert(std::move(nodes)).second) {
                source_.note("dxf-repeated", "lines drawn twice are used once", line.path->offset);
            }
        }
    }

    void add(Polyline &line) {
        const DxfPath &path = *line.path;
        builder_.from({path.offset});
        builder_.addCurves(curvesOf(path), line.stretches);
        const std::int32_t tag = tags_.of(drawn_.layers[path.layer]);
        if (!line.closed) {
            builder_.addChain(line.nodes, tag, line.stretches);
            return;
        }
        if (!contour_) { // one for all, for the even-odd rule
            contour_ = builder_.addContour(shape_, FillRule::EvenOdd);
        }
        builder_.addRing(*contour_, line.nodes, tag, line.stretches);
    }

    Polyline polylineOf(const DxfPath &path) const {
        const double wanted = source_.options.curveTolerance;
        const double tolerance =
            wanted > 0.0 ? wanted : std::min(box_.diagonal() / kFineness, boxOf(path).diagonal() / kPathFineness);
        Polyline line{&path, false, {}, {}};
        const std::span<const Curve> curves = curvesOf(path);
        line.nodes.push_back(curves.front().point(0.0));
        for (std::size_t k = 0; k < curves.size(); ++k) {
            if (curves[k].kind() == CurveKind::Line || !(tolerance > 0.0)) {
                line.nodes.push_back(curves[k].point(1.0));
                line.stretches.emplace_back();
                continue;
            }
            double from = 0.0;
            for (const double to : curves[k].flatten(tolerance)) {
                line.nodes.push_back(curves[k].point(to));
                line.stretches.push_back({static_cast<std::uint32_t>(k), from, to});
                from = to;
            }
        }
        const bool meets = distance(line.nodes.front(), line.nodes.back()) <= kSameEnd * box_.diagonal();
        line.closed = path.closed || (meets && line.nodes.size() > 3);
        if (line.closed && meets) {
            line.nodes.pop_back();
        }
        line.closed = line.closed && line.nodes.size() > 2;
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
    Box2 box_;                             ///< of everything that is read
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
