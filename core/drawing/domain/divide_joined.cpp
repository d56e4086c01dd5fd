#include "core/drawing/domain/divide_joined.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr int kMaxDivisions = 8; ///< attempts

/// Returns the loops after a division.
std::vector<SegmentRun> loopsIn(const DividedSegments &parts, std::vector<SegmentRun> loops) {
    const auto placeOf = [&](std::uint32_t segment) {
        const auto found = std::lower_bound(parts.given.begin(), parts.given.end(), segment);
        return static_cast<std::uint32_t>(found - parts.given.begin());
    };
    for (SegmentRun &loop : loops) {
        loop = {placeOf(loop.first), placeOf(loop.end)};
    }
    return loops;
}

/// Takes the segments of a division, which the domain has already, with what belongs to them.
void takeDivision(DrawnDomain &drawn, const DividedSegments &parts, const std::vector<SegmentRun> &loops) {
    drawn.loops = loops;
    drawn.shares = parts.elements;
    if (drawn.sources != nullptr) {
        const std::vector<ShapeNode> old = std::exchange(drawn.sources->segments, {});
        for (const std::uint32_t s : parts.given) {
            drawn.sources->segments.push_back(old[s]);
        }
    }
}

/// Returns the segments that must not be divided: parts of a line could not keep its bias.
std::vector<bool> biasedLines(const DrawnDomain &drawn, const GivenSizes &given) {
    std::vector<bool> whole(drawn.domain.segments.size(), false);
    const std::vector<ElementBias> bias = given.biases(drawn);
    for (std::size_t s = 0; s < bias.size(); ++s) {
        whole[s] = bias[s].any() && !drawn.domain.segments[s].stretch.follows();
    }
    return whole;
}

} // namespace

void divideJoined(DrawnDomain &drawn, const GivenSizes &given) {
    const std::vector<std::uint32_t> &shapes = drawn.shapes;
    if (shapes.empty() || (shapes.front() == shapes.back() && drawn.domain.points.empty())) {
        return; // one shape, which no other one divides
    }
    const std::vector<std::uint32_t> counts = given.elements(drawn);
    std::vector<bool> whole = biasedLines(drawn, given);
    for (int round = 0; round < kMaxDivisions; ++round) {
        DividedSegments parts = divideAtJoints(drawn.domain, drawn.joints, shapes, counts, whole);
        if (parts.given.empty()) {
            return;
        }
        const std::vector<SegmentRun> loops = loopsIn(parts, drawn.loops);
        drawn.domain.segments.swap(parts.segments);
        const std::vector<std::uint32_t> twice = drawnTwice(drawn.domain, loops, parts.given);
        if (twice.empty()) {
            takeDivision(drawn, parts, loops);
            return;
        }
        drawn.domain.segments.swap(parts.segments); // back to what was drawn
        for (const std::uint32_t s : twice) {
            whole[s] = true;
        }
    }
}

} // namespace forefront
