#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

class SpacingField;

/// Returns the shape factor α = 4√3·area/Σl²: 1 equilateral, 0 degenerate, negative inverted (S. H. Lo).
double shapeFactor(Vec2 a, Vec2 b, Vec2 c);
/// Returns the spacing conformity δ of a segment: min(L/ρ, ρ/L), ρ at its midpoint.
double spacingConformity(double segmentLength, double rho);

inline constexpr std::size_t kHistogramBins = 40;

/// Quality statistics of a mesh.
struct MeshQuality {
    std::size_t nodes = 0;
    std::size_t elements = 0;
    std::size_t edges = 0;
    double area = 0.0;
    double alphaMean = 0.0;
    double alphaGeometricMean = 0.0;
    double alphaMin = 0.0;
    double alpha1 = 0.0, alpha5 = 0.0, alpha50 = 0.0; ///< percentiles 1, 5 and 50 %
    double deltaMean = 0.0;                           ///< of the edges; 0 without a spacing
    double deltaAreaMean = 0.0;                       ///< over the area; 0 without a spacing
    double minAngle = 0.0, maxAngle = 0.0;            ///< degrees
    double minScaledJacobian = 0.0;
    std::array<std::size_t, wordsOf<CellKind>().size()> kinds{}; ///< numbers of elements, by CellKind
    std::array<std::uint64_t, kHistogramBins>
        alphaHistogram{};                    ///< equal bins over [0, 1]; negative α counts in the first
    std::array<std::uint64_t, 13> valence{}; ///< interior corners by number of elements; the last counts 12 and more
    ElementId worst = kNoElement;            ///< the element with minimum α
    std::size_t flat = 0;                    ///< elements with a corner of no area, within the rounding of their nodes
};

/// Returns the quality statistics of a mesh. They come from the corners of its elements, except for the area and the
/// scaled Jacobian; see placed_cell.hpp. δ is left out if `spacing` is null. Throws std::bad_alloc if memory runs
/// out.
MeshQuality measureQuality(const MeshView &mesh, const SpacingField *spacing);

/// Returns α of every element.
std::vector<float> shapeFactors(const MeshView &mesh);

} // namespace forefront
