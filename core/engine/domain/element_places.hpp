#pragma once

#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/geometry/curve.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Returns where `count` (>= 1) elements with a bias begin and end along a line, as fractions of its length: count + 1
/// numbers from 0 to 1. Their lengths form a geometric sequence, or two that mirror each other. Without a bias, all are
/// equally long.
std::vector<double> elementPlaces(std::uint32_t count, const ElementBias &bias);

/// Returns the number of elements before a fraction of the length, given elementPlaces(): a part of an element counts
/// by its length.
double elementsBefore(const std::vector<double> &places, double fraction);
/// Returns the fraction of the length before which there are so many elements: the inverse of elementsBefore().
double placeOfElement(const std::vector<double> &places, double elements);

/// Returns the parameter of a curve before which there is this fraction of its length.
double parameterAtLength(const Curve &curve, double fraction);

} // namespace forefront
