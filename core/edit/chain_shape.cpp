#include "core/edit/chain_shape.hpp"

#include "core/base/ids.hpp"
#include "core/edit/path_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace forefront {

ChainShapes::ChainShapes(const Domain &domain)
    : domain_(domain), chains_(curveChains(domain)), tolerance_(1e-9 * domain.bounds().diagonal()) {}

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

Curve ChainShapes::curveOf(std::span<const Link> run) const {
    const CurveStretch &first = run.front().stretch;
    const double from = first.t0, to = run.back().stretch.t1;
    const Curve &whole = domain_.curves[first.curve];
    const Curve curve = from == 0.0 && to == 1.0 ? whole : whole.part(from, to);
    const Vec2 start = domain_.nodes[run.front().from], end = domain_.nodes[run.back().to];
    if (curve.kind() != CurveKind::Arc) {
        return joining(curve, start, end);
    }
    const Vec2 gaps[] = {start - curve.point(0.0), end - curve.point(1.0)};
    if (std::max(length(gaps[0]), length(gaps[1])) <= tolerance_ && joins(curve, start, end)) {
        return curve;
    }
    // An arc that is small in its drawing. To fit its chord, it is turned and scaled, which would change an arc that
    // is nearly closed out of proportion.
    constexpr double kMostChange = 0.01;
    const double chord = distance(curve.point(0.0), curve.point(1.0));
    const Curve fitting = length(gaps[1] - gaps[0]) <= kMostChange * chord ? joining(curve, start, end) : Curve();
    return fitting.kind() == CurveKind::Arc && joins(fitting, start, end) ? fitting
                                                                          : joining(cubicAlong(curve), start, end);
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
        addRun(std::span(links).subspan(first, last - first), shape);
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
