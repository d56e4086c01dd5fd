#include "core/engine/domain/chains/chain_path.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace forefront {

namespace {

/// Returns true if no part of the second curve, which was made from the first by moving its ends, is much farther from
/// it than the ends.
bool staysNear(const Curve &given, const Curve &changed) {
    constexpr double kFarther = 4.0; // times as far as its ends
    const double gap =
        std::max(distance(given.point(0.0), changed.point(0.0)), distance(given.point(1.0), changed.point(1.0)));
    const std::array between{0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875};
    return std::all_of(between.begin(), between.end(),
                       [&](double t) { return distance(given.point(t), changed.point(t)) <= kFarther * gap; });
}

/// Returns an arc moved to end at two points: a full turn as it is, others turned and scaled, or a cubic where that
/// would change the arc out of proportion, as if it is nearly closed.
Curve movedArc(const Curve &arc, Vec2 start, Vec2 end) {
    constexpr double kMostChange = 0.01; // relative to the chord
    if (start == end && std::fabs(arc.numbers()[7]) > std::numbers::pi) {
        return moved(arc, start - arc.point(0.0));
    }
    const Vec2 gaps[] = {start - arc.point(0.0), end - arc.point(1.0)};
    if (length(gaps[1] - gaps[0]) <= kMostChange * distance(arc.point(0.0), arc.point(1.0))) {
        const Curve fitting = joining(arc, start, end);
        if (fitting.kind() == CurveKind::Arc && joins(fitting, start, end) && staysNear(arc, fitting)) {
            return fitting;
        }
    }
    return joining(cubicAlong(arc), start, end);
}

/// Reverses the chords of a closed path of one part; its curve stays.
void reverseChords(ChainPath &path) {
    std::vector<double> &cuts = path.cuts[0];
    std::reverse(cuts.begin(), cuts.end());
    for (double &cut : cuts) {
        cut = 1.0 - cut;
    }
    const std::vector<ChainPath::Chord> before = path.chords;
    for (std::size_t k = 0; k < before.size(); ++k) {
        path.chords[k] = {before[(before.size() - k) % before.size()].node, before[before.size() - 1 - k].segment};
    }
}

/// Recognises a closed path of one full arc as a circle, which runs counter-clockwise, or an ellipse.
void recogniseRound(ChainPath &path) {
    constexpr double kRounding = 1e-12;
    constexpr double kTurn = 2.0 * std::numbers::pi;
    if (!path.closed || path.curves.size() != 1 || path.curves[0].kind() != CurveKind::Arc) {
        return;
    }
    const auto n = path.curves[0].numbers();
    if (!(std::fabs(std::fabs(n[7]) - kTurn) <= kRounding)) {
        return;
    }
    const Vec2 centre{n[0], n[1]}, start = path.nodes[0] - centre;
    const Vec2 side = (1.0 / kTurn) * path.curves[0].derivative(0.0);
    const double size = lengthSquared(start);
    const bool isCircle =
        std::fabs(dot(start, side)) <= kRounding * size && std::fabs(lengthSquared(side) - size) <= kRounding * size;
    const Vec2 end = centre + side; // of the second semi-axis
    const Vec2 other = isCircle ? leftNormal(start) : end - centre;
    if (cross(start, other) == 0.0) {
        return; // flat
    }
    if (isCircle && cross(start, side) < 0.0) {
        reverseChords(path);
    }
    path.round = isCircle ? std::vector{centre, path.nodes[0]} : std::vector{centre, path.nodes[0], end};
    path.curves[0] = Curve::arc(centre, start, other);
}

} // namespace

ChainPaths::ChainPaths(const Domain &domain, LooseEnds ends)
    : domain_(domain), ends_(ends), chains_(curveChains(domain)), tolerance_(1e-9 * domain.bounds().diagonal()) {}

/// Returns which ends of a curve must be moved to end at two nodes.
ChainPaths::Loose ChainPaths::looseEnds(const Curve &curve, Vec2 start, Vec2 end) const {
    const Vec2 ends[] = {curve.point(0.0), curve.point(1.0)};
    const bool isArc = curve.kind() == CurveKind::Arc; // must join its nodes to be kept as one
    return {distance(ends[0], start) > tolerance_ || (isArc && !joins(curve, start, ends[1])),
            distance(ends[1], end) > tolerance_ || (isArc && !joins(curve, ends[0], end))};
}

bool ChainPaths::anyLooseEnd() const {
    return std::any_of(chains_.list.begin(), chains_.list.end(), [&](const CurveChain &chain) {
        const Curve along = domain_.curves[chain.curve].part(chain.t0, chain.t1);
        const Loose loose = looseEnds(along, domain_.nodes[chain.start], domain_.nodes[chain.end]);
        return loose.start || loose.end;
    });
}

