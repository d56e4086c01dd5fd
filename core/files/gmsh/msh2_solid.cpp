#include "core/files/common/part_groups.hpp"
#include "core/files/common/solid_mesh.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_groups.hpp"

#include <cstdint>
#include <limits>

namespace forefront {

/// Writes prisms and hexahedra as MSH 2.2, ASCII: faces, then cells, each of the physical group of its part.
void writeMsh2Solid(const SolidMesh &mesh, TextWriter &out) {
    constexpr int kTriangle = 2, kQuadrilateral = 3, kHexahedron = 5, kPrism = 6;
    constexpr std::size_t kNameBytes = 127;
    const PartGroups groups(mesh.tags, {std::numeric_limits<std::int32_t>::max(), kNameBytes, asQuotable});
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << groups.groups().size() << '\n';
    for (const PartGroup &group : groups.groups()) {
        out << group.dimension + 1 << ' ' << group.number << " \"" << group.label << "\"\n";
    }
    out << "$EndPhysicalNames\n$Nodes\n" << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ' ' << mesh.nodes[n][0] << ' ' << mesh.nodes[n][1] << ' ' << mesh.nodes[n][2] << '\n';
    }
    out << "$EndNodes\n$Elements\n" << mesh.faces.size() + mesh.cells.size() << '\n';
    std::size_t number = 0;
    const auto write = [&](int type, std::int32_t group, std::span<const std::uint32_t> nodes) {
        out << ++number << ' ' << type << " 2 " << group << ' ' << group;
        for (const std::uint32_t node : nodes) {
            out << ' ' << node + std::uint64_t{1};
        }
        out << '\n';
    };
    for (std::size_t k = 0; k < mesh.faces.size() && out.ok(); ++k) {
        const SolidFace &face = mesh.faces[k];
        write(face.count == 3 ? kTriangle : kQuadrilateral, groups.of(1, face.tag).number, face.nodes());
    }
    for (std::size_t k = 0; k < mesh.cells.size() && out.ok(); ++k) {
        const SolidCell &cell = mesh.cells[k];
        write(cell.count == 6 ? kPrism : kHexahedron, groups.of(2, cell.region).number, cell.nodes());
    }
    out << "$EndElements\n";
    writeMshComments({}, mesh.unit, out);
}

} // namespace forefront
