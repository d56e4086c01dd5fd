#pragma once

#include "core/engine/base/ids.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Maps the node numbers of a file, which may have gaps and come in any order, to indices 0, 1, 2, ... in the order of
/// the file. Numbers without large gaps cost four bytes each; others are looked up in a sorted list.
class NodeTable {
  public:
    void reserve(std::size_t count) { numbers_.reserve(count); }
    void add(std::int64_t number) { numbers_.push_back(number); }
    std::size_t size() const { return numbers_.size(); }
    std::int64_t number(std::size_t index) const { return numbers_[index]; }
    const std::vector<std::int64_t> &numbers() const { return numbers_; }
    /// Prepares for find() once all numbers are added. Returns the index of a node whose number was given before, or
    /// kNoIndex if all differ.
    std::uint32_t finish();
    /// Returns the index of a node, or kNoIndex.
    std::uint32_t find(std::int64_t number) const {
        if (sorted_.empty()) {
            const auto slot = static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(lowest_);
            return slot < dense_.size() ? dense_[slot] : kNoIndex;
        }
        return findSorted(number);
    }

  private:
    std::uint32_t findSorted(std::int64_t number) const;

    std::vector<std::int64_t> numbers_;
    std::int64_t lowest_ = 0;
    std::vector<std::uint32_t> dense_;
    std::vector<std::uint32_t> sorted_; ///< indices in the order of their numbers
};

} // namespace forefront
