#include "core/drawing/commands/transform.hpp"

#include "core/drawing/commands/fit_mapped.hpp"
#include "core/drawing/commands/stretch_arcs.hpp"
#include "core/drawing/constraints/map_constraints.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/shift_formulas.hpp"
#include "core/drawing/picking/selected_handles.hpp"
#include "core/drawing/shapes/groups.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/spec/source_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr double kMaxCopies = 10000.0;
constexpr std::size_t kMaxNewNodes = 1000000; ///< in all copies together

/// Maps a rectangle whose image is one. A quarter turn exchanges its sides: the first one runs along x.
void mapRectangle(Shape &shape, const PlaneMap &map) {
    if (!shape.segmentTags.empty()) {
        shape.segmentTags = segmentTagsOf(shape);
    }
    const std::vector<std::int32_t> tags = shape.segmentTags;
    shape.nodes = {map(shape.nodes[0]), map(shape.nodes[1])};
    shape.as<RectangleForm>().radius *= std::sqrt(std::fabs(map.determinant()));
    shape.cuts.clear();
    if (map.u.x == 0.0) {
        // The last side comes first; the arcs at the second and fourth corner change places, as these corners do.
        constexpr std::array<std::size_t, 8> kBefore{3, 2, 1, 0, 6, 5, 4, 7};
        for (std::size_t k = 0; k < shape.segmentTags.size(); ++k) {
            shape.segmentTags[k] = tags[kBefore[k]];
        }
        const std::map<std::uint32_t, SegmentSize> sizes = std::exchange(shape.segmentSizes, {});
        for (std::uint32_t k = 0; k < kBefore.size(); ++k) {
            if (const auto found = sizes.find(static_cast<std::uint32_t>(kBefore[k])); found != sizes.end()) {
                shape.segmentSizes.emplace(k, found->second);
            }
        }
        auto second = shape.nodeSizes.extract(1), fourth = shape.nodeSizes.extract(3);
        for (auto *const corner : {&second, &fourth}) {
            if (!corner->empty()) {
                corner->key() = 4 - corner->key();
                shape.nodeSizes.insert(std::move(*corner));
            }
        }
    }
}

void mapCircle(Shape &shape, const PlaneMap &map) {
    const Vec2 centre = shape.nodes[0], arm = shape.nodes[1] - centre;
    if (!map.isSimilarity()) {
        shape.form = EllipseForm{};
        shape.nodes.push_back(centre + leftNormal(arm));
    } else if (map.determinant() < 0.0) {
        shape.cuts.clear(); // it still runs counter-clockwise
    }
    std::transform(shape.nodes.begin(), shape.nodes.end(), shape.nodes.begin(), map);
}

Status checkMap(const PlaneMap &map) {
    if (!map.finite() || map.determinant() == 0.0) {
        return error("bad-number",
                     "invalid transformation: areas would be multiplied by " + numberText(map.determinant(), 6) +
                         "; expected a finite factor other than 0",
                     "enter finite numbers, and scale factors other than 0");
    }
    return {};
}

/// Checks that there is something to copy, and that a number being typed does not exhaust memory with copies.
Status checkCopies(const Document &document, const Selection &selection, std::size_t copies) {
    std::size_t nodes = selection.sources.size() + selection.markers.size();
    for (const auto &shape : document.shapes) {
        nodes += selection.shapes.contains(shape->id) ? handleCount(*shape) : 0;
    }
    if (nodes == 0) {
        return error("not-possible", "nothing that can be copied is selected",
                     "select whole shapes, size sources or region markers");
    }
    if (nodes > kMaxNewNodes / std::max<std::size_t>(copies, 1)) {
        return error("not-possible",
                     "the copies would have " + std::to_string(nodes * copies) + " nodes; expected at most " +
                         std::to_string(kMaxNewNodes),
                     "enter a smaller number, or select fewer shapes");
    }
    return {};
}

Status checkCount(double count) {
    if (!(count >= 2.0 && count <= kMaxCopies) || count != std::floor(count)) {
        return error("bad-number",
                     "invalid number of items " + numberText(count, 10) + "; expected a whole number from 2 to " +
                         numberText(kMaxCopies, 10),
                     "enter a whole number; it includes the original");
    }
    return {};
}

/// Lets the formulas of items that were moved as a whole move with them.
void moveFormulas(Document &document, const Selection &selection, Vec2 by) {
    if (document.formulas.empty()) {
        return;
    }
    const auto shift = [&](NumberOwner::Kind kind, const std::set<std::uint32_t> &items) {
        for (const std::uint32_t item : items) {
            shiftFormulas(document, {kind, item}, by);
        }
    };
    shift(NumberOwner::Kind::Shape, selection.shapes);
    shift(NumberOwner::Kind::Source, selection.sources);
    shift(NumberOwner::Kind::Region, selection.markers);
}

/// An item and its copy.
struct CopiedItem {
    NumberOwner from, to;
    Vec2 by; ///< movement of the copy; zero if it was mapped otherwise
};

