#include "core/drawing/joints/joint_index.hpp"

#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <limits>

namespace forefront {

bool canJoin(const Shape &shape) {
    return isPath(shape) || shape.is<RectangleForm>() || shape.is<PointForm>();
}

bool hasReorderedHandles(const Shape &before, const Shape &after) {
    std::vector<Vec2> from = handlesOf(before), to = handlesOf(after);
    if (from == to) {
        return false;
    }
    std::sort(from.begin(), from.end(), comesBefore);
    std::sort(to.begin(), to.end(), comesBefore);
    return from == to;
}

std::optional<double> alongSegment(Vec2 a, Vec2 b, Vec2 p, double tolerance) {
    const double squared = lengthSquared(b - a);
    const double t = squared > 0.0 ? std::clamp(dot(p - a, b - a) / squared, 0.0, 1.0) : 0.0;
    return distance(p, a + t * (b - a)) <= tolerance ? std::optional(t) : std::nullopt;
}

std::size_t sideCount(const Shape &shape) {
    const bool rounded = shape.is<RectangleForm>() && shape.as<RectangleForm>().radius > 0.0;
    if (rounded || !(isPath(shape) || shape.is<RectangleForm>())) {
        return 0;
    }
    const std::size_t count = handleCount(shape);
    return isClosed(shape) || count == 0 ? count : count - 1;
}

bool isStraightSide(const Shape &shape, std::size_t k) {
    return !isPath(shape) || shape.path().curves.empty() || shape.path().curves[k] == Curve();
}

JointIndex::JointIndex(const Document &document)
    : JointIndex(document, {{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()},
                            {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}}) {}

JointIndex::JointIndex(const Document &document, const Box2 &within)
    : document_(document), tolerance_(samePlaceDistance(document)) {
    const Box2 box = within.grown(tolerance_);
    for (std::size_t s = 0; s < document.shapes.size(); ++s) {
        const Shape &shape = *document.shapes[s];
        if (canJoin(shape)) {
            isPath(shape) ? addShape(s, shape.nodes, box) : addShape(s, handlesOf(shape), box);
        }
    }
    build();
}

void JointIndex::addShape(std::size_t shape, const std::vector<Vec2> &handles, const Box2 &within) {
    const Shape &of = *document_.shapes[shape];
    const std::size_t sides = sideCount(of);
    for (std::uint32_t k = 0; k < handles.size(); ++k) {
        if (within.contains(handles[k])) {
            handles_.push_back({shape, k, handles[k]});
        }
        const Vec2 next = handles[k + 1 < handles.size() ? k + 1 : 0];
        if (k < sides && boxOf(handles[k], next).overlaps(within) && isStraightSide(of, k)) {
            segments_.push_back({shape, k, handles[k], next});
        }
    }
}

void JointIndex::build() {
    std::vector<Box2> boxes;
    boxes.reserve(std::max(handles_.size(), segments_.size()));
    for (const JointHandle &handle : handles_) {
        boxes.push_back({handle.at, handle.at});
    }
    handleTree_ = BoxTree(boxes);
    boxes.clear();
    for (const JointSegment &segment : segments_) {
        boxes.push_back(boxOf(segment.a, segment.b));
    }
    segmentTree_ = BoxTree(boxes);
}

std::vector<JointSegment> JointIndex::segmentsAt(Vec2 p) const {
    std::vector<std::uint32_t> found;
    segmentTree_.query(Box2{p, p}.grown(tolerance_), [&](std::uint32_t k) {
        if (liesInside(segments_[k], p)) {
            found.push_back(k);
        }
    });
    std::sort(found.begin(), found.end());
    std::vector<JointSegment> segments;
    segments.reserve(found.size());
    for (const std::uint32_t k : found) {
        segments.push_back(segments_[k]);
    }
    return segments;
}

} // namespace forefront
