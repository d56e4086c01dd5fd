#include "core/drawing/commands/trim_commands.hpp"

#include "core/drawing/commands/changed_lengths.hpp"
#include "core/drawing/commands/join_segments.hpp"
#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/curve_crossings.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace forefront {
namespace {

constexpr double kTouch = 1e-9; ///< distance within which curves touch, in sizes of the drawing
constexpr double kApart = 1e-9; ///< positions closer than this are the same

double touchOf(const Document &document) {
    return kTouch * boundsOf(document).diagonal();
}

/// Calls `visit(curve)` for the segments of visible shapes whose box meets another one.
template <class Visit>
void visitCurves(const Document &document, const Box2 &box, std::uint32_t except, const Visit &visit) {
    for (const auto &shape : document.shapes) {
        if (shape->id == except || shape->hidden || shape->is<PointForm>() || !boundsOf(*shape).overlaps(box)) {
            continue;
        }
        const Outline outline = outlineOf(*shape);
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            visit(outline.curve(k));
        }
    }
}

/// A shape as a path. A position on it is the index of a segment plus the parameter on it; on a closed path, positions
/// that differ by the number of segments are the same place.
struct Path {
    Shape shape;
    Outline outline;

    double size() const { return static_cast<double>(outline.segmentCount()); }
    double positionOf(Vec2 at) const {
        double best = 0.0, nearest = -1.0;
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            const Curve curve = outline.curve(k);
            const double t = curve.nearest(at), away = distance(curve.point(t), at);
            if (nearest < 0.0 || away < nearest) {
                nearest = away;
                best = static_cast<double>(k) + t;
            }
        }
        return best;
    }
};

Result<Path> pathOf(const Document &document, std::uint32_t id) {
    const Shape *const given = findShape(document, id);
    if (given == nullptr) {
        return error("no-such-shape", "shape " + std::to_string(id) + " not found");
    }
    if (given->is<PointForm>()) {
        return error("not-possible", "a point has no outline to trim", "click a path, a rectangle or a circle");
    }
    Path path{*given, {}};
    path.shape.cuts.clear();
    becomePath(path.shape);
    path.outline = outlineOf(path.shape);
    return path;
}

/// The curves that may cross a path, and a tree over their boxes.
struct Neighbours {
    std::vector<Curve> curves; ///< those of the path first, in order
    BoxTree tree;
};

Neighbours neighboursOf(const Document &document, const Path &path, double touch) {
    Neighbours found;
    Box2 box;
    for (std::size_t k = 0; k < path.outline.segmentCount(); ++k) {
        found.curves.push_back(path.outline.curve(k));
        box.add(found.curves.back().bounds());
    }
    visitCurves(document, box.grown(touch), path.shape.id, [&](const Curve &other) { found.curves.push_back(other); });
    std::vector<Box2> boxes;
    boxes.reserve(found.curves.size());
    for (const Curve &curve : found.curves) {
        boxes.push_back(curve.bounds().grown(touch));
    }
    found.tree = BoxTree(boxes);
    return found;
}

/// Returns true if two positions in ascending order, on one segment or on neighbouring ones, are the same place.
bool isSamePlace(const Path &path, double first, double second, double touch) {
    const auto at = [&](double position) {
        const auto k = std::min(static_cast<std::size_t>(position), path.outline.segmentCount() - 1);
        return path.outline.curve(k).point(position - static_cast<double>(k));
    };
    const double node = std::floor(second);
    const double along =
        node > first ? distance(at(first), at(node)) + distance(at(node), at(second)) : distance(at(first), at(second));
    return second - first <= kApart || (second - first < 1.0 && along <= 4.0 * touch);
}

