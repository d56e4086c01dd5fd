#include "core/geometry/edge_meetings.hpp"

#include <algorithm>

namespace forefront {

namespace {

constexpr std::size_t kFanOut = 8;
constexpr std::size_t kMostTests = 20'000'000; // a second or so

/// Bits of x and y (16 each) interleaved.
std::uint32_t mortonCode(std::uint32_t x, std::uint32_t y) {
    const auto spread = [](std::uint32_t v) {
        v = (v | (v << 8)) & 0x00ff00ffU;
        v = (v | (v << 4)) & 0x0f0f0f0fU;
        v = (v | (v << 2)) & 0x33333333U;
        return (v | (v << 1)) & 0x55555555U;
    };
    return spread(x) | (spread(y) << 1);
}

/// Boxes of edges in the order of a space-filling curve, packed level upon level.
class BoxTree {
  public:
    BoxTree(std::span<const Vec2> points, std::span<const PlaneEdge> edges) : edges_(edges.size()) {
        std::vector<Box2> boxes(edges.size());
        Box2 whole;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            boxes[e] = boxOf(points[edges[e].a], points[edges[e].b]);
            whole.add(boxes[e]);
        }
        std::vector<std::pair<std::uint32_t, std::uint32_t>> keys(edges.size());
        for (std::size_t e = 0; e < edges.size(); ++e) {
            keys[e] = {mortonCode(step(boxes[e].min.x, boxes[e].max.x, whole.min.x, whole.max.x),
                                  step(boxes[e].min.y, boxes[e].max.y, whole.min.y, whole.max.y)),
                       static_cast<std::uint32_t>(e)};
        }
        std::sort(keys.begin(), keys.end());
        levels_.emplace_back();
        for (std::size_t i = 0; i < keys.size(); ++i) {
            edges_[i] = keys[i].second;
            levels_[0].push_back(boxes[edges_[i]]);
        }
        while (levels_.back().size() > 1) {
            const std::vector<Box2> &lower = levels_.back();
            std::vector<Box2> upper((lower.size() + kFanOut - 1) / kFanOut);
            for (std::size_t i = 0; i < lower.size(); ++i) {
                upper[i / kFanOut].add(lower[i]);
            }
            levels_.push_back(std::move(upper));
        }
    }

    /// Calls visit(edge) for every edge whose box meets the segment ab; visit returns false to stop.
    template <class Visit>
    bool search(Vec2 a, Vec2 b, const Visit &visit) const {
        return edges_.empty() || search(levels_.size() - 1, 0, a, b, visit);
    }

  private:
    /// Position of the middle of [low, high] within the whole, in 0..65535.
    static std::uint32_t step(double low, double high, double least, double greatest) {
        const double extent = 0.5 * greatest - 0.5 * least;
        const double part = extent > 0.0 ? (0.25 * low + 0.25 * high - 0.5 * least) / extent : 0.0;
        return static_cast<std::uint32_t>(std::clamp(part, 0.0, 1.0) * 65535.0);
    }
    static bool meets(const Box2 &box, Vec2 a, Vec2 b) {
        if (!box.overlaps(boxOf(a, b))) {
            return false;
        }
        const int side = orientation(a, b, box.min);
        return side == 0 || orientation(a, b, box.max) != side || orientation(a, b, {box.min.x, box.max.y}) != side ||
               orientation(a, b, {box.max.x, box.min.y}) != side;
    }
    template <class Visit>
    bool search(std::size_t level, std::size_t i, Vec2 a, Vec2 b, const Visit &visit) const {
        if (!meets(levels_[level][i], a, b)) {
            return true;
        }
        if (level == 0) {
            return visit(edges_[i]);
        }
        const std::size_t last = std::min(levels_[level - 1].size(), (i + 1) * kFanOut);
        for (std::size_t child = i * kFanOut; child < last; ++child) {
            if (!search(level - 1, child, a, b, visit)) {
                return false;
            }
        }
        return true;
    }

    std::vector<std::uint32_t> edges_;
    std::vector<std::vector<Box2>> levels_; // the first one: boxes of single edges
};

} // namespace

EdgeMeetings findMeetings(std::span<const Vec2> points, std::span<const PlaneEdge> edges,
                          std::span<const std::uint32_t> queries, std::size_t most) {
    EdgeMeetings result;
    if (queries.empty()) {
        return result;
    }
    const BoxTree tree(points, edges);
    std::vector<std::uint8_t> isQuery(edges.size(), 0);
    for (const std::uint32_t e : queries) {
        isQuery[e] = 1;
    }
    std::size_t tests = 0;
    for (const std::uint32_t e : queries) {
        const Vec2 a = points[edges[e].a], b = points[edges[e].b];
        result.complete = tree.search(a, b, [&](std::uint32_t f) {
            if (f == e || (isQuery[f] != 0 && f < e)) { // a pair of queries is found once
                return true;
            }
            const SegmentMeeting kind = meet(a, b, points[edges[f].a], points[edges[f].b]);
            if (kind != SegmentMeeting::Apart && kind != SegmentMeeting::SharedEnd) {
                result.list.push_back({std::min(e, f), std::max(e, f), kind});
            }
            return ++tests < kMostTests && result.list.size() < most;
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
    // Never outside of what both segments cover, however ill-conditioned the crossing is.
    const Box2 first = boxOf(a, b), second = boxOf(c, d);
    return {std::clamp(p.x, std::max(first.min.x, second.min.x), std::min(first.max.x, second.max.x)),
            std::clamp(p.y, std::max(first.min.y, second.min.y), std::min(first.max.y, second.max.y))};
}

} // namespace forefront
