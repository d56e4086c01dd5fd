#include "core/drawing/domain/join_neighbours.hpp"

#include "core/drawing/domain/side_choice.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Removes those of some nodes that nothing refers to.
void removeUnused(DrawnDomain &drawn, const std::vector<std::uint32_t> &nodes) {
    Domain &domain = drawn.domain;
    std::vector<bool> unused(domain.nodes.size(), false);
    for (const std::uint32_t node : nodes) {
        unused[node] = true;
    }
    for (const DomainSegment &segment : domain.segments) {
        unused[segment.a] = unused[segment.b] = false;
    }
    for (const ConstraintPoint &point : domain.points) {
        unused[point.node] = false;
    }
    std::vector<std::uint32_t> number(domain.nodes.size());
    std::uint32_t next = 0;
    for (std::size_t n = 0; n < number.size(); ++n) {
        number[n] = next;
        next += unused[n] ? 0 : 1;
    }
    for (DomainSegment &segment : domain.segments) {
        segment.a = number[segment.a];
        segment.b = number[segment.b];
    }
    for (ConstraintPoint &point : domain.points) {
        point.node = number[point.node];
    }
    eraseMarked(unused, domain.nodes);
    if (drawn.sources != nullptr) {
        eraseMarked(unused, drawn.sources->nodes);
    }
}

/// Removes the marked segments; an empty list marks none.
void removeSegments(DrawnDomain &drawn, const std::vector<bool> &marked) {
    if (marked.empty()) {
        return;
    }
    eraseMarked(marked, drawn.domain.segments);
    if (drawn.sources != nullptr) {
        eraseMarked(marked, drawn.sources->segments);
    }
}

} // namespace

void joinNeighbours(const Document &document, DrawnDomain &drawn) {
    Domain &domain = drawn.domain;
    std::vector<bool> dropped;
    std::vector<std::uint32_t> inner;            // nodes of curves that are dropped
    std::map<std::uint32_t, SegmentRun> holders; // what took the place of a kept line, by its first segment
    for (NeighbourSide &side : neighbourSides(domain, drawn.loops, drawn.samePlace)) {
        const auto holder = holders.find(side.kept.first);
        side.kept = holder != holders.end() ? holder->second : side.kept;
        const SideChoice choice = drawn.sources != nullptr ? chooseSide(document, domain, *drawn.sources, side)
                                                           : SideChoice{.tag = domain.segments[side.kept.first].tag};
        if (choice.conflict) {
            drawn.findings.push_back(*choice.conflict);
            continue;
        }
        const SegmentRole role = side.within ? SegmentRole::Constraint : domain.segments[side.kept.first].role;
        if (choice.dropped) {
            holders[holder != holders.end() ? holder->first : side.kept.first] = side.dropped;
            std::swap(side.kept, side.dropped);
        }
        dropped.resize(domain.segments.size(), false);
        std::fill(dropped.begin() + side.dropped.first, dropped.begin() + side.dropped.end, true);
        for (std::uint32_t s = side.dropped.first + 1; s < side.dropped.end; ++s) {
            inner.push_back(domain.segments[s].a);
        }
        for (std::uint32_t s = side.kept.first; s < side.kept.end; ++s) {
            domain.segments[s].role = role;
            domain.segments[s].tag = choice.tag;
        }
    }
    removeSegments(drawn, dropped);
    if (!inner.empty()) {
        removeUnused(drawn, inner);
    }
}

} // namespace forefront