Vec2 shiftOf(const PlaneMap &map) {
    return map.isTranslation() ? map.shift : Vec2{};
}

/// Returns the angle of a box after a map, which is exact unless the map shears the box. An angle that describes the
/// same directions as before keeps its value.
double mappedAngle(double degrees, const PlaneMap &map) {
    constexpr double kRounding = 1e-12;
    const Vec2 side = unitVector(degrees), image = side.x * map.u + side.y * map.v;
    const double turned = std::atan2(image.y, image.x) * 180.0 / std::numbers::pi;
    return std::fabs(std::remainder(turned - degrees, 90.0)) <= kRounding ? degrees : boxAngle(turned);
}

/// Maps a source. A box stays one: its corners a and b are mapped, and its first side takes the direction of its image.
SizeSource mapped(SizeSource source, const PlaneMap &map) {
    source.a = map(source.a);
    source.b = map(source.b);
    if (source.shape == SourceShape::Box && !map.isTranslation()) {
        source.angle = mappedAngle(source.angle, map);
    }
    source.radius *= map.isTranslation() ? 1.0 : std::sqrt(std::fabs(map.determinant()));
    return source;
}

} // namespace

void mapShape(Shape &shape, const PlaneMap &map) {
    if (map.isTranslation()) {
        moveShape(shape, map.shift); // without rounding axes of arcs
        return;
    }
    // A rectangle or slot whose image is none becomes a path first.
    const bool keepsForm = shape.visit(
        [](const PathForm &) { return true; },
        [&](const RectangleForm &form) { return map.keepsAxes() && (form.radius == 0.0 || map.isSimilarity()); },
        [](const CircleForm &) { return true; }, [](const PointForm &) { return true; },
        [](const EllipseForm &) { return true; }, [&](const SlotForm &) { return map.isSimilarity(); });
    if (!keepsForm) {
        becomePath(shape);
    }
    if (shape.is<CircleForm>()) {
        mapCircle(shape, map); // may change its form
        return;
    }
    const auto mapNodes = [&] { std::transform(shape.nodes.begin(), shape.nodes.end(), shape.nodes.begin(), map); };
    shape.visit(
        [&](PathForm &path) {
            mapNodes();
            for (Curve &curve : path.curves) {
                curve = curve.kind() == CurveKind::Line ? Curve() : curve.mapped(map);
            }
        },
        [&](const RectangleForm &) { mapRectangle(shape, map); }, [](const CircleForm &) {},
        [&](const PointForm &) { mapNodes(); }, [&](const EllipseForm &) { mapNodes(); },
        [&](const SlotForm &) { mapSlot(shape, map); });
}

namespace {

/// Maps everything selected, without the mapped regions. `keepsArcs`: paths whose arcs of circles can keep their radii
/// are stretched so.
Result<Document> mappedSelection(const Document &document, const Selection &selection, const PlaneMap &map,
                                 bool keepsArcs) {
    Document next = document;
    const auto handles = handlesToMove(document, selection);
    for (auto &pointer : next.shapes) {
        const bool whole = selection.shapes.contains(pointer->id);
        const auto part = handles.find(pointer->id);
        if (!whole && part == handles.end()) {
            continue;
        }
        Shape shape = *pointer;
        if (std::optional<Shape> sketched = whole && keepsArcs ? stretchedWithArcs(shape, map) : std::nullopt) {
            shape = *std::move(sketched);
        } else if (whole) {
            mapShape(shape, map);
        } else if (Status status = mapHandles(shape, part->second, map); !status.empty()) {
            return status;
        }
        if (Diagnostics faults = checkShape(shape); !faults.empty()) {
            return faults;
        }
        pointer = std::make_shared<const Shape>(std::move(shape));
    }
    for (const std::uint32_t k : selection.sources) {
        if (k < next.spacing.sources.size()) {
            next.spacing.sources[k] = mapped(next.spacing.sources[k], map);
        }
    }
    for (const std::uint32_t k : selection.markers) {
        if (k < next.regionMarkers.size()) {
            next.regionMarkers[k].at = map(next.regionMarkers[k].at);
        }
    }
    if (std::all_of(next.shapes.begin(), next.shapes.end(),
                    [&](const auto &shape) { return selection.shapes.contains(shape->id); })) {
        for (MappedSpec &spec : next.mapped) { // their corners are places, which the whole drawing takes along
            std::transform(spec.corners.begin(), spec.corners.end(), spec.corners.begin(), map);
        }
    }
    mapConstraints(next, selection.shapes, map);
    return next;
}

} // namespace

Result<Document> transformSelection(const Document &document, const Selection &selection, const PlaneMap &map) {
    if (Status status = checkMap(map); !status.empty()) {
        return status;
    }
    Result<Document> next = mappedSelection(document, selection, map, false);
    if (!next) {
        return next;
    }
    // A stretched arc is no arc of a circle, and has no tangents or radius that could be kept.
    if (stretchesAlongAxes(map) && !keepsConstraints(document, *next)) {
        Result<Document> sketched = mappedSelection(document, selection, map, true);
        if (sketched && keepsConstraints(document, *sketched)) {
            next = std::move(sketched);
        }
    }
    if (map.isTranslation()) {
        moveFormulas(*next, selection, map.shift);
        return next;
    }
    return fitMapped(document, *std::move(next), selection.shapes);
}

