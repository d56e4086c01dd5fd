#include "core/engine/geometry/box_tree.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/geometry/hilbert.hpp"

#include <algorithm>

namespace forefront {
namespace {

std::vector<std::uint64_t> hilbertCodes(std::span<const Box2> boxes) {
    Box2 whole;
    for (const Box2 &box : boxes) {
        if (isFinite(box.min) && isFinite(box.max)) {
            whole.add(box);
        }
    }
    std::vector<std::uint64_t> codes(boxes.size());
    std::transform(boxes.begin(), boxes.end(), codes.begin(),
                   [&](const Box2 &box) { return std::uint64_t{hilbertCode(mortonCode(box, whole))}; });
    return codes;
}

} // namespace

BoxTree::BoxTree(std::span<const Box2> boxes) : items_(orderByKeys(hilbertCodes(boxes))) {
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
    Box2 whole;
    for (const Box2 &box : levels_.back()) {
        whole.add(box);
    }
    scale_ = StepScale(whole);
    for (const std::vector<Box2> &level : levels_) {
        std::vector<BoxBlock> &blocks = blocks_.emplace_back((level.size() + kFan - 1) / kFan);
        for (std::size_t k = 0; k < level.size(); ++k) {
            blocks[k / kFan].set(k % kFan, scale_(level[k]));
        }
    }
}

} // namespace forefront
