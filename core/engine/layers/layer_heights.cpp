#include "core/engine/layers/layer_heights.hpp"

#include <cmath>

namespace forefront {

LayerHeights::LayerHeights(const LayerSpec &spec, double longest)
    : tops_{0.0}, untilIsotropic_(!spec.count && !spec.thickness) {
    double height = spec.first;
    const auto add = [&] {
        tops_.push_back(tops_.back() + height);
        height *= spec.growth;
    };
    add();
    const auto wanted = [&] {
        if (spec.count) {
            return tops_.size() <= *spec.count;
        }
        if (spec.thickness) { // one more layer where that comes nearer
            return tops_.back() + 0.5 * height <= *spec.thickness;
        }
        return height < kIsotropic * longest;
    };
    while (tops_.size() <= kMaxLayers && wanted()) {
        add();
    }
}

std::uint32_t LayerHeights::countOver(double length) const {
    const auto all = static_cast<std::uint32_t>(tops_.size() - 1);
    if (!untilIsotropic_) {
        return all;
    }
    std::uint32_t count = 1;
    while (count < all && tops_[count + 1] - tops_[count] < kIsotropic * length) {
        ++count;
    }
    return count;
}

} // namespace forefront
