#include "core/files/common/names.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/surfaces/surfaces.hpp"

#include <cmath>
#include <cstdint>
#include <span>

namespace forefront {

namespace {

FileNames solidsOf(const TagList &tags) {
    UniqueNames unique;
    return identifiersOf({.edges = {}, .points = {}, .regions = tags.regions}, unique);
}

void writePlaces(const MeshView &mesh, TextWriter &out) {
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << ' ' << mesh.elevation(n) << '\n';
    }
}

/// Writes the corners of each element after their number, then its region if `regions`.
void writeFaces(const MeshView &mesh, bool regions, TextWriter &out) {
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            out << block.traits().nodes;
            for (const NodeId node : block.nodesOf(k)) {
                out << ' ' << index(node);
            }
            if (regions) {
                out << ' ' << block.region(k);
            }
            out << '\n';
        }
    }
}

/// Writes the head of a facet with its unit normal.
void writeNormal(const MeshView &mesh, std::uint32_t element, TextWriter &out) {
    const std::span<const NodeId> corners = mesh.cornersOf(element);
    const auto rise = [&](NodeId node) { return mesh.elevation(index(node)) - mesh.elevation(index(corners[0])); };
    const Vec2 a = mesh.nodes[index(corners[1])] - mesh.nodes[index(corners[0])];
    const Vec2 b = mesh.nodes[index(corners[2])] - mesh.nodes[index(corners[0])];
    const double za = rise(corners[1]), zb = rise(corners[2]);
    const double x = a.y * zb - za * b.y, y = za * b.x - a.x * zb, z = cross(a, b);
    const double length = std::hypot(x, y, z);
    if (mesh.elevations.empty() || !(length > 0.0)) {
        out << "facet normal 0 0 1\nouter loop\n";
        return;
    }
    out << "facet normal " << x / length << ' ' << y / length << ' ' << z / length << "\nouter loop\n";
}

} // namespace

void writePly(const MeshView &mesh, TextWriter &out) {
    out << "ply\nformat ascii 1.0\ncomment " << titleOf(mesh) << "\nelement vertex " << mesh.nodes.size()
        << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.elementCount()
        << "\nproperty list uchar int vertex_indices\nproperty int region\nend_header\n";
    writePlaces(mesh, out);
    writeFaces(mesh, true, out);
}

void writeOff(const MeshView &mesh, TextWriter &out) {
    out << "OFF\n" << mesh.nodes.size() << ' ' << mesh.elementCount() << " 0\n";
    writePlaces(mesh, out);
    writeFaces(mesh, false, out);
}

void writeStl(const MeshView &mesh, TextWriter &out) {
    const FileNames names = solidsOf(tagsOf(mesh));
    for (const auto &[tag, elements] : elementsByRegion(mesh)) {
        out << "solid " << names.regions.at(tag) << '\n';
        for (std::size_t k = 0; k < elements.size() && out.ok(); ++k) {
            writeNormal(mesh, elements[k], out);
            for (const NodeId node : mesh.cornersOf(elements[k])) {
                out << "vertex " << mesh.nodes[index(node)].x << ' ' << mesh.nodes[index(node)].y << ' '
                    << mesh.elevation(index(node)) << '\n';
            }
            out << "endloop\nendfacet\n";
        }
        out << "endsolid " << names.regions.at(tag) << '\n';
    }
}

Diagnostics noteFlatSurface(const MeshView &mesh) {
    if (!mesh.elevations.empty()) {
        return {};
    }
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = "no-elevation";
    note.message = "z is 0 at all nodes: the mesh has no elevations";
    return {note};
}

Diagnostics noteStlChanges(const MeshView &mesh) {
    const TagList tags = tagsOf(mesh);
    Diagnostics notes = noteChangedNames(tags, solidsOf(tags));
    const Diagnostics flat = noteFlatSurface(mesh);
    notes.insert(notes.end(), flat.begin(), flat.end());
    return notes;
}

} // namespace forefront
