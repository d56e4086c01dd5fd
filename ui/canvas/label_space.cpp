#include "ui/canvas/label_space.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace forefront {
namespace {

/// Clips the segment from a to b to a rectangle. Returns false if nothing is left.
bool clip(const PixelRect &rect, Pixel &a, Pixel &b) {
    const Pixel d = b - a;
    double t0 = 0.0, t1 = 1.0;
    for (const auto &[step, room] : {std::pair(-d.x, a.x - rect.x), std::pair(d.x, rect.x + rect.width - a.x),
                                     std::pair(-d.y, a.y - rect.y), std::pair(d.y, rect.y + rect.height - a.y)}) {
        if (step == 0.0 && room < 0.0) {
            return false;
        }
        if (step < 0.0) {
            t0 = std::max(t0, room / step);
        } else if (step > 0.0) {
            t1 = std::min(t1, room / step);
        }
    }
    const Pixel from = a;
    a = from + t0 * d;
    b = from + t1 * d;
    return t0 <= t1;
}

} // namespace

bool meets(const PixelRect &rect, Pixel a, Pixel b) {
    return clip(rect, a, b);
}

void LabelSpace::open(const PixelRect &room, double cell) {
    room_ = room;
    cell_ = cell;
    columns_ = static_cast<std::size_t>(std::max(0.0, room.width) / cell) + 1;
    rows_ = static_cast<std::size_t>(std::max(0.0, room.height) / cell) + 1;
}

void LabelSpace::takeLine(Pixel a, Pixel b) {
    if (!room_ || !clip(*room_, a, b)) {
        return;
    }
    if (lineCells_.empty()) {
        lineCells_.resize(columns_ * rows_);
    }
    const auto steps = static_cast<int>(std::ceil(glm::distance(a, b) / (0.5 * cell_)));
    for (int k = 0; k <= steps; ++k) {
        const Pixel p = glm::mix(a, b, steps > 0 ? static_cast<double>(k) / steps : 0.0);
        const auto column = static_cast<std::size_t>(std::max(0.0, (p.x - room_->x) / cell_));
        const auto row = static_cast<std::size_t>(std::max(0.0, (p.y - room_->y) / cell_));
        lineCells_[std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1)] = 1;
    }
}

bool LabelSpace::holds(Pixel p) const {
    return !room_ ||
           (p.x >= room_->x && p.x <= room_->x + room_->width && p.y >= room_->y && p.y <= room_->y + room_->height);
}

PixelRect LabelSpace::inside(PixelRect rect) const {
    if (room_) {
        rect.x = std::max(room_->x, std::min(rect.x, room_->x + room_->width - rect.width));
        rect.y = std::max(room_->y, std::min(rect.y, room_->y + room_->height - rect.height));
    }
    return rect;
}

bool LabelSpace::isFree(const PixelRect &rect, bool lines) const {
    const bool within = holds({rect.x, rect.y}) && holds({rect.x + rect.width, rect.y + rect.height});
    return within && std::none_of(taken_.begin(), taken_.end(), [&](const PixelRect &t) { return rect.overlaps(t); }) &&
           !(lines && coversLine(rect));
}

bool LabelSpace::coversLine(const PixelRect &rect) const {
    if (lineCells_.empty()) {
        return false;
    }
    const auto cellOf = [&](double way, std::size_t count) {
        return std::min(static_cast<std::size_t>(std::max(0.0, way / cell_)), count - 1);
    };
    const double rim = 0.25 * cell_; // takeLine() may miss a cell of which a line only cuts off a corner
    const std::size_t left = cellOf(rect.x - rim - room_->x, columns_);
    const std::size_t right = cellOf(rect.x + rect.width + rim - room_->x, columns_);
    const std::size_t last = cellOf(rect.y + rect.height + rim - room_->y, rows_);
    for (std::size_t row = cellOf(rect.y - rim - room_->y, rows_); row <= last; ++row) {
        const auto begin = lineCells_.begin() + static_cast<std::ptrdiff_t>(row * columns_);
        if (std::any_of(begin + static_cast<std::ptrdiff_t>(left), begin + static_cast<std::ptrdiff_t>(right) + 1,
                        [](std::uint8_t taken) { return taken != 0; })) {
            return true;
        }
    }
    return false;
}

} // namespace forefront
