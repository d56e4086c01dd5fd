#include "core/geometry/box_tree.hpp"

#include "core/base/key_order.hpp"

namespace forefront {
namespace {

/// Interleaves the lower 16 bits with zeros.
std::uint32_t spread(std::uint32_t v) {
    v = (v | (v << 8)) & 0x00ff00ffU;
    v = (v | (v << 4)) & 0x0f0f0f0fU;
    v = (v | (v << 2)) & 0x33333333U;
    return (v | (v << 1)) & 0x55555555U;
}

/// Returns the position of the middle of [low, high] within the whole range, in 0..65535. Uses halves and quarters, so
/// that nothing overflows.
std::uint32_t step(double low, double high, double wholeLow, double wholeHigh) {
    const double extent = 0.5 * wholeHigh - 0.5 * wholeLow;
    const double part = extent > 0.0 ? (0.25 * low + 0.25 * high - 0.5 * wholeLow) / extent : 0.0;
    return part >= 0.0 ? static_cast<std::uint32_t>(std::min(part, 1.0) * 65535.0) : 0U; // a NaN goes to 0
}

std::vector<std::uint64_t> mortonCodes(std::span<const Box2> boxes) {
    Box2 whole;
    for (const Box2 &box : boxes) {
        if (isFinite(box.min) && isFinite(box.max)) {
            whole.add(box);
        }
    }
    std::vector<std::uint64_t> codes(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const Box2 &box = boxes[k];
        codes[k] = spread(step(box.min.x, box.max.x, whole.min.x, whole.max.x)) |
                   spread(step(box.min.y, box.max.y, whole.min.y, whole.max.y)) << 1;
    }
    return codes;
}

} // namespace

BoxTree::BoxTree(std::span<const Box2> boxes) : items_(orderByKeys(mortonCodes(boxes))) {
    if (boxes.empty()) {
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