/// Returns the positions where a path meets other shapes or itself, in order, without those at the ends of an open one.
std::vector<double> crossingsAlong(const Document &document, const Path &path) {
    const double touch = touchOf(document);
    const std::size_t own = path.outline.segmentCount();
    const Neighbours near = neighboursOf(document, path, touch);
    std::vector<double> found;
    for (std::size_t k = 0; k < own; ++k) {
        near.tree.query(near.curves[k].bounds(), [&](std::uint32_t other) {
            if (other == k) {
                return;
            }
            for (const CurveCrossing &crossing : crossingsOf(near.curves[k], near.curves[other], touch)) {
                const bool end = std::min(crossing.first, 1.0 - crossing.first) <= kApart;
                if (other >= own || !end) { // neighbours on the path share their ends
                    found.push_back(static_cast<double>(k) + crossing.first);
                }
            }
        });
    }
    std::sort(found.begin(), found.end());
    const double size = path.size();
    if (!path.outline.closed) {
        std::erase_if(found, [&](double at) { return at <= kApart || at >= size - kApart; });
    } else if (!found.empty() && isSamePlace(path, found.back(), size, touch)) {
        found.back() = 0.0; // the first node again
        std::sort(found.begin(), found.end());
    }
    found.erase(
        std::unique(found.begin(), found.end(), [&](double a, double b) { return isSamePlace(path, a, b, touch); }),
        found.end());
    return found;
}

/// The part between two positions; on a closed path, `to` may be beyond its last segment.
struct PathStretch {
    double from = 0.0, to = 0.0;
};

Result<PathStretch> stretchAround(const Path &path, std::span<const double> crossings, Vec2 at) {
    const bool closed = path.outline.closed;
    if (crossings.size() < (closed ? 2U : 1U)) {
        return error("not-possible",
                     displayName(path.shape) + (closed && crossings.size() == 1 ? " is crossed at one place only"
                                                                                : " is not crossed by any other line"),
                     "trim between two crossings, or delete it");
    }
    const double place = path.positionOf(at);
    const auto next = std::upper_bound(crossings.begin(), crossings.end(), place);
    const bool first = next == crossings.begin(), last = next == crossings.end();
    const double size = path.size();
    return PathStretch{!first   ? *(next - 1)
                       : closed ? crossings.back() - size
                                : 0.0,
                       !last    ? *next
                       : closed ? crossings.front() + size
                                : size};
}

/// Calls `visit(segment, t0, t1)` for the segments of a stretch in order.
template <class Visit>
void visitStretch(const Path &path, PathStretch stretch, const Visit &visit) {
    const std::size_t segments = path.outline.segmentCount();
    const double turn = stretch.from < 0.0 ? path.size() : 0.0;
    stretch = {stretch.from + turn, stretch.to + turn};
    const auto end = static_cast<std::size_t>(std::ceil(stretch.to - kApart));
    for (auto k = static_cast<std::size_t>(stretch.from); k < end; ++k) {
        const auto base = static_cast<double>(k);
        const double t0 = std::max(stretch.from - base, 0.0), t1 = std::min(stretch.to - base, 1.0);
        if (t1 - t0 > kApart) {
            visit(k < segments ? k : k - segments, t0, t1);
        }
    }
}

/// Returns a stretch of a path as an open path with the same properties.
Shape openPart(const Path &path, const PathStretch &stretch) {
    Shape part = path.shape;
    PathForm &form = part.form.emplace<PathForm>(PathForm{.closed = false});
    part.nodes.clear();
    part.segmentTags.clear();
    part.segmentSizes.clear(); // see carrySegmentSizes()
    visitStretch(path, stretch, [&](std::size_t k, double t0, double t1) {
        const bool whole = t0 == 0.0 && t1 == 1.0;
        const Curve curve = path.outline.curve(k), piece = whole ? curve : curve.part(t0, t1);
        if (part.nodes.empty()) {
            part.nodes.push_back(t0 == 0.0 ? path.outline.from(k) : piece.point(0.0));
        }
        part.nodes.push_back(t1 == 1.0 ? path.outline.to(k) : piece.point(1.0));
        form.curves.push_back(path.outline.isCurved(k) ? piece : Curve());
        part.segmentTags.push_back(segmentTag(path.shape, path.outline.part(k)));
    });
    if (path.outline.curves.empty()) {
        form.curves.clear();
    }
    if (path.shape.segmentTags.empty()) {
        part.segmentTags.clear();
    }
    keepNodeSizes(part, path.shape);
    return part;
}

/// Returns the last segment at an end of an open path, running towards that end.
Result<Curve> segmentTowards(const Document &document, NodeRef end) {
    const Shape *const path = findShape(document, end.shape);
    if (path == nullptr || end.node >= handleCount(*path)) {
        return error("no-such-node", "node not found");
    }
    const bool first = end.node == 0, last = end.node + 1 == path->nodes.size();
    if (!path->isPolyline() || (!first && !last)) {
        return error("not-possible", "only the ends of open paths can be extended", "select the end of an open path");
    }
    const Outline outline = outlineOf(*path);
    return first ? outline.curve(0).part(1.0, 0.0) : outline.curve(outline.segmentCount() - 1);
}

