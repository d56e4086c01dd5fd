#include "core/files/common/node_table.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

std::uint32_t NodeTable::finish() {
    dense_.clear();
    sorted_.clear();
    if (numbers_.empty()) {
        return kNoIndex;
    }
    const auto [minimum, maximum] = std::minmax_element(numbers_.begin(), numbers_.end());
    lowest_ = *minimum;
    const std::uint64_t span = static_cast<std::uint64_t>(*maximum) - static_cast<std::uint64_t>(*minimum);
    constexpr std::uint64_t kGaps = 4;
    if (span < kGaps * numbers_.size()) {
        dense_.assign(static_cast<std::size_t>(span) + 1, kNoIndex);
        for (std::size_t k = 0; k < numbers_.size(); ++k) {
            std::uint32_t &slot = dense_[static_cast<std::size_t>(numbers_[k] - lowest_)];
            if (slot != kNoIndex) {
                return static_cast<std::uint32_t>(k);
            }
            slot = static_cast<std::uint32_t>(k);
        }
        return kNoIndex;
    }
    sorted_.resize(numbers_.size());
    std::iota(sorted_.begin(), sorted_.end(), 0U);
    std::sort(sorted_.begin(), sorted_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return numbers_[a] != numbers_[b] ? numbers_[a] < numbers_[b] : a < b;
    });
    const auto twin = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                         [&](std::uint32_t a, std::uint32_t b) { return numbers_[a] == numbers_[b]; });
    return twin == sorted_.end() ? kNoIndex : *(twin + 1);
}

std::uint32_t NodeTable::findSorted(std::int64_t number) const {
    const auto place = std::lower_bound(sorted_.begin(), sorted_.end(), number,
                                        [&](std::uint32_t a, std::int64_t sought) { return numbers_[a] < sought; });
    return place != sorted_.end() && numbers_[*place] == number ? *place : kNoIndex;
}

} // namespace forefront
