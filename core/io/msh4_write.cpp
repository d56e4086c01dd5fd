#include "core/io/msh_names.hpp"
#include "core/io/readers.hpp"
#include "core/mesh/edge_table.hpp"

#include <map>
#include <set>
#include <vector>

namespace forefront {

namespace {

struct Entity {
    int dimension = 0;
    std::int32_t tag = 0;      ///< among entities of its dimension
    std::int32_t physical = 0; ///< our tag
    Box2 box;
    std::set<std::int32_t> bounds; ///< curves around a surface
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> parts; ///< indices of points, edges or elements
};

/// Gmsh wants every node and element to belong to an entity of a model: each tagged point is a model point, each
/// boundary tag a curve, each region a surface.
class MshModel {
  public:
    explicit MshModel(const Mesh &mesh) : mesh_(mesh), owner_(mesh.nodes.size(), kNoIndex) {
        for (std::uint32_t p = 0; p < mesh.points.size(); ++p) {
            Entity &entity = entities_.emplace_back();
            entity.tag = static_cast<std::int32_t>(p) + 1;
            entity.physical = mesh.points[p].tag;
            add(entities_.size() - 1, p, {{mesh.points[p].node}});
        }
        for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
            add(entityOf(1, mesh.edges[e].tag), e, {{mesh.edges[e].a, mesh.edges[e].b}});
        }
        for (std::uint32_t e = 0; e < mesh.elements.size(); ++e) {
            add(entityOf(2, mesh.region(e)), e, mesh.elements[e]);
        }
        findBounds();
        for (std::uint32_t n = 0; n < owner_.size(); ++n) {
            if (owner_[n] == kNoIndex && !entities_.empty()) {
                owner_[n] = static_cast<std::uint32_t>(entities_.size() - 1);
            }
            if (owner_[n] != kNoIndex) {
                entities_[owner_[n]].nodes.push_back(n);
            }
        }
    }

    const std::vector<Entity> &entities() const { return entities_; }
    std::size_t count(int dimension) const {
        std::size_t number = 0;
        for (const Entity &entity : entities_) {
            number += entity.dimension == dimension ? 1 : 0;
        }
        return number;
    }

  private:
    std::size_t entityOf(int dimension, std::int32_t tag) {
        const auto [entry, added] = numbers_.emplace(std::pair(dimension, tag), entities_.size());
        if (added) {
            Entity &entity = entities_.emplace_back();
            entity.dimension = dimension;
            entity.tag = entity.physical = tag;
        }
        return entry->second;
    }

    void add(std::size_t number, std::uint32_t part, std::span<const NodeId> nodes) {
        Entity &entity = entities_[number];
        entity.parts.push_back(part);
        for (const NodeId node : nodes) {
            entity.box.add(mesh_.nodes[index(node)]);
            if (owner_[index(node)] == kNoIndex) {
                owner_[index(node)] = static_cast<std::uint32_t>(number);
            }
        }
    }

    void findBounds() {
        if (mesh_.elements.empty()) {
            return;
        }
        const EdgeTable edges(mesh_);
        for (const TaggedEdge &edge : mesh_.edges) {
            for (const HalfEdge side : edges.find(edge.a, edge.b)) {
                entities_[entityOf(2, mesh_.region(elementOf(side)))].bounds.insert(edge.tag);
            }
        }
    }

    const Mesh &mesh_;
    std::vector<Entity> entities_;
    std::map<std::pair<int, std::int32_t>, std::size_t> numbers_;
    std::vector<std::uint32_t> owner_; ///< entity of a node: the first, and so of the least dimension, that uses it
};

void writeEntities(const MshModel &model, TextWriter &out) {
    out << "$Entities\n" << model.count(0) << ' ' << model.count(1) << ' ' << model.count(2) << " 0\n";
    for (const Entity &entity : model.entities()) {
        out << entity.tag << ' ' << entity.box.min.x << ' ' << entity.box.min.y << " 0 ";
        if (entity.dimension > 0) {
            out << entity.box.max.x << ' ' << entity.box.max.y << " 0 ";
        }
        out << "1 " << entity.physical;
        if (entity.dimension > 0) {
            out << ' ' << entity.bounds.size();
            for (const std::int32_t curve : entity.bounds) {
                out << ' ' << curve;
            }
        }
        out << '\n';
    }
    out << "$EndEntities\n";
}

void writeNodes(const Mesh &mesh, const MshModel &model, TextWriter &out) {
    std::size_t blocks = 0;
    for (const Entity &entity : model.entities()) {
        blocks += entity.nodes.empty() ? 0 : 1;
    }
    const std::size_t count = blocks > 0 ? mesh.nodes.size() : 0;
    out << "$Nodes\n" << blocks << ' ' << count << ' ' << (count > 0 ? 1 : 0) << ' ' << count << '\n';
    for (const Entity &entity : model.entities()) {
        if (entity.nodes.empty()) {
            continue;
        }
        out << entity.dimension << ' ' << entity.tag << " 0 " << entity.nodes.size() << '\n';
        for (const std::uint32_t node : entity.nodes) {
            out << node + std::uint64_t{1} << '\n';
        }
        for (std::size_t k = 0; k < entity.nodes.size() && out.ok(); ++k) {
            out << mesh.nodes[entity.nodes[k]].x << ' ' << mesh.nodes[entity.nodes[k]].y << " 0\n";
        }
    }
    out << "$EndNodes\n";
}

void writeElements(const Mesh &mesh, const MshModel &model, TextWriter &out) {
    const std::size_t count = mesh.points.size() + mesh.edges.size() + mesh.elements.size();
    out << "$Elements\n"
        << model.entities().size() << ' ' << count << ' ' << (count > 0 ? 1 : 0) << ' ' << count << '\n';
    // Numbered as in the mesh, so that a reader can restore the order.
    const std::size_t firsts[] = {1, 1 + mesh.points.size(), 1 + mesh.points.size() + mesh.edges.size()};
    for (const Entity &entity : model.entities()) {
        constexpr int kTypes[] = {15, 1, 2};
        out << entity.dimension << ' ' << entity.tag << ' ' << kTypes[entity.dimension] << ' ' << entity.parts.size()
            << '\n';
        for (std::size_t k = 0; k < entity.parts.size() && out.ok(); ++k) {
            const std::uint32_t part = entity.parts[k];
            out << firsts[entity.dimension] + part;
            const auto node = [&](NodeId id) { out << ' ' << index(id) + 1; };
            if (entity.dimension == 0) {
                node(mesh.points[part].node);
            } else if (entity.dimension == 1) {
                node(mesh.edges[part].a);
                node(mesh.edges[part].b);
            } else {
                for (const NodeId id : mesh.elements[part]) {
                    node(id);
                }
            }
            out << '\n';
        }
    }
    out << "$EndElements\n";
}

} // namespace

void writeMsh4(const Mesh &mesh, TextWriter &out) {
    const MshModel model(mesh);
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    writePhysicalNames(mesh, out);
    writeEntities(model, out);
    writeNodes(mesh, model, out);
    writeElements(mesh, model, out);
}

} // namespace forefront
