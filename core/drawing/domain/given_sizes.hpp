#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/domain/drawn_domain.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/spacing/spec/placed_sizes.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace forefront {

/// The sizes, numbers of elements and biases that a document gives for the segments of its shapes. Keeps a reference to
/// the document.
class GivenSizes {
  public:
    explicit GivenSizes(const Document &document);

    /// Returns true if the lines of the document differ in more than their places and tags, so that making the domain
    /// needs DrawnDomain::sources.
    bool needsSources() const { return needsSources_; }
    /// Returns where each segment of an outline comes from, and the size and the number of elements along it. `number`:
    /// of the shape, in the document.
    std::vector<SegmentSource> sourcesOf(const Shape &shape, std::uint32_t number, const Outline &outline) const;

  private:
    const Document &document_;
    std::map<std::int32_t, PartSegments> counted_;
    bool needsSources_ = false;
};

// Return what is given for all segments of a domain, see PlacedSizes; empty if none has any.

std::vector<std::uint32_t> elementsAlong(const DrawnDomain &drawn);
std::vector<ElementBias> biasesAlong(const DrawnDomain &drawn);
std::vector<PartSize> sizesAlong(const DrawnDomain &drawn);

} // namespace forefront
