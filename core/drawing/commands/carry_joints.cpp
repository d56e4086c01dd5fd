#include "core/drawing/commands/carry_joints.hpp"

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace forefront {
namespace {

/// A place that a command has moved.
struct MovedPlace {
    Vec2 from, to;
};

/// A straight segment that a command has moved.
struct MovedSegment {
    MovedPlace a, b;
};

bool canJoin(const Shape &shape) {
    return isPath(shape) || shape.is<RectangleForm>() || shape.is<PointForm>();
}

/// Returns true if the shape has the same handles in another order, as after reversing a path.
bool onlyReordered(std::vector<Vec2> before, std::vector<Vec2> after) {
    std::sort(before.begin(), before.end(), comesBefore);
    std::sort(after.begin(), after.end(), comesBefore);
    return before == after;
}

/// Returns the parameter along a segment of the point nearest to p, in [0, 1]; none if it is farther than `tolerance`.
std::optional<double> along(Vec2 a, Vec2 b, Vec2 p, double tolerance) {
    const double squared = lengthSquared(b - a);
    const double t = squared > 0.0 ? std::clamp(dot(p - a, b - a) / squared, 0.0, 1.0) : 0.0;
    return distance(p, a + t * (b - a)) <= tolerance ? std::optional(t) : std::nullopt;
}

/// Moves what is joined with handles that a command has moved.
class JointMover {
  public:
    JointMover(const Document &before, Document after)
        : before_(before), document_(std::move(after)), tolerance_(jointTolerance(before)) {}

    Result<Document> run() {
        // A moved corner of a rectangle moves its neighbours, which may be joined with further shapes.
        const std::size_t limit = document_.shapes.size() + 1;
        for (std::size_t round = 0; round < limit; ++round) {
            collect();
            if (moved_.empty()) {
                break;
            }
            const Result<bool> any = moveJoined();
            if (!any) {
                return any.faults();
            }
            if (!*any) {
                break;
            }
        }
        keepEndsOnSegments();
        return std::move(document_);
    }

  private:
    /// Returns the shape before the command; null if it has other handles now.
    const Shape *unchangedList(const Shape &now) const {
        const Shape *const old = findShape(before_, now.id);
        return old != nullptr && canJoin(now) && old->form.index() == now.form.index() &&
                       handleCount(*old) == handleCount(now)
                   ? old
                   : nullptr;
    }

    void collect() {
        moved_.clear();
        segments_.clear();
        for (const auto &shape : document_.shapes) {
            const Shape *const old = unchangedList(*shape);
            if (old == nullptr || old == shape.get()) {
                continue;
            }
            const std::vector<Vec2> from = handlesOf(*old), to = handlesOf(*shape);
            if (from == to || onlyReordered(from, to)) {
                continue;
            }
            for (std::size_t k = 0; k < from.size(); ++k) {
                if (from[k] != to[k]) {
                    moved_.push_back({from[k], to[k]});
                }
            }
            collectSegments(*old, from, to);
        }
        std::stable_sort(moved_.begin(), moved_.end(),
                         [](const MovedPlace &a, const MovedPlace &b) { return a.from.x < b.from.x; });
    }

    void collectSegments(const Shape &shape, const std::vector<Vec2> &from, const std::vector<Vec2> &to) {
        if (shape.is<PointForm>() || (shape.is<RectangleForm>() && shape.as<RectangleForm>().radius > 0.0)) {
            return;
        }
        const std::size_t count = isClosed(shape) ? from.size() : from.size() - 1;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t next = (k + 1) % from.size();
            const bool straight = !isPath(shape) || shape.path().curves.empty() || shape.path().curves[k] == Curve();
            if (straight && (from[k] != to[k] || from[next] != to[next])) {
                segments_.push_back({{from[k], to[k]}, {from[next], to[next]}});
            }
        }
    }

    /// Returns where a handle at a place goes with what has moved; none if it is joined with nothing that has.
    std::optional<Vec2> target(Vec2 at) const {
        const auto first = std::lower_bound(moved_.begin(), moved_.end(), at.x - tolerance_,
                                            [](const MovedPlace &place, double x) { return place.from.x < x; });
        for (auto place = first; place != moved_.end() && place->from.x <= at.x + tolerance_; ++place) {
            if (distance(place->from, at) <= tolerance_) {
                return place->to;
            }
        }
        for (const MovedSegment &segment : segments_) {
            const bool inside = distance(at, segment.a.from) > tolerance_ && distance(at, segment.b.from) > tolerance_;
            const std::optional<double> t =
                inside ? along(segment.a.from, segment.b.from, at, tolerance_) : std::nullopt;
            if (t) {
                return segment.a.to + *t * (segment.b.to - segment.a.to);
            }
        }
        return std::nullopt;
    }

    Result<bool> moveJoined() {
        bool any = false;
        for (std::shared_ptr<const Shape> &place : document_.shapes) {
            const Shape *const old = unchangedList(*place);
            if (old == nullptr) {
                continue;
            }
            const std::vector<Vec2> from = handlesOf(*old), now = handlesOf(*place);
            std::map<std::uint32_t, Vec2> targets;
            for (std::uint32_t k = 0; k < now.size(); ++k) {
                const std::optional<Vec2> to = from[k] == now[k] ? target(from[k]) : std::nullopt;
                if (to && *to != now[k]) {
                    targets.emplace(k, *to);
                }
            }
            if (targets.empty()) {
                continue;
            }
            if (place->locked) {
                return error("joined-locked",
                             displayName(*place) + " is locked and joined with what moves at " +
                                 placeText(from[targets.begin()->first]),
                             "unlock it, or detach the node from it");
            }
            place = moved(*place, now, targets);
            any = true;
        }
        return any;
    }

    static std::shared_ptr<const Shape> moved(Shape shape, std::vector<Vec2> places,
                                              const std::map<std::uint32_t, Vec2> &targets) {
        if (isPath(shape)) {
            for (const auto &[k, to] : targets) {
                places[k] = to;
            }
            moveNodes(shape, std::move(places)); // at once: curves would be lost if ends met on the way
        } else {
            for (const auto &[k, to] : targets) {
                placeHandle(shape, k, to);
            }
        }
        return std::make_shared<const Shape>(std::move(shape));
    }

    /// Puts ends of open paths that were on a segment, and were moved by themselves, back on it.
    void keepEndsOnSegments() {
        for (std::shared_ptr<const Shape> &place : document_.shapes) {
            const Shape *const old = unchangedList(*place);
            if (old == nullptr || old == place.get() || !place->isPolyline()) {
                continue;
            }
            std::map<std::uint32_t, Vec2> targets;
            const auto last = static_cast<std::uint32_t>(place->nodes.size() - 1);
            for (const std::uint32_t k : {0U, last}) {
                const Vec2 from = old->nodes[k], now = place->nodes[k];
                const std::optional<Vec2> on = from != now ? onSegment(place->id, from, now) : std::nullopt;
                if (on) {
                    targets.emplace(k, *on);
                }
            }
            if (!targets.empty()) {
                place = moved(*place, place->nodes, targets);
            }
        }
    }

    /// Returns the place nearest to `now` on the segment of another shape that `from` lies inside of, where that
    /// segment has not moved. None if there is no such segment.
    std::optional<Vec2> onSegment(std::uint32_t id, Vec2 from, Vec2 now) const {
        for (const auto &shape : before_.shapes) {
            if (shape->id == id || !isPath(*shape) || findShape(document_, shape->id) == nullptr ||
                findShape(document_, shape->id)->nodes != shape->nodes) {
                continue;
            }
            const std::vector<Vec2> &nodes = shape->nodes;
            const std::size_t count = isClosed(*shape) ? nodes.size() : nodes.size() - 1;
            for (std::size_t k = 0; k < count; ++k) {
                const Vec2 a = nodes[k], b = nodes[(k + 1) % nodes.size()];
                const bool straight = shape->path().curves.empty() || shape->path().curves[k] == Curve();
                if (straight && distance(from, a) > tolerance_ && distance(from, b) > tolerance_ &&
                    along(a, b, from, tolerance_)) {
                    const double t = std::clamp(dot(now - a, b - a) / lengthSquared(b - a), 0.0, 1.0);
                    return a + t * (b - a);
                }
            }
        }
        return std::nullopt;
    }

    const Document &before_;
    Document document_;
    double tolerance_;
    std::vector<MovedPlace> moved_; ///< by x of `from`
    std::vector<MovedSegment> segments_;
};

/// A node that a command inserted into a path or removed from it, between two others.
struct ListedNode {
    std::uint32_t shape = 0;
    Vec2 at;
    std::optional<Vec2> previous, next; ///< none at the end of an open path
};

/// Returns the nodes of the longer list that the shorter one lacks; none unless the shorter one is the rest of it.
std::vector<ListedNode> missing(const Shape &longer, const std::vector<Vec2> &shorter) {
    std::vector<ListedNode> list;
    const std::vector<Vec2> &nodes = longer.nodes;
    const std::size_t n = nodes.size();
    const bool closed = isClosed(longer);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < n; ++k) {
        if (kept < shorter.size() && nodes[k] == shorter[kept]) {
            ++kept;
            continue;
        }
        const bool first = k == 0 && !closed, last = k + 1 == n && !closed;
        list.push_back({longer.id, nodes[k], first ? std::nullopt : std::optional(nodes[(k + n - 1) % n]),
                        last ? std::nullopt : std::optional(nodes[(k + 1) % n])});
    }
    return kept == shorter.size() ? list : std::vector<ListedNode>();
}

