#include "core/edit/refine_chords.hpp"

#include "core/base/ids.hpp"
#include "core/domain/domain_graph.hpp"
#include "core/domain/domain_meetings.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr int kMaxHalvings = 12; ///< each makes a chord deviate by a quarter
constexpr std::size_t kMaxAdded = 8192;
constexpr double kFlatChord = 1e-14; ///< deviation, as a fraction of the coordinates, that rounding alone causes

/// Returns the chords of curves that meet other segments elsewhere than at their ends, in ascending order.
std::vector<std::uint32_t> meetingChords(const Domain &domain) {
    const DomainGraph graph = graphOf(domain);
    if (graph.edges.size() != domain.segments.size()) {
        return {}; // invalid, which validation reports
    }
    const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
    if (sweep.droppedCount == 0) {
        return {};
    }
    const DomainMeetings meetings = findDomainMeetings(graph, sweep, kMaxAdded);
    std::vector<std::uint32_t> found;
    for (const std::vector<EdgeMeeting> *list : {&meetings.crossings, &meetings.overlaps}) {
        for (const EdgeMeeting &meeting : *list) {
            found.insert(found.end(), {meeting.first, meeting.second});
        }
    }
    for (const DomainMeetings::Touch &touch : meetings.touches) {
        found.push_back(touch.edge);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    const Box2 box = domain.bounds();
    const double flat = kFlatChord * std::max(length(box.min), length(box.max));
    std::erase_if(found, [&](std::uint32_t s) {
        const CurveStretch &stretch = domain.segments[s].stretch;
        return !stretch.follows() || !(domain.curves[stretch.curve].deviation(stretch.t0, stretch.t1) > flat);
    });
    return found;
}

/// Halves chords, given in ascending order.
void halve(Domain &domain, const std::vector<std::uint32_t> &chords, DomainSources *sources) {
    std::vector<DomainSegment> segments;
    std::vector<std::uint32_t> given; // per segment: the one that it was or is half of
    auto next = chords.begin();
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
        DomainSegment segment = domain.segments[s];
        if (next != chords.end() && *next == s) {
            ++next;
            const double middle = std::midpoint(segment.stretch.t0, segment.stretch.t1);
            DomainSegment half = segment;
            half.b = static_cast<std::uint32_t>(domain.nodes.size());
            half.stretch.t1 = segment.stretch.t0 = middle;
            segment.a = half.b;
            domain.nodes.push_back(domain.curves[half.stretch.curve].point(middle));
            if (sources != nullptr) {
                sources->nodes.push_back(sources->segments[s]);
            }
            segments.push_back(half);
            given.push_back(s);
        }
        segments.push_back(segment);
        given.push_back(s);
    }
    domain.segments = std::move(segments);
    if (sources != nullptr) {
        auto old = std::exchange(sources->segments, {});
        for (const std::uint32_t s : given) {
            sources->segments.push_back(old[s]);
        }
    }
}

} // namespace

void refineMeetingChords(Domain &domain, DomainSources *sources) {
    const std::size_t limit = domain.segments.size() + kMaxAdded;
    std::vector<std::uint32_t> chords = meetingChords(domain);
    if (chords.empty()) {
        return;
    }
    const Domain given = domain;
    const DomainSources givenSources = sources != nullptr ? *sources : DomainSources{};
    for (int round = 0; round < kMaxHalvings && !chords.empty(); ++round) {
        if (domain.segments.size() + chords.size() > limit) {
            break;
        }
        halve(domain, chords, sources);
        chords = meetingChords(domain);
    }
    if (!chords.empty()) { // some curves really meet
        domain = given;
        if (sources != nullptr) {
            *sources = givenSources;
        }
    }
}

} // namespace forefront
