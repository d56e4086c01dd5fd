#include "ui/style/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace forefront {

namespace {

constexpr std::array<std::uint32_t, 20> kViridis{0x440154, 0x481567, 0x482677, 0x453781, 0x404788, 0x39568c, 0x33638d,
                                                 0x2d708e, 0x287d8e, 0x238a8d, 0x1f968b, 0x20a387, 0x29af7f, 0x3cbb75,
                                                 0x55c667, 0x73d055, 0x95d840, 0xb8de29, 0xdce319, 0xfde725};
constexpr std::array<std::uint32_t, 10> kCividis{0x00204d, 0x00336f, 0x39486b, 0x575c6d, 0x707173,
                                                 0x8a8779, 0xa69d75, 0xc4b56c, 0xe4cf5b, 0xffea46};

constexpr std::array<std::uint32_t, 9> kDiverging{0x542788, 0x8073ac, 0xb2abd2, 0xd8daeb, 0xf7f7f7,
                                                  0xfee0b6, 0xfdb863, 0xe08214, 0xb35806};
constexpr std::array<std::uint32_t, 9> kDivergingDark{0xcbb3ff, 0xa48fd8, 0x7a6ca6, 0x4d4d6e, 0x27333f,
                                                      0x665033, 0xa3742f, 0xd99a38, 0xffc266};
constexpr std::array<std::uint32_t, 8> kCategories{0x56b4e9, 0xe69f00, 0x009e73, 0xf0e442,
                                                   0xcc79a7, 0x0072b2, 0xd55e00, 0x999999};

/// A colour at a place of a map.
struct MapStop {
    double at;
    std::uint32_t colour;
};
constexpr std::array<MapStop, 5> kQualityDark{
    {{0.0, 0xff6369}, {0.2, 0xff6369}, {0.5, 0xe0a63a}, {0.76, 0x56707f}, {1.0, 0x27333f}}};
constexpr std::array<MapStop, 5> kQualityLight{
    {{0.0, 0xc6263c}, {0.2, 0xc6263c}, {0.5, 0xd08a00}, {0.76, 0xb3c4d1}, {1.0, 0xedf1f5}}};

Colour between(std::span<const MapStop> stops, double t) {
    std::size_t k = 1;
    while (k + 1 < stops.size() && stops[k].at < t) {
        ++k;
    }
    const MapStop &a = stops[k - 1], &b = stops[k];
    return mix(rgb(a.colour), rgb(b.colour), std::clamp((t - a.at) / (b.at - a.at), 0.0, 1.0));
}

Colour between(std::span<const std::uint32_t> support, double t) {
    const double last = static_cast<double>(support.size() - 1);
    const double at = std::clamp(t, 0.0, 1.0) * last;
    const auto i = static_cast<std::size_t>(std::min(std::floor(at), last - 1.0));
    return mix(rgb(support[i]), rgb(support[i + 1]), at - static_cast<double>(i));
}

} // namespace

Colour viridis(double t) {
    return between(kViridis, t);
}

Colour cividis(double t) {
    return between(kCividis, t);
}

Colour cividisReversed(double t) {
    return cividis(1.0 - t);
}

Colour diverging(double t) {
    return between(kDiverging, t);
}

Colour divergingDark(double t) {
    return between(kDivergingDark, t);
}

Colour qualityDark(double t) {
    return between(kQualityDark, t);
}

Colour qualityLight(double t) {
    return between(kQualityLight, t);
}

Colour qualityDarkReversed(double t) {
    return qualityDark(1.0 - t);
}

Colour qualityLightReversed(double t) {
    return qualityLight(1.0 - t);
}

Colour categories(double t) {
    const double count = static_cast<double>(kCategories.size());
    const auto i = static_cast<std::size_t>(std::clamp(t * count, 0.0, count - 1.0));
    return rgb(kCategories[i]);
}

Colour spacingColour(double t) {
    return viridis(1.0 - 0.75 * std::clamp(t, 0.0, 1.0));
}

} // namespace forefront
