#pragma once

#include "core/engine/layers/layer_spec.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// The heights of the tops of the layers of one specification above the wall.
class LayerHeights {
  public:
    /// The last layer before the next would be as high as this many times the length of the wall edges below it.
    static constexpr double kIsotropic = 0.7;

    /// `longest`: length of the longest wall edge, for layers that are added until they are isotropic.
    LayerHeights(const LayerSpec &spec, double longest);

    /// Returns the height of the top of layer `k`, counted from 1; 0 for k = 0.
    double operator[](std::uint32_t k) const { return tops_[k]; }
    /// Returns the number of layers asked for over wall edges of a length, at least 1.
    std::uint32_t countOver(double length) const;

  private:
    std::vector<double> tops_;
    bool untilIsotropic_ = false;
};

} // namespace forefront
