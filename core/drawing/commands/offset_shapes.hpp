#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <set>

namespace forefront {

/// Adds the outlines at a distance from shapes, > 0 outside and < 0 inside; around an open path, the outline of the
/// band of twice that width. Corners on the outside become round. Parallels of lines, arcs of circles and circles are
/// exact; parallels of other curves are cubics, within 1e-6 of the size of the result. The inside of a closed path that
/// crosses itself follows the even-odd rule. Role, tags and name are copied from the original. `made`, if not null,
/// becomes the selection of the new shapes. Errors: no-such-shape, bad-number, not-possible (a point; nothing is left),
/// those of combineShapes().
Result<Document> offsetShapes(const Document &document, const std::set<std::uint32_t> &ids, double distance,
                              Selection *made = nullptr);

} // namespace forefront
