#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <set>

namespace forefront {

/// Operations that combine closed shapes. The first shape is the one that comes first in the document.
enum class ShapeOperation : std::uint8_t {
    Union,        ///< the area that any of them covers
    Difference,   ///< the area of the first without the others
    Intersection, ///< the area that all of them cover
    Exclusion,    ///< the area that an odd number of them covers
    Divide        ///< the area of the first, with the outlines of the others inside it as constraints
};

/// Replaces closed shapes by the result of an operation on their areas: closed paths around its faces and, for Divide,
/// open ones. Curves stay curves. Segments keep the tags of the shapes they come from; the first shape gives its role
/// and name, and its place in the list. Nodes and lines within 1e-9 of the extent are joined. `result`, if not null,
/// becomes the selection of the new shapes. Errors: no-such-shape; not-possible (fewer than two shapes, an open one, or
/// nothing would be left).
Result<Document> combineShapes(const Document &document, const std::set<std::uint32_t> &ids, ShapeOperation operation,
                               Selection *result = nullptr);

/// Returns true if the selection holds at least two shapes and all of them are closed.
bool canCombine(const Document &document, const Selection &selection);

} // namespace forefront
