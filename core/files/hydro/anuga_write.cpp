#include "core/engine/mesh/edge_table.hpp"
#include "core/files/common/names.hpp"
#include "core/files/hydro/hydro.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace forefront {

namespace {

FileNames anugaNames(const TagList &tags) {
    UniqueNames unique;
    return identifiersOf({.edges = tags.edges, .points = {}, .regions = tags.regions}, unique);
}

/// Returns the triangle beyond the side opposite to each corner of each triangle; -1: none.
std::vector<std::array<std::int64_t, 3>> neighboursOf(const MeshView &mesh) {
    std::vector<std::array<std::int64_t, 3>> neighbours(mesh.elementCount(), {-1, -1, -1});
    const EdgeTable table(mesh);
    const HalfEdges &halves = table.halfEdges();
    table.forEach([&](NodeId, NodeId, std::span<const HalfEdge> sides) {
        for (std::size_t k = 0; sides.size() == 2 && k < 2; ++k) {
            neighbours[halves.elementOf(sides[k])][(halves.sideOf(sides[k]) + 2) % 3] =
                static_cast<std::int64_t>(halves.elementOf(sides[1 - k]));
        }
    });
    return neighbours;
}

} // namespace

/// Writes a mesh of ANUGA (.tsh): vertices with their elevation if the mesh has some, triangles with neighbours and the
/// name of their region, boundary segments with their names, and no outline.
void writeAnuga(const MeshView &mesh, TextWriter &out) {
    const FileNames names = anugaNames(tagsOf(mesh));
    const bool elevations = !mesh.elevations.empty();
    out << mesh.nodes.size() << (elevations ? " 1" : " 0")
        << " # <# of verts> <# of vert attributes>, next lines <vertex #> <x> <y> [attributes] ...Triangulation "
           "Vertices...\n";
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n << ' ' << mesh.nodes[n].x << ' ' << mesh.nodes[n].y;
        if (elevations) {
            out << ' ' << mesh.elevation(n);
        }
        out << '\n';
    }
    out << "# attribute column titles ...Triangulation Vertex Titles...\n" << (elevations ? "elevation\n" : "");
    out << mesh.elementCount()
        << " # <# of triangles>, next lines <triangle #> [<vertex #>] [<neigbouring triangle #>] [attribute of region] "
           "...Triangulation Triangles...\n";
    const std::vector<std::array<std::int64_t, 3>> neighbours = neighboursOf(mesh);
    for (std::size_t e = 0; e < mesh.elementCount() && out.ok(); ++e) {
        out << e;
        for (const NodeId node : mesh.cornersOf(e)) {
            out << ' ' << index(node);
        }
        for (const std::int64_t neighbour : neighbours[e]) {
            out << ' ' << neighbour;
        }
        out << ' ' << names.regions.at(mesh.region(e)) << '\n';
    }
    out << mesh.edges.size()
        << " # <# of segments>, next lines <segment #> <vertex #>  <vertex #> [boundary tag] ...Triangulation "
           "Segments...\n";
    for (std::size_t k = 0; k < mesh.edges.size() && out.ok(); ++k) {
        const TaggedEdge &edge = mesh.edges[k];
        out << k << ' ' << index(edge.a) << ' ' << index(edge.b) << ' ' << names.edges.at(edge.tag) << '\n';
    }
    out << "0 0 # <# of verts> <# of vert attributes>, next lines <vertex #> <x> <y> [attributes] ...Mesh "
           "Vertices...\n0 # <# of segments>, next lines <segment #> <vertex #>  <vertex #> [boundary tag] ...Mesh "
           "Segments...\n0 # <# of holes>, next lines <Hole #> <x> <y> ...Mesh Holes...\n0 # <# of regions>, next "
           "lines "
           "<Region #> <x> <y> <tag>...Mesh Regions...\n0 # <# of regions>, next lines <Region #> [Max Area] ...Mesh "
           "Regions...\n";
}

Diagnostics noteAnugaChanges(const MeshView &mesh) {
    TagList tags = tagsOf(mesh);
    tags.points.clear();
    Diagnostics notes = noteChangedNames(tags, anugaNames(tags));
    if (mesh.elevations.empty()) {
        Diagnostic &note = notes.emplace_back();
        note.severity = Severity::Note;
        note.code = "no-elevation";
        note.message = "no elevations are written: the mesh has none";
    }
    return notes;
}

} // namespace forefront