/// Returns a segment continued beyond its end, as far as the drawing reaches.
Curve continued(const Document &document, const Curve &segment) {
    if (segment.kind() == CurveKind::Arc) {
        const std::array<double, 8> n = segment.numbers();
        const double rest = 2.0 * std::numbers::pi - std::fabs(n[7]);
        return Curve::arc({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, n[6] + n[7], std::copysign(rest, n[7]));
    }
    const Vec2 end = segment.point(1.0);
    return Curve::line(end, end + 2.0 * boundsOf(document).diagonal() * segment.tangent(1.0));
}

} // namespace

Result<std::vector<double>> crossingsAlong(const Document &document, std::uint32_t shape) {
    const Result<Path> path = pathOf(document, shape);
    return path ? Result(crossingsAlong(document, *path)) : path.faults();
}

Result<std::vector<Curve>> partToTrim(const Document &document, std::uint32_t shape, Vec2 at,
                                      std::span<const double> crossings) {
    const Result<Path> path = pathOf(document, shape);
    const Result<PathStretch> stretch = path ? stretchAround(*path, crossings, at) : path.faults();
    if (!stretch) {
        return stretch.faults();
    }
    std::vector<Curve> curves;
    visitStretch(*path, *stretch,
                 [&](std::size_t k, double t0, double t1) { curves.push_back(path->outline.curve(k).part(t0, t1)); });
    return curves;
}

namespace {

/// Removes a stretch of a path; what is left of an open path in two parts becomes two shapes.
Result<Document> withoutStretch(const Document &document, const Path &path, const PathStretch &stretch) {
    const double size = path.size();
    const std::uint32_t id = path.shape.id;
    std::vector<PathStretch> kept;
    if (path.outline.closed) {
        kept.push_back({stretch.to, stretch.from + size});
    } else {
        kept = {{0.0, stretch.from}, {stretch.to, size}};
        std::erase_if(kept, [](const PathStretch &part) { return part.to - part.from <= kApart; });
    }
    if (kept.empty()) {
        Selection whole;
        whole.shapes = {id};
        return deleteSelection(document, whole);
    }
    Result<Document> next = replaceShape(document, openPart(path, kept.front()));
    if (next && kept.size() > 1) {
        next = addShape(*next, openPart(path, kept.back()));
    }
    if (!next) {
        return next;
    }
    // The ends become nodes of the shapes that they lie on.
    Document joined = joinToSegments(*next, id);
    return kept.size() > 1 ? joinToSegments(joined, document.nextId) : joined;
}

/// Returns the places of a stretch: its ends, the nodes between them and the middle of each segment, in order.
std::vector<Vec2> placesOf(const Path &path, const PathStretch &stretch) {
    std::vector<Vec2> places;
    visitStretch(path, stretch, [&](std::size_t k, double t0, double t1) {
        const Curve curve = path.outline.curve(k);
        if (places.empty()) {
            places.push_back(curve.point(t0));
        }
        places.push_back(curve.point(0.5 * (t0 + t1)));
        places.push_back(curve.point(t1));
    });
    return places;
}

/// Returns the stretch of a path along a stretch of another one, which is given by its places; none if the path leaves
/// them by more than `touch`.
std::optional<PathStretch> stretchAlong(const Path &path, const std::vector<Vec2> &places, double touch) {
    std::vector<double> positions;
    for (const Vec2 place : places) {
        const double position = path.positionOf(place);
        const auto k = std::min(static_cast<std::size_t>(position), path.outline.segmentCount() - 1);
        if (distance(path.outline.curve(k).point(position - static_cast<double>(k)), place) > touch) {
            return std::nullopt;
        }
        positions.push_back(position);
    }
    const double low = std::min(positions.front(), positions.back()),
                 high = std::max(positions.front(), positions.back());
    const bool between = std::all_of(positions.begin(), positions.end(),
                                     [&](double at) { return at >= low - kApart && at <= high + kApart; });
    if (between) {
        return PathStretch{low, high};
    }
    const bool around = std::all_of(positions.begin(), positions.end(),
                                    [&](double at) { return at <= low + kApart || at >= high - kApart; });
    return around && path.outline.closed ? std::optional(PathStretch{high, low + path.size()}) : std::nullopt;
}

} // namespace

