#pragma once

#include "core/base/result.hpp"
#include "core/edit/references.hpp"

#include <cstdint>
#include <optional>
#include <set>

namespace forefront {

struct Shape;

inline constexpr std::uint32_t kMaxElementCount = 1'000'000;

/// Returns the length of a tagged part of a shape (see taggedSegments()); nullopt if it is not a single line or curve,
/// like the side of a rectangle with rounded corners.
std::optional<double> countableLength(const Shape &shape, std::uint32_t part);

/// Returns the number of equal elements along a segment that the size of its boundary part stands for; nullopt if the
/// part has no size, or one that does not divide the length of the segment.
std::optional<std::uint32_t> elementCount(const Document &document, SegmentRef segment);

/// Gives each of the segments a size of its length / `count`, so that `count` elements result where nothing asks for
/// smaller ones; nullopt removes the sizes. Sizes belong to tags, so segments get tags of their own, shared by segments
/// of the same tag and length; a tag keeps its growth, or the part of it that a curve allows, and its name with a
/// number. Shorter segments of the same call may ask for smaller elements near the ends of longer ones. Faults:
/// no-such-segment; not-possible for a segment without a countableLength(); bad-number for a count of 0 or above
/// kMaxElementCount.
Result<Document> setElementCount(const Document &document, const std::set<SegmentRef> &segments,
                                 std::optional<std::uint32_t> count);

} // namespace forefront
