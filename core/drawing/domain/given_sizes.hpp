#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/drawn_domain.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/spacing/spec/placed_sizes.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace forefront {

/// The sizes, numbers of elements and biases that a document gives for the segments of its shapes, found for the
/// segments of the domain that the shapes draw. Finding them needs DrawnDomain::sources. Keeps a reference to the
/// document.
class GivenSizes {
  public:
    explicit GivenSizes(const Document &document);

    /// Returns true if the document gives any.
    bool any() const { return any_; }
    /// Notes what is given for the segments of an outline. `number`: of the shape, in the document.
    void add(const Shape &shape, std::uint32_t number, const Outline &outline);

    /// Returns the number of elements along a segment, or along the curve that it is a chord of; 0: as the spacing
    /// asks.
    std::uint32_t elementsOf(const DrawnDomain &drawn, std::uint32_t segment) const;
    /// Returns the bias of the elements along a segment, or along the curve that it is a chord of.
    ElementBias biasOf(const DrawnDomain &drawn, std::uint32_t segment) const;
    /// Returns the size along a segment; 0: none.
    PartSize sizeOf(const DrawnDomain &drawn, std::uint32_t segment) const;

    /// Return the numbers, biases and sizes of all segments, see PlacedSizes; empty if none has any.
    std::vector<std::uint32_t> elements(const DrawnDomain &drawn) const;
    std::vector<ElementBias> biases(const DrawnDomain &drawn) const;
    std::vector<PartSize> sizes(const DrawnDomain &drawn) const;

  private:
    void addCounts(const Shape &shape, std::uint32_t number, const Outline &outline);

    const Document &document_;
    std::map<std::int32_t, PartSegments> counted_;
    bool any_ = false;
    // By shape, of each segment of its outline:
    std::map<std::uint32_t, std::vector<std::uint32_t>> counts_; ///< numbers of elements
    std::map<std::uint32_t, std::vector<std::uint32_t>> parts_;  ///< tagged parts
    std::map<std::uint32_t, std::vector<PartSize>> sizes_;
};

} // namespace forefront
