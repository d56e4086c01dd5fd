#pragma once

#include "core/engine/base/api.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// How the lengths of the elements along a line or curve with a number of elements change: by equal factors.
struct ElementBias {
    /// Length of the last element over that of the first, in the direction of the segment; with `bothEnds`, of the
    /// elements in the middle over those at the ends. 1: no bias, the lengths follow the spacing. See isValid().
    double ratio = 1.0;
    bool bothEnds = false; ///< the lengths change from both ends to the middle

    static constexpr double kMaxRatio = 1e4;
    bool isValid() const { return ratio >= 1.0 / kMaxRatio && ratio <= kMaxRatio; }
    bool any() const { return ratio != 1.0; }
    /// Returns the bias seen from the other end.
    ElementBias reversed() const { return {bothEnds ? ratio : 1.0 / ratio, bothEnds}; }

    friend bool operator==(const ElementBias &, const ElementBias &) = default;
};

/// The numbers of elements that lines and curves of a domain must have, and their biases, see PlacedSizes::elements.
/// Refers to the lists, which must outlive it.
class SegmentElements {
  public:
    SegmentElements() = default;
    /// `elements`, `biases`: by index into Domain::segments; an empty list of biases: none.
    SegmentElements(const std::vector<std::uint32_t> &elements) : elements_(elements) {}
    SegmentElements(const std::vector<std::uint32_t> &elements, const std::vector<ElementBias> &biases)
        : elements_(elements), biases_(biases) {}

    /// Returns the number along the line or curve that a segment is a part of; 0: as the spacing asks.
    std::uint32_t operator[](std::size_t segment) const { return segment < elements_.size() ? elements_[segment] : 0; }
    /// Returns the bias along it, in the direction of the segment.
    ElementBias bias(std::size_t segment) const { return segment < biases_.size() ? biases_[segment] : ElementBias{}; }

  private:
    std::span<const std::uint32_t> elements_;
    std::span<const ElementBias> biases_;
};

} // namespace forefront
