#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace forefront {

/// A part of the boundaries and constraints: entire shapes, and single segments of other shapes.
struct BoundaryPart {
    std::set<std::uint32_t> shapes;
    std::set<SegmentRef> segments;
};

/// Names a part of the boundary; other parts keep their names. If a tag already has the name, the part gets that tag. A
/// new name creates a new tag, or renames the part's tag if nothing else has it. With an empty name the part gets a tag
/// with the default name. Faults: no-such-shape, no-such-segment; not-possible for an empty part.
Result<Document> nameBoundaryPart(const Document &document, const BoundaryPart &part, const std::string &name);

/// Renames a boundary tag everywhere. If another tag has the name, everything with the tag gets that one instead, and
/// nothing is left of the tag.
Result<Document> renameBoundaryTag(const Document &document, std::int32_t tag, const std::string &name);

/// Names the region of one marker, by the same rules. Fault: no-such-marker.
Result<Document> nameRegionOf(const Document &document, std::size_t marker, const std::string &name);

/// Returns the boundary tag that has a name, or the default name of a tag in use.
std::optional<std::int32_t> boundaryTagNamed(const Document &document, const std::string &name);

/// Returns the smallest tag above all boundary tags in use or named.
std::int32_t freeBoundaryTag(const Document &document);

} // namespace forefront
