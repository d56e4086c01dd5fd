#pragma once

#include "core/base/api.hpp"
#include "core/mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

class SpacingField;

/// Shape factor α = 4√3·area/Σl²: 1 equilateral, 0 degenerate, negative inverted (S. H. Lo).
double shapeFactor(Vec2 a, Vec2 b, Vec2 c);
/// Spacing conformity δ of a segment: min(L/ρ, ρ/L), ρ at its midpoint.
double spacingConformity(double segmentLength, double rho);

inline constexpr std::size_t kHistogramBins = 40;

struct MeshQuality {
    std::size_t nodes = 0;
    std::size_t elements = 0;
    std::size_t segments = 0; ///< all edges
    double area = 0.0;
    double alphaMean = 0.0;
    double alphaGeometricMean = 0.0;
    double alphaMin = 0.0;
    double alpha1 = 0.0, alpha5 = 0.0, alpha50 = 0.0; ///< percentiles 1, 5 and 50 %
    double deltaMean = 0.0;                           ///< 0 when no spacing was given
    double minAngle = 0.0, maxAngle = 0.0;            ///< degrees
    std::array<std::uint64_t, kHistogramBins>
        alphaHistogram{};                    ///< equal bins over [0, 1]; negative α counts in the first
    std::array<std::uint64_t, 13> valence{}; ///< interior nodes by number of elements; last: 12 and more
    ElementId worst = kNoElement;            ///< the element of least α
};

/// Statistics of a mesh; `spacing` may be null, then δ is left out.
MeshQuality measure(const Mesh &mesh, const SpacingField *spacing);

/// α of every element.
std::vector<float> shapeFactors(const Mesh &mesh);

} // namespace forefront
