#include "core/drawing/constraints/joint_search.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cstddef>

namespace forefront {
namespace {

SketchPart nodeOf(NodeRef handle) {
    return {handle.shape, SketchPartKind::Node, handle.node};
}

} // namespace

JointSearch::JointSearch(const Document &document, const JointSource &source)
    : document_(document), places_(*source.places), source_(source) {
    for (const SketchPart &part : source.moved) {
        if (part.kind == SketchPartKind::Node) {
            addNode({part.shape, part.index});
        } else {
            addCurve(part);
        }
    }
}

bool JointSearch::usable(std::uint32_t id) const {
    if (&places_ == &document_) {
        return true;
    }
    const Shape *const here = findShape(places_, id), *const now = findShape(document_, id);
    return here != nullptr && now != nullptr && here->form.index() == now->form.index() &&
           handleCount(*here) == handleCount(*now);
}

void JointSearch::addNode(NodeRef node) {
    if (usable(node.shape) && canJoin(*findShape(places_, node.shape))) {
        nodes_.insert(node);
    }
}

void JointSearch::addCurve(const SketchPart &segment) {
    const Shape *const shape = findShape(places_, segment.shape);
    if (usable(segment.shape) && shape != nullptr && isPath(*shape) && segment.index < shape->path().curves.size()) {
        curves_.insert(segment);
    }
}

void JointSearch::run() {
    for (const NodeRef node : nodes_) {
        const std::vector<Vec2> handles = handlesOf(*findShape(places_, node.shape));
        box_.add(handles[node.node]);
        box_.add(handles[(node.node + 1) % handles.size()]);
        box_.add(handles[node.node == 0 ? handles.size() - 1 : node.node - 1]);
    }
    for (const SketchPart &curve : curves_) {
        box_.add(findShape(places_, curve.shape)->nodes[curve.index]);
    }
    if (box_.empty()) {
        return;
    }
    // Joints mostly lead no farther. Where they do, the search begins again in a larger box.
    for (bool covered = false; !covered;) {
        index_.emplace(places_, box_);
        reach_ = box_;
        search();
        covered = reach_ == box_;
        box_ = reach_.grown(0.5 * reach_.diagonal());
    }
}

void JointSearch::search() {
    entered_.clear();
    queue_.clear();
    under_.clear();
    parts_.clear();
    joints_.clear();
    standing_ = false;
    for (const NodeRef node : nodes_) {
        enter(node);
    }
    for (const SketchPart &curve : curves_) {
        enterCurve(curve);
    }
    followAll();
    standing_ = true;
    while (!under_.empty()) {
        for (const NodeRef end : std::exchange(under_, {})) {
            enter(end);
        }
        followAll();
    }
    std::sort(joints_.begin(), joints_.end());
    joints_.erase(std::unique(joints_.begin(), joints_.end()), joints_.end());
}

/// Enters a node. The corners of a rectangle depend on one another.
void JointSearch::enter(NodeRef handle) {
    const bool rectangle = findShape(places_, handle.shape)->is<RectangleForm>();
    for (const std::uint32_t k : rectangle ? std::vector<std::uint32_t>{0, 1, 2, 3} : std::vector{handle.node}) {
        const SketchPart part = nodeOf({handle.shape, k});
        if (entered_.insert(part).second) {
            queue_.push_back(part);
            parts_.push_back({part, standing_});
        }
    }
}

void JointSearch::enterCurve(const SketchPart &segment) {
    const PartForm form = formOfPart(document_, segment);
    if ((form == PartForm::Circle || form == PartForm::Cubic) && form == formOfPart(places_, segment) &&
        entered_.insert(segment).second) {
        queue_.push_back(segment);
        parts_.push_back({segment, standing_});
        const auto count = static_cast<std::uint32_t>(handleCount(*findShape(places_, segment.shape)));
        enter({segment.shape, segment.index});
        enter({segment.shape, (segment.index + 1) % count});
    }
}

void JointSearch::followAll() {
    for (std::size_t k = 0; k < queue_.size(); ++k) {
        const SketchPart part = queue_[k]; // a copy, since the queue grows
        part.kind == SketchPartKind::Node ? follow({part.shape, part.index}) : followCurve(part);
    }
    queue_.clear();
}

void JointSearch::follow(NodeRef handle) {
    const std::size_t position = positionOf(places_, handle.shape);
    const Shape &shape = *places_.shapes[position];
    const std::vector<Vec2> handles = handlesOf(shape);
    const Vec2 at = handles[handle.node];
    reach_.add(at);
    const auto count = static_cast<std::uint32_t>(handles.size());
    const std::size_t sides = sideCount(shape);
    const NodeRef first = followNodes(handle, at, count, sides == count);
    followSegments(handle, at, position, first);
    for (const std::uint32_t side : {handle.node == 0 ? count - 1 : handle.node - 1, handle.node}) {
        if (side < sides && isStraightSide(shape, side)) {
            reach_.add(handles[side]);
            reach_.add(handles[(side + 1) % count]);
            followSide({position, side, handles[side], handles[(side + 1) % count]});
        }
    }
}

/// Brings in the nodes at the same place. Returns the first of them all.
NodeRef JointSearch::followNodes(NodeRef handle, Vec2 at, std::size_t count, bool isClosed) {
    NodeRef first = handle;
    std::vector<NodeRef> others;
    index_->handlesAt(at, [&](const JointHandle &found) {
        const NodeRef other = refOf(found.shape, found.handle);
        const std::size_t gap = other.node > handle.node ? other.node - handle.node : handle.node - other.node;
        const bool beside =
            other.shape == handle.shape && (gap <= 1 || (gap + 1 == count && isClosed)); // ends of one segment
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
        joints_.emplace_back(nodeOf(first), nodeOf(handle));
    }
    return first;
}

std::pair<NodeRef, NodeRef> JointSearch::endsOf(const JointSegment &segment) const {
    const auto count = static_cast<std::uint32_t>(handleCount(*places_.shapes[segment.shape]));
    return {refOf(segment.shape, segment.side), refOf(segment.shape, (segment.side + 1) % count)};
}

/// Returns true if the nodes of a segment are as apart as another node.
bool JointSearch::isWith(NodeRef handle, const JointSegment &segment) const {
    const auto [a, b] = endsOf(segment);
    return isApart(a) == isApart(handle) && isApart(b) == isApart(handle);
}

/// Returns the segments of other shapes that a node lies on, one of those that have the same ends.
std::vector<JointSegment> JointSearch::segmentsUnder(NodeRef handle, Vec2 at, std::size_t position) const {
    std::vector<JointSegment> under;
    for (const JointSegment &segment : index_->segmentsAt(at)) {
        const auto same = [&](Vec2 p, Vec2 q) { return distance(p, q) <= index_->tolerance(); };
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

void JointSearch::followSegments(NodeRef handle, Vec2 at, std::size_t position, NodeRef first) {
    for (const JointSegment &segment : segmentsUnder(handle, at, position)) {
        // Nodes at one place lie on one segment together; one equation says it for all of them.
        const auto [a, b] = endsOf(segment);
        if (first == handle || a.shape == first.shape) {
            under_.insert(under_.end(), {a, b});
            joints_.emplace_back(nodeOf(handle), SketchPart{a.shape, SketchPartKind::Segment, segment.side});
        }
    }
}

/// Brings in the nodes of other shapes that lie on a segment.
void JointSearch::followSide(const JointSegment &side) {
    std::vector<NodeRef> on;
    index_->handlesOn(side.a, side.b, [&](const JointHandle &found, double) {
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

/// Brings in the curved segments of other shapes that lie on one.
void JointSearch::followCurve(const SketchPart &part) {
    const Shape &shape = *findShape(places_, part.shape);
    const auto count = static_cast<std::uint32_t>(shape.nodes.size());
    const NodeRef a{part.shape, part.index}, b{part.shape, (part.index + 1) % count};
    std::vector<SketchPart> same;
    index_->handlesAt(shape.nodes[a.node], [&](const JointHandle &found) {
        const Shape &other = *places_.shapes[found.shape];
        if (other.id == shape.id || !usable(other.id) || !isPath(other) || other.path().curves.empty() ||
            isApart({other.id, found.handle}) != isApart(a)) {
            return;
        }
        const auto last = static_cast<std::uint32_t>(other.nodes.size() - 1);
        for (const std::uint32_t k : {found.handle, found.handle == 0 ? last : found.handle - 1}) {
            const std::uint32_t end = k == found.handle ? (k + 1) % (last + 1) : k;
            const bool beside = k < sideCount(other) && isApart({other.id, end}) == isApart(b) &&
                                distance(other.nodes[end], shape.nodes[b.node]) <= index_->tolerance();
            if (beside && isSame(shape.path().curves[part.index], other.path().curves[k])) {
                same.push_back({other.id, SketchPartKind::Segment, k});
            }
        }
    });
    std::sort(same.begin(), same.end());
    for (const SketchPart &other : same) {
        enterCurve(other);
        if (entered_.contains(other)) {
            joints_.emplace_back(std::min(part, other), std::max(part, other));
        }
    }
}

bool JointSearch::isSame(const Curve &a, const Curve &b) const {
    constexpr double kAside = 0.3; // to tell curves apart that meet in the middle
    return a.kind() == b.kind() && distance(a.point(0.5), b.point(0.5)) <= index_->tolerance() &&
           distance(a.point(kAside), b.point(b.nearest(a.point(kAside)))) <= index_->tolerance();
}

} // namespace forefront
