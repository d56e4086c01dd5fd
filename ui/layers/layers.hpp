#pragma once

#include "ui/layers/layer.hpp"

#include <memory>

namespace forefront {

/// Inside of the domain, its boundary, constraints and isolated points.
std::unique_ptr<Layer> makeDomainLayer();
/// Size sources and region markers.
std::unique_ptr<Layer> makeMarksLayer();

} // namespace forefront
