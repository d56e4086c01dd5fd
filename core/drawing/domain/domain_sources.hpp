#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/spacing/spec/placed_sizes.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// The node of a shape's outline that a part of a domain comes from, or begins at.
struct ShapeNode {
    std::uint32_t shape = 0; ///< index into Document::shapes
    std::uint32_t node = 0;  ///< index into the nodes of its outline
};

/// Where a segment of a domain comes from, and what the drawing asks for along it. What divides a segment copies this
/// record to the parts.
struct SegmentSource {
    std::uint32_t shape = 0;    ///< index into Document::shapes
    std::uint32_t node = 0;     ///< index of the node of its outline that the segment is at or begins at
    std::uint32_t elements = 0; ///< see PlacedSizes::elements; of a part of a straight segment, its share
    ElementBias bias{};         ///< see PlacedSizes::biases
    PartSize size{0.0, 0.0};    ///< see PlacedSizes::segments

    ShapeNode start() const { return {shape, node}; }
};

/// The shapes that the parts of a domain come from: one list for each list of the domain, in the same order.
struct DomainSources {
    std::vector<ShapeNode> nodes, points;
    std::vector<SegmentSource> segments;
};

/// Returns the domain of a document as toDomain does, and where its parts come from.
Domain toDomain(const Document &document, DomainSources &sources);

} // namespace forefront
