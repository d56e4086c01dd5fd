#pragma once

#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace forefront {

/// The triangles between the values of a grid with columns at `x` and rows at `y`, both ascending.
struct GridMesh {
    std::shared_ptr<const BackgroundMesh> mesh;
    std::vector<std::uint32_t> nodes; ///< of the mesh, row by row from the bottom; kAbsent where there is no value

    static constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();
};

/// Makes a node of each value > 0 and divides each rectangle of four nodes into two triangles; one with three nodes is
/// a single triangle. `values`: row by row from the bottom, fewer than 2³² - 1.
GridMesh gridMesh(std::span<const double> x, std::span<const double> y, std::span<const double> values);

} // namespace forefront
