#pragma once

#include "core/drawing/document/document.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// The lines and curves of a tagged part of a shape: see taggedSegments().
struct PartLength {
    double length = 0.0;
    std::uint32_t pieces = 0;
};

/// Returns the lengths of all parts of a shape.
std::vector<PartLength> partLengths(const Shape &shape);

} // namespace forefront
