#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/files/common/domain_file.hpp"

namespace FOREFRONT_API forefront {

/// Returns the domain of a document. Curved segments become chords that follow their curves; coinciding nodes of
/// different shapes become one node. It holds no sizes: see spacingOf().
Domain toDomain(const Document &document);

/// Returns all element sizes of a document: its rules, in which boundary parts with a number of elements have the sizes
/// that lead to it; the sizes of its nodes and regions; and the sizes and numbers of elements along the segments of
/// toDomain(). With sizes of segments or numbers of elements, this makes the domain: jobOf() returns both at once.
SpacingSpec spacingOf(const Document &document);

/// Returns the meshing job of a document: its domain, spacing and options.
MeshingJob jobOf(const Document &document);

/// Returns a document that shows a domain: segments are chained to polygons and polylines whose segments follow the
/// curves of the domain; loops around one curve become circles and ellipses. Tags and names are kept. Curves that do
/// not quite end at their nodes are moved there, or only their outer chords where moving all of any would add a fault.
Document fromDomain(const Domain &domain);
/// Returns a document that shows a domain and has the sizes that came with it. Sizes of regions go to their markers;
/// one of a place without a marker gets a marker. Numbers of elements, which no such file holds, are left out.
Document fromDomain(const DomainFile &file);

} // namespace forefront
