#pragma once

#include "core/engine/base/api.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace FOREFRONT_API forefront {

/// The numbers that a file gives to the nodes or elements of a mesh.
class PartNumbers {
  public:
    PartNumbers() = default;
    /// Numbers them first, first + 1, ...
    explicit PartNumbers(std::int64_t first) : first_(first) {}
    /// Gives each its number in `numbers`; takes no memory where they are successive.
    explicit PartNumbers(std::vector<std::int64_t> numbers) : first_(numbers.empty() ? 0 : numbers.front()) {
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            if (numbers[k] != first_ + static_cast<std::int64_t>(k)) {
                numbers_ = std::move(numbers);
                return;
            }
        }
    }
    /// Returns the number of the part with this index.
    std::int64_t of(std::size_t index) const {
        return index < numbers_.size() ? numbers_[index] : first_ + static_cast<std::int64_t>(index);
    }

  private:
    std::int64_t first_ = 0;
    std::vector<std::int64_t> numbers_;
};

/// The numbers of the nodes and elements of a mesh in its file, for messages; without a file, their indices.
struct MeshNumbers {
    PartNumbers nodes, elements;
};

} // namespace forefront
