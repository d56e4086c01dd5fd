#pragma once

#include "core/edit/document.hpp"

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

/// Returns, for each part of a shape, its mean distance from the chords that stand for it. The size of a boundary part
/// holds at the chords and grows away from them, so that on a curve it is larger by the growth times this distance.
std::vector<double> meanGaps(const Document &document, const Shape &shape);

} // namespace forefront
