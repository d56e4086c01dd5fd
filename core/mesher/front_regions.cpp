#include "core/mesher/front_regions.hpp"

#include <limits>

namespace forefront {

FrontRegions::FrontRegions() : phases{0, 1} {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    boxes.push_back({{-kInfinity, -kInfinity}, {kInfinity, kInfinity}});
}

} // namespace forefront
