#include "ui/canvas/dimension_room.hpp"

#include "ui/canvas/label_space.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace forefront {

bool DimensionRoom::runsAlong(const Line &line, Pixel a, Pixel b) const {
    const double size = glm::distance(line.a, line.b);
    if (size == 0.0) {
        return false;
    }
    const Pixel along = (line.b - line.a) / size, normal{-along.y, along.x}, way = b - a;
    constexpr double kParallel = 0.1; // sine of the angle
    if (std::abs(glm::dot(way, normal)) > kParallel * glm::length(way)) {
        return false;
    }
    const double aside = glm::dot(0.5 * (a + b) - line.a, normal);
    const double from = glm::dot(a - line.a, along), to = glm::dot(b - line.a, along);
    return std::abs(aside) < gap_ && std::min(from, to) < size && std::max(from, to) > 0.0;
}

bool DimensionRoom::isLineFree(Pixel a, Pixel b) const {
    return std::none_of(lines_.begin(), lines_.end(), [&](const Line &line) { return runsAlong(line, a, b); });
}

bool DimensionRoom::isTextFree(const PixelRect &rect) const {
    const auto free = [&](const std::vector<Line> &lines) {
        return std::none_of(lines.begin(), lines.end(), [&](const Line &line) { return meets(rect, line.a, line.b); });
    };
    return free(lines_) && free(sides_);
}

} // namespace forefront
