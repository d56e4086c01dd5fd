#include "tests/support/flat_corners.hpp"

#include <algorithm>
#include <numbers>
#include <set>
#include <utility>

namespace forefront::testing {

std::optional<Vec2> unforcedFlatPlace(const MeshView &mesh) {
    constexpr double kForcing = std::numbers::pi / 180.0;
    std::set<std::pair<NodeId, NodeId>> given;
    for (const TaggedEdge &edge : mesh.edges) {
        given.insert(std::minmax(edge.a, edge.b));
    }
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const auto corners = mesh.cornersOf(e);
        std::optional<Vec2> flat;
        bool forced = false;
        for (std::size_t k = 0; corners.size() == 4 && k < 4; ++k) {
            const Vec2 before = mesh.nodes[index(corners[(k + 3) & 3])], at = mesh.nodes[index(corners[k])];
            const Vec2 after = mesh.nodes[index(corners[(k + 1) & 3])];
            const double sine = cross(after - at, before - at) / (distance(after, at) * distance(before, at));
            if (sine < 1e-9) {
                flat = at;
            }
            const bool counts = given.contains(std::minmax(corners[(k + 3) & 3], corners[k])) &&
                                given.contains(std::minmax(corners[k], corners[(k + 1) & 3]));
            forced = forced || (counts && sine < kForcing && dot(after - at, before - at) > 0.0);
        }
        if (flat && !forced) {
            return flat;
        }
    }
    return std::nullopt;
}

} // namespace forefront::testing
