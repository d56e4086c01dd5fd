#include "core/files/common/node_labels.hpp"

namespace forefront {

std::vector<std::int32_t> nodeLabels(const Mesh &mesh) {
    std::vector<std::int32_t> labels(mesh.nodes.size(), 0);
    for (const TaggedEdge &edge : mesh.edges) {
        for (const NodeId node : {edge.a, edge.b}) {
            std::int32_t &label = labels[index(node)];
            label = label == 0 || edge.tag < label ? edge.tag : label;
        }
    }
    for (const TaggedNode &point : mesh.points) {
        labels[index(point.node)] = point.tag;
    }
    return labels;
}

} // namespace forefront
