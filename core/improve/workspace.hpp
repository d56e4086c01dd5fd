#pragma once

#include "core/mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace forefront {

/// What swapping and smoothing need to know beside the mesh: 13 bytes per element and 2 per node.
struct ImproveWorkspace {
    explicit ImproveWorkspace(Mesh &mesh);

    Mesh &mesh;
    std::vector<std::array<ElementId, 3>> neighbours; ///< across side k, kept up to date by swaps
    std::vector<std::uint8_t> locked;                 ///< per element: bit k says that side k may not be swapped
    std::vector<std::uint8_t> fixed;                  ///< per node: 1 where it may not move
    std::vector<std::uint8_t> valence; ///< per node: elements around it; kManyElements stands for so many or more
    /// No element gets below this α, unless it was below and rises. At least the least α of the mesh at the start, so
    /// that the least α never falls.
    double floor = 0.0;

    static constexpr std::uint8_t kManyElements = 255;

    Vec2 at(NodeId n) const { return mesh.nodes[index(n)]; }
    bool isLocked(std::size_t element, unsigned side) const { return ((locked[element] >> side) & 1U) != 0; }
    void addValence(NodeId n, int step) {
        std::uint8_t &v = valence[index(n)];
        v = v == kManyElements ? v : static_cast<std::uint8_t>(v + step);
    }
    bool swappable(std::size_t element, unsigned side) const {
        return neighbours[element][side] != kNoElement && !isLocked(element, side);
    }
};

/// α of element e.
double alphaOf(const Mesh &mesh, std::size_t e);

/// Computed α above which the sign of the area is certain: the error of the computed area is below 1e-15 of Σl², since
/// differences of coordinates are rounded once.
inline constexpr double kCertainAlpha = 1e-12;

/// True when abc is counter-clockwise, decided exactly where the computed α leaves it open.
bool surelyPositive(double alpha, Vec2 a, Vec2 b, Vec2 c);

} // namespace forefront
