#include "core/drawing/colour_outline/outline_fit.hpp"

#include "core/engine/geometry/plane_sweep.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/engine/geometry/stroke_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace forefront {
namespace {

/// Times that the distance from the outline is halved where curves cross, before its points are joined by lines.
constexpr int kHalvings = 4;
/// Maximum distance of a chord from a curve in the check whether curves cross, pixels.
constexpr double kChordError = 0.05;

/// A curve along a stretch of an outline.
struct FittedCurve {
    Curve curve;
    std::size_t from = 0, to = 0; ///< its ends among the points of the outline; the same for a whole loop
    int halvings = 0;             ///< of the smoothness
};

/// An outline with its curves.
struct FittedLoop {
    const PixelLoop *outline = nullptr;
    std::vector<FittedCurve> curves;
};

/// Returns the points of an outline from one to another, or once around.
std::vector<Vec2> stretchOf(const PixelLoop &outline, std::size_t from, std::size_t to) {
    std::vector<Vec2> points{outline[from]};
    do {
        from = (from + 1) % outline.size();
        points.push_back(outline[from]);
    } while (from != to);
    return points;
}

/// Appends curves that end at points of the outline, the first of which begins at point `from`.
void append(std::vector<FittedCurve> &curves, const std::vector<Curve> &added, const PixelLoop &outline,
            std::size_t from, int halvings) {
    for (const Curve &curve : added) {
        std::size_t to = (from + 1) % outline.size();
        while (to != from && outline[to] != curve.point(1.0)) {
            to = (to + 1) % outline.size();
        }
        curves.push_back({curve, from, to, halvings});
        from = to;
    }
}

/// Returns lines through all points.
std::vector<Curve> linesAlong(const std::vector<Vec2> &points) {
    std::vector<Curve> lines;
    for (std::size_t k = 1; k < points.size(); ++k) {
        lines.push_back(Curve::line(points[k - 1], points[k]));
    }
    return lines;
}

FittedLoop fitLoop(const PixelLoop &outline, double smoothness) {
    FittedLoop loop{&outline, {}};
    std::vector<Curve> curves = fitStroke(outline, smoothness, true);
    const bool curved =
        std::any_of(curves.begin(), curves.end(), [](const Curve &curve) { return curve.kind() != CurveKind::Line; });
    if (curves.size() < (curved ? 2U : 3U)) { // it would enclose no area
        append(loop.curves, linesAlong(stretchOf(outline, 0, 0)), outline, 0, kHalvings + 1);
        return loop;
    }
    const auto first = std::find(outline.begin(), outline.end(), curves.front().point(0.0));
    append(loop.curves, curves, outline, static_cast<std::size_t>(first - outline.begin()), 0);
    return loop;
}

/// Appends the points of the chords of a curve after its start.
void addChords(const Curve &curve, std::vector<Vec2> &points) {
    const std::vector<double> places =
        curve.kind() == CurveKind::Line ? std::vector<double>{1.0} : curve.flatten(kChordError);
    for (const double t : places) {
        points.push_back(curve.point(t));
    }
}

/// Returns boxes around the places where curves of the loops meet.
std::vector<Box2> meetingsOf(const std::vector<FittedLoop> &loops, const std::stop_token &stop) {
    std::vector<Vec2> points;
    std::vector<PlaneEdge> edges;
    for (const FittedLoop &loop : loops) {
        const auto first = static_cast<std::uint32_t>(points.size());
        for (const FittedCurve &fitted : loop.curves) {
            addChords(fitted.curve, points);
        }
        for (auto k = first; k < points.size(); ++k) {
            edges.push_back({k, k + 1 < points.size() ? k + 1 : first});
        }
    }
    const PlaneSweepResult sweep = sweepPlane(points, edges, stop);
    std::vector<Box2> boxes;
    for (std::size_t k = 0; k < edges.size() && sweep.droppedCount > 0; ++k) {
        if (sweep.dropped[k] != 0) {
            boxes.push_back(boxOf(points[edges[k].a], points[edges[k].b]).grown(kChordError));
        }
    }
    return boxes;
}

/// Returns true if the curve passes through one of the boxes.
bool passes(const Curve &curve, const std::vector<Box2> &boxes) {
    const Box2 bounds = curve.bounds();
    std::vector<Vec2> points;
    for (const Box2 &box : boxes) {
        if (!bounds.overlaps(box)) {
            continue;
        }
        if (points.empty()) {
            points.push_back(curve.point(0.0));
            addChords(curve, points);
        }
        for (std::size_t k = 1; k < points.size(); ++k) {
            if (boxOf(points[k - 1], points[k]).overlaps(box)) {
                return true;
            }
        }
    }
    return false;
}

/// Replaces the curves of a loop that pass through one of the boxes by ones closer to the outline.
void fitCloser(FittedLoop &loop, const std::vector<Box2> &boxes, double smoothness) {
    std::vector<FittedCurve> closer;
    for (const FittedCurve &old : loop.curves) {
        if (old.halvings > kHalvings || !passes(old.curve, boxes)) {
            closer.push_back(old);
            continue;
        }
        const std::vector<Vec2> points = stretchOf(*loop.outline, old.from, old.to);
        const int halvings = old.halvings + 1;
        append(closer,
               halvings > kHalvings ? linesAlong(points) : fitStroke(points, std::ldexp(smoothness, -halvings), false),
               *loop.outline, old.from, halvings);
    }
    loop.curves = std::move(closer);
}

/// Fits curves that meet others closer to their outlines, until none do. It ends: each round halves the distance of a
/// curve, and the outlines themselves never meet.
void separate(std::vector<FittedLoop> &loops, double smoothness, const Progress &progress) {
    for (std::vector<Box2> boxes = meetingsOf(loops, progress.stop); !boxes.empty() && !progress.cancelled();
         boxes = meetingsOf(loops, progress.stop)) {
        progress("separating curves that cross", 0.0);
        for (FittedLoop &loop : loops) {
            fitCloser(loop, boxes, smoothness);
        }
    }
}

} // namespace

