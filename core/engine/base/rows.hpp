#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace forefront {

/// Items in rows that lie behind one another in memory, such as the segments at each node. Each row keeps the order in
/// which its items were added.
template <class Item>
class Rows {
  public:
    Rows() = default;
    /// `visit(add)` calls `add(row, item)` for each item. It is called twice, to count and to fill the rows, and must
    /// add the same items both times. At most 2^32 - 1 items.
    template <class Visit>
    Rows(std::size_t rows, const Visit &visit) : starts_(rows + 1, 0) {
        visit([this](std::size_t row, const Item &) { ++starts_[row + 1]; });
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        items_.resize(starts_.back());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        visit([&](std::size_t row, const Item &item) { items_[next[row]++] = item; });
    }

    /// Returns the number of rows.
    std::size_t size() const { return starts_.empty() ? 0 : starts_.size() - 1; }
    std::span<const Item> operator[](std::size_t row) const {
        return {items_.data() + starts_[row], items_.data() + starts_[row + 1]};
    }
    std::span<Item> operator[](std::size_t row) {
        return {items_.data() + starts_[row], items_.data() + starts_[row + 1]};
    }
    /// Returns the items of all rows, row by row.
    std::span<const Item> items() const { return items_; }

  private:
    std::vector<std::uint32_t> starts_; ///< per row, its first item; then the number of items
    std::vector<Item> items_;
};

} // namespace forefront
