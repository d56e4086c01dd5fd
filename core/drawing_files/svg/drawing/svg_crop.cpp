#include "core/drawing_files/svg/drawing/svg_crop.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

namespace {

/// Returns the ends of a straight segment and, between them, where it crosses the four lines along the sides of a box.
std::vector<Vec2> cutAtSides(Vec2 a, Vec2 b, const Box2 &box) {
    struct Cut {
        double t;
        Vec2 at;
    };
    std::vector<Cut> cuts;
    const Vec2 centre = box.centre();
    const bool nearerA = distance(a, centre) <= distance(b, centre);
    const Vec2 near = nearerA ? a : b, along = (nearerA ? b : a) - near; // from the nearer end, rounding is smaller
    for (const double side : {box.min.x, box.max.x}) {
        if ((a.x < side) != (b.x < side)) {
            cuts.push_back({(side - a.x) / (b.x - a.x), {side, near.y + (side - near.x) * (along.y / along.x)}});
        }
    }
    for (const double side : {box.min.y, box.max.y}) {
        if ((a.y < side) != (b.y < side)) {
            cuts.push_back({(side - a.y) / (b.y - a.y), {near.x + (side - near.y) * (along.x / along.y), side}});
        }
    }
    std::sort(cuts.begin(), cuts.end(), [](const Cut &s, const Cut &t) { return s.t < t.t; });
    std::vector<Vec2> points{a};
    for (const Cut &cut : cuts) {
        points.push_back(cut.at);
    }
    points.push_back(b);
    return points;
}

/// Calls visit(from, to, stretch, outside) for the parts of a path, in order, each of them in the box or on one side of
/// a side of it.
template <class Visit>
void forParts(const SvgPath &path, bool closed, const Box2 &box, double tolerance, const Visit &visit) {
    const std::size_t count = path.nodes.size();
    for (std::size_t k = 0; k + (closed ? 0 : 1) < count; ++k) {
        const Vec2 a = path.nodes[k], b = path.nodes[(k + 1) % count];
        const CurveStretch stretch = k + 1 < count && k < path.stretches.size() ? path.stretches[k] : CurveStretch{};
        if (!stretch.follows()) {
            const std::vector<Vec2> points = cutAtSides(a, b, box);
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                visit(points[i], points[i + 1], stretch, !box.contains(midpoint(points[i], points[i + 1])));
            }
            continue;
        }
        const Curve &curve = path.curves[stretch.curve];
        Vec2 from = a;
        double t0 = stretch.t0;
        for (const double t1 : curve.flattenWithin(box, tolerance, stretch.t0, stretch.t1)) {
            const Vec2 to = t1 == stretch.t1 ? b : curve.point(t1);
            visit(from, to, CurveStretch{stretch.curve, t0, t1}, !curve.bounds(t0, t1).overlaps(box));
            from = to;
            t0 = t1;
        }
    }
}

/// Draws a ring that runs along the sides of a box.
class Ring {
  public:
    explicit Ring(const Box2 &box) : box_(box) {}

    /// Each part that is outside lies on one side of a side of the box, so moving it onto the box passes no place
    /// inside.
    void add(Vec2 from, Vec2 to, const CurveStretch &stretch, bool outside) {
        straightTo(outside ? clamped(from) : from);
        if (outside || !stretch.follows()) {
            straightTo(outside ? clamped(to) : to);
        } else {
            nodes.push_back(to);
            stretches.push_back(stretch);
        }
    }

    std::vector<Vec2> nodes;
    std::vector<CurveStretch> stretches;

  private:
    Vec2 clamped(Vec2 p) const {
        return {std::clamp(p.x, box_.min.x, box_.max.x), std::clamp(p.y, box_.min.y, box_.max.y)};
    }

    /// Draws a straight segment, unless it has no length. Of several along one side of the box, one is left.
    void straightTo(Vec2 p) {
        while (nodes.size() > 1 && !stretches.back().follows() && onOneSide(nodes[nodes.size() - 2], nodes.back(), p)) {
            nodes.pop_back();
            stretches.pop_back();
        }
        if (nodes.empty() || nodes.back() != p) {
            stretches.resize(nodes.size());
            nodes.push_back(p);
        }
    }

    bool onOneSide(Vec2 p, Vec2 q, Vec2 r) const {
        const auto all = [](double s, double t, double u, double side) { return s == side && t == side && u == side; };
        return all(p.x, q.x, r.x, box_.min.x) || all(p.x, q.x, r.x, box_.max.x) || all(p.y, q.y, r.y, box_.min.y) ||
               all(p.y, q.y, r.y, box_.max.y);
    }

    const Box2 &box_;
};

/// Returns a path without nodes that looks like the lines of another one.
SvgPath lineLike(const SvgPath &path) {
    SvgPath line;
    line.isLine = path.isLine;
    line.paint = path.paint;
    line.paint.filled = false;
    line.element = path.element;
    line.name = path.name;
    line.offset = path.offset;
    line.limit = path.limit;
    return line;
}

} // namespace

void cropArea(SvgPath &path, const Box2 &box, double tolerance) {
    Ring ring(box);
    forParts(path, true, box, tolerance, [&](Vec2 from, Vec2 to, const CurveStretch &stretch, bool outside) {
        ring.add(from, to, stretch, outside);
    });
    path.nodes = std::move(ring.nodes);
    path.stretches = std::move(ring.stretches);
    path.closed = true;
}

std::vector<SvgPath> croppedLines(const SvgPath &path, const Box2 &box, double tolerance) {
    std::vector<SvgPath> lines;
    std::uint32_t lastCurve = kNoCurve; // the last one that the last line follows
    forParts(path, path.closed, box, tolerance, [&](Vec2 from, Vec2 to, CurveStretch stretch, bool outside) {
        if (outside) {
            return;
        }
        if (lines.empty() || lines.back().nodes.back() != from) {
            lines.push_back(lineLike(path));
            lines.back().nodes.push_back(from);
            lastCurve = kNoCurve;
        }
        SvgPath &line = lines.back();
        if (stretch.follows()) {
            if (std::exchange(lastCurve, stretch.curve) != stretch.curve) {
                line.curves.push_back(path.curves[stretch.curve]);
            }
            stretch.curve = static_cast<std::uint32_t>(line.curves.size() - 1);
        }
        line.nodes.push_back(to);
        line.stretches.push_back(stretch);
    });
    return lines;
}

} // namespace forefront
