#include "core/improve/workspace.hpp"

#include "core/geometry/predicates.hpp"
#include "core/improve/join.hpp"
#include "core/mesh/quality.hpp"

#include <algorithm>
#include <limits>

namespace forefront {

ImproveWorkspace::ImproveWorkspace(Mesh &improved, ThreadPool &threads)
    : mesh(improved), pool(threads), twin(3 * mesh.elements.size()), start(mesh.nodes.size(), kNoHalfEdge),
      fixed(mesh.nodes.size(), 0), valence(mesh.nodes.size(), 0), alpha(mesh.elements.size()),
      rings(mesh.nodes.size()) {
    joinElements(*this);
    pool.forChunks(mesh.nodes.size(), kChunk, [this](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t n = begin; n < end; ++n) {
            beginRing(n);
        }
    });
}

void ImproveWorkspace::beginRing(std::size_t n) {
    const HalfEdge first = start[n];
    if (fixed[n] != 0 || first == kNoHalfEdge) {
        fixed[n] = 1;
        return;
    }
    std::array<NodeId, kRingNodes> nodes;
    unsigned count = 0, leastAt = 0;
    HalfEdge h = first;
    do {
        if (h < start[n]) {
            start[n] = h;
            leastAt = count;
        }
        if (count < kRingNodes) {
            nodes[count] = to(h);
        }
        h = twin[previousSide(h)];
    } while (++count < kMostValence && h != first);
    if (h != first) {
        fixed[n] = 1;
        return;
    }
    valence[n] = static_cast<std::uint8_t>(count);
    if (count <= kRingNodes) {
        std::rotate_copy(nodes.begin(), nodes.begin() + leastAt, nodes.begin() + count, rings[n].begin());
    }
}

void ImproveWorkspace::renewRing(NodeId n) {
    Ring &ring = rings[index(n)];
    unsigned count = 0;
    aroundFree(n, [&](HalfEdge h) {
        if (count < kRingNodes) {
            ring[count] = to(h);
        }
        ++count;
    });
    valence[index(n)] = static_cast<std::uint8_t>(count);
}

double ImproveWorkspace::alphaOf(std::size_t e) const {
    const Element &n = mesh.elements[e];
    return shapeFactor(at(n[0]), at(n[1]), at(n[2]));
}

double ImproveWorkspace::measureAlpha() {
    pool.forChunks(alpha.size(), kChunk, [this](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t e = begin; e < end; ++e) {
            alpha[e] = static_cast<float>(alphaOf(e));
        }
    });
    return leastAlpha();
}

double ImproveWorkspace::leastAlpha() const {
    if (alpha.empty()) {
        return 0.0;
    }
    // Rounding to float keeps the order but for ties.
    const float rounded = *std::min_element(alpha.begin(), alpha.end());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < alpha.size(); ++e) {
        if (alpha[e] == rounded) {
            least = std::min(least, alphaOf(e));
        }
    }
    return least;
}

bool surelyPositive(double a, Vec2 p, Vec2 q, Vec2 r) {
    return a > kCertainAlpha || (a > -kCertainAlpha && orientation(p, q, r) > 0);
}

} // namespace forefront