/// Inserts and removes nodes of segments that paths share.
class SharedSegments {
  public:
    SharedSegments(const Document &before, Document after)
        : before_(before), document_(std::move(after)), tolerance_(jointTolerance(before)) {}

    Result<Document> run() {
        std::vector<ListedNode> inserted, removed;
        for (const auto &shape : document_.shapes) {
            const Shape *const old = findShape(before_, shape->id);
            if (old == nullptr || old == shape.get() || !isPath(*old) || !isPath(*shape) ||
                isClosed(*old) != isClosed(*shape)) {
                continue;
            }
            const std::vector<ListedNode> more = missing(*shape, old->nodes), fewer = missing(*old, shape->nodes);
            inserted.insert(inserted.end(), more.begin(), more.end());
            removed.insert(removed.end(), fewer.begin(), fewer.end());
        }
        for (const ListedNode &node : inserted) {
            if (Status status = insertInto(node); !status.empty()) {
                return status;
            }
        }
        for (const ListedNode &node : removed) {
            if (hasNewShapeAt(node.at)) { // the path was divided there
                continue;
            }
            if (Status status = removeFrom(node); !status.empty()) {
                return status;
            }
        }
        return std::move(document_);
    }

  private:
    bool same(Vec2 a, Vec2 b) const { return distance(a, b) <= tolerance_; }
    bool same(const std::optional<Vec2> &a, Vec2 b) const { return a && same(*a, b); }

