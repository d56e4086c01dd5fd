#include "core/drawing/arrangement/assembly/short_segments.hpp"

#include "core/engine/base/ids.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace forefront {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// The lengths of the two shortest segments at a node; infinite without them.
struct Shortest {
    double first = kNone, second = kNone;
    std::uint32_t segment = kNoIndex; ///< the one of length `first`

    void add(std::uint32_t s, double length) {
        if (length < first) {
            second = first;
            first = length;
            segment = s;
        } else {
            second = std::min(second, length);
        }
    }
    double besides(std::uint32_t s) const { return segment == s ? second : first; }
};

} // namespace

ShortSegments findShortSegments(const Domain &domain, double limit) {
    constexpr double kShort = 0.01; // of the neighbours
    const auto lengthOf = [&](const DomainSegment &segment) {
        return distance(domain.nodes[segment.a], domain.nodes[segment.b]);
    };
    std::vector<Shortest> atNodes(domain.nodes.size());
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
        const DomainSegment &segment = domain.segments[s];
        atNodes[segment.a].add(s, lengthOf(segment));
        atNodes[segment.b].add(s, lengthOf(segment));
    }
    ShortSegments found;
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
        const DomainSegment &segment = domain.segments[s];
        const double length = lengthOf(segment);
        const double beside = std::min(atNodes[segment.a].besides(s), atNodes[segment.b].besides(s));
        if (length >= limit || beside == kNone || length >= kShort * beside) {
            continue;
        }
        if (found.count++ == 0) {
            found.first = midpoint(domain.nodes[segment.a], domain.nodes[segment.b]);
            found.segment = s;
        }
        found.longest = std::max(found.longest, length);
    }
    return found;
}

} // namespace forefront
