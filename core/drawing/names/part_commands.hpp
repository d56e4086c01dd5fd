#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/names/name_commands.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

// Commands on what the mesher makes of parts of the boundary, inner lines and regions. A part whose tag has no name and
// is used elsewhere, too, first gets a tag of its own with what that one has. Errors: those of nameBoundaryPart().

/// Sets the boundary layers of a part, whose tag is ignored in `spec`; nullopt removes them. Error: bad-layer.
Result<Document> setLayers(const Document &document, const BoundaryPart &part, std::optional<LayerSpec> spec);
/// Gives an inner line a width, as a strip of rows of elements; the tag in `spec` is ignored; nullopt removes it.
/// Error: bad-strip.
Result<Document> setStrip(const Document &document, const BoundaryPart &part, std::optional<StripSpec> spec);
/// Makes an inner line a crack, or no longer.
Result<Document> setCrack(const Document &document, const BoundaryPart &part, bool cracks);
/// Divides a part and another one, with the tag `partner`, alike; nullopt unties the part. Both leave the pairs that
/// they were in. Error: not-possible if the partner is the part itself.
Result<Document> setPeriodic(const Document &document, const BoundaryPart &part, std::optional<std::int32_t> partner);
/// Fills the faces of a region by rows between opposite sides, or no longer. Corners that were given are kept.
Document setMapped(const Document &document, std::int32_t region, bool mapped);
/// Sets the places of the corners of a mapped region: 3 or 4 nodes of the outline of each of its faces, see MappedSpec;
/// empty: the sharpest ones. Does nothing if the region is not mapped.
Document setMappedCorners(const Document &document, std::int32_t region, std::vector<Vec2> corners);
/// Gives a region elements of its own, or, with nullopt, those of the rest.
Document setElements(const Document &document, std::int32_t region, std::optional<Elements> elements);

/// Returns the elements that a region has of its own; nullopt: those of the rest.
std::optional<Elements> elementsOf(const Document &document, std::int32_t region);
/// Returns the boundary layers of a tag; null: none.
const LayerSpec *layersOf(const Document &document, std::int32_t tag);
/// Returns the strip along lines with a tag; null: none.
const StripSpec *stripOf(const Document &document, std::int32_t tag);
/// Returns the tag that is divided like another one, if any.
std::optional<std::int32_t> periodicPartner(const Document &document, std::int32_t tag);
bool isCrack(const Document &document, std::int32_t tag);
bool isMapped(const Document &document, std::int32_t region);
/// Returns how a region is mapped; null: it is not.
const MappedSpec *mappedOf(const Document &document, std::int32_t region);

} // namespace forefront
