#pragma once

#include "core/engine/mesh/tri_mesh.hpp"
#include "core/files/gmsh/msh_groups.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

/// An entity of a Gmsh model with the nodes and elements on it.
struct MshEntity {
    int dimension = 0;
    std::int32_t tag = 0;      ///< its number in the file
    std::int32_t physical = 0; ///< number of its physical group
    Box2 box;
    std::set<std::int32_t> bounds; ///< curves around a surface
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> parts; ///< indices of points, edges or elements

    /// Returns the number of nodes of each of its parts.
    std::size_t cornerCount() const { return static_cast<std::size_t>(dimension) + 1; }
    /// Returns the MSH number of its element type: point, 2-node line or 3-node triangle.
    int elementType() const { return std::array{15, 1, 2}[static_cast<std::size_t>(dimension)]; }
};

/// The geometric model that Gmsh expects every node and element to belong to: each tagged point is a model point, each
/// boundary tag a curve, each region a surface. Entities have distinct numbers across dimensions too, because GetFEM
/// treats them as regions. Views the mesh and its groups.
class MshModel {
  public:
    MshModel(const TriMesh &mesh, const MshGroups &groups);

    const std::vector<MshEntity> &entities() const { return entities_; }
    std::size_t count(int dimension) const;
    /// Returns the number of entities that own nodes.
    std::size_t nodeBlocks() const;
    /// Returns the nodes of a point, edge or element by the dimension of its entity; the first dimension + 1 are used.
    Element nodesOf(int dimension, std::uint32_t part) const {
        return dimension == 0   ? Element{mesh_.points[part].node}
               : dimension == 1 ? Element{mesh_.edges[part].a, mesh_.edges[part].b}
                                : mesh_.elements[part];
    }
    /// Returns the number of the first point, edge or element. They are numbered in the order of the mesh, so that a
    /// reader can restore it.
    std::size_t firstNumber(int dimension) const {
        return 1 + (dimension > 0 ? mesh_.points.size() : 0) + (dimension > 1 ? mesh_.edges.size() : 0);
    }

  private:
    std::size_t entityOf(int dimension, std::int32_t tag);
    void add(std::size_t number, std::uint32_t part);
    void addElements();
    void findBounds();

    const TriMesh &mesh_;
    const MshGroups &groups_;
    std::vector<MshEntity> entities_;
    std::map<std::pair<int, std::int32_t>, std::size_t> numbers_;
    std::vector<std::uint32_t> owner_; ///< entity of a node: the first that uses it, so that of the lowest dimension
};

} // namespace forefront
