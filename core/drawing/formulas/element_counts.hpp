#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace forefront {

// Numbers of elements of boundary parts (see PartElements and rulesOf()) and of single segments, which take precedence
// (see Shape::segmentSizes).

/// Returns the lengths of the tagged parts of a shape (see taggedSegments()); nullopt for a part that is not a single
/// line or curve, like the side of a rectangle with rounded corners: its elements cannot be counted.
std::vector<std::optional<double>> countableLengths(const Shape &shape);

/// Returns the number of elements of a segment, or else of the boundary part that it belongs to; nullopt if there is
/// none.
std::optional<std::uint32_t> elementCount(const Document &document, SegmentRef segment);

/// Gives each segment a number of elements, which overrides other sizes; nullopt removes the number, and a size of the
/// segment. The growth stays; that of its boundary part is the first one. Tags do not change. Faults: no-such-segment;
/// not-possible for a segment without a length, see countableLengths(); bad-number for a count of 0 or above
/// kMaxElementCount.
Result<Document> setElementCount(const Document &document, const std::set<SegmentRef> &segments,
                                 std::optional<std::uint32_t> count);

/// Gives the boundary part with a tag a number of elements in place of its size; nullopt removes both. Faults:
/// bad-number, bad-source.
Result<Document> setPartElements(const Document &document, std::int32_t tag, std::optional<PartElements> elements);

/// The segments of a boundary part.
struct PartSegments {
    std::size_t count = 0;
    double shortest = 0.0, longest = 0.0;
    double total = 0.0; ///< length
};
/// Returns the segments of each boundary part with a number of elements, by tag, except those with a size of their own;
/// none for parts without segments.
std::map<std::int32_t, PartSegments> countedParts(const Document &document);
/// Returns the number of elements along each tagged part of a shape (see taggedSegments()), 0 where the spacing
/// decides; empty if no part has any. `counted`: the result of countedParts().
std::vector<std::uint32_t> elementsOfParts(const Document &document, const Shape &shape,
                                           const std::map<std::int32_t, PartSegments> &counted);
/// Returns the size along each tagged part of a shape that has a size or a number of elements of its own, 0 for the
/// others; empty if none has any.
std::vector<PartSize> sizesOfParts(const Shape &shape);
/// Returns the size that follows from the number of elements of the boundary part with a tag; nullopt if it has none.
std::optional<PartSize> elementSize(const Document &document, std::int32_t tag);

/// Returns the rules of a document, in which boundary parts with a number of elements have the sizes that lead to it.
SpacingSpec rulesOf(const Document &document);

/// Updates the numbers of elements after a command changed a document. Where segments were divided or joined without a
/// change of their total length, their elements keep their size: the halves of a line of 24 elements get 12 each.
void carryElementCounts(const Document &before, Document &next);

} // namespace forefront