std::vector<ChainPaths::Link> ChainPaths::linksOf(std::span<const std::uint32_t> nodes,
                                                  std::span<const std::uint32_t> segments) const {
    std::vector<Link> links;
    links.reserve(segments.size());
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const std::uint32_t s = segments[k];
        const DomainSegment &segment = domain_.segments[s];
        const std::uint32_t to = k + 1 < nodes.size() ? nodes[k + 1] : nodes[0];
        const bool curved = chains_.ofSegment[s] != kNoIndex;
        const bool forward = segment.a == nodes[k] && segment.b == to;
        const CurveStretch along = forward ? segment.stretch : segment.stretch.reversed();
        links.push_back({nodes[k], to, s, curved ? along : CurveStretch{}});
    }
    return links;
}

/// Returns true if two consecutive links follow one curve.
bool ChainPaths::continues(const Link &before, const Link &after) const {
    return before.stretch.follows() && chains_.ofSegment[before.segment] == chains_.ofSegment[after.segment] &&
           before.stretch.t1 == after.stretch.t0;
}

/// Returns the part of the curve along a run as it is.
Curve ChainPaths::alongRun(std::span<const Link> run) const {
    const CurveStretch &first = run.front().stretch;
    const double from = first.t0, to = run.back().stretch.t1;
    const Curve &whole = domain_.curves[first.curve];
    return from == 0.0 && to == 1.0 ? whole : whole.part(from, to);
}

/// Returns the curve along a run, moved so that it ends at the nodes.
Curve ChainPaths::curveOf(std::span<const Link> run) const {
    const Curve curve = alongRun(run);
    const Vec2 start = domain_.nodes[run.front().from], end = domain_.nodes[run.back().to];
    if (curve.kind() != CurveKind::Arc) {
        return joining(curve, start, end);
    }
    const Loose loose = looseEnds(curve, start, end);
    return loose.start || loose.end ? movedArc(curve, start, end) : curve;
}

/// Adds the links along one curve, or one straight link. Chords at loose ends are split off if all nodes must stay, or
/// if the whole curve would move much farther than its ends.
void ChainPaths::addRuns(std::span<const Link> run, ChainPath &path) const {
    if (run.size() == 1) {
        return addRun(run, path);
    }
    const Curve curve = alongRun(run);
    const Loose loose = looseEnds(curve, domain_.nodes[run.front().from], domain_.nodes[run.back().to]);
    const bool stays = !loose.start && !loose.end;
    if (stays || (ends_ == LooseEnds::MoveCurve && staysNear(curve, curveOf(run)))) {
        return addRun(run, path);
    }
    const std::size_t before = loose.start ? 1 : 0, after = loose.end && run.size() > before + 1 ? 1 : 0;
    for (const auto part : {run.first(before), run.subspan(before, run.size() - before - after), run.last(after)}) {
        if (!part.empty()) {
            addRun(part, path);
        }
    }
}

void ChainPaths::addRun(std::span<const Link> run, ChainPath &path) const {
    path.nodes.push_back(domain_.nodes[run.front().from]);
    path.tags.push_back(domain_.segments[run.front().segment].tag);
    path.chords.push_back({run.front().from, run.front().segment});
    if (run.front().stretch.follows()) {
        path.curves.resize(path.nodes.size());
        path.cuts.resize(path.nodes.size());
        addCurve(run, path);
    }
}

void ChainPaths::addCurve(std::span<const Link> run, ChainPath &path) const {
    path.curves.back() = curveOf(run);
    std::vector<double> &cuts = path.cuts.back();
    const double from = run.front().stretch.t0, to = run.back().stretch.t1;
    for (std::size_t k = 0; k + 1 < run.size(); ++k) {
        const double cut = (run[k].stretch.t1 - from) / (to - from);
        if (cut > (cuts.empty() ? 0.0 : cuts.back()) && cut < 1.0) {
            cuts.push_back(cut);
            path.chords.push_back({run[k + 1].from, run[k + 1].segment});
        }
    }
    if (cuts.empty()) {
        cuts.push_back(1.0); // a single chord
    }
}

ChainPath ChainPaths::make(std::span<const std::uint32_t> nodes, std::span<const std::uint32_t> segments,
                           bool closed) const {
    std::vector<Link> links = linksOf(nodes, segments);
    if (closed) { // start where a curve ends, if the chain begins within one
        std::size_t first = 0;
        while (first < links.size() && continues(links[(first + links.size() - 1) % links.size()], links[first])) {
            ++first;
        }
        std::rotate(links.begin(), links.begin() + static_cast<std::ptrdiff_t>(first % links.size()), links.end());
    }
    ChainPath path;
    path.closed = closed;
    for (std::size_t first = 0, last = 0; first < links.size(); first = last) {
        for (last = first + 1; last < links.size() && continues(links[last - 1], links[last]); ++last) {
        }
        addRuns(std::span(links).subspan(first, last - first), path);
    }
    path.end = links.back().to;
    if (!path.curves.empty()) {
        path.curves.resize(path.nodes.size());
        path.cuts.resize(path.nodes.size());
    }
    if (!closed) {
        path.nodes.push_back(domain_.nodes[path.end]);
    }
    recogniseRound(path);
    return path;
}

} // namespace forefront
