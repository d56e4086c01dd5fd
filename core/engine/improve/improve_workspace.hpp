#pragma once

#include "core/engine/base/raw_vector.hpp"
#include "core/engine/base/thread_pool.hpp"
#include "core/engine/improve/improve_watch.hpp"
#include "core/engine/mesh/tri_half_edge.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace forefront {

/// Returns the side after h in its element, counter-clockwise.
constexpr HalfEdge nextSide(HalfEdge h) {
    return sideOf(h) == 2 ? h - 2 : h + 1;
}
/// Returns the side before h in its element.
constexpr HalfEdge previousSide(HalfEdge h) {
    return sideOf(h) == 0 ? h + 2 : h - 1;
}

/// The data that improvement keeps beside the mesh: 16 bytes per element and 20 per node.
struct ImproveWorkspace {
    /// Unusable after a stop. `room`: number of further nodes to reserve memory for.
    ImproveWorkspace(TriMesh &mesh, ThreadPool &pool, const std::stop_token &stop = {}, std::size_t room = 0);

    /// Maximum number of elements: joining them uses one bit of each half-edge.
    static constexpr std::size_t kMaxElements = 0x7fffffffU / 3U;
    /// Nodes with more elements around them are fixed.
    static constexpr unsigned kMaxValence = 64;
    /// Elements or nodes of a task. Fixed, so that results do not depend on the number of threads.
    static constexpr std::size_t kChunk = 8192;
    /// Maximum number of nodes of a stored ring. Longer rings are walked each time.
    static constexpr unsigned kRingNodes = 7;

    TriMesh &mesh;
    ThreadPool &pool;
    ImproveWatch *watch = nullptr; ///< learns of each change; null: none
    /// The half-edge across; none on the boundary, between regions, on tagged edges and where the mesh does not
    /// conform. Swaps keep it up to date.
    RawVector<HalfEdge> twin;
    RawVector<HalfEdge> start;       ///< per node: a half-edge that starts there, if any
    RawVector<std::uint8_t> fixed;   ///< per node: 1 if it must not move
    RawVector<std::uint8_t> valence; ///< per node: elements around it if free, else 0
    RawVector<float> alpha;          ///< per element; smoothing uses its memory meanwhile
    /// The nodes around a free node, counter-clockwise from its start on, as differences of indices, since neighbours
    /// lie close in memory; then 0. All 0 where a difference is too large or the ring too long.
    using Ring = std::array<std::int16_t, kRingNodes>;
    RawVector<Ring> rings; ///< per node; undefined for fixed nodes

    Vec2 at(NodeId n) const { return mesh.nodes[index(n)]; }
    NodeId from(HalfEdge h) const { return mesh.elements[elementOf(h)][sideOf(h)]; }
    NodeId to(HalfEdge h) const { return mesh.elements[elementOf(h)][(sideOf(h) + 1U) % 3U]; }
    NodeId apex(HalfEdge h) const { return mesh.elements[elementOf(h)][(sideOf(h) + 2U) % 3U]; }
    bool isFree(std::size_t n) const { return fixed[n] == 0; }
    bool isFree(NodeId n) const { return fixed[index(n)] == 0; }
    double alphaOf(std::size_t e) const;
    void addValence(NodeId n, int step) {
        if (isFree(n)) {
            valence[index(n)] = static_cast<std::uint8_t>(valence[index(n)] + step);
        }
    }

    /// Calls visit(half-edge from n) for the elements around a free node, counter-clockwise.
    template <class Visit>
    void aroundFree(NodeId n, Visit &&visit) const {
        const HalfEdge first = start[index(n)];
        HalfEdge h = first;
        do {
            visit(h);
            h = twin[previousSide(h)];
        } while (h != first);
    }
    /// Calls visit(node) for the nodes around a free node, counter-clockwise from its start on. The ring must be up to
    /// date.
    template <class Visit>
    void ringOfFree(std::size_t n, Visit &&visit) const {
        const Ring &ring = rings[n];
        if (ring[0] == 0) {
            aroundFree(NodeId{static_cast<std::uint32_t>(n)}, [&](HalfEdge h) { visit(to(h)); });
            return;
        }
        for (unsigned k = 0; k < valence[n]; ++k) {
            visit(NodeId{static_cast<std::uint32_t>(static_cast<std::int64_t>(n) + ring[k])});
        }
    }

    /// Tells the watch of a change.
    void report(ImproveChange change, const ChangedParts &parts = {}) const {
        if (watch != nullptr) {
            watch->changed(change, mesh, mesh.nodes, parts);
        }
    }

    /// Updates the ring and the valence of a free node after swaps around it.
    void renewRing(NodeId n);
    /// Makes the ring of a node, from its lowest half-edge on, or fixes the node if it has too many elements.
    void beginRing(std::size_t n);
    /// Computes α of all elements and returns the minimum, exactly as shapeFactor computes it; 0 without elements.
    double measureAlpha(const std::stop_token &stop = {});
    /// Returns the minimum α from `alpha`, exactly as shapeFactor computes it.
    double minAlpha(const std::stop_token &stop = {}) const;

  private:
    void setRing(std::size_t n, const std::array<NodeId, kRingNodes> &nodes, unsigned count);
};

/// A computed α above this has a certain sign: the error of the computed area is below 1e-15 of Σl², since differences
/// of coordinates are rounded once.
inline constexpr double kCertainAlpha = 1e-12;

/// Returns true if abc is counter-clockwise, decided exactly where the computed α is not certain.
bool surelyPositive(double alpha, Vec2 a, Vec2 b, Vec2 c);

} // namespace forefront
