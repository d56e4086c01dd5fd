#include "core/drawing/constraints/sketch_joints.hpp"

#include "core/drawing/constraints/document_sketch.hpp"
#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace forefront {
namespace {

using Role = ShapeUnknown::Role;

SketchPart nodeOf(NodeRef handle) {
    return {handle.shape, SketchPartKind::Node, handle.node};
}

} // namespace

/// Follows joints from node to node, in two rounds. What moves with the sketch comes first. Then come the segments of
/// other shapes that its nodes lie on: these stay where they are if the sketch can do without moving them.
class JointFinder::Search {
  public:
    Search(DocumentSketch &sketch, const JointSource &source)
        : sketch_(sketch), source_(source), places_(*source.places), index_(places_) {
        for (const NodeRef handle : source.moved) {
            if (usable(handle.shape)) {
                enter(handle);
            }
        }
    }

    void find() {
        std::vector<NodeRef> named;
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            if (unknown.role <= Role::Y && canJoin(*findShape(sketch_.document(), unknown.shape)) &&
                usable(unknown.shape)) {
                named.push_back({unknown.shape, unknown.index});
            }
        }
        for (const NodeRef handle : named) {
            enter(handle);
        }
        followAll();
        while (!reached_.empty()) {
            const std::size_t before = sketch_.system.values.size();
            for (const NodeRef end : std::exchange(reached_, {})) {
                enter(end);
            }
            followAll();
            for (std::size_t k = before; k < sketch_.system.values.size(); ++k) {
                sketch_.standing.push_back(static_cast<std::uint32_t>(k));
            }
        }
    }

    void write() {
        findGiven();
        sketch_.system.firstJoint = sketch_.jointId(0);
        std::sort(found_.begin(), found_.end());
        found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
        for (const auto &[node, other] : found_) {
            const std::vector<SketchEquation> equations = equationsOf(node, other);
            if (!equations.empty()) {
                const auto at = handlesOf(*findShape(places_, node.shape))[node.index];
                for (const SketchEquation &equation : equations) {
                    sketch_.system.addEquation(equation, sketch_.jointId(sketch_.joints.size()));
                }
                sketch_.joints.push_back({node, other, at});
            }
        }
    }

  private:
    using Joint = std::pair<SketchPart, SketchPart>;

    /// Returns true if a shape has the same handles in the drawing of the joints and in that of the sketch.
    bool usable(std::uint32_t id) const {
        if (&places_ == &sketch_.document()) {
            return true;
        }
        const Shape *const here = findShape(places_, id), *const now = findShape(sketch_.document(), id);
        return here != nullptr && now != nullptr && here->form.index() == now->form.index() &&
               handleCount(*here) == handleCount(*now);
    }

    NodeRef refOf(std::size_t shape, std::uint32_t handle) const { return {places_.shapes[shape]->id, handle}; }

    /// Adds the unknowns of a node. Those of a corner of a rectangle are those of its neighbours, too.
    void enter(NodeRef handle) {
        const bool rectangle = findShape(sketch_.document(), handle.shape)->is<RectangleForm>();
        for (const std::uint32_t k : rectangle ? std::vector<std::uint32_t>{0, 1, 2, 3} : std::vector{handle.node}) {
            if (entered_.insert({handle.shape, k}).second) {
                sketch_.point(nodeOf({handle.shape, k}));
                queue_.push_back({handle.shape, k});
            }
        }
    }

    /// Follows all nodes that have come into the sketch, and those that come in on the way.
    void followAll() {
        for (std::size_t k = 0; k < queue_.size(); ++k) {
            follow(queue_[k]);
        }
        queue_.clear();
    }

    void follow(NodeRef handle) {
        const std::size_t position = positionOf(places_, handle.shape);
        const Shape &shape = *places_.shapes[position];
        const std::vector<Vec2> handles = handlesOf(shape);
        const Vec2 at = handles[handle.node];
        const NodeRef first = followNodes(handle, at, handles.size());
        followSegments(handle, at, position, first);
        const auto count = static_cast<std::uint32_t>(handles.size());
        const std::size_t sides = sideCount(shape);
        for (const std::uint32_t side : {handle.node == 0 ? count - 1 : handle.node - 1, handle.node}) {
            if (side < sides && isStraightSide(shape, side)) {
                followSide({position, side, handles[side], handles[(side + 1) % count]});
            }
        }
    }

    bool isApart(NodeRef handle) const { return source_.apart.contains(handle); }

    /// Brings in the nodes at the same place. Returns the first of them all.
    NodeRef followNodes(NodeRef handle, Vec2 at, std::size_t count) {
        NodeRef first = handle;
        std::vector<NodeRef> others;
        index_.handlesAt(at, [&](const JointHandle &found) {
            const NodeRef other = refOf(found.shape, found.handle);
            const std::size_t gap = other.node > handle.node ? other.node - handle.node : handle.node - other.node;
            const bool beside = other.shape == handle.shape && (gap <= 1 || gap + 1 == count); // ends of one segment
            if (!beside && isApart(other) == isApart(handle) && usable(other.shape)) {
                others.push_back(other);
                first = std::min(first, other);
            }
        });
        std::sort(others.begin(), others.end());
        for (const NodeRef other : others) {
            enter(other);
        }
        if (first != handle) {
            found_.emplace_back(nodeOf(first), nodeOf(handle));
        }
        return first;
    }

    /// Returns true if the nodes of a segment are as apart as another node.
    bool isWith(NodeRef handle, const JointSegment &segment) const {
        const auto [a, b] = endsOf(segment);
        return isApart(a) == isApart(handle) && isApart(b) == isApart(handle);
    }

    /// Returns the segments of other shapes that a node lies on, one of those that have the same ends.
    std::vector<JointSegment> segmentsUnder(NodeRef handle, Vec2 at, std::size_t position) const {
        std::vector<JointSegment> under;
        for (const JointSegment &segment : index_.segmentsAt(at)) {
            const auto same = [&](Vec2 p, Vec2 q) { return distance(p, q) <= index_.tolerance(); };
            const bool known = std::any_of(under.begin(), under.end(), [&](const JointSegment &other) {
                return (same(other.a, segment.a) && same(other.b, segment.b)) ||
                       (same(other.a, segment.b) && same(other.b, segment.a));
            });
            if (!known && segment.shape != position && usable(places_.shapes[segment.shape]->id) &&
                isWith(handle, segment)) {
                under.push_back(segment);
            }
        }
        return under;
    }

    std::pair<NodeRef, NodeRef> endsOf(const JointSegment &segment) const {
        const auto count = static_cast<std::uint32_t>(handleCount(*places_.shapes[segment.shape]));
        return {refOf(segment.shape, segment.side), refOf(segment.shape, (segment.side + 1) % count)};
    }

    void followSegments(NodeRef handle, Vec2 at, std::size_t position, NodeRef first) {
        for (const JointSegment &segment : segmentsUnder(handle, at, position)) {
            // Nodes at one place lie on one segment together; one equation says it for all of them.
            const auto [a, b] = endsOf(segment);
            if (first == handle || a.shape == first.shape) {
                reached_.insert(reached_.end(), {a, b});
                found_.emplace_back(nodeOf(handle), SketchPart{a.shape, SketchPartKind::Segment, segment.side});
            }
        }
    }

    /// Brings in the nodes of other shapes that lie on a segment.
    void followSide(const JointSegment &side) {
        std::vector<NodeRef> on;
        index_.handlesOn(side.a, side.b, [&](const JointHandle &found, double) {
            const NodeRef handle = refOf(found.shape, found.handle);
            if (found.shape != side.shape && usable(handle.shape) && isWith(handle, side)) {
                on.push_back(handle);
            }
        });
        std::sort(on.begin(), on.end());
        for (const NodeRef handle : on) {
            enter(handle);
        }
    }

    /// Finds the unknowns whose values are given.
    void findGiven() {
        given_ = sketch_.system.held;
        for (const SketchEquation &equation : sketch_.system.equations) {
            if (equation.kind == EquationKind::Value) {
                given_[equation.unknowns[0]] = true;
            }
        }
    }

    std::vector<SketchEquation> equationsOf(const SketchPart &node, const SketchPart &other) {
        const SketchPoint p = sketch_.point(node);
        if (other.kind == SketchPartKind::Node) {
            return sameEquations(p, sketch_.point(other));
        }
        const DocumentSketch::Ends line = sketch_.line(other);
        const std::array<std::uint32_t, 6> used = {p.x, p.y, line.a.x, line.a.y, line.b.x, line.b.y};
        const bool given = std::all_of(used.begin(), used.end(), [&](std::uint32_t k) { return given_[k]; });
        return given ? std::vector<SketchEquation>() : std::vector{makePointLine(p, line.a, line.b, 0.0, 1.0)};
    }

    std::vector<SketchEquation> sameEquations(SketchPoint p, SketchPoint q) const {
        std::vector<SketchEquation> equations;
        for (const auto &[a, b] : {std::pair(p.x, q.x), std::pair(p.y, q.y)}) {
            if (a == b) {
                continue;
            }
            if (!given_[a] || !given_[b]) {
                equations.push_back(makeEqual(a, b));
            } else if (std::fabs(sketch_.system.values[a] - sketch_.system.values[b]) > index_.tolerance()) {
                return {};
            }
        }
        return equations;
    }

    DocumentSketch &sketch_;
    const JointSource &source_;
    const Document &places_;
    JointIndex index_;
    std::set<NodeRef> entered_;
    std::vector<NodeRef> queue_;   ///< entered, to be followed
    std::vector<NodeRef> reached_; ///< ends of segments that nodes of the sketch lie on
    std::vector<Joint> found_;
    std::vector<bool> given_;
};

JointFinder::JointFinder(DocumentSketch &sketch, const JointSource &source)
    : search_(source.places != nullptr ? std::make_unique<Search>(sketch, source) : nullptr) {}
JointFinder::~JointFinder() = default;

void JointFinder::find() {
    if (search_) {
        search_->find();
    }
}

void JointFinder::write() {
    if (search_) {
        search_->write();
    }
}

} // namespace forefront