std::size_t OutlineFit::nodes() const {
    std::size_t count = 0;
    for (const std::vector<Curve> &loop : loops) {
        count += loop.size();
    }
    return count;
}

OutlineFit fitOutlines(const std::vector<PixelLoop> &outlines, double smoothness, const Progress &progress) {
    OutlineFit result;
    std::vector<FittedLoop> loops;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        if (progress.cancelled()) {
            return {};
        }
        progress("fitting curves", static_cast<double>(k) / static_cast<double>(outlines.size()));
        if (k > 0 && std::fabs(signedArea(outlines[k])) < 16.0 * smoothness * smoothness) {
            ++result.dropped;
            continue;
        }
        loops.push_back(fitLoop(outlines[k], smoothness));
    }
    separate(loops, smoothness, progress);
    if (progress.cancelled()) {
        return {};
    }
    for (const FittedLoop &loop : loops) {
        std::vector<Curve> &curves = result.loops.emplace_back();
        for (const FittedCurve &fitted : loop.curves) {
            curves.push_back(fitted.curve);
        }
    }
    return result;
}

std::vector<Shape> boundariesAlong(const OutlineFit &fit, const PlaneMap &map) {
    std::vector<Shape> shapes;
    for (const std::vector<Curve> &loop : fit.loops) {
        Shape shape;
        PathForm &path = shape.path();
        bool curved = false;
        for (const Curve &curve : loop) {
            // The end of a curve is exactly the beginning of the next one, also in the plane.
            shape.nodes.push_back(map(curve.point(0.0)));
            const bool line = curve.kind() == CurveKind::Line;
            path.curves.push_back(line ? Curve() : curve.mapped(map));
            curved = curved || !line;
        }
        if (!curved) {
            path.curves.clear();
        }
        shapes.push_back(std::move(shape));
    }
    return shapes;
}

} // namespace forefront
