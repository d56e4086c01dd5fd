#include "core/drawing/domain/join_neighbours.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {
namespace {

/// Returns true if a line has layers, a periodic partner, a crack or a strip by its tag, and the line that would take
/// its place has another tag.
bool losesRole(const Document &document, const Domain &domain, SegmentRun kept, SegmentRun dropped) {
    const std::int32_t tag = domain.segments[dropped.first].tag;
    const auto ofTag = [tag](const auto &spec) { return spec.tag == tag; };
    const auto &layers = document.layers;
    const auto &periodic = document.periodic;
    const auto &cracks = document.cracks;
    const auto &strips = document.strips;
    return tag != domain.segments[kept.first].tag &&
           (std::any_of(layers.begin(), layers.end(), ofTag) || std::any_of(strips.begin(), strips.end(), ofTag) ||
            std::find(cracks.begin(), cracks.end(), tag) != cracks.end() ||
            std::any_of(periodic.begin(), periodic.end(),
                        [tag](const PeriodicSpec &spec) { return spec.from == tag || spec.to == tag; }));
}

/// Returns true if the same sizes and numbers of elements are given along two lines. Else neither can do for both.
bool haveSameSizes(const DrawnDomain &drawn, const GivenSizes &given, SegmentRun first, SegmentRun second) {
    if (drawn.sources == nullptr) {
        return true;
    }
    // A part of a curve has a share of the curve's number, which depends on the rest of it.
    const auto isWhole = [&](SegmentRun run) {
        const CurveStretch &start = drawn.domain.segments[run.first].stretch;
        const CurveStretch &end = drawn.domain.segments[run.end - 1].stretch;
        return !start.follows() || (start.t0 == 0.0 && end.t1 == 1.0);
    };
    const auto isBiased = [&](SegmentRun run) { return given.biasOf(drawn, run.first).any(); };
    const std::uint32_t elements = given.elementsOf(drawn, first.first);
    const bool counted = elements == 0 || (isWhole(first) && isWhole(second) && !isBiased(first) && !isBiased(second));
    return counted && elements == given.elementsOf(drawn, second.first) &&
           given.sizeOf(drawn, first.first) == given.sizeOf(drawn, second.first);
}

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
    eraseMarked(marked, drawn.shares);
    if (drawn.sources != nullptr) {
        eraseMarked(marked, drawn.sources->segments);
    }
}

} // namespace

void joinNeighbours(const Document &document, DrawnDomain &drawn, const GivenSizes &given) {
    Domain &domain = drawn.domain;
    std::vector<bool> dropped;
    std::vector<std::uint32_t> inner; // nodes of curves that are dropped
    for (const NeighbourSide &side : neighbourSides(domain, drawn.loops)) {
        if (!haveSameSizes(drawn, given, side.kept, side.dropped) ||
            losesRole(document, domain, side.kept, side.dropped)) {
            continue;
        }
        dropped.resize(domain.segments.size(), false);
        std::fill(dropped.begin() + side.dropped.first, dropped.begin() + side.dropped.end, true);
        for (std::uint32_t s = side.dropped.first + 1; s < side.dropped.end; ++s) {
            inner.push_back(domain.segments[s].a);
        }
        for (std::uint32_t s = side.kept.first; side.within && s < side.kept.end; ++s) {
            domain.segments[s].role = SegmentRole::Constraint;
        }
    }
    removeSegments(drawn, dropped);
    if (!inner.empty()) {
        removeUnused(drawn, inner);
    }
}

} // namespace forefront
