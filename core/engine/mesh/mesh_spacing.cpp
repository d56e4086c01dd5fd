#include "core/engine/mesh/mesh_spacing.hpp"

#include "core/engine/base/ids.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace forefront {

std::shared_ptr<const BackgroundMesh> spacingOfMesh(const MeshView &mesh) {
    auto background = std::make_shared<BackgroundMesh>();
    background->nodes.assign(mesh.nodes.begin(), mesh.nodes.end());
    std::vector<double> area(mesh.nodes.size(), 0.0), density(mesh.nodes.size(), 0.0);
    const auto at = [&mesh](NodeId node) { return mesh.nodes[index(node)]; };
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> corners = mesh.cornersOf(e);
        double whole = 0.0;
        for (std::size_t k = 2; k < corners.size(); ++k) {
            whole += 0.5 * std::abs(cross(at(corners[k - 1]) - at(corners[0]), at(corners[k]) - at(corners[0])));
        }
        if (!(whole > 0.0)) {
            continue;
        }
        const double square = corners.size() == 3 ? 4.0 / std::numbers::sqrt3 * whole : whole;
        for (const NodeId node : corners) {
            area[index(node)] += whole;
            density[index(node)] += whole / square;
        }
        for (std::size_t k = 2; k < corners.size(); ++k) {
            background->elements.push_back({static_cast<std::uint32_t>(corners[0]),
                                            static_cast<std::uint32_t>(corners[k - 1]),
                                            static_cast<std::uint32_t>(corners[k])});
        }
    }
    if (background->elements.empty()) {
        return nullptr;
    }
    background->values.assign(mesh.nodes.size(), 1.0); // of nodes that are no corners, which nothing uses
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (density[n] > 0.0) {
            background->values[n] = std::sqrt(area[n] / density[n]);
        }
    }
    return background;
}

} // namespace forefront
