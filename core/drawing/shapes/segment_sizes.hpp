#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace forefront {

// Sizes of elements along single segments: see Shape::segmentSizes. Tags and names of boundary parts have no part in
// them.

inline constexpr std::uint32_t kMaxElementCount = 1'000'000;

/// Returns the size of a segment, or null if it has none of its own.
const SegmentSize *segmentSize(const Document &document, SegmentRef segment);

/// Returns true if a segment of the document has a size of its own.
bool hasSegmentSizes(const Document &document);

/// Sets the sizes of segments; nullopt removes them. Errors: bad-size, bad-number, no-such-segment, no-such-shape.
Result<Document> setSegmentSize(const Document &document, const std::set<SegmentRef> &segments,
                                const std::optional<SegmentSize> &size);

/// Sets a size for each of the segments. Errors as for setSegmentSize().
Result<Document> setSegmentSizes(const Document &document, const std::map<SegmentRef, SegmentSize> &sizes);

/// Sets the bias of segments with a number of elements of their own. Errors as for setSegmentSize(); bad-number for an
/// invalid ratio, not-possible for a segment without such a number.
Result<Document> setElementBias(const Document &document, const std::set<SegmentRef> &segments,
                                const ElementBias &bias);
/// Turns the bias of segments around: what was fine becomes coarse. Errors as for setElementBias().
Result<Document> flipElementBias(const Document &document, const std::set<SegmentRef> &segments);

/// A change of the sizes of segments; unset members leave their values unchanged.
struct SegmentSizeChange {
    std::optional<double> size;   ///< takes the place of a number of elements
    std::optional<double> growth; ///< for segments that have a size or a number of elements
};
/// Changes the size or the growth of segments that may differ in the other. Errors as for setSegmentSize().
Result<Document> changeSegmentSizes(const Document &document, const std::set<SegmentRef> &segments,
                                    const SegmentSizeChange &change);

/// Returns the sizes of the segments of a path that a shape becomes, one for each segment of the shape's outline; parts
/// of several segments share a number of elements by length.
std::map<std::uint32_t, SegmentSize> sizesOfOutline(const Shape &shape);

/// Moves the sizes of segments after a command changed a document. They stay at their numbers where a shape has as many
/// segments as before, or its command has moved them; elsewhere, and where the command has removed them together with a
/// change of the outline, segments of the changed and new shapes take the sizes that were at their places. A shorter
/// segment keeps its number of elements; several parts of one share it by length.
void carrySegmentSizes(const Document &before, Document &next);

/// Returns the faults of the sizes of a shape's segments. Codes: bad-size, bad-number, no-such-segment.
Diagnostics checkSegmentSizes(const Shape &shape);

/// Returns the name of a segment: "segment 3 of quay"; that of the shape if it has only one.
std::string segmentName(const Shape &shape, std::uint32_t segment);

} // namespace forefront
