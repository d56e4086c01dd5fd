#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/domain/element_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns the length of a straight segment; 0 if its nodes do not exist.
double lengthOf(const Domain &domain, const DomainSegment &segment) {
    const bool known = segment.a < domain.nodes.size() && segment.b < domain.nodes.size();
    return known ? distance(domain.nodes[segment.a], domain.nodes[segment.b]) : 0.0;
}

} // namespace

void carryElements(const Domain &before, const Repaired &repaired, SpacingSpec &spacing) {
    if (!spacing.placed.segments.empty()) {
        const std::vector<PartSize> given = std::exchange(spacing.placed.segments, {});
        for (const std::uint32_t source : repaired.segmentSource) {
            spacing.placed.segments.push_back(source < given.size() ? given[source] : PartSize{0.0, 0.0});
        }
    }
    if (spacing.placed.elements.empty()) {
        return;
    }
    const std::vector<std::uint32_t> given = std::exchange(spacing.placed.elements, {});
    const std::vector<ElementBias> biases = std::exchange(spacing.placed.biases, {});
    const std::vector<DomainSegment> &segments = repaired.domain.segments;
    for (std::size_t s = 0; s < segments.size(); ++s) {
        const std::uint32_t source = repaired.segmentSource[s];
        std::uint32_t count = source < given.size() ? given[source] : 0;
        ElementBias bias = source < biases.size() ? biases[source] : ElementBias{};
        if (count > 0 && !segments[s].stretch.follows()) {
            const double part = lengthOf(repaired.domain, segments[s]),
                         whole = lengthOf(before, before.segments[source]);
            const double share = part < whole ? part / whole : 1.0;
            count = static_cast<std::uint32_t>(std::max(1.0, std::round(count * share)));
            if (source < biases.size() && share < 1.0) {
                bias = partOf(biases[source], share);
            }
        }
        spacing.placed.elements.push_back(count);
        if (!biases.empty()) {
            spacing.placed.biases.push_back(bias);
        }
    }
}

} // namespace forefront
