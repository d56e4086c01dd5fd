#include "core/files/common/node_labels.hpp"

#include "core/files/common/tagged_cells.hpp"

namespace forefront {

std::vector<std::int32_t> nodeLabels(const MeshView &mesh) {
    std::vector<std::int32_t> labels(mesh.nodes.size(), 0);
    for (const TaggedEdge &edge : mesh.edges) {
        for (const NodeId node : EdgeNodes(edge)) {
            std::int32_t &label = labels[index(node)];
            label = label == 0 || edge.tag < label ? edge.tag : label;
        }
    }
    for (const TaggedNode &point : mesh.points) {
        labels[index(point.node)] = point.tag;
    }
    return labels;
}

void noteUnusedLabels(const std::vector<std::int32_t> &labels, const Mesh &mesh, const char *code,
                      const SourceText &source) {
    std::vector<std::uint8_t> carried(labels.size(), 0);
    const auto see = [&](NodeId node, std::int32_t tag) {
        carried[index(node)] = carried[index(node)] != 0 || labels[index(node)] == tag ? 1 : 0;
    };
    for (const TaggedEdge &edge : mesh.edges) {
        see(edge.a, edge.tag);
        see(edge.b, edge.tag);
        if (edge.middle != kNoNode) {
            see(edge.middle, edge.tag);
        }
    }
    for (const TaggedNode &point : mesh.points) {
        see(point.node, point.tag);
    }
    std::size_t unused = 0;
    for (std::size_t n = 0; n < labels.size(); ++n) {
        unused += labels[n] != 0 && carried[n] == 0 ? 1 : 0;
    }
    if (unused > 0) {
        source.note(code, "labels of nodes are ignored where no edge or point there has the same tag", 0, unused);
    }
}

} // namespace forefront
