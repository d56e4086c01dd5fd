#include "core/drawing/commands/joint_mover.hpp"

#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/joints/side_slide.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
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

/// Moves what is joined with handles that a command has moved.
class JointMover {
  public:
    JointMover(const JointIndex &index, Document after)
        : index_(index), before_(index.document()), document_(std::move(after)) {}

    Result<FollowedMove> run() {
        findGiven();
        slideOnSides();
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
        return FollowedMove{std::move(document_), std::move(given_), std::move(turned_)};
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

    /// Returns true if the shape at a position has not changed, without a look into it.
    bool isSame(std::size_t s) const { return s < before_.shapes.size() && before_.shapes[s] == document_.shapes[s]; }

    void collect() {
        moved_.clear();
        segments_.clear();
        hasMoved_.assign(before_.shapes.size(), {});
        for (std::size_t s = 0; s < document_.shapes.size(); ++s) {
            const Shape *const old = isSame(s) ? nullptr : unchangedList(s);
            if (old == nullptr || old == document_.shapes[s].get()) {
                continue;
            }
            const std::vector<Vec2> from = handlesOf(*old), to = handlesOf(*document_.shapes[s]);
            if (from == to || hasReorderedHandles(*old, *document_.shapes[s])) {
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

    /// Finds the handles that the command has moved.
    void findGiven() {
        for (std::size_t s = 0; s < document_.shapes.size(); ++s) {
            const Shape *const old = isSame(s) ? nullptr : unchangedList(s);
            if (old == nullptr || old == document_.shapes[s].get() || hasReorderedHandles(*old, *document_.shapes[s])) {
                continue;
            }
            const std::vector<Vec2> from = handlesOf(*old), to = handlesOf(*document_.shapes[s]);
            for (std::uint32_t k = 0; k < from.size(); ++k) {
                if (from[k] != to[k]) {
                    given_.insert({old->id, k});
                }
            }
        }
    }

    /// Puts nodes that were alone on a side of another shape, which has not moved, back on its sides. Where several
    /// nodes of a shape lie on one side, it is a border, and goes with them.
    void slideOnSides() {
        const std::set<NodeRef> given = given_;
        for (auto first = given.begin(); first != given.end();) {
            const auto last =
                std::find_if(first, given.end(), [&](NodeRef node) { return node.shape != first->shape; });
            slideOnSides({first, last});
            first = last;
        }
    }

    /// `given`: nodes of one shape.
    void slideOnSides(const std::set<NodeRef> &given) {
        const std::size_t s = positionOf(document_, given.begin()->shape);
        std::shared_ptr<const Shape> &place = document_.shapes[s];
        const std::vector<Vec2> from = handlesOf(*unchangedList(s)), now = handlesOf(*place);
        std::map<std::uint32_t, Vec2> targets;
        for (const NodeRef node : given) {
            const JointSegment *const side = sideUnder(node, from);
            if (side != nullptr) {
                targets.emplace(node.node, slideOn(*side, from[node.node], now[node.node]));
                given_.erase(node);
            }
        }
        if (!targets.empty()) {
            place = moved(*place, now, targets);
        }
    }

    /// Returns where a node on a side slides. Only nodes of open paths and points go round corners: the
    /// corner of a closed shape would leave a gap to what lies beyond.
    Vec2 slideOn(const JointSegment &side, Vec2 from, Vec2 to) {
        const Vec2 at = slideAlongSides(*before_.shapes[side.shape], side.side, to);
        if (alongSegment(side.a, side.b, at, index_.tolerance())) {
            return at;
        }
        std::set<NodeRef> nodes;
        bool canTurn = true;
        index_.handlesAt(from, [&](const JointHandle &handle) {
            const Shape &shape = *before_.shapes[handle.shape];
            canTurn = canTurn && (shape.isPolyline() || shape.is<PointForm>());
            nodes.insert({shape.id, handle.handle});
        });
        if (!canTurn) {
            return distance(at, side.a) < distance(at, side.b) ? side.a : side.b;
        }
        turned_.merge(nodes);
        return at;
    }

    /// Returns the side of another shape, which the command has not moved, that a node lies inside of, if no other
    /// moved node of its shape lies on it. `from`: the handles of the shape before. None if there is no such side.
    const JointSegment *sideUnder(NodeRef node, const std::vector<Vec2> &from) const {
        const JointSegment *const side = index_.segmentAt(from[node.node], [&](const JointSegment &candidate) {
            const Shape &shape = *before_.shapes[candidate.shape];
            const std::size_t s = position(document_, shape.id, candidate.shape);
            return shape.id != node.shape && s < document_.shapes.size() &&
                   handlesOf(*document_.shapes[s]) == handlesOf(shape);
        });
        const auto isOnSide = [&](std::uint32_t k) {
            return k != node.node && given_.contains({node.shape, k}) &&
                   alongSegment(side->a, side->b, from[k], index_.tolerance());
        };
        for (std::uint32_t k = 0; side != nullptr && k < from.size(); ++k) {
            if (isOnSide(k)) {
                return nullptr;
            }
        }
        return side;
    }

    const JointIndex &index_;
    const Document &before_;
    Document document_;
    std::set<NodeRef> given_;  ///< handles that the command has moved, without those that slide
    std::set<NodeRef> turned_; ///< see FollowedMove
    std::vector<MovedPlace> moved_;
    std::vector<MovedSegment> segments_;
    std::vector<std::vector<bool>> hasMoved_; ///< by position in before_ and handle; empty: none of the shape
};

} // namespace

Result<FollowedMove> followJoints(const JointIndex &index, Document after) {
    return JointMover(index, std::move(after)).run();
}

} // namespace forefront
