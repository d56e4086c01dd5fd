#include "core/drawing/arrangement/assembly/face_points.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

/// Returns the gaps between the heights of the nodes, the tallest first: lines through them have the most room.
std::vector<std::pair<double, double>> tallestGaps(std::span<const FaceEdge> edges, std::size_t limit) {
    std::vector<double> heights;
    heights.reserve(2 * edges.size());
    for (const FaceEdge &edge : edges) {
        heights.push_back(edge.a.y);
        heights.push_back(edge.b.y);
    }
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    std::vector<std::pair<double, double>> gaps; // height, lower end
    for (std::size_t k = 1; k < heights.size(); ++k) {
        gaps.emplace_back(heights[k] - heights[k - 1], heights[k - 1]);
    }
    const auto kept = static_cast<std::ptrdiff_t>(std::min(limit, gaps.size()));
    std::partial_sort(gaps.begin(), gaps.begin() + kept, gaps.end(), [](const auto &s, const auto &t) {
        return s.first != t.first ? s.first > t.first : s.second < t.second;
    });
    gaps.resize(static_cast<std::size_t>(kept));
    return gaps;
}

/// Returns width and middle of the widest part of the face along the line at this height, at which no node lies.
std::pair<double, double> widestStretch(std::span<const FaceEdge> edges, double height) {
    std::vector<std::pair<double, bool>> crossings;
    for (const FaceEdge &edge : edges) {
        if ((edge.a.y < height) != (edge.b.y < height)) {
            const double t = (height - edge.a.y) / (edge.b.y - edge.a.y);
            crossings.emplace_back(edge.a.x + t * (edge.b.x - edge.a.x), edge.twice);
        }
    }
    std::sort(crossings.begin(), crossings.end());
    std::pair<double, double> best{0.0, 0.0};
    bool inside = false;
    for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
        inside = inside != !crossings[k].second;
        const double width = crossings[k + 1].first - crossings[k].first;
        if (inside && width > best.first) {
            best = {width, crossings[k].first + 0.5 * width};
        }
    }
    return best;
}

} // namespace

std::optional<Vec2> pointInFace(std::span<const FaceEdge> edges) {
    constexpr std::size_t kLines = 8;
    double room = 0.0;
    Vec2 best;
    for (const auto &[gap, low] : tallestGaps(edges, kLines)) {
        const double height = low + 0.5 * gap;
        const auto [width, middle] = widestStretch(edges, height);
        if (std::min(width, gap) > room) {
            room = std::min(width, gap);
            best = {middle, height};
        }
    }
    return room > 0.0 ? std::optional(best) : std::nullopt;
}

} // namespace forefront
