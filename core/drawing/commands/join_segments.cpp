#include "core/drawing/commands/join_segments.hpp"

#include "core/drawing/picking/pick_index.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/box_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace forefront {
namespace {

/// A node of a shape on a segment of another one, or of its own, between the ends of the segment.
struct Meeting {
    SegmentRef segment;
    double t = 0.0; ///< parameter on the segment
    Vec2 node;
};

std::vector<Meeting> meetingsOf(const Document &document, const Shape &shape, double reach) {
    const PickIndex index(std::make_shared<const Document>(document));
    const auto others = [&](const Shape &other) { return other.id != shape.id; };
    std::vector<Meeting> meetings;
    for (const Vec2 node : outlineOf(shape).nodes) {
        const auto hit = index.segment(node, reach, others);
        if (!hit) {
            continue;
        }
        const bool circle = findShape(document, hit->ref.shape)->is<CircleForm>(); // has no ends
        if (circle || (distance(node, hit->a) > reach && distance(node, hit->b) > reach)) {
            meetings.push_back({hit->ref, hit->t, node});
        }
    }
    return meetings;
}

/// Returns where nodes of a path lie on its own segments.
std::vector<Meeting> ownMeetingsOf(const Shape &shape, double reach) {
    const Outline outline = outlineOf(shape);
    std::vector<Box2> boxes;
    boxes.reserve(outline.segmentCount());
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        boxes.push_back(outline.curve(k).bounds().grown(reach));
    }
    const BoxTree tree(boxes);
    std::vector<Meeting> meetings;
    for (const Vec2 node : outline.nodes) {
        tree.query({node, node}, [&](std::uint32_t k) {
            // Segments that begin or end at the node are left out with it.
            const bool atEnd = distance(node, outline.from(k)) <= reach || distance(node, outline.to(k)) <= reach;
            const Curve curve = outline.curve(k);
            const double t = curve.nearest(node);
            if (!atEnd && distance(curve.point(t), node) <= reach) {
                meetings.push_back({{shape.id, outline.part(k)}, t, node});
            }
        });
    }
    return meetings;
}

/// Converts the shapes that are touched to paths, so that nodes can be inserted into exactly the segments touched.
Document withPaths(Document document, const std::vector<Meeting> &meetings) {
    for (const Meeting &meeting : meetings) {
        const Shape *shape = findShape(document, meeting.segment.shape);
        if (isPath(*shape)) {
            continue;
        }
        if (Result<Document> next = convertToPath(document, shape->id)) {
            document = *std::move(next);
        }
    }
    return document;
}

} // namespace

Document joinToSegments(const Document &document, std::uint32_t id) {
    const Shape *shape = findShape(document, id);
    const double reach = samePlaceDistance(document);
    if (shape == nullptr || isRound(*shape) || !(reach > 0.0)) {
        return document;
    }
    Document joined = withPaths(document, meetingsOf(document, *shape, reach));
    std::vector<Meeting> meetings = meetingsOf(joined, *shape, reach);
    if (isPath(*shape)) {
        const std::vector<Meeting> own = ownMeetingsOf(*shape, reach);
        meetings.insert(meetings.end(), own.begin(), own.end());
    }
    // From the last segment to the first, and backwards along each, so that insertions do not shift later places.
    std::sort(meetings.begin(), meetings.end(),
              [](const Meeting &a, const Meeting &b) { return std::tie(b.segment, b.t) < std::tie(a.segment, a.t); });
    for (const Meeting &meeting : meetings) {
        if (Result<Document> next = insertNode(joined, meeting.segment, meeting.node)) {
            joined = *std::move(next);
        }
    }
    return joined;
}

} // namespace forefront
