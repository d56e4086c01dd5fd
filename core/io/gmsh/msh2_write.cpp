#include "core/io/gmsh/msh_names.hpp"
#include "core/io/names.hpp"
#include "core/io/readers.hpp"

namespace forefront {

namespace {

constexpr int kPointType = 15, kLineType = 1, kTriangleType = 2;

} // namespace

void writePhysicalNames(const Mesh &mesh, TextWriter &out) {
    const TagList tags = tagsOf(mesh);
    out << "$PhysicalNames\n" << tags.points.size() + tags.edges.size() + tags.regions.size() << '\n';
    int dimension = 0;
    for (const auto *names : {&tags.points, &tags.edges, &tags.regions}) {
        for (const auto &[tag, name] : *names) {
            out << dimension << ' ' << tag << " \"" << asQuotable(name) << "\"\n";
        }
        ++dimension;
    }
    out << "$EndPhysicalNames\n";
}

/// Gmsh MSH 2.2, ASCII: every element line is "number type 2 physical-tag geometry-tag nodes", both tags ours.
void writeMsh2(const Mesh &mesh, TextWriter &out) {
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    writePhysicalNames(mesh, out);
    out << "$Nodes\n" << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ' ' << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << " 0\n";
    }
    out << "$EndNodes\n$Elements\n" << mesh.points.size() + mesh.edges.size() + mesh.elements.size() << '\n';
    std::size_t number = 0;
    const auto begin = [&](int type, std::int32_t tag) -> TextWriter & {
        return out << ++number << ' ' << type << " 2 " << tag << ' ' << tag;
    };
    for (const TaggedNode &point : mesh.points) {
        begin(kPointType, point.tag) << ' ' << index(point.node) + 1 << '\n';
    }
    for (const TaggedEdge &edge : mesh.edges) {
        begin(kLineType, edge.tag) << ' ' << index(edge.a) + 1 << ' ' << index(edge.b) + 1 << '\n';
    }
    for (std::size_t e = 0; e < mesh.elements.size() && out.ok(); ++e) {
        begin(kTriangleType, mesh.region(e));
        for (const NodeId node : mesh.elements[e]) {
            out << ' ' << index(node) + 1;
        }
        out << '\n';
    }
    out << "$EndElements\n";
}

} // namespace forefront
