#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/boundary/discretise.hpp"
#include "core/engine/layers/layer_report.hpp"
#include "core/engine/layers/layer_spec.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// An element of the layers, counter-clockwise; a triangle has kNoIndex as its last node.
struct LayerCell {
    std::array<std::uint32_t, 4> nodes{};
    std::uint32_t region = 0; ///< index into DiscreteDomain::regions
};

/// Boundary layers, or the rows of mapped faces, and what they leave to the front.
///
/// The nodes of the layers are numbered from the nodes of `outer` on: first those of `outer`, then `inner`.
struct BoundaryLayers {
    /// What the layers leave free: the tops of the layers and the segments without them. Its first nodes are those of
    /// the discretised boundary, including those on walls, which it does not use. Tops have the tag of their wall.
    std::shared_ptr<const DiscreteDomain> outer;
    std::vector<Vec2> inner; ///< the nodes inside the layers
    std::vector<LayerCell> cells;
    LayerReport report;
};

/// What layers are built from. Refers to its parts.
struct LayerRequest {
    const Domain &domain;
    std::span<const LayerSpec> specs; ///< checked, see checkLayers()
    SegmentElements elements;         ///< segments with a number of elements keep it
    bool keepBoundary = false;        ///< no segment may be divided in another way
    double gradation = 0.2;           ///< growth of the size from the tops of the layers, per unit of distance
    double maxElements = std::numeric_limits<double>::infinity(); ///< of the layers
    const PeriodicSides *periodic = nullptr;                      ///< parts that are divided alike; null: none
};

/// Layers together with what they change.
struct BuiltLayers {
    std::shared_ptr<const BoundaryLayers> layers;
    /// The discretised boundary, divided by the layers where their ends slide along it.
    std::shared_ptr<const DiscreteDomain> boundary;
    std::shared_ptr<const SpacingField> spacing; ///< at most the length of a top edge there
};

/// Builds the layers on a discretised boundary. They do not depend on the number of threads. Layers that end along
/// periodic parts are alike on both. Errors: too-many-nodes, too-many-elements (before the elements are made),
/// periodic-layers (layers of different heights end at a place and at its image), cancelled.
Result<BuiltLayers> buildLayers(const LayerRequest &request, std::shared_ptr<const DiscreteDomain> boundary,
                                std::shared_ptr<const SpacingField> spacing, const Progress &progress = {});

/// Returns the mesh of a front that started from BoundaryLayers::outer with the layers added: its tagged edges and
/// points are those of `boundary`.
Mesh withLayers(Mesh mesh, const BoundaryLayers &layers, const DiscreteDomain &boundary);

} // namespace forefront
