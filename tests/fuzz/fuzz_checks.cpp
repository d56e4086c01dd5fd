#include "tests/fuzz/fuzz_checks.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <span>

namespace forefront::fuzz {

void demand(bool kept, const char *promise) {
    if (!kept) {
        std::fprintf(stderr, "broken promise: %s\n", promise);
        std::abort();
    }
}

void checkMesh(const MeshView &mesh) {
    const auto known = [&](NodeId node) { return index(node) < mesh.nodes.size(); };
    demand(std::all_of(mesh.nodes.begin(), mesh.nodes.end(), isFinite), "coordinates are finite");
    for (const MeshView::Block &block : mesh.blocks()) {
        demand(block.regions.empty() || block.regions.size() == block.size(), "a region for every element");
    }
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> nodes = mesh.nodesOf(e);
        demand(std::all_of(nodes.begin(), nodes.end(), known), "elements use nodes that exist");
        const std::set<NodeId> different(nodes.begin(), nodes.end());
        demand(different.size() == nodes.size(), "the nodes of an element are different");
    }
    for (const TaggedEdge &edge : mesh.edges) {
        demand(known(edge.a) && known(edge.b) && (edge.middle == kNoNode || known(edge.middle)) && edge.tag >= 1,
               "edges use nodes that exist and have a tag");
    }
    for (const TaggedNode &point : mesh.points) {
        demand(known(point.node) && point.tag >= 1, "points are nodes that exist and have a tag");
    }
}

} // namespace forefront::fuzz
