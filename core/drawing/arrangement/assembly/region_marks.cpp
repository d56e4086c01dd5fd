#include "core/drawing/arrangement/assembly/assembler.hpp"
#include "core/drawing/arrangement/assembly/face_points.hpp"
#include "core/engine/base/ids.hpp"

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
    std::vector<std::uint32_t> starts(faces_.count + 1, 0);
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
    forEach([&](std::uint32_t, std::uint32_t face, bool) { ++starts[face + 1]; });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<FaceEdge> edges(starts.back());
    std::vector<std::uint32_t> fill(starts.begin(), starts.end() - 1);
    forEach([&](std::uint32_t e, std::uint32_t face, bool twice) {
        const PlaneEdge &edge = snapped_.edges[e];
        edges[fill[face]++] = {snapped_.nodes[edge.a], snapped_.nodes[edge.b], twice};
    });
    for (std::uint32_t face = 1; face < faces_.count; ++face) {
        if (starts[face] == starts[face + 1]) {
            continue;
        }
        const std::uint32_t feature = cover_.owner[face];
        if (const auto at = pointInFace(std::span(edges).subspan(starts[face], starts[face + 1] - starts[face]))) {
            result_.domain.regionMarkers.push_back({*at, input_.features[feature].regionTag});
            result_.markerFeature.push_back(feature);
        }
    }
}

} // namespace forefront
