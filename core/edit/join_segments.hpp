#pragma once

#include "core/edit/document.hpp"

namespace forefront {

/// Where nodes of a shape lie on segments of other shapes (within 1e-9 of the drawing's size), those segments get a
/// node there too, so that the shapes meet properly; a rectangle met so becomes a polygon. Circles cannot be met. A
/// document without the shape, or where nothing meets, comes back as it is.
Document joinToSegments(const Document &document, std::uint32_t shape);

} // namespace forefront
