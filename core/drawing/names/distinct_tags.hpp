#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

/// Returns `other` with tags that mean the same in `document`, for putting both drawings together. A boundary part
/// whose name has a tag in `document` gets that tag; one whose tag is in use there for a part of another name, or of
/// none, gets a free tag, together with its name, sizes, numbers of elements, layers, periodic parts, cracks and
/// formulas. The same for the regions of markers; a region without a marker keeps tag 1. Other tags stay as they are.
Document withDistinctTags(const Document &other, const Document &document);

} // namespace forefront
