#pragma once

#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/gmsh/msh_groups.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace forefront {

/// Parts of an entity that are of one kind.
struct MshRun {
    CellKind kind;
    std::size_t begin, end; ///< their range in the list of parts
};

/// An entity of a Gmsh model with the nodes and elements on it.
struct MshEntity {
    int dimension = 0;
    std::int32_t tag = 0;      ///< its number in the file
    std::int32_t physical = 0; ///< number of its physical group
    Box2 box;
    std::set<std::int32_t> bounds; ///< curves around a surface
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> parts; ///< indices of points, edges or elements, by kind
    std::vector<MshRun> runs;         ///< the kinds of its parts
};

/// The geometric model that Gmsh expects every node and element to belong to: each tagged point is a model point, each
/// boundary tag a curve, each region a surface. Entities have distinct numbers across dimensions too, because GetFEM
/// treats them as regions. The view of the mesh and its groups must outlive it.
class MshModel {
  public:
    MshModel(const MeshView &mesh, const MshGroups &groups);

    const std::vector<MshEntity> &entities() const { return entities_; }
    std::size_t count(int dimension) const;
    /// Returns the number of entities that own nodes.
    std::size_t nodeBlocks() const;
    /// Returns the number of runs of all entities.
    std::size_t cellBlocks() const;
    /// Calls visit(NodeId) for each node of a point, edge or element by the dimension of its entity.
    template <class Visit>
    void forEachNode(int dimension, std::uint32_t part, Visit visit) const {
        if (dimension == 0) {
            visit(mesh_.points[part].node);
        } else if (dimension == 1) {
            const EdgeNodes nodes(mesh_.edges[part]);
            std::for_each(nodes.begin(), nodes.end(), visit);
        } else {
            const std::span<const NodeId> nodes = mesh_.nodesOf(part);
            std::for_each(nodes.begin(), nodes.end(), visit);
        }
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
    CellKind kindOf(int dimension, std::uint32_t part) const;
    void findRuns(MshEntity &entity) const;

    const MeshView &mesh_;
    const MshGroups &groups_;
    std::vector<MshEntity> entities_;
    std::map<std::pair<int, std::int32_t>, std::size_t> numbers_;
    std::vector<std::uint32_t> owner_; ///< entity of a node: the first that uses it, so that of the lowest dimension
};

} // namespace forefront
