#pragma once

#include "core/engine/layers/boundary_layers.hpp"
#include "core/engine/layers/finished_rays.hpp"
#include "core/engine/layers/layer_cut.hpp"

#include <span>

namespace forefront {

/// Makes the nodes and elements of finished rays, what they leave to the front, and the report.
BoundaryLayers layerElements(const CutBoundary &boundary, const FinishedRays &rays, std::span<const LayerSpec> specs);

} // namespace forefront
