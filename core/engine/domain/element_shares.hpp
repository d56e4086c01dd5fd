#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/domain/segment_elements.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// The elements along a part of a line with a number of elements.
struct ElementShare {
    std::uint32_t elements = 1;
    ElementBias bias{};    ///< in the direction of the line
    bool keepsBias = true; ///< false: the lengths rise and fall there in a way that no bias describes; it has none
};

/// Returns what the elements with these indices, from `first` to before `end`, are along a line with a number of
/// elements and a bias, see elementPlaces(). `first` < `end` <= `count`.
ElementShare elementsBetween(std::uint32_t count, const ElementBias &bias, std::uint32_t first, std::uint32_t end);

/// Divides the elements of a line among its consecutive parts, each of which gets those that lie in it, and at least
/// one: more than `count` altogether if there are more parts. Their lengths stay about the same.
///
/// `ends`: where the parts end, as fractions of the line's length, in ascending order; the last one is 1.
std::vector<ElementShare> shareElements(std::uint32_t count, const ElementBias &bias, std::span<const double> ends);

/// Returns the elements along one part of a line, between two fractions of its length, `from` < `to`. Those of several
/// parts add up to `count`, unless some are shorter than an element.
ElementShare shareOfPart(std::uint32_t count, const ElementBias &bias, double from, double to);

} // namespace forefront
