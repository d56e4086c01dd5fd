#pragma once

#include "core/engine/mesh/tri_half_edge.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace forefront {

/// A mesh of triangles with its neighbours, in which edges are swapped, nodes inserted and tagged edges divided. Nodes,
/// elements and tagged edges keep their numbers; new ones follow. Changes the mesh that it was made of, which must be
/// valid and outlive it. All signs are exact.
class InsertionMesh {
  public:
    explicit InsertionMesh(TriMesh &mesh);

    const TriMesh &mesh() const { return mesh_; }
    std::uint32_t elementCount() const { return static_cast<std::uint32_t>(mesh_.elements.size()); }
    /// Returns the half-edge across, or kNoHalfEdge at the boundary.
    HalfEdge across(HalfEdge h) const { return across_[h]; }
    /// Returns the index of the tagged edge that a half-edge lies on, or kNoIndex.
    std::uint32_t taggedEdge(HalfEdge h) const { return tagged_[h]; }
    /// Returns a half-edge of a tagged edge.
    HalfEdge halfEdgeOf(std::uint32_t edge) const { return sideOfTagged_[edge]; }
    NodeId startOf(HalfEdge h) const { return mesh_.elements[elementOf(h)][sideOf(h)]; }
    NodeId endOf(HalfEdge h) const { return mesh_.elements[elementOf(h)][(sideOf(h) + 1) % 3]; }
    /// Returns the node of the half-edge's element that is not on it.
    NodeId apexOf(HalfEdge h) const { return mesh_.elements[elementOf(h)][(sideOf(h) + 2) % 3]; }
    Vec2 place(NodeId n) const { return mesh_.nodes[index(n)]; }

    /// Where a straight walk from the centre of an element towards a point ends.
    struct Walk {
        enum class End : std::uint8_t {
            Inside,  ///< in the element of `side`; the point may lie on one of its untagged edges
            Blocked, ///< at the tagged edge of `side`, which the walk would cross or which the point lies on
            Lost     ///< the point is a node, or nowhere
        };
        End end = End::Lost;
        HalfEdge side = kNoHalfEdge;
    };
    Walk walk(std::size_t element, Vec2 to) const;

    /// Appends the tagged edges, seen from a point inside an element, that bound the elements whose circumcircles
    /// contain the point and that the point sees.
    void tagsAround(std::size_t element, Vec2 point, std::vector<std::uint32_t> &found);

    /// Swaps edges around an element until no untagged one fails the test of Delaunay's circle with its two elements.
    void swapAround(std::size_t element);
    /// Inserts a node in an element that a walk to it has found, and swaps edges around it by the circle test. Returns
    /// false and changes nothing if it would make an element that is not positive.
    bool insert(std::size_t element, Vec2 point);
    /// Divides a tagged edge by a node, and swaps edges around it. The edge keeps the half at its node a; the other
    /// half becomes the last tagged edge. Returns false and changes nothing if an element would not be positive.
    bool divide(std::uint32_t edge, Vec2 point);

    /// Returns the elements that the last change made or changed.
    const std::vector<std::uint32_t> &changed() const { return changed_; }
    /// Records changes from now on, so that they can be taken back or kept. Not while others are recorded.
    void beginTrial();
    /// Returns the elements of changed() that were there when the trial began, with the nodes that they had.
    const std::vector<std::pair<std::uint32_t, Element>> &replaced() const { return trial_.elements; }
    void keepTrial() { trial_.active = false; }
    /// Takes back all changes since beginTrial().
    void undoTrial();
    /// Returns the number of edges swapped so far.
    std::size_t swaps() const { return swaps_; }

  private:
    /// A side that an element gets: what lies across it, and on it.
    struct Side {
        HalfEdge across = kNoHalfEdge;
        std::uint32_t tagged = kNoIndex;
    };
    /// What a trial changed, as it was before; the oldest first.
    struct Trial {
        bool active = false;
        std::size_t nodes = 0, elementCount = 0, edgeCount = 0, swaps = 0;
        std::vector<std::pair<std::uint32_t, Element>> elements;
        std::vector<std::pair<HalfEdge, Side>> sides;
        std::vector<std::pair<std::uint32_t, HalfEdge>> sidesOfTagged;
        std::vector<std::pair<std::uint32_t, TaggedEdge>> edges;
    };
    void record(std::size_t element, const std::array<Side, 3> &next);
    Side sideAt(HalfEdge h) const { return {across_[h], tagged_[h]}; }
    bool positive(NodeId a, NodeId b, Vec2 point) const;
    std::uint32_t newElement(std::size_t like);
    void set(std::size_t element, const Element &nodes, const std::array<Side, 3> &sides);
    /// Returns true if a half-edge may be swapped and fails the test of Delaunay's circle.
    bool failsCircleTest(HalfEdge h) const;
    void swap(HalfEdge h);
    void swapWhereNeeded();
    bool insertOnEdge(HalfEdge h, Vec2 point);
    void splitEdge(HalfEdge h, NodeId node, std::uint32_t first, std::uint32_t second);
    void splitElement(std::size_t element, NodeId node);

    TriMesh &mesh_;
    std::vector<HalfEdge> across_;
    std::vector<std::uint32_t> tagged_;
    std::vector<HalfEdge> sideOfTagged_;
    std::vector<HalfEdge> open_; ///< sides to test
    std::vector<std::uint32_t> changed_, cavity_, mark_;
    std::uint32_t round_ = 0;
    std::size_t swaps_ = 0;
    Trial trial_;
};

} // namespace forefront
