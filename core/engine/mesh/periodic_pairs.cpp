#include "core/engine/mesh/periodic_pairs.hpp"

#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/image_nodes.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace forefront {

namespace {

double toleranceOf(const MeshView &mesh) {
    return std::max(kPeriodicTolerance * mesh.bounds().diagonal(), 1e-300);
}

/// Returns the nodes of the edges with a tag, ascending.
std::vector<std::uint32_t> nodesWithTag(const MeshView &mesh, std::int32_t tag) {
    std::vector<std::uint32_t> nodes;
    for (const TaggedEdge &edge : mesh.edges) {
        if (edge.tag == tag) {
            for (const NodeId node : {edge.a, edge.b, edge.middle}) {
                if (node != kNoNode) {
                    nodes.push_back(static_cast<std::uint32_t>(node));
                }
            }
        }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

/// The nodes of both parts of a link, with the second node for each of the first.
class LinkedNodes {
  public:
    LinkedNodes(const MeshView &mesh, const PeriodicLink &link)
        : from_(nodesWithTag(mesh, link.from)), to_(nodesWithTag(mesh, link.to)) {
        const ImageNodes images(mesh.nodes, to_, toleranceOf(mesh));
        for (const std::uint32_t node : from_) {
            second_.push_back(images.find(link.map(mesh.nodes[node])));
        }
    }

    const std::vector<std::uint32_t> &from() const { return from_; }
    const std::vector<std::uint32_t> &to() const { return to_; }
    std::uint32_t second(std::size_t k) const { return second_[k]; }
    /// Returns the second node of a node of the first part.
    std::uint32_t imageOf(NodeId node) const {
        const auto found = std::lower_bound(from_.begin(), from_.end(), static_cast<std::uint32_t>(node));
        return second_[static_cast<std::size_t>(found - from_.begin())];
    }

  private:
    std::vector<std::uint32_t> from_, to_, second_;
};

/// Checks one link of a mesh.
class PairCheck {
  public:
    PairCheck(const MeshView &mesh, const PeriodicLink &link, const MeshNumbers &numbers)
        : mesh_(mesh), link_(link), numbers_(numbers), nodes_(mesh, link) {}

    Diagnostics run() {
        for (std::size_t k = 0; k < nodes_.from().size(); ++k) {
            if (nodes_.second(k) == kNoIndex) {
                return nodeFault(nodes_.from()[k], link_.from, link_.to);
            }
        }
        std::vector<std::uint32_t> reached;
        for (std::size_t k = 0; k < nodes_.from().size(); ++k) {
            reached.push_back(nodes_.second(k));
        }
        std::sort(reached.begin(), reached.end());
        for (const std::uint32_t node : nodes_.to()) {
            if (!std::binary_search(reached.begin(), reached.end(), node)) {
                return nodeFault(node, link_.to, link_.from);
            }
        }
        return edgeFaults();
    }

  private:
    std::string nameOf(std::int32_t tag) const { return boundaryName(mesh_.boundaryNames, tag); }

    Diagnostics fault(std::string message, Vec2 at) const {
        Diagnostics faults =
            error("periodic-pairs", std::move(message), "mesh the domain again with its periodic parts");
        faults.front().at = at;
        return faults;
    }
    Diagnostics nodeFault(std::uint32_t node, std::int32_t own, std::int32_t other) const {
        return fault("node " + std::to_string(numbers_.nodes.of(node)) + " of periodic part " + nameOf(own) +
                         " has no partner on " + nameOf(other),
                     mesh_.nodes[node]);
    }

    /// Returns the fault of an edge of the first part whose nodes are not those of an edge of the second.
    Diagnostics edgeFaults() const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, NodeId> middles;
        for (const TaggedEdge &edge : mesh_.edges) {
            if (edge.tag == link_.to) {
                middles.emplace(std::minmax(static_cast<std::uint32_t>(edge.a), static_cast<std::uint32_t>(edge.b)),
                                edge.middle);
            }
        }
        for (const TaggedEdge &edge : mesh_.edges) {
            if (edge.tag != link_.from) {
                continue;
            }
            const auto found = middles.find(std::minmax(nodes_.imageOf(edge.a), nodes_.imageOf(edge.b)));
            const bool paired =
                found != middles.end() &&
                (edge.middle == kNoNode ? found->second == kNoNode
                                        : static_cast<std::uint32_t>(found->second) == nodes_.imageOf(edge.middle));
            if (!paired) {
                return fault("an edge of periodic part " + nameOf(link_.from) + " has no partner on " +
                                 nameOf(link_.to),
                             midpoint(mesh_.nodes[index(edge.a)], mesh_.nodes[index(edge.b)]));
            }
        }
        return {};
    }

    const MeshView &mesh_;
    const PeriodicLink &link_;
    const MeshNumbers &numbers_;
    LinkedNodes nodes_;
};

} // namespace

PeriodicPairs periodicPairs(const MeshView &mesh, const PeriodicLink &link) {
    const LinkedNodes nodes(mesh, link);
    PeriodicPairs result;
    result.link = link;
    for (std::size_t k = 0; k < nodes.from().size(); ++k) {
        const std::uint32_t from = nodes.from()[k], to = nodes.second(k);
        if (to == kNoIndex || to == from) {
            continue;
        }
        const Vec2 image = link.map(mesh.nodes[from]);
        result.pairs.push_back({NodeId{from}, NodeId{to}});
        result.deviation = std::max(result.deviation, distance(image, mesh.nodes[to]));
        result.exact += image == mesh.nodes[to] ? 1U : 0U;
    }
    return result;
}

Diagnostics verifyPeriodic(const MeshView &mesh, const MeshNumbers &numbers) {
    Diagnostics faults;
    for (const PeriodicLink &link : mesh.periodic) {
        Diagnostics ofLink = PairCheck(mesh, link, numbers).run();
        faults.insert(faults.end(), ofLink.begin(), ofLink.end());
    }
    return faults;
}

void alignMiddleNodes(Mesh &mesh) {
    for (const PeriodicLink &link : mesh.periodic) {
        const LinkedNodes nodes(mesh, link);
        for (const TaggedEdge &edge : mesh.edges) {
            if (edge.tag == link.from && edge.middle != kNoNode) {
                mesh.nodes[nodes.imageOf(edge.middle)] = link.map(mesh.nodes[index(edge.middle)]);
            }
        }
    }
}

} // namespace forefront
