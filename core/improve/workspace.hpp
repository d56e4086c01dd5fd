#pragma once

#include "core/base/raw_vector.hpp"
#include "core/base/thread_pool.hpp"
#include "core/mesh/edge_table.hpp"
#include "core/mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace forefront {

inline constexpr HalfEdge kNoHalfEdge = kNoIndex;

/// The side after h in its element, counter-clockwise, and the side before it.
constexpr HalfEdge nextSide(HalfEdge h) {
    return sideOf(h) == 2 ? h - 2 : h + 1;
}
constexpr HalfEdge previousSide(HalfEdge h) {
    return sideOf(h) == 0 ? h + 2 : h - 1;
}

/// What improving needs to know beside the mesh: 16 bytes per element and 20 per node.
struct ImproveWorkspace {
    /// After a stop it is not fit for use. `room`: for how many more nodes memory is asked for, unused until then.
    ImproveWorkspace(Mesh &mesh, ThreadPool &pool, const std::stop_token &stop = {}, std::size_t room = 0);

    /// More elements cannot be held: a bit of each half-edge is needed while elements are joined.
    static constexpr std::size_t kMostElements = 0x7fffffffU / 3U;
    /// Free nodes with more elements around them are held, too.
    static constexpr unsigned kMostValence = 64;
    /// Elements and nodes of a task: fixed, so that results do not depend on the number of threads.
    static constexpr std::size_t kChunk = 8192;
    /// Rings with more nodes are walked each time.
    static constexpr unsigned kRingNodes = 7;

    Mesh &mesh;
    ThreadPool &pool;
    /// The half-edge across; none on the boundary, between regions, on tagged edges and where the mesh does not
    /// conform. Kept up to date by swaps.
    RawVector<HalfEdge> twin;
    RawVector<HalfEdge> start;       ///< per node: a half-edge that starts there; none at a node without elements
    RawVector<std::uint8_t> fixed;   ///< per node: 1 where it may not move
    RawVector<std::uint8_t> valence; ///< elements around each free node; 0 for others
    RawVector<float> alpha;          ///< per element; smoothing borrows its memory meanwhile
    /// The nodes around a free node, counter-clockwise from its start on, as differences of indices: neighbours lie
    /// near in memory. The rest is 0; all is where one lies too far, or where there are more.
    using Ring = std::array<std::int16_t, kRingNodes>;
    RawVector<Ring> rings; ///< per node; meaningless where it is held

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
    /// Calls visit(node) for the nodes around a free node, counter-clockwise from its start on; the ring must be up to
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

    /// Brings ring and valence of a free node up to date after swaps around it.
    void renewRing(NodeId n);
    /// Makes the ring of a node, beginning at its least half-edge, or holds the node where it has too many elements.
    void beginRing(std::size_t n);
    /// Computes all α and returns the least, exactly as shapeFactor gives it; 0 for a mesh without elements.
    double measureAlpha(const std::stop_token &stop = {});
    /// The least α, from `alpha`, exactly as shapeFactor gives it.
    double leastAlpha(const std::stop_token &stop = {}) const;

  private:
    void setRing(std::size_t n, const std::array<NodeId, kRingNodes> &nodes, unsigned count);
};

/// Computed α above which the sign of the area is certain: the error of the computed area is below 1e-15 of Σl², since
/// differences of coordinates are rounded once.
inline constexpr double kCertainAlpha = 1e-12;

/// True when abc is counter-clockwise, decided exactly where the computed α leaves it open.
bool surelyPositive(double alpha, Vec2 a, Vec2 b, Vec2 c);

} // namespace forefront
