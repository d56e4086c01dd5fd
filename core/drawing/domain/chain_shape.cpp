#include "core/drawing/domain/chain_shape.hpp"

#include "core/drawing/shapes/path_curve.hpp"
#include "core/engine/base/ids.hpp"

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

} // namespace

ChainShapes::ChainShapes(const Domain &domain, LooseEnds ends)
    : domain_(domain), ends_(ends), chains_(curveChains(domain)), tolerance_(1e-9 * domain.bounds().diagonal()) {}

/// Returns which ends of a curve must be moved to end at two nodes.
ChainShapes::Loose ChainShapes::looseEnds(const Curve &curve, Vec2 start, Vec2 end) const {
    const Vec2 ends[] = {curve.point(0.0), curve.point(1.0)};
    const bool isArc = curve.kind() == CurveKind::Arc; // must join its nodes to be kept as one
    return {distance(ends[0], start) > tolerance_ || (isArc && !joins(curve, start, ends[1])),
            distance(ends[1], end) > tolerance_ || (isArc && !joins(curve, ends[0], end))};
}

bool ChainShapes::anyLooseEnd() const {
    return std::any_of(chains_.list.begin(), chains_.list.end(), [&](const CurveChain &chain) {
        const Curve along = domain_.curves[chain.curve].part(chain.t0, chain.t1);
        const Loose loose = looseEnds(along, domain_.nodes[chain.start], domain_.nodes[chain.end]);
        return loose.start || loose.end;
    });
}

std::vector<ChainShapes::Link> ChainShapes::linksOf(std::span<const std::uint32_t> nodes,
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
bool ChainShapes::continues(const Link &before, const Link &after) const {
    return before.stretch.follows() && chains_.ofSegment[before.segment] == chains_.ofSegment[after.segment] &&
           before.stretch.t1 == after.stretch.t0;
}

/// Returns the part of the curve along a run as it is.
Curve ChainShapes::alongRun(std::span<const Link> run) const {
    const CurveStretch &first = run.front().stretch;
    const double from = first.t0, to = run.back().stretch.t1;
    const Curve &whole = domain_.curves[first.curve];
    return from == 0.0 && to == 1.0 ? whole : whole.part(from, to);
}

/// Returns the curve along a run, moved so that it ends at the nodes.
Curve ChainShapes::curveOf(std::span<const Link> run) const {
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
void ChainShapes::addRuns(std::span<const Link> run, Shape &shape) const {
    if (run.size() == 1) {
        return addRun(run, shape);
    }
    const Curve curve = alongRun(run);
    const Loose loose = looseEnds(curve, domain_.nodes[run.front().from], domain_.nodes[run.back().to]);
    const bool stays = !loose.start && !loose.end;
    if (stays || (ends_ == LooseEnds::MoveCurve && staysNear(curve, curveOf(run)))) {
        return addRun(run, shape);
    }
    const std::size_t before = loose.start ? 1 : 0, after = loose.end && run.size() > before + 1 ? 1 : 0;
    for (const auto part : {run.first(before), run.subspan(before, run.size() - before - after), run.last(after)}) {
        if (!part.empty()) {
            addRun(part, shape);
        }
    }
}

void ChainShapes::addRun(std::span<const Link> run, Shape &shape) const {
    shape.nodes.push_back(domain_.nodes[run.front().from]);
    shape.segmentTags.push_back(domain_.segments[run.front().segment].tag);
    Curve curve;
    std::vector<double> cuts;
    if (run.front().stretch.follows()) {
        curve = curveOf(run);
        const double from = run.front().stretch.t0, to = run.back().stretch.t1;
        for (std::size_t k = 0; k + 1 < run.size(); ++k) {
            const double cut = (run[k].stretch.t1 - from) / (to - from);
            if (cut > (cuts.empty() ? 0.0 : cuts.back()) && cut < 1.0) {
                cuts.push_back(cut);
            }
        }
        if (cuts.empty()) {
            cuts.push_back(1.0); // a single chord
        }
    }
    shape.curves.push_back(curve);
    shape.cuts.push_back(std::move(cuts));
}

Shape ChainShapes::make(std::span<const std::uint32_t> nodes, std::span<const std::uint32_t> segments,
                        bool closed) const {
    std::vector<Link> links = linksOf(nodes, segments);
    if (closed) { // start where a curve ends, if the chain begins within one
        std::size_t first = 0;
        while (first < links.size() && continues(links[(first + links.size() - 1) % links.size()], links[first])) {
            ++first;
        }
        std::rotate(links.begin(), links.begin() + static_cast<std::ptrdiff_t>(first % links.size()), links.end());
    }
    Shape shape;
    shape.kind = closed ? ShapeKind::Polygon : ShapeKind::Polyline;
    for (std::size_t first = 0, last = 0; first < links.size(); first = last) {
        for (last = first + 1; last < links.size() && continues(links[last - 1], links[last]); ++last) {
        }
        addRuns(std::span(links).subspan(first, last - first), shape);
    }
    if (!closed) {
        shape.nodes.push_back(domain_.nodes[links.back().to]);
    }
    const auto straight = [](const Curve &curve) { return curve.kind() == CurveKind::Line; };
    if (std::all_of(shape.curves.begin(), shape.curves.end(), straight)) {
        shape.curves.clear();
        shape.cuts.clear();
    }
    shape.tag = shape.segmentTags.front();
    if (std::all_of(shape.segmentTags.begin(), shape.segmentTags.end(), [&](auto tag) { return tag == shape.tag; })) {
        shape.segmentTags.clear();
    }
    recogniseLoop(shape);
    return shape;
}

/// Turns a closed path of one full arc into a circle or an ellipse.
void ChainShapes::recogniseLoop(Shape &shape) const {
    constexpr double kRounding = 1e-12;
    constexpr double kTurn = 2.0 * std::numbers::pi;
    if (shape.kind != ShapeKind::Polygon || shape.curves.size() != 1 || shape.curves[0].kind() != CurveKind::Arc) {
        return;
    }
    const auto n = shape.curves[0].numbers();
    if (!(std::fabs(std::fabs(n[7]) - kTurn) <= kRounding)) {
        return;
    }
    const Vec2 centre{n[0], n[1]}, start = shape.nodes[0] - centre;
    const Vec2 side = (1.0 / kTurn) * shape.curves[0].derivative(0.0);
    const double size = lengthSquared(start);
    const bool round =
        std::fabs(dot(start, side)) <= kRounding * size && std::fabs(lengthSquared(side) - size) <= kRounding * size;
    if (round && cross(start, side) < 0.0) { // a circle runs counter-clockwise
        std::reverse(shape.cuts[0].begin(), shape.cuts[0].end());
        for (double &cut : shape.cuts[0]) {
            cut = 1.0 - cut;
        }
    }
    shape.kind = round ? ShapeKind::Circle : ShapeKind::Ellipse;
    shape.nodes = round ? std::vector{centre, shape.nodes[0]} : std::vector{centre, shape.nodes[0], centre + side};
    shape.curves.clear();
}

} // namespace forefront
