#pragma once

#include "core/improve/smooth.hpp"
#include "core/improve/workspace.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace forefront {

/// A few dozen nodes of the mesh, copied out to try changes on: the elements around its inner nodes. Inner nodes have
/// rings of neighbours, counter-clockwise, and may move; those on the rim stay where they are. Nodes are numbered
/// locally. Lengths are in ρ at the first node, from there on; in floats, so what is put back must be looked at again.
///
/// Changes that a cutout has no room for, that would join two nodes twice, or that would leave an element or a changed
/// edge without an inner node return false and may leave the cutout in disorder: try them on a copy.
class Cutout {
  public:
    using Local = std::uint8_t;
    static constexpr Local kNone = 0xff;
    static constexpr unsigned kNodes = 72;
    static constexpr unsigned kRing = 12; ///< nodes with as many elements are not taken in

    struct Node {
        float x, y, rho;
        NodeId id;            ///< none: new
        std::uint8_t valence; ///< elements around; 0 where the node is held
        std::uint8_t size;    ///< nodes in the ring; 0 on the rim and where the node has gone
        Local ring[kRing];
    };

    Cutout() = default;
    Cutout(const Cutout &other) { *this = other; }
    Cutout &operator=(const Cutout &other) {
        count_ = other.count_;
        origin_ = other.origin_;
        scale_ = other.scale_;
        std::copy_n(other.nodes_.begin(), count_, nodes_.begin()); // the rest means nothing
        return *this;
    }

    /// Copies the elements around a free node, around its free neighbours and around theirs. `rho`: per node. False
    /// where that is too much.
    bool take(const ImproveWorkspace &work, std::span<const float> rho, NodeId centre);

    unsigned count() const { return count_; }
    const Node &operator[](std::size_t n) const { return nodes_[n]; }
    bool inner(Local n) const { return nodes_[n].size != 0; }
    /// In the plane of the mesh.
    Vec2 place(Local n) const { return origin_ + scale_ * Vec2{nodes_[n].x, nodes_[n].y}; }
    float rho(Local n) const { return static_cast<float>(scale_) * nodes_[n].rho; }
    /// The neighbours after and before one in the ring of an inner node; none where it is no neighbour.
    Local after(Local at, Local what) const;
    Local before(Local at, Local what) const;

    /// Turns the edge ab to the other diagonal of its two elements.
    bool turn(Local a, Local b);
    /// Takes the inner node a away: its neighbours are joined to b, which, where it is an inner node, comes to the
    /// middle of the edge. Two elements fewer.
    bool merge(Local a, Local b);
    /// Parts the inner node a in two: the new node takes over `taken` of the nodes in the ring of a, from place `first`
    /// on, and shares the one before and the one after. Two elements more.
    bool divide(Local a, unsigned first, unsigned taken);
    /// Turns edges as long as that brings valences nearer to 6, at most a few times.
    bool tidy();
    /// Moves each inner node in turn to where NodeSmoother would, as the others then lie.
    void relax(int sweeps, const SmoothingAims &aims);

    /// How bad the cutout is.
    struct Loss {
        float sum = 0.0F;     ///< Σ (1 − α − its usual value) over elements + a part of the same of δ over edges
        float least = 1.0F;   ///< α
        float stretch = 0.0F; ///< mean of L/ρ − 1 over edges
    };
    Loss loss() const;

    /// Calls visit(a, b, c) for each element, a being the least of its inner nodes.
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
    void exchange(Local at, Local was, Local is);
    bool changeValence(Local n, int by);
    bool apexes(Local a, Local b, Local &c, Local &d) const;
    bool mergeRings(Local a, Local b, std::span<const Local> others);
    void balance(Node &n, const SmoothingAims &aims) const;
    int gainOfTurn(Local a, Local b, Local c, Local d) const;

    unsigned count_ = 0;
    Vec2 origin_;
    double scale_ = 1.0;
    std::array<Node, kNodes> nodes_;
};

} // namespace forefront
