#include "core/drawing/domain/divide_joined.hpp"

#include "core/drawing/domain/given_sizes.hpp"
#include "core/drawing/domain/joint_notes.hpp"

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
    if (drawn.sources == nullptr) {
        return;
    }
    const std::vector<SegmentSource> old = std::exchange(drawn.sources->segments, {});
    for (std::size_t s = 0; s < parts.given.size(); ++s) {
        SegmentSource source = old[parts.given[s]];
        if (parts.elements[s] > 0) {
            source.elements = parts.elements[s];
            source.bias = parts.biases[s];
        }
        drawn.sources->segments.push_back(source);
    }
}

/// Notes what was joined although it was drawn apart, and what was not. Call before the division is taken.
void noteJoints(const Document &document, DrawnDomain &drawn, const DividedSegments &parts,
                const std::vector<bool> &whole) {
    const JointNotes notes(document, drawn.domain);
    drawn.farthest = std::max(drawn.farthest, parts.farthest);
    notes.joined(drawn.farthest, drawn.findings);
    for (const NodeBesideCurve &beside : parts.beside) {
        notes.beside(beside, drawn.shapes[beside.segment], drawn.findings);
    }
    for (std::size_t s = 0; s < whole.size(); ++s) {
        if (whole[s]) {
            notes.along(drawn.shapes[s], drawn.findings);
        }
    }
}

} // namespace

void divideJoined(const Document &document, DrawnDomain &drawn) {
    const std::vector<std::uint32_t> &shapes = drawn.shapes;
    if (shapes.empty() || (shapes.front() == shapes.back() && drawn.domain.points.empty())) {
        return; // one shape, which no other one divides
    }
    const std::vector<std::uint32_t> counts = elementsAlong(drawn);
    const std::vector<ElementBias> ratios = biasesAlong(drawn);
    std::vector<bool> whole(drawn.domain.segments.size(), false);
    for (int round = 0; round < kMaxDivisions; ++round) {
        DividedSegments parts =
            divideAtJoints(drawn.domain, drawn.joints, shapes, {counts, ratios}, whole, drawn.samePlace);
        if (parts.given.empty()) {
            noteJoints(document, drawn, parts, whole);
            return;
        }
        const std::vector<SegmentRun> loops = loopsIn(parts, drawn.loops);
        drawn.domain.segments.swap(parts.segments);
        const std::vector<std::uint32_t> twice = drawnTwice(drawn.domain, loops, parts.given, drawn.samePlace);
        if (twice.empty()) {
            noteJoints(document, drawn, parts, whole);
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
