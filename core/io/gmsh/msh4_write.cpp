#include "core/io/gmsh/gmsh.hpp"
#include "core/io/gmsh/msh_model.hpp"

namespace forefront {

namespace {

void writeEntities(const MshModel &model, TextWriter &out) {
    out << "$Entities\n" << model.count(0) << ' ' << model.count(1) << ' ' << model.count(2) << " 0\n";
    for (const MshEntity &entity : model.entities()) {
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
    const std::size_t blocks = model.nodeBlocks();
    const std::size_t count = blocks > 0 ? mesh.nodes.size() : 0;
    out << "$Nodes\n" << blocks << ' ' << count << ' ' << (count > 0 ? 1 : 0) << ' ' << count << '\n';
    for (const MshEntity &entity : model.entities()) {
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
    for (const MshEntity &entity : model.entities()) {
        out << entity.dimension << ' ' << entity.tag << ' ' << entity.elementType() << ' ' << entity.parts.size()
            << '\n';
        for (std::size_t k = 0; k < entity.parts.size() && out.ok(); ++k) {
            const std::uint32_t part = entity.parts[k];
            out << model.firstNumber(entity.dimension) + part;
            const Element nodes = model.nodesOf(entity.dimension, part);
            for (std::size_t node = 0; node < entity.cornerCount(); ++node) {
                out << ' ' << index(nodes[node]) + 1;
            }
            out << '\n';
        }
    }
    out << "$EndElements\n";
}

} // namespace

/// MSH 4.1, ASCII.
void writeMsh4(const Mesh &mesh, TextWriter &out) {
    const MshGroups groups(mesh);
    const MshModel model(mesh, groups);
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    groups.writeNames(out);
    writeEntities(model, out);
    writeNodes(mesh, model, out);
    writeElements(mesh, model, out);
    groups.writeOrigins(out);
}

} // namespace forefront