Result<Document> copySelection(const Document &document, const Selection &selection, std::span<const PlaneMap> maps,
                               Selection *copies) {
    if (Status status = checkCopies(document, selection, maps.size()); !status.empty()) {
        return status;
    }
    std::vector<Shape> shapes;
    std::vector<CopiedItem> copied;
    std::vector<std::map<std::uint32_t, std::uint32_t>> copiesOf; // shapes with their copies, for each map
    Selection fresh;
    CopiedGroups groups(document);
    for (const PlaneMap &map : maps) {
        copiesOf.emplace_back();
        groups.beginCopy();
        if (Status status = checkMap(map); !status.empty()) {
            return status;
        }
        for (const auto &shape : document.shapes) {
            if (selection.shapes.contains(shape->id)) {
                const std::uint32_t id = document.nextId + static_cast<std::uint32_t>(shapes.size());
                fresh.shapes.insert(id);
                copiesOf.back().emplace(shape->id, id);
                copied.push_back({NumberOwner::ofShape(shape->id), NumberOwner::ofShape(id), shiftOf(map)});
                shapes.push_back(*shape);
                shapes.back().group = groups(shape->group);
                mapShape(shapes.back(), map);
            }
        }
    }
    Result<Document> next = addShapes(document, std::move(shapes));
    if (!next) {
        return next;
    }
    for (const PlaneMap &map : maps) {
        for (const std::uint32_t k : selection.sources) {
            if (k < document.spacing.sources.size()) {
                const auto index = static_cast<std::uint32_t>(next->spacing.sources.size());
                fresh.sources.insert(index);
                copied.push_back({NumberOwner::ofSource(k), NumberOwner::ofSource(index), shiftOf(map)});
                next->spacing.sources.push_back(mapped(document.spacing.sources[k], map));
            }
        }
        for (const std::uint32_t k : selection.markers) {
            if (k < document.regionMarkers.size()) {
                const auto index = static_cast<std::uint32_t>(next->regionMarkers.size());
                fresh.markers.insert(index);
                copied.push_back({NumberOwner::ofRegion(k), NumberOwner::ofRegion(index), shiftOf(map)});
                next->regionMarkers.push_back(document.regionMarkers[k]);
                next->regionMarkers.back().at = map(document.regionMarkers[k].at);
            }
        }
    }
    for (std::size_t k = 0; k < maps.size(); ++k) {
        std::set<std::uint32_t> made;
        for (const auto &[from, to] : copiesOf[k]) {
            made.insert(to);
        }
        for (const auto &[from, to] : copyConstraints(*next, document, copiesOf[k])) {
            copied.push_back({NumberOwner::ofConstraint(from), NumberOwner::ofConstraint(to), {}});
        }
        mapConstraints(*next, made, maps[k]);
    }
    for (const CopiedItem &item : copied) {
        copyFormulas(*next, item.from, item.to);
        shiftFormulas(*next, item.to, item.by);
    }
    pruneFormulas(*next); // turned and scaled items have other positions
    if (copies != nullptr) {
        *copies = std::move(fresh);
    }
    return next;
}

Result<Document> linearArray(const Document &document, const Selection &selection, double count, Vec2 step,
                             Selection *copies) {
    if (Status status = checkCount(count); !status.empty()) {
        return status;
    }
    if (!isFinite(step) || step == Vec2{}) {
        return error("bad-number", "invalid step " + placeText(step) + "; expected finite numbers that are not both 0",
                     "enter the distance from one copy to the next");
    }
    std::vector<PlaneMap> maps;
    for (int k = 1; k < count; ++k) {
        maps.push_back(PlaneMap::translation(1.0 * k * step));
    }
    return copySelection(document, selection, maps, copies);
}

Result<Document> polarArray(const Document &document, const Selection &selection, double count, Vec2 centre,
                            double degrees, bool turns, Selection *copies) {
    if (Status status = checkCount(count); !status.empty()) {
        return status;
    }
    if (!(std::fabs(degrees) <= 360.0) || degrees == 0.0) {
        return error("bad-number", "invalid angle " + numberText(degrees, 6) + "; expected -360 to 360 degrees, not 0",
                     "enter an angle such as 90");
    }
    const double step = degrees / (std::fabs(degrees) == 360.0 ? count : count - 1.0);
    const Vec2 middle = boundsOf(document, selection).centre();
    std::vector<PlaneMap> maps;
    for (int k = 1; k < count; ++k) {
        const PlaneMap turn = PlaneMap::rotation(k * step, centre);
        maps.push_back(turns ? turn : PlaneMap::translation(turn(middle) - middle));
    }
    return copySelection(document, selection, maps, copies);
}

} // namespace forefront
