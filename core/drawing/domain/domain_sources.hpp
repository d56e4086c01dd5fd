#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// The node of a shape's outline that a part of a domain comes from, or begins at.
struct ShapeNode {
    std::uint32_t shape = 0; ///< index into Document::shapes
    std::uint32_t node = 0;  ///< index into the nodes of its outline
};

/// The shapes that the parts of a domain come from: one list for each list of the domain, in the same order.
struct DomainSources {
    std::vector<ShapeNode> nodes, segments, points;
};

/// Returns the domain of a document as toDomain does, and where its parts come from.
Domain toDomain(const Document &document, DomainSources &sources);

} // namespace forefront
