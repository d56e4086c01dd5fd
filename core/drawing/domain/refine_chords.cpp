#include "core/drawing/domain/refine_chords.hpp"

#include "core/drawing/shapes/curve_crossings.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/domain_meetings.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr int kMaxHalvings = 12; ///< each makes a chord deviate by a quarter
constexpr std::size_t kMaxAdded = 8192;
constexpr double kTouching = 1e-12;  ///< distance within which curves meet, in diagonals of the domain
constexpr double kFlatChord = 1e-14; ///< deviation, as a fraction of the coordinates, that rounding alone causes

Curve curveOf(const Domain &domain, std::uint32_t segment) {
    const DomainSegment &s = domain.segments[segment];
    return s.stretch.follows() ? domain.curves[s.stretch.curve].part(s.stretch.t0, s.stretch.t1)
                               : Curve::line(domain.nodes[s.a], domain.nodes[s.b]);
}

/// Returns true if the curves of two segments themselves meet elsewhere than at the ends of both: finer chords would
/// meet too.
bool reallyMeet(const Domain &domain, const EdgeMeeting &meeting, double flat) {
    constexpr double kEnd = 1e-9; // in the parameter
    const auto isEnd = [](double t) { return std::min(t, 1.0 - t) <= kEnd; };
    const Curve first = curveOf(domain, meeting.first), second = curveOf(domain, meeting.second);
    const auto crossings = crossingsOf(first, second, flat);
    // For curves that run along each other from end to end, only the ends are reported: look at a middle.
    const Vec2 middle = first.point(0.5);
    const bool same = distance(second.point(second.nearest(middle)), middle) <= flat;
    return same || std::any_of(crossings.begin(), crossings.end(), [&](const CurveCrossing &crossing) {
               return !isEnd(crossing.first) || !isEnd(crossing.second);
           });
}

/// Returns the chords that meet other segments elsewhere than at their ends although their curves do not, in ascending
/// order.
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
    const Box2 box = domain.bounds();
    const double touching = kTouching * box.diagonal();
    std::vector<std::uint32_t> found;
    for (const std::vector<EdgeMeeting> *list : {&meetings.crossings, &meetings.overlaps}) {
        for (const EdgeMeeting &meeting : *list) {
            if (!reallyMeet(domain, meeting, touching)) {
                found.insert(found.end(), {meeting.first, meeting.second});
            }
        }
    }
    for (const DomainMeetings::Touch &touch : meetings.touches) {
        const Curve curve = curveOf(domain, touch.edge);
        const Vec2 at = graph.points[touch.point];
        if (distance(curve.point(curve.nearest(at)), at) > touching) {
            found.push_back(touch.edge);
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
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
                sources->nodes.push_back(sources->segments[s].start());
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
    if (!chords.empty()) { // too near each other
        domain = given;
        if (sources != nullptr) {
            *sources = givenSources;
        }
    }
}

} // namespace forefront
