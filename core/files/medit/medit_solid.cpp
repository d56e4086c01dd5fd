#include "core/files/common/solid_mesh.hpp"
#include "core/files/medit/medit.hpp"

#include <algorithm>
#include <cstdint>

namespace forefront {

namespace {

template <class Item>
void writeMeditSolids(const std::vector<Item> &items, const char *keyword, std::uint8_t corners,
                      std::int32_t Item::*tag, TextWriter &out) {
    const auto count =
        std::count_if(items.begin(), items.end(), [&](const Item &item) { return item.count == corners; });
    if (count == 0) {
        return;
    }
    out << '\n' << keyword << '\n' << count << '\n';
    for (const Item &item : items) {
        if (item.count == corners && out.ok()) {
            for (const std::uint32_t node : item.nodes()) {
                out << node + std::uint64_t{1} << ' ';
            }
            out << item.*tag << '\n';
        }
    }
}

} // namespace

/// Writes prisms and hexahedra as MEDIT .mesh, ASCII, in three dimensions. Comments hold the names.
void writeMeditSolid(const SolidMesh &mesh, TextWriter &out) {
    out << "MeshVersionFormatted 2\n";
    writeNameComments(mesh.tags, "#", out);
    out << "Dimension\n3\n\nVertices\n" << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << mesh.nodes[n][0] << ' ' << mesh.nodes[n][1] << ' ' << mesh.nodes[n][2] << " 0\n";
    }
    writeMeditSolids(mesh.faces, "Triangles", 3, &SolidFace::tag, out);
    writeMeditSolids(mesh.faces, "Quadrilaterals", 4, &SolidFace::tag, out);
    writeMeditSolids(mesh.cells, "Prisms", 6, &SolidCell::region, out);
    writeMeditSolids(mesh.cells, "Hexahedra", 8, &SolidCell::region, out);
    out << "\nEnd\n";
}

} // namespace forefront
