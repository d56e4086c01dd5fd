#include "core/drawing/arrangement/assembly/assembler.hpp"
#include "core/drawing/arrangement/assembly/face_points.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/rows.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

/// Returns, per face, the smallest index among the faces that it merges with when the dropped edges are removed.
std::vector<std::uint32_t> Assembler::joinFaces() const {
    std::vector<std::uint32_t> root(faces_.count);
    std::iota(root.begin(), root.end(), 0U);
    const auto rootOf = [&](std::uint32_t face) {
        while (root[face] != face) {
            face = root[face] = root[root[face]];
        }
        return face;
    };
    for (std::uint32_t e = 0; e < fate_.size(); ++e) {
        if (!kept(e)) {
            const std::uint32_t left = rootOf(faces_.left[e]), right = rootOf(faces_.right[e]);
            root[std::max(left, right)] = std::min(left, right);
        }
    }
    for (std::uint32_t face = 0; face < faces_.count; ++face) {
        root[face] = rootOf(face);
    }
    return root;
}

/// Puts a marker into every face inside, in the order of the faces' first edges in the domain.
void Assembler::markRegions() {
    const std::vector<std::uint32_t> root = joinFaces();
    const auto forEach = [&](const auto &visit) { // edges of the domain, on the faces inside
        for (std::uint32_t e = 0; e < fate_.size(); ++e) {
            const std::uint32_t left = root[faces_.left[e]], right = root[faces_.right[e]];
            if (kept(e) && inside(left)) {
                visit(e, left, left == right);
            }
            if (kept(e) && right != left && inside(right)) {
                visit(e, right, false);
            }
        }
    };
    const Rows<FaceEdge> edges(faces_.count, [&](const auto &add) {
        forEach([&](std::uint32_t e, std::uint32_t face, bool twice) {
            const PlaneEdge &edge = snapped_.edges[e];
            add(face, FaceEdge{snapped_.nodes[edge.a], snapped_.nodes[edge.b], twice});
        });
    });
    for (std::uint32_t face = 1; face < faces_.count; ++face) {
        if (edges[face].empty()) {
            continue;
        }
        const std::uint32_t feature = cover_.owner[face];
        if (const auto at = pointInFace(edges[face])) {
            result_.domain.regionMarkers.push_back({*at, input_.features[feature].regionTag});
            result_.markerFeature.push_back(feature);
        }
    }
}

} // namespace forefront
