#include "core/edit/box_tree.hpp"

#include <numeric>

namespace forefront {
namespace {

/// Interleaves the lower 16 bits with zeros.
std::uint32_t spread(std::uint32_t v) {
    v &= 0xffffU;
    v = (v | (v << 8)) & 0x00ff00ffU;
    v = (v | (v << 4)) & 0x0f0f0f0fU;
    v = (v | (v << 2)) & 0x33333333U;
    return (v | (v << 1)) & 0x55555555U;
}

std::uint32_t lattice(double value, double low, double extent) {
    const double t = extent > 0.0 ? (value - low) / extent * 65535.0 : 0.0;
    return t >= 0.0 ? static_cast<std::uint32_t>(std::min(t, 65535.0)) : 0U; // a NaN goes to 0
}

} // namespace

BoxTree::BoxTree(std::span<const Box2> boxes) {
    Box2 all;
    for (const Box2 &box : boxes) {
        if (isFinite(box.min) && isFinite(box.max)) {
            all.add(box.centre());
        }
    }
    const Vec2 extent = all.empty() ? Vec2{} : all.size();
    std::vector<std::uint32_t> keys(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const Vec2 centre = boxes[k].centre();
        keys[k] = spread(lattice(centre.x, all.min.x, extent.x)) | spread(lattice(centre.y, all.min.y, extent.y)) << 1;
    }
    items_.resize(boxes.size());
    std::iota(items_.begin(), items_.end(), 0U);
    std::stable_sort(items_.begin(), items_.end(), [&](auto a, auto b) { return keys[a] < keys[b]; });

    if (items_.empty()) {
        return;
    }
    levels_.emplace_back();
    levels_.back().reserve(items_.size());
    for (const std::uint32_t item : items_) {
        levels_.back().push_back(boxes[item]);
    }
    while (levels_.back().size() > kFan) {
        const std::vector<Box2> &below = levels_.back();
        std::vector<Box2> level((below.size() + kFan - 1) / kFan);
        for (std::size_t k = 0; k < below.size(); ++k) {
            level[k / kFan].add(below[k]);
        }
        levels_.push_back(std::move(level));
    }
}

} // namespace forefront
