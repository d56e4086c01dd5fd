#include "core/files/common/tagged_cells.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_groups.hpp"
#include "core/files/gmsh/msh_periodic.hpp"

namespace forefront {

namespace {

/// Writes the section $Periodic; nothing for a mesh without periodic parts.
void writeMsh2Periodic(const MeshView &mesh, const MshGroups &groups, TextWriter &out) {
    if (mesh.periodic.empty()) {
        return;
    }
    out << "$Periodic\n" << mesh.periodic.size() << '\n';
    for (const PeriodicLink &link : mesh.periodic) {
        out << "1 " << groups.number(1, link.to) << ' ' << groups.number(1, link.from) << "\nAffine";
        for (const double value : affineOf(link.map)) {
            out << ' ' << value;
        }
        const PeriodicPairs found = periodicPairs(mesh, link);
        out << '\n' << found.pairs.size() << '\n';
        for (const NodePair &pair : found.pairs) {
            out << index(pair.to) + 1 << ' ' << index(pair.from) + 1 << '\n';
        }
    }
    out << "$EndPeriodic\n";
}

} // namespace

/// Writes MSH 2.2, ASCII: each element line is "number type 2 group entity nodes", where both tags are the number of
/// the group.
void writeMsh2With(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    const MshGroups groups(mesh, options.keepTags);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    groups.writeNames(out);
    out << "$Nodes\n" << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ' ' << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << " 0\n";
    }
    out << "$EndNodes\n$Elements\n" << mesh.points.size() + mesh.edges.size() + mesh.elementCount() << '\n';
    std::size_t number = 0;
    const auto write = [&](CellKind kind, std::int32_t group, const auto &nodes) {
        out << ++number << ' ' << traitsOf(kind).gmsh << " 2 " << group << ' ' << group;
        for (const NodeId node : nodes) {
            out << ' ' << index(node) + 1;
        }
        out << '\n';
    };
    for (const TaggedNode &point : mesh.points) {
        write(CellKind::Point, groups.number(0, point.tag), std::span(&point.node, 1));
    }
    for (const TaggedEdge &edge : mesh.edges) {
        write(cellKindOf(edge), groups.number(1, edge.tag), EdgeNodes(edge));
    }
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            write(block.kind, groups.number(2, block.region(k)), block.nodesOf(k));
        }
    }
    out << "$EndElements\n";
    writeMsh2Periodic(mesh, groups, out);
    writeMshElevations(mesh, out);
    groups.writeOrigins(out, options.unit);
}

void writeMsh2(const MeshView &mesh, TextWriter &out) {
    writeMsh2With(mesh, {}, out);
}

} // namespace forefront
