#pragma once

#include "core/base/result.hpp"
#include "core/edit/references.hpp"

#include <cstdint>
#include <set>
#include <string>

namespace forefront {

/// Part of the boundaries and constraints: whole shapes, and single segments of others.
struct BoundaryPart {
    std::set<std::uint32_t> shapes;
    std::set<SegmentRef> segments;
};

/// Names a part of the boundary and nothing else. A name that another tag already has makes the part join that tag; a
/// new name makes a new tag, unless the part is all that carries its tag, which is then renamed. An empty name gives
/// the part a tag with the default name. Faults: no-such-shape, no-such-segment; not-possible for an empty part.
Result<Document> nameBoundaryPart(const Document &document, const BoundaryPart &part, const std::string &name);

/// Names the region of one marker, by the same rules. Fault: no-such-marker.
Result<Document> nameRegionOf(const Document &document, std::size_t marker, const std::string &name);

/// Returns the smallest tag above all boundary tags in use or named.
std::int32_t freeBoundaryTag(const Document &document);

} // namespace forefront
