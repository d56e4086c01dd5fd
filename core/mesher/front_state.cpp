#include "core/mesher/front_state.hpp"

#include "core/base/hash.hpp"

namespace forefront {

FrontState::FrontState(const DiscreteDomain &boundary)
    : front(boundary), nodes(boundary.nodes), manyRegions(boundary.regions.size() > 1),
      smallNodesLeft(16 * static_cast<std::uint64_t>(boundary.nodes.size()) + 1000) {
    order.rebuild(front);
}

std::uint64_t FrontState::hash() const {
    Hash64 hash;
    front.addTo(hash);
    hash.add(static_cast<std::uint64_t>(nodes.size()));
    for (const Vec2 p : nodes) {
        hash.add(p.x);
        hash.add(p.y);
    }
    hash.add(static_cast<std::uint64_t>(elements.size()));
    for (const Element &element : elements) {
        for (const NodeId node : element) {
            hash.add(static_cast<std::uint64_t>(index(node)));
        }
    }
    for (const std::uint64_t value : {work.advances, work.elements, work.frontSum, work.tested, work.candidates,
                                      work.newNodes, work.deferrals, work.forced, smallNodesLeft}) {
        hash.add(value); // work.delivered and work.cellsVisited belong to the grid
    }
    return hash.value();
}

} // namespace forefront
