#include "core/files/common/edge_chains.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/sms/two_dm.hpp"
#include "core/files/sms/two_dm_cards.hpp"

#include <algorithm>
#include <span>

namespace forefront {

namespace {

void writeTwoDmElement(std::size_t number, const MeshView::Block &block, std::size_t k, TextWriter &out) {
    const auto card = std::find_if(kTwoDmCards.begin(), kTwoDmCards.end(),
                                   [&](const TwoDmCard &each) { return each.kind == block.kind; });
    const std::span<const NodeId> nodes = block.nodesOf(k);
    out << card->name << ' ' << number;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        out << ' ' << index(nodes[twoDmNode(block.traits(), n)]) + 1;
    }
    out << ' ' << block.region(k) << '\n';
}

/// Writes a node string: its last node is negative, then comes its number.
void writeNodeString(const EdgeChain &chain, std::int32_t tag, TextWriter &out) {
    constexpr std::size_t kPerLine = 10;
    for (std::size_t k = 0; k < chain.nodes.size(); ++k) {
        const bool last = k + 1 == chain.nodes.size();
        out << (k % kPerLine == 0 ? "NS " : " ") << (last ? "-" : "") << index(chain.nodes[k]) + 1;
        out << (!last && k % kPerLine + 1 == kPerLine ? "\n" : "");
    }
    out << ' ' << tag << '\n';
}

} // namespace

/// Writes elements with their region as material, nodes with their elevations, and node strings with the number of
/// their boundary part. Comments, lines that begin with '#', keep names and points.
void writeTwoDm(const MeshView &mesh, TextWriter &out) {
    out << "MESH2D\nNUM_MATERIALS_PER_ELEM 1\n";
    writeNameComments(mesh, "#", out);
    for (const TaggedNode &point : mesh.points) {
        out << "# point " << index(point.node) + 1 << ' ' << point.tag << '\n';
    }
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            writeTwoDmElement(block.first + k + 1, block, k, out);
        }
    }
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << "ND " << n + 1 << ' ' << mesh.nodes[n].x << ' ' << mesh.nodes[n].y << ' ' << mesh.elevation(n) << '\n';
    }
    for (const auto &[tag, edges] : edgesByTag(mesh)) {
        for (const EdgeChain &chain : joinEdges(mesh, edges)) {
            writeNodeString(chain, tag, out);
        }
    }
}

Diagnostics noteTwoDmChanges(const MeshView &mesh) {
    if (!mesh.elevations.empty()) {
        return {};
    }
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = "no-elevation";
    note.message = "all nodes have the elevation 0: the mesh has none";
    return {note};
}

} // namespace forefront
