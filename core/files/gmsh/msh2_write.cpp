#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_groups.hpp"

namespace forefront {

namespace {

constexpr int kPointType = 15, kLineType = 1, kTriangleType = 2;

} // namespace

/// Writes MSH 2.2, ASCII: each element line is "number type 2 group entity nodes", where both tags are the number of
/// the group.
void writeMsh2(const TriMesh &mesh, TextWriter &out) {
    const MshGroups groups(mesh);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    groups.writeNames(out);
    out << "$Nodes\n" << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ' ' << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << " 0\n";
    }
    out << "$EndNodes\n$Elements\n" << mesh.points.size() + mesh.edges.size() + mesh.elements.size() << '\n';
    std::size_t number = 0;
    const auto begin = [&](int type, std::int32_t group) -> TextWriter & {
        return out << ++number << ' ' << type << " 2 " << group << ' ' << group;
    };
    for (const TaggedNode &point : mesh.points) {
        begin(kPointType, groups.number(0, point.tag)) << ' ' << index(point.node) + 1 << '\n';
    }
    for (const TaggedEdge &edge : mesh.edges) {
        begin(kLineType, groups.number(1, edge.tag)) << ' ' << index(edge.a) + 1 << ' ' << index(edge.b) + 1 << '\n';
    }
    for (std::size_t e = 0; e < mesh.elements.size() && out.ok(); ++e) {
        begin(kTriangleType, groups.number(2, mesh.region(e)));
        for (const NodeId node : mesh.elements[e]) {
            out << ' ' << index(node) + 1;
        }
        out << '\n';
    }
    out << "$EndElements\n";
    groups.writeOrigins(out);
}

} // namespace forefront
