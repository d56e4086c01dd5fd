#pragma once

#include "core/engine/base/api.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// The numbers of elements that lines and curves of a domain must have, see PlacedSizes::elements. Refers to the list,
/// which must outlive it.
class SegmentElements {
  public:
    SegmentElements() = default;
    /// `elements`: by index into Domain::segments.
    SegmentElements(const std::vector<std::uint32_t> &elements) : elements_(elements) {}

    /// Returns the number along the line or curve that a segment is a part of; 0: as the spacing asks.
    std::uint32_t operator[](std::size_t segment) const { return segment < elements_.size() ? elements_[segment] : 0; }

  private:
    std::span<const std::uint32_t> elements_;
};

} // namespace forefront
