#include "core/engine/domain/element_shares.hpp"

#include "core/engine/domain/element_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace forefront {
namespace {

/// Finds the element that a place on a line is nearest to the beginning of.
class ElementFinder {
  public:
    ElementFinder(std::uint32_t count, const ElementBias &bias)
        : count_(count), places_(bias.any() ? elementPlaces(count, bias) : std::vector<double>()) {}

    std::uint32_t before(double fraction) const {
        constexpr double kTie = 1e-7; // what ends and begins in the middle of an element agrees, up to rounding
        const double elements = places_.empty() ? count_ * fraction : elementsBefore(places_, fraction);
        return static_cast<std::uint32_t>(std::clamp(std::lround(elements + kTie), 0L, static_cast<long>(count_)));
    }

  private:
    std::uint32_t count_;
    std::vector<double> places_; ///< empty: all elements are equally long
};

} // namespace

ElementShare elementsBetween(std::uint32_t count, const ElementBias &bias, std::uint32_t first, std::uint32_t end) {
    ElementShare share{end - first};
    if (!bias.any() || share.elements == 1) {
        return share;
    }
    const std::uint32_t last = end - 1;
    const auto exponent = [&](std::uint32_t k) { return bias.bothEnds ? std::min(k, count - 1 - k) : k; };
    const double factor = std::pow(bias.ratio, 1.0 / (bias.bothEnds ? std::max((count - 1) / 2, 1U) : count - 1));
    const auto power = [&](std::uint32_t from, std::uint32_t to) {
        return std::pow(factor, static_cast<double>(exponent(to)) - static_cast<double>(exponent(from)));
    };
    const std::uint32_t middle = (count - 1) / 2; // of the longest or shortest element
    if (!bias.bothEnds || last <= count / 2 || first >= middle) {
        share.bias = {power(first, last), false};
    } else if (first == count - end) {
        share.bias = {power(first, middle), true};
    } else {
        share.keepsBias = false;
    }
    return share;
}

std::vector<ElementShare> shareElements(std::uint32_t count, const ElementBias &bias, std::span<const double> ends) {
    const ElementFinder finder(count, bias);
    const auto parts = static_cast<std::uint32_t>(ends.size());
    std::vector<ElementShare> shares;
    std::uint32_t before = 0;
    for (std::uint32_t k = 0; k < parts; ++k) {
        const std::uint32_t left = parts - 1 - k;
        if (before >= count) { // more parts than elements
            shares.push_back(ElementShare{});
            continue;
        }
        const std::uint32_t most = count > left ? std::max(count - left, before + 1) : before + 1;
        const std::uint32_t after = left == 0 ? count : std::clamp(finder.before(ends[k]), before + 1, most);
        shares.push_back(elementsBetween(count, bias, before, after));
        before = after;
    }
    return shares;
}

ElementShare shareOfPart(std::uint32_t count, const ElementBias &bias, double from, double to) {
    const ElementFinder finder(count, bias);
    const std::uint32_t first = std::min(finder.before(from), count - 1);
    return elementsBetween(count, bias, first, std::max(finder.before(to), first + 1));
}

} // namespace forefront
