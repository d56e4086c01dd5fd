#include "core/edit/chain_shape.hpp"

#include "core/base/ids.hpp"
#include "core/edit/path_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace forefront {

namespace {

/// Returns the curve turned and scaled to end at two points, if it is an arc that this moves nowhere much farther than
/// at its ends. An arc that is nearly closed would change out of proportion.
std::optional<Curve> fittingArc(const Curve &curve, Vec2 start, Vec2 end) {
    constexpr double kMostChange = 0.01; // of the chord
    constexpr double kFarther = 4.0;
    const Vec2 gaps[] = {start - curve.point(0.0), end - curve.point(1.0)};
    if (!(length(gaps[1] - gaps[0]) <= kMostChange * distance(curve.point(0.0), curve.point(1.0)))) {
        return std::nullopt;
    }
    const Curve fitting = joining(curve, start, end);
    if (fitting.kind() != CurveKind::Arc || !joins(fitting, start, end)) {
        return std::nullopt;
    }
    const double most = kFarther * std::max(length(gaps[0]), length(gaps[1]));
    for (const double t : {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875}) {
        if (!(distance(curve.point(t), fitting.point(t)) <= most)) {
            return std::nullopt;
        }
    }
    return fitting;
}

} // namespace

ChainShapes::ChainShapes(const Domain &domain, LooseEnds ends)
    : domain_(domain), ends_(ends), chains_(curveChains(domain)), tolerance_(1e-9 * domain.bounds().diagonal()) {}

bool ChainShapes::isLoose(std::uint32_t curve, double t, std::uint32_t node) const {
    return !(distance(domain_.curves[curve].point(t), domain_.nodes[node]) <= tolerance_);
}

bool ChainShapes::anyLooseEnd() const {
    return std::any_of(chains_.list.begin(), chains_.list.end(), [&](const CurveChain &chain) {
        return isLoose(chain.curve, chain.t0, chain.start) || isLoose(chain.curve, chain.t1, chain.end);
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
    const double gap = std::max(distance(start, curve.point(0.0)), distance(end, curve.point(1.0)));
    if (gap <= tolerance_ && joins(curve, start, end)) {
        return curve;
    }
    const std::optional<Curve> fitting = fittingArc(curve, start, end);
    return fitting ? *fitting : joining(cubicAlong(curve), start, end);
}

/// Returns true if the curve along a run can end at the nodes without moving much farther elsewhere: the handles of a
/// cubic move with its ends, and so does a cubic along at most a quarter of an arc.
bool ChainShapes::movesWell(std::span<const Link> run) const {
    const Curve curve = alongRun(run);
    constexpr double kQuarter = 0.5 * std::numbers::pi + 1e-9;
    return curve.kind() != CurveKind::Arc || std::fabs(curve.numbers()[7]) <= kQuarter ||
           fittingArc(curve, domain_.nodes[run.front().from], domain_.nodes[run.back().to]).has_value();
}

/// Adds the links along one curve, or one straight link. Chords at loose ends are split off where that is better.
void ChainShapes::addRuns(std::span<const Link> run, Shape &shape) const {
    if (run.size() > 1) {
        const Link &first = run.front(), &last = run.back();
        const bool startsLoose = isLoose(first.stretch.curve, first.stretch.t0, first.from);
        const bool endsLoose = isLoose(last.stretch.curve, last.stretch.t1, last.to);
        if ((startsLoose || endsLoose) && (ends_ == LooseEnds::MoveChord || !movesWell(run))) {
            const std::size_t before = startsLoose ? 1 : 0, after = endsLoose && run.size() > before + 1 ? 1 : 0;
            for (const auto part :
                 {run.first(before), run.subspan(before, run.size() - before - after), run.last(after)}) {
                if (!part.empty()) {
                    addRun(part, shape);
                }
            }
            return;
        }
    }
    addRun(run, shape);
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