Result<Document> trimAt(const Document &document, std::uint32_t shape, Vec2 at) {
    const Result<Path> path = pathOf(document, shape);
    const Result<PathStretch> stretch =
        path ? stretchAround(*path, crossingsAlong(document, *path), at) : path.faults();
    if (!stretch) {
        return stretch.faults();
    }
    const std::vector<Vec2> places = placesOf(*path, *stretch);
    const double touch = samePlaceDistance(document);
    Result<Document> next = withoutStretch(document, *path, *stretch);
    if (next) {
        dropChangedLengths(document, *next, shape);
    }
    for (const auto &other : document.shapes) {
        const bool apart = other->id == shape || other->hidden || other->locked || other->is<PointForm>();
        if (!next || apart || !boundsOf(*other).grown(touch).contains(places.front())) {
            continue;
        }
        const Result<Path> beside = pathOf(*next, other->id);
        const std::optional<PathStretch> same = beside ? stretchAlong(*beside, places, touch) : std::nullopt;
        if (same) {
            const Document whole = *next;
            next = withoutStretch(whole, *beside, *same);
            if (next) {
                dropChangedLengths(whole, *next, other->id);
            }
        }
    }
    return next;
}

Result<Curve> extensionAt(const Document &document, NodeRef end) {
    const Result<Curve> segment = segmentTowards(document, end);
    if (!segment) {
        return segment.faults();
    }
    const Curve further = continued(document, *segment);
    const double touch = touchOf(document);
    std::optional<double> first;
    const auto meet = [&](const Curve &other) {
        for (const CurveCrossing &crossing : crossingsOf(further, other, touch)) {
            const bool away = distance(crossing.at, further.point(0.0)) > 4.0 * touch;
            if (away && crossing.first < 1.0 - kApart && (!first || crossing.first < *first)) {
                first = crossing.first;
            }
        }
    };
    visitCurves(document, further.bounds().grown(touch), end.shape, meet);
    const Outline own = outlineOf(*findShape(document, end.shape));
    const std::size_t last = end.node == 0 ? 0 : own.segmentCount() - 1;
    for (std::size_t k = 0; k < own.segmentCount(); ++k) {
        if (k != last) {
            meet(own.curve(k));
        }
    }
    if (!first) {
        return error("not-possible",
                     displayName(*findShape(document, end.shape)) + " meets no other line when extended",
                     "draw a line in its path first");
    }
    return further.part(0.0, *first);
}

Result<Document> extendEnd(const Document &document, NodeRef end) {
    const Result<Curve> added = extensionAt(document, end);
    if (!added) {
        return added.faults();
    }
    const bool atStart = end.node == 0;
    Shape path = *findShape(document, end.shape);
    path.cuts.clear();
    const std::size_t last = atStart ? 0 : path.nodes.size() - 2; // segment
    const Curve old = outlineOf(path).curve(last);
    const Vec2 to = added->point(1.0);
    const auto insertAt = [&](auto &list, auto value) {
        list.insert(atStart ? list.begin() : list.end(), std::move(value));
    };
    if (old.kind() == CurveKind::Cubic) {
        insertAt(path.nodes, to);
        insertAt(path.path().curves, Curve());
        path.segmentSizes.clear(); // see carrySegmentSizes()
        if (!path.segmentTags.empty()) {
            path.segmentTags.resize(path.nodes.size() - 2, path.tag);
            insertAt(path.segmentTags, std::int32_t{path.segmentTags[last]});
        }
    } else {
        (atStart ? path.nodes.front() : path.nodes.back()) = to;
        if (old.kind() == CurveKind::Arc) {
            const Curve towards = atStart ? old.part(1.0, 0.0) : old;
            const std::array<double, 8> n = towards.numbers();
            const Curve longer = Curve::arc({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, n[6], n[7] + added->numbers()[7]);
            path.path().curves[last] = atStart ? longer.part(1.0, 0.0) : longer;
        }
    }
    Result<Document> next = replaceShape(document, std::move(path));
    if (!next) {
        return next;
    }
    dropChangedLengths(document, *next, end.shape);
    return joinToSegments(*next, end.shape);
}

} // namespace forefront
