#pragma once

#include "core/mesh/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

/// An entity of a Gmsh model and what lies on it.
struct MshEntity {
    int dimension = 0;
    std::int32_t tag = 0;      ///< among entities of its dimension
    std::int32_t physical = 0; ///< our tag
    Box2 box;
    std::set<std::int32_t> bounds; ///< curves around a surface
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> parts; ///< indices of points, edges or elements

    /// Nodes of each of its parts.
    std::size_t cornerCount() const { return static_cast<std::size_t>(dimension) + 1; }
    /// As MSH numbers them: point, 2-node line, 3-node triangle.
    int elementType() const { return std::array{15, 1, 2}[static_cast<std::size_t>(dimension)]; }
};

/// Gmsh wants every node and element to belong to an entity of a model: each tagged point is a model point, each
/// boundary tag a curve, each region a surface. Views the mesh.
class MshModel {
  public:
    explicit MshModel(const Mesh &mesh);

    const std::vector<MshEntity> &entities() const { return entities_; }
    std::size_t count(int dimension) const;
    /// Entities that own nodes.
    std::size_t nodeBlocks() const;
    /// Nodes of a point, edge or element, by the dimension of its entity: the first dimension + 1 of the array count.
    Element nodesOf(int dimension, std::uint32_t part) const {
        return dimension == 0   ? Element{mesh_.points[part].node}
               : dimension == 1 ? Element{mesh_.edges[part].a, mesh_.edges[part].b}
                                : mesh_.elements[part];
    }
    /// Number of the first point, edge or element. Numbered as in the mesh, so that a reader can restore the order.
    std::size_t firstNumber(int dimension) const {
        return 1 + (dimension > 0 ? mesh_.points.size() : 0) + (dimension > 1 ? mesh_.edges.size() : 0);
    }

  private:
    std::size_t entityOf(int dimension, std::int32_t tag);
    void add(std::size_t number, std::uint32_t part);
    void addElements();
    void findBounds();

    const Mesh &mesh_;
    std::vector<MshEntity> entities_;
    std::map<std::pair<int, std::int32_t>, std::size_t> numbers_;
    std::vector<std::uint32_t> owner_; ///< entity of a node: the first, and so of the least dimension, that uses it
};

} // namespace forefront
