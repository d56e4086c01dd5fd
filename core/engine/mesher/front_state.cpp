#include "core/engine/mesher/front_state.hpp"

#include "core/engine/base/hash.hpp"

#include <algorithm>
#include <limits>

namespace forefront {

namespace {

/// Returns true if some segments of Γ are longer than others by more than about the width of a fine class.
bool lengthsDiffer(const GenerationFront &front) {
    constexpr double kClass = 1.01;
    double shortest = std::numeric_limits<double>::infinity(), longest = 0.0;
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        if (front[id].alive && !front.isolated(id)) {
            shortest = std::min(shortest, front[id].length);
            longest = std::max(longest, front[id].length);
        }
    }
    return longest > kClass * shortest;
}

} // namespace

FrontState::FrontState(const DiscreteDomain &boundary, const FrontCare &frontCare, const FrontRules &frontRules)
    : front(boundary), rules(frontRules), order({rules.base, rules.seed}), care(frontCare),
      strips(std::make_shared<const FrontStrips>()), nodes(boundary.nodes), manyFaces(boundary.regions.size() > 1),
      smallNodesLeft(16 * static_cast<std::uint64_t>(boundary.nodes.size()) + 1000) {
    const bool first = frontCare.boundaryFirst && lengthsDiffer(front);
    walkRules = {frontCare.fineClasses, first ? static_cast<std::uint32_t>(boundary.nodes.size()) : 0U};
}

FrontState::FrontState(const FrontState &whole, GenerationFront part, std::uint32_t onlyStrip, std::uint32_t firstNew)
    : front(std::move(part)), care(whole.care), walkRules(whole.walkRules), strips(whole.strips), strip(onlyStrip),
      stripEnd(onlyStrip + 1), firstNode(firstNew), manyFaces(whole.manyFaces), smallNodesLeft(whole.smallNodesLeft) {}

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
    walkOrder.addTo(hash);
    hash.add((static_cast<std::uint64_t>(index(walk.base)) << 32) | walk.level);
    hash.add(static_cast<std::uint64_t>(strip));
    for (const std::uint64_t value : {work.advances, work.elements, work.frontSum, work.candidates, work.newNodes,
                                      work.deferrals, work.forced, smallNodesLeft}) {
        hash.add(value); // without the work that depends on the grid
    }
    return hash.value();
}

int AdvanceDelta::growth() const {
    switch (kind) {
    case Kind::Deferral:
    case Kind::Two:
        return 0;
    case Kind::NewNode:
    case Kind::Connection:
        return 1;
    case Kind::Previous:
    case Kind::Next:
    case Kind::Three:
        return -1;
    case Kind::Opening:
        return 2;
    case Kind::Closing:
        return -2;
    case Kind::Loop:
        return -3;
    }
    return 0;
}

} // namespace forefront
