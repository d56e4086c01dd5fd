#include "core/engine/geometry/edge_meetings.hpp"

#include "core/engine/geometry/box_tree.hpp"

#include <algorithm>

namespace forefront {

namespace {

constexpr std::size_t kMaxTests = 20'000'000; // a second or so

/// Returns true if a box meets the segment ab. Exact.
bool meetsSegment(const Box2 &box, Vec2 a, Vec2 b) {
    if (!box.overlaps(boxOf(a, b))) {
        return false;
    }
    const int side = orientation(a, b, box.min);
    return side == 0 || orientation(a, b, box.max) != side || orientation(a, b, {box.min.x, box.max.y}) != side ||
           orientation(a, b, {box.max.x, box.min.y}) != side;
}

BoxTree treeOf(std::span<const Vec2> points, std::span<const PlaneEdge> edges) {
    std::vector<Box2> boxes;
    boxes.reserve(edges.size());
    for (const PlaneEdge &edge : edges) {
        boxes.push_back(boxOf(points[edge.a], points[edge.b]));
    }
    return BoxTree(boxes);
}

} // namespace

EdgeMeetings findMeetings(std::span<const Vec2> points, std::span<const PlaneEdge> edges,
                          std::span<const std::uint32_t> queries, std::size_t limit) {
    EdgeMeetings result;
    if (queries.empty()) {
        return result;
    }
    const BoxTree tree = treeOf(points, edges);
    std::vector<std::uint8_t> isQuery(edges.size(), 0);
    for (const std::uint32_t e : queries) {
        isQuery[e] = 1;
    }
    std::size_t tests = 0;
    for (const std::uint32_t e : queries) {
        const Vec2 a = points[edges[e].a], b = points[edges[e].b];
        const auto meetsQuery = [&](const Box2 &box) { return meetsSegment(box, a, b); };
        result.complete = tree.search(meetsQuery, [&](std::uint32_t f) {
            if (f == e || (isQuery[f] != 0 && f < e)) { // a pair of queries is found once
                return true;
            }
            const SegmentMeeting kind = meet(a, b, points[edges[f].a], points[edges[f].b]);
            if (kind != SegmentMeeting::Apart && kind != SegmentMeeting::SharedEnd) {
                result.list.push_back({std::min(e, f), std::max(e, f), kind});
            }
            return ++tests < kMaxTests && result.list.size() < limit;
        });
        if (!result.complete) {
            break;
        }
    }
    std::sort(result.list.begin(), result.list.end(), [](const EdgeMeeting &s, const EdgeMeeting &t) {
        return s.first != t.first ? s.first < t.first : s.second < t.second;
    });
    return result;
}

Vec2 crossingPoint(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Vec2 u = b - a, v = d - c;
    const double determinant = cross(u, v);
    const double t = determinant != 0.0 ? cross(c - a, v) / determinant : 0.5;
    const Vec2 p = lerp(a, b, std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0.5);
    // Clamped to the boxes of both segments, however ill-conditioned the crossing is.
    const Box2 first = boxOf(a, b), second = boxOf(c, d);
    return {std::clamp(p.x, std::max(first.min.x, second.min.x), std::min(first.max.x, second.max.x)),
            std::clamp(p.y, std::max(first.min.y, second.min.y), std::min(first.max.y, second.max.y))};
}

} // namespace forefront
