#include "core/engine/mesh/shoreline.hpp"
#include "core/files/hydro/hydro.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

namespace {

/// Returns a code for each node: 0 within, 1 on land, 2 and more on the open parts in their order. Where an open part
/// ends, its last node has its code.
std::vector<std::uint32_t> shoreCodes(const MeshView &mesh, std::span<const std::int32_t> openTags) {
    std::vector<std::uint32_t> codes(mesh.nodes.size(), 0);
    for (const ShoreStretch &stretch : shoreline(mesh, {})) {
        for (const NodeId node : stretch.nodes) {
            codes[index(node)] = 1;
        }
    }
    for (std::uint32_t k = 0; k < openTags.size(); ++k) {
        for (const ShoreStretch &stretch : shoreline(mesh, openTags.subspan(k, 1))) {
            for (const NodeId node : stretch.nodes) {
                std::uint32_t &code = codes[index(node)];
                code = stretch.kind == ShoreStretch::Kind::Open && code == 1 ? k + 2 : code;
            }
        }
    }
    return codes;
}

} // namespace

/// Writes a mesh of MIKE 21 and MIKE 3 Flow Model FM: the item and unit of bathymetry in metres, nodes with elevation
/// and code, elements of type 21 (triangles) or 25 (with quadrilaterals; the fourth node of a triangle is 0).
void writeMike(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    const std::vector<std::uint32_t> codes = shoreCodes(mesh, options.openBoundaries);
    out << "100079 1000 " << mesh.nodes.size() << " NON-UTM\n";
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ' ' << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << ' ' << mesh.elevation(n) << ' ' << codes[n]
            << '\n';
    }
    const bool quads = std::any_of(mesh.blocks().begin(), mesh.blocks().end(),
                                   [](const MeshView::Block &block) { return block.traits().corners == 4; });
    out << mesh.elementCount() << (quads ? " 4 25\n" : " 3 21\n");
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            out << block.first + k + 1;
            for (const NodeId node : block.nodesOf(k)) {
                out << ' ' << index(node) + 1;
            }
            out << (quads && block.traits().corners == 3 ? " 0\n" : "\n");
        }
    }
}

} // namespace forefront
