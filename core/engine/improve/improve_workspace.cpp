#include "core/engine/improve/improve_workspace.hpp"

#include "core/engine/geometry/predicates.hpp"
#include "core/engine/improve/join.hpp"
#include "core/engine/mesh/quality.hpp"

#include <algorithm>
#include <limits>

namespace forefront {

ImproveWorkspace::ImproveWorkspace(TriMesh &improved, ThreadPool &threads, const std::stop_token &stop,
                                   std::size_t room)
    : mesh(improved), pool(threads) {
    const auto make = [](auto &list, std::size_t size, std::size_t more) {
        list.reserve(size + more);
        list.resize(size);
    };
    const std::size_t elements = mesh.elements.size(), nodes = mesh.nodes.size();
    make(twin, 3 * elements, 6 * room);
    make(start, nodes, room);
    make(fixed, nodes, room);
    make(valence, nodes, room);
    alpha.reserve(std::max(elements + 2 * room, 2 * (nodes + room))); // smoothing keeps its moves here
    alpha.resize(elements);
    rings.reserve(nodes + room);
    joinElements(*this, stop);
    if (stop.stop_requested()) {
        return;
    }
    rings.resize(mesh.nodes.size());
    pool.forChunks(
        mesh.nodes.size(), kChunk,
        [this](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t n = begin; n < end; ++n) {
                beginRing(n);
            }
        },
        stop);
}

void ImproveWorkspace::setRing(std::size_t n, const std::array<NodeId, kRingNodes> &nodes, unsigned count) {
    Ring ring{};
    bool fits = count <= kRingNodes;
    for (unsigned k = 0; fits && k < count; ++k) {
        const std::int64_t step = static_cast<std::int64_t>(index(nodes[k])) - static_cast<std::int64_t>(n);
        ring[k] = static_cast<std::int16_t>(step);
        fits = ring[k] == step;
    }
    rings[n] = fits ? ring : Ring{};
}

void ImproveWorkspace::beginRing(std::size_t n) {
    valence[n] = 0;
    const HalfEdge first = start[n];
    if (fixed[n] != 0 || first == kNoHalfEdge) {
        fixed[n] = 1;
        return;
    }
    std::array<NodeId, kRingNodes> nodes;
    unsigned count = 0, minAt = 0;
    HalfEdge h = first;
    do {
        if (h < start[n]) {
            start[n] = h;
            minAt = count;
        }
        if (count < kRingNodes) {
            nodes[count] = to(h);
        }
        h = twin[previousSide(h)];
    } while (++count < kMaxValence && h != first);
    if (h != first) {
        fixed[n] = 1;
        return;
    }
    valence[n] = static_cast<std::uint8_t>(count);
    if (count <= kRingNodes) {
        std::rotate(nodes.begin(), nodes.begin() + minAt, nodes.begin() + count);
    }
    setRing(n, nodes, count);
}

void ImproveWorkspace::renewRing(NodeId n) {
    std::array<NodeId, kRingNodes> nodes;
    unsigned count = 0;
    aroundFree(n, [&](HalfEdge h) {
        if (count < kRingNodes) {
            nodes[count] = to(h);
        }
        ++count;
    });
    valence[index(n)] = static_cast<std::uint8_t>(count);
    setRing(index(n), nodes, count);
}

double ImproveWorkspace::alphaOf(std::size_t e) const {
    const Element &n = mesh.elements[e];
    return shapeFactor(at(n[0]), at(n[1]), at(n[2]));
}

double ImproveWorkspace::measureAlpha(const std::stop_token &stop) {
    pool.forChunks(
        alpha.size(), kChunk,
        [this](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t e = begin; e < end; ++e) {
                alpha[e] = static_cast<float>(alphaOf(e));
            }
        },
        stop);
    return minAlpha(stop);
}

double ImproveWorkspace::minAlpha(const std::stop_token &stop) const {
    if (alpha.empty()) {
        return 0.0;
    }
    std::vector<double> minima((alpha.size() + kChunk - 1) / kChunk, std::numeric_limits<double>::infinity());
    pool.forChunks(
        alpha.size(), kChunk,
        [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            // Rounding to float keeps the order except for ties.
            const float rounded = *std::min_element(alpha.data() + begin, alpha.data() + end);
            for (std::size_t e = begin; e < end; ++e) {
                if (alpha[e] == rounded) {
                    minima[chunk] = std::min(minima[chunk], alphaOf(e));
                }
            }
        },
        stop);
    return *std::min_element(minima.begin(), minima.end());
}

bool surelyPositive(double a, Vec2 p, Vec2 q, Vec2 r) {
    return a > kCertainAlpha || (a > -kCertainAlpha && orientation(p, q, r) > 0);
}

} // namespace forefront
