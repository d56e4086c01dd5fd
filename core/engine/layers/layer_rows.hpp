#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/layers/boundary_layers.hpp"
#include "core/engine/layers/layer_report.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace FOREFRONT_API forefront {

/// The rows of boundary layers as lines, for a picture of them before there is a mesh.
struct LayerRows {
    /// Maximum number of pieces of rows; of more, only the tops of the layers are kept.
    static constexpr std::size_t kMaxPieces = 100'000;

    LayerReport report;                      ///< without numbers of elements
    std::vector<std::array<Vec2, 2>> pieces; ///< of the rows, from ray to ray; those of a column follow each other
};

/// Finds the rows of layers on a discretised boundary, which are those of buildLayers(), without making elements.
/// Errors: too-many-elements, cancelled.
Result<LayerRows> layerRows(const LayerRequest &request, const DiscreteDomain &boundary, const Progress &progress = {});

} // namespace forefront
