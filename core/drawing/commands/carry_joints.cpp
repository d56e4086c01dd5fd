#include "core/drawing/commands/carry_joints.hpp"

#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/picking/selected_handles.hpp"
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

/// Returns true if the shape has the same handles in another order, as after reversing a path.
bool onlyReordered(std::vector<Vec2> before, std::vector<Vec2> after) {
    std::sort(before.begin(), before.end(), comesBefore);
    std::sort(after.begin(), after.end(), comesBefore);
    return before == after;
}

/// Moves what is joined with handles that a command has moved.
class JointMover {
  public:
    JointMover(const JointIndex &index, Document after)
        : index_(index), before_(index.document()), document_(std::move(after)) {}

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
        carryCorners();
        return std::move(document_);
    }

  private:
    /// The targets of handles by position of their shape in document_ and by handle.
    using Targets = std::map<std::size_t, std::map<std::uint32_t, Vec2>>;

    /// Returns the position of a shape in one document, which often is that in the other.
    static std::size_t position(const Document &document, std::uint32_t id, std::size_t likely) {
        const auto &shapes = document.shapes;
        return likely < shapes.size() && shapes[likely]->id == id ? likely : positionOf(document, id);
    }

    /// Returns the shape at a position as it was before the command; null if it has other handles now.
    const Shape *unchangedList(std::size_t s) const {
        const Shape &now = *document_.shapes[s];
        const std::size_t at = position(before_, now.id, s);
        if (at == before_.shapes.size() || !canJoin(now)) {
            return nullptr;
        }
        const Shape &old = *before_.shapes[at];
        const bool turned = old.is<RectangleForm>() && isPath(now); // a rectangle becomes a path with the same corners
        return (old.form.index() == now.form.index() || turned) && handleCount(old) == handleCount(now) ? &old
                                                                                                        : nullptr;
    }

    void collect() {
        moved_.clear();
        segments_.clear();
        hasMoved_.assign(before_.shapes.size(), {});
        for (std::size_t s = 0; s < document_.shapes.size(); ++s) {
            const Shape *const old = unchangedList(s);
            if (old == nullptr || old == document_.shapes[s].get()) {
                continue;
            }
            const std::vector<Vec2> from = handlesOf(*old), to = handlesOf(*document_.shapes[s]);
            if (from == to || onlyReordered(from, to)) {
                continue;
            }
            std::vector<bool> &hasMoved = hasMoved_[position(before_, old->id, s)];
            hasMoved.resize(from.size());
            for (std::size_t k = 0; k < from.size(); ++k) {
                if (from[k] != to[k]) {
                    moved_.push_back({from[k], to[k]});
                    hasMoved[k] = true;
                }
            }
            collectSegments(*old, from, to);
        }
        std::stable_sort(moved_.begin(), moved_.end(),
                         [](const MovedPlace &a, const MovedPlace &b) { return a.from.x < b.from.x; });
    }

    void collectSegments(const Shape &shape, const std::vector<Vec2> &from, const std::vector<Vec2> &to) {
        for (std::size_t k = 0; k < sideCount(shape); ++k) {
            const std::size_t next = (k + 1) % from.size();
            if (isStraightSide(shape, k) && (from[k] != to[k] || from[next] != to[next])) {
                segments_.push_back({{from[k], to[k]}, {from[next], to[next]}});
            }
        }
    }

    /// Returns where handles go with what has moved. A handle joined with several goes with the first place, or else
    /// with the first segment.
    Targets findTargets() const {
        Targets targets;
        const auto add = [&](const JointHandle &handle, Vec2 to) {
            const std::vector<bool> &hasMoved = hasMoved_[handle.shape];
            if (!hasMoved.empty() && hasMoved[handle.handle]) {
                return;
            }
            const std::size_t s = position(document_, before_.shapes[handle.shape]->id, handle.shape);
            if (s < document_.shapes.size()) {
                targets[s].emplace(handle.handle, to);
            }
        };
        for (const MovedPlace &place : moved_) {
            index_.handlesAt(place.from, [&](const JointHandle &handle) { add(handle, place.to); });
        }
        for (const MovedSegment &segment : segments_) {
            index_.handlesOn(segment.a.from, segment.b.from, [&](const JointHandle &handle, double t) {
                add(handle, segment.a.to + t * (segment.b.to - segment.a.to));
            });
        }
        return targets;
    }

    Result<bool> moveJoined() {
        bool any = false;
        for (auto &[s, targets] : findTargets()) {
            std::shared_ptr<const Shape> &place = document_.shapes[s];
            const Shape *const old = unchangedList(s);
            if (old == nullptr) {
                continue;
            }
            const std::vector<Vec2> from = handlesOf(*old), now = handlesOf(*place);
            std::map<std::uint32_t, Vec2> follow;
            for (const auto &[k, to] : targets) {
                if (from[k] == now[k] && to != now[k]) {
                    follow.emplace(k, to);
                }
            }
            if (follow.empty()) {
                continue;
            }
            if (place->locked) {
                return error("joined-locked",
                             displayName(*place) + " is locked and joined with what moves at " +
                                 placeText(from[follow.begin()->first]),
                             "unlock it, or drag with Alt to detach the node from it");
            }
            place = moved(*place, now, follow);
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
        for (std::size_t s = 0; s < document_.shapes.size(); ++s) {
            std::shared_ptr<const Shape> &place = document_.shapes[s];
            const Shape *const old = unchangedList(s);
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

    /// Moves the corners of mapped regions with the nodes that they are, unless the command has moved them itself.
    void carryCorners() {
        if (document_.mapped.empty()) {
            return;
        }
        collect();
        for (MappedSpec &spec : document_.mapped) {
            if (std::ranges::find(before_.mapped, spec) == before_.mapped.end()) {
                continue;
            }
            for (Vec2 &corner : spec.corners) {
                const auto node = std::ranges::find_if(moved_, [&](const MovedPlace &place) {
                    return distance(place.from, corner) <= index_.tolerance();
                });
                corner = node != moved_.end() ? node->to : corner;
            }
        }
    }

    /// Returns the place nearest to `now` on the segment of another path that `from` lies inside of, where that path
    /// has not moved. None if there is no such segment.
    std::optional<Vec2> onSegment(std::uint32_t id, Vec2 from, Vec2 now) const {
        const JointSegment *const segment = index_.segmentAt(from, [&](const JointSegment &candidate) {
            const Shape &shape = *before_.shapes[candidate.shape];
            const std::size_t s = position(document_, shape.id, candidate.shape);
            return shape.id != id && isPath(shape) && s < document_.shapes.size() &&
                   document_.shapes[s]->nodes == shape.nodes;
        });
        if (segment == nullptr) {
            return std::nullopt;
        }
        const Vec2 a = segment->a, way = segment->b - segment->a;
        return a + std::clamp(dot(now - a, way) / lengthSquared(way), 0.0, 1.0) * way;
    }

    const JointIndex &index_;
    const Document &before_;
    Document document_;
    std::vector<MovedPlace> moved_; ///< by x of `from`
    std::vector<MovedSegment> segments_;
    std::vector<std::vector<bool>> hasMoved_; ///< by position in before_ and handle; empty: none of the shape
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
    SharedSegments(const JointIndex &index, Document after)
        : before_(index.document()), document_(std::move(after)), tolerance_(index.tolerance()) {}

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

Result<Document> carryThrough(const JointIndex &index, const Document &after) {
    Result<Document> next = SharedSegments(index, after).run();
    return next ? JointMover(index, *std::move(next)).run() : next;
}

} // namespace

Result<Document> carryJoints(const Document &before, const Document &after) {
    return carryThrough(JointIndex(before), after);
}

Joints::Joints(std::shared_ptr<const Document> document)
    : document_(std::move(document)), index_(std::make_shared<const JointIndex>(*document_)) {}

Result<Document> Joints::carry(const Document &after) const {
    return carryThrough(*index_, after);
}

std::vector<bool> Joints::joinedHandles(std::uint32_t shape) const {
    const std::size_t position = positionOf(*document_, shape);
    if (position == document_->shapes.size() || !canJoin(*document_->shapes[position])) {
        return {};
    }
    const std::vector<Vec2> handles = handlesOf(*document_->shapes[position]);
    std::vector<bool> joined;
    joined.reserve(handles.size());
    for (std::uint32_t k = 0; k < handles.size(); ++k) {
        bool shared = false;
        index_->handlesAt(handles[k], [&](const JointHandle &other) {
            shared = shared || other.shape != position || other.handle != k;
        });
        joined.push_back(shared || index_->segmentAt(handles[k], [](const JointSegment &) { return true; }) != nullptr);
    }
    return joined;
}

Selection Joints::withJoined(const Selection &selection) const {
    Selection all = selection;
    const auto addAt = [&](Vec2 place) {
        index_->handlesAt(place, [&](const JointHandle &handle) {
            const std::uint32_t id = document_->shapes[handle.shape]->id;
            if (!selection.shapes.contains(id)) {
                all.nodes.insert({id, handle.handle});
            }
        });
    };
    for (const std::uint32_t id : selection.shapes) {
        const Shape *const shape = findShape(*document_, id);
        if (shape != nullptr && canJoin(*shape)) {
            const std::vector<Vec2> handles = handlesOf(*shape);
            std::for_each(handles.begin(), handles.end(), addAt);
        }
    }
    for (const auto &[id, moving] : handlesToMove(*document_, selection)) {
        const Shape *const shape = findShape(*document_, id);
        const std::vector<Vec2> handles = shape != nullptr && canJoin(*shape) ? handlesOf(*shape) : std::vector<Vec2>();
        for (const std::uint32_t k : moving) {
            if (k < handles.size()) {
                addAt(handles[k]);
            }
        }
    }
    return all;
}

} // namespace forefront
