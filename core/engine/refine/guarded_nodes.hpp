#pragma once

#include "core/engine/mesh/tri_mesh.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace forefront {

/// The nodes of a mesh around which refinement must not leave sharper elements than it finds, since edges that may not
/// be divided could stop it there: at first the ends of these edges. New nodes are guarded inside elements whose nodes
/// all are. Remembers for each node how sharp the given elements around it are.
class GuardedNodes {
  public:
    /// `isKept`: whether a tagged edge, by its index, may not be divided.
    GuardedNodes(const TriMesh &given, const std::function<bool(std::uint32_t edge)> &isKept);

    /// Returns false if no node is guarded.
    bool any() const { return any_; }
    /// Returns true if a node of an element is guarded.
    bool guards(const Element &element) const;
    /// Takes over a new node, the last one, in an element or, as its first two nodes, on an edge.
    void add(const Element &around, unsigned corners);
    /// Forgets the node added last.
    void removeLast();
    /// Returns the greatest cosine of the least angles of the given elements around the nodes of an element.
    double given(const Element &element) const;
    /// Notes that an element became sharper than the given ones around it.
    void blame(const Element &element);
    bool anyBlamed() const { return !blamed_.empty(); }
    /// Guards the given nodes within a number of rings around those blamed, or all, for another refinement of the given
    /// mesh.
    void extend(const TriMesh &given, unsigned rings);
    void guardAll(const TriMesh &given);

  private:
    void forgetNew(const TriMesh &given);

    // By node:
    std::vector<bool> guarded_;
    std::vector<double> cosine_;
    std::vector<std::uint32_t> origin_; ///< the given node that it descends from
    std::vector<std::uint32_t> blamed_; ///< given nodes
    bool any_ = false;
};

/// Returns the cosine of the least angle of an element.
double leastAngleCosine(const TriMesh &mesh, const Element &element);

} // namespace forefront
