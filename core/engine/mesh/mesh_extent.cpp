#include "core/engine/mesh/mesh_extent.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/mesh/placed_cell.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

namespace {

/// Sets of nodes that elements connect.
class ConnectedNodes {
  public:
    explicit ConnectedNodes(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

    void join(NodeId a, NodeId b) {
        const std::size_t s = rootOf(index(a)), t = rootOf(index(b));
        parent_[std::max(s, t)] = static_cast<std::uint32_t>(std::min(s, t));
    }
    bool isRoot(std::size_t node) const { return parent_[node] == node; }

  private:
    std::size_t rootOf(std::size_t node) {
        while (parent_[node] != node) {
            parent_[node] = parent_[parent_[node]];
            node = parent_[node];
        }
        return node;
    }

    std::vector<std::uint32_t> parent_;
};

std::vector<RegionExtent> regionsOf(const MeshView &mesh) {
    std::map<std::int32_t, RegionExtent> regions;
    RegionExtent *region = nullptr; // that of the last element, since most neighbours have the same
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            const std::int32_t tag = block.region(k);
            if (region == nullptr || region->tag != tag) {
                region = &regions[tag];
                region->tag = tag;
            }
            ++region->elements;
            region->area += 0.5 * twiceArea(PlacedCell(block, k, mesh.nodes));
        }
    }
    std::vector<RegionExtent> found;
    for (auto &[tag, extent] : regions) {
        const auto name = mesh.regionNames.find(tag);
        extent.name = name == mesh.regionNames.end() ? "" : name->second;
        found.push_back(extent);
    }
    return found;
}

std::vector<BoundaryExtent> boundariesOf(const MeshView &mesh) {
    std::map<std::int32_t, BoundaryExtent> boundaries;
    for (const TaggedEdge &edge : mesh.edges) {
        BoundaryExtent &boundary = boundaries[edge.tag];
        ++boundary.edges;
        boundary.length += edgeLength(mesh.nodes, edge.a, edge.middle, edge.b);
    }
    std::vector<BoundaryExtent> found;
    for (auto &[tag, extent] : boundaries) {
        const auto name = mesh.boundaryNames.find(tag);
        extent.tag = tag;
        extent.name = name == mesh.boundaryNames.end() ? "" : name->second;
        found.push_back(extent);
    }
    return found;
}

} // namespace

MeshExtent extentOf(const MeshView &mesh, std::size_t edges) {
    ConnectedNodes connected(mesh.nodes.size());
    std::vector<std::uint8_t> used(mesh.nodes.size(), 0);
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            const std::span<const NodeId> corners = block.nodesOf(k).first(block.traits().corners);
            for (const NodeId corner : corners) {
                used[index(corner)] = 1;
                connected.join(corners[0], corner);
            }
        }
    }
    MeshExtent extent;
    std::size_t nodes = 0;
    for (std::size_t node = 0; node < used.size(); ++node) {
        nodes += used[node];
        extent.parts += used[node] != 0 && connected.isRoot(node) ? 1 : 0;
    }
    extent.holes =
        extent.parts + edges - nodes - mesh.elementCount(); // Euler: nodes - edges + elements + holes = parts
    extent.regions = regionsOf(mesh);
    extent.boundaries = boundariesOf(mesh);
    return extent;
}

} // namespace forefront
