#include "core/engine/mesh/shoreline.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/hydro/hydro.hpp"

#include <span>
#include <vector>

namespace forefront {

namespace {

/// Writes a list of stretches: their number, the number of their nodes, then each with its number of nodes and type.
/// `types`: whether stretches have a type.
void writeStretches(std::span<const ShoreStretch> stretches, bool types, int land, int island, TextWriter &out) {
    std::size_t nodes = 0;
    for (const ShoreStretch &stretch : stretches) {
        nodes += stretch.nodes.size();
    }
    out << stretches.size() << '\n' << nodes << '\n';
    for (const ShoreStretch &stretch : stretches) {
        out << stretch.nodes.size();
        if (types) {
            out << ' ' << (stretch.kind == ShoreStretch::Kind::Island ? island : land);
        }
        out << '\n';
        for (const NodeId node : stretch.nodes) {
            out << index(node) + 1 << '\n';
        }
    }
}

/// Writes the layout that both programs share: a title, the numbers of elements and nodes, nodes with their depth,
/// elements with their number of nodes, open boundaries, then land.
void writeGrid(const MeshView &mesh, const ExportOptions &options, int land, int island, TextWriter &out) {
    out << titleOf(mesh) << '\n' << mesh.elementCount() << ' ' << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ' ' << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << ' ' << 0.0 - mesh.elevation(n) << '\n';
    }
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            out << block.first + k + 1 << ' ' << block.traits().nodes;
            for (const NodeId node : block.nodesOf(k)) {
                out << ' ' << index(node) + 1;
            }
            out << '\n';
        }
    }
    const std::vector<ShoreStretch> shore = shoreline(mesh, options.openBoundaries);
    std::size_t open = 0;
    while (open < shore.size() && shore[open].kind == ShoreStretch::Kind::Open) {
        ++open;
    }
    writeStretches(std::span(shore).first(open), false, land, island, out);
    writeStretches(std::span(shore).subspan(open), true, land, island, out);
}

} // namespace

void writeAdcirc(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    writeGrid(mesh, options, 20, 21, out);
}

void writeSchism(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    writeGrid(mesh, options, 0, 1, out);
}

Diagnostics noteDepths(const MeshView &mesh) {
    if (!mesh.elevations.empty()) {
        return {};
    }
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = "no-depth";
    note.message = "all nodes have the depth 0: the mesh has none";
    return {note};
}

} // namespace forefront
