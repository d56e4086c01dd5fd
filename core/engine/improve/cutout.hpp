#pragma once

#include "core/engine/improve/improve_workspace.hpp"
#include "core/engine/improve/smooth.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace forefront {

/// A copy of a few dozen nodes of the mesh to try changes on: the elements around its inner nodes. Inner nodes have
/// rings of neighbours, counter-clockwise, and may move; nodes on the rim do not move. Nodes have local numbers.
/// Coordinates are relative to the first node, in units of ρ there, in single precision, so the mesh must be checked
/// when a cutout is put back.
///
/// A change returns false if the cutout has no room for it, if it would join two nodes twice, or if it would leave an
/// element or a changed edge without an inner node. The cutout is then unusable, so try changes on a copy.
class Cutout {
  public:
    using Local = std::uint8_t;
    static constexpr Local kNone = 0xff;
    static constexpr unsigned kNodes = 72;
    static constexpr unsigned kRing = 12; ///< nodes have fewer elements than this

    /// A node with its ring.
    struct Node {
        float x, y, rho;
        NodeId id;            ///< kNoNode: new
        std::uint8_t valence; ///< elements around it; 0 if the node is fixed
        std::uint8_t size;    ///< nodes in the ring; 0 on the rim and for removed nodes
        Local ring[kRing];
    };

    Cutout() = default;
    Cutout(const Cutout &other) { *this = other; }
    Cutout &operator=(const Cutout &other) {
        count_ = other.count_;
        origin_ = other.origin_;
        scale_ = other.scale_;
        std::copy_n(other.nodes_.begin(), count_, nodes_.begin()); // the rest is unused
        return *this;
    }

    /// Copies the elements around a free node, its free neighbours and theirs. `rho`: ρ per node. Returns false if
    /// there are too many.
    bool take(const ImproveWorkspace &work, std::span<const float> rho, NodeId centre);

    unsigned count() const { return count_; }
    const Node &operator[](std::size_t n) const { return nodes_[n]; }
    bool inner(Local n) const { return nodes_[n].size != 0; }
    /// Returns the position of a node in the mesh.
    Vec2 place(Local n) const { return origin_ + scale_ * Vec2{nodes_[n].x, nodes_[n].y}; }
    /// Returns ρ at a node.
    float rho(Local n) const { return static_cast<float>(scale_) * nodes_[n].rho; }
    /// Returns the neighbour after (or before) `what` in the ring of an inner node, or kNone.
    Local after(Local at, Local what) const;
    Local before(Local at, Local what) const;

    /// Swaps the edge ab for the other diagonal of its two elements.
    bool swapEdge(Local a, Local b);
    /// Removes the inner node a and joins its neighbours to b. If b is an inner node, it moves to the middle of the
    /// edge. Removes two elements.
    bool merge(Local a, Local b);
    /// Divides the inner node a in two. The new node takes over `taken` neighbours of a, from position `first` of its
    /// ring on, and shares the neighbour before and the one after them. Adds two elements.
    bool divide(Local a, unsigned first, unsigned taken);
    /// Swaps a few edges as long as that brings valences nearer to 6.
    bool balanceValences();
    /// Moves each inner node in turn as NodeSmoother would, from the current positions of the others.
    void relax(int sweeps, const SmoothingAims &aims);

    /// A measure of how far the cutout is from the ideal.
    struct Loss {
        float sum = 0.0F; ///< Σ(1 − α − its usual value) over elements, plus a part of the same for δ over edges
        float minAlpha = 1.0F;
        float stretch = 0.0F; ///< mean of L/ρ − 1 over edges
    };
    Loss loss() const;

    /// Calls visit(a, b, c) for each element, where a is the lowest of its inner nodes.
    template <class Visit>
    void forEachElement(Visit &&visit) const {
        for (unsigned i = 0; i < count_; ++i) {
            const Node &n = nodes_[i];
            for (unsigned k = 0; k < n.size; ++k) {
                const Local j = n.ring[k], l = n.ring[k + 1U < n.size ? k + 1U : 0U];
                if ((j > i || !inner(j)) && (l > i || !inner(l))) {
                    visit(static_cast<Local>(i), j, l);
                }
            }
        }
    }

  private:
    using Numbers = std::array<Local, 128>; ///< local numbers by a hash of the node
    Local add(const ImproveWorkspace &work, std::span<const float> rho, NodeId id, Numbers &numbers);
    bool addRing(const ImproveWorkspace &work, std::span<const float> rho, Local n, Numbers &numbers);
    bool insertAfter(Local at, Local before, Local what);
    bool drop(Local at, Local what);
    void exchange(Local at, Local from, Local to);
    bool changeValence(Local n, int by);
    bool apexes(Local a, Local b, Local &c, Local &d) const;
    bool mergeRings(Local a, Local b, std::span<const Local> others);
    void balance(Node &n, const SmoothingAims &aims) const;
    int gainOfSwap(Local a, Local b, Local c, Local d) const;

    unsigned count_ = 0;
    Vec2 origin_;
    double scale_ = 1.0;
    std::array<Node, kNodes> nodes_;
};

} // namespace forefront
