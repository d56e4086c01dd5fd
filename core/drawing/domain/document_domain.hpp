#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/mesher/options.hpp"

namespace FOREFRONT_API forefront {

/// Returns the domain of a document. Curved segments become chords that follow their curves; coinciding nodes of
/// different shapes become one node. Segments of boundary parts with a number of elements ask for that number.
Domain toDomain(const Document &document);

/// Returns the meshing job of a document: its domain, spacing and options.
MeshingJob jobOf(const Document &document);

/// Returns a document that shows a domain: segments are chained to polygons and polylines whose segments follow the
/// curves of the domain; loops around one curve become circles and ellipses. Tags and names are kept. Curves that do
/// not quite end at their nodes are moved there, or only their outer chords where moving all of any would add a fault.
Document fromDomain(const Domain &domain);

} // namespace forefront