    /// Returns true if a shape that the command has added has a node at a place.
    bool hasNewShapeAt(Vec2 at) const {
        return std::any_of(document_.shapes.begin(), document_.shapes.end(), [&](const auto &shape) {
            return findShape(before_, shape->id) == nullptr &&
                   std::any_of(shape->nodes.begin(), shape->nodes.end(), [&](Vec2 node) { return same(node, at); });
        });
    }

    Status insertInto(const ListedNode &node) {
        for (std::size_t s = 0; s < document_.shapes.size(); ++s) {
            const std::shared_ptr<const Shape> shape = document_.shapes[s];
            if (shape->id == node.shape || !isPath(*shape)) {
                continue;
            }
            const std::vector<Vec2> &nodes = shape->nodes;
            const std::size_t count = isClosed(*shape) ? nodes.size() : nodes.size() - 1;
            for (std::uint32_t k = 0; k < count; ++k) {
                const Vec2 a = nodes[k], b = nodes[(k + 1) % nodes.size()];
                if ((same(node.previous, a) && same(node.next, b)) || (same(node.previous, b) && same(node.next, a))) {
                    Result<Document> next = insertNode(document_, {shape->id, k}, node.at);
                    if (!next) {
                        return next.faults();
                    }
                    document_ = *std::move(next);
                    break;
                }
            }
        }
        return {};
    }

    Status removeFrom(const ListedNode &removed) {
        Selection joined;
        for (const auto &shape : document_.shapes) {
            if (shape->id == removed.shape || !canJoin(*shape)) {
                continue;
            }
            const std::vector<Vec2> nodes = handlesOf(*shape);
            const std::size_t n = nodes.size();
            for (std::uint32_t k = 0; k < n; ++k) {
                if (!same(nodes[k], removed.at)) {
                    continue;
                }
                const bool end = !isClosed(*shape) && (k == 0 || k + 1 == n);
                const Vec2 previous = nodes[(k + n - 1) % n], next = nodes[(k + 1) % n];
                const bool shared = isPath(*shape) && !end &&
                                    ((same(removed.previous, previous) && same(removed.next, next)) ||
                                     (same(removed.previous, next) && same(removed.next, previous)));
                if (!shared || shape->locked) {
                    return error("joined-node",
                                 "the node at " + placeText(removed.at) + " is joined with " + displayName(*shape),
                                 "detach it first, or delete the other segments at it");
                }
                joined.nodes.insert({shape->id, k});
            }
        }
        if (!joined.empty()) {
            document_ = deleteSelection(document_, joined);
        }
        return {};
    }

    const Document &before_;
    Document document_;
    double tolerance_;
};

} // namespace

double jointTolerance(const Document &document) {
    const Box2 box = boundsOf(document);
    constexpr double kWeld = 1e-6;
    return document.shapes.empty() ? 0.0 : kWeld * length(box.size());
}

Result<Document> carryJoints(const Document &before, const Document &after) {
    Result<Document> next = SharedSegments(before, after).run();
    return next ? JointMover(before, *std::move(next)).run() : next;
}

} // namespace forefront
