#include "core/io/svg/svg_crop.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {

namespace {

/// Draws the cropped path.
class Cropper {
  public:
    Cropper(const Box2 &box, double tolerance) : box_(box), tolerance_(tolerance) {}

    void line(Vec2 a, Vec2 b) {
        std::array<double, 6> cuts{0.0, 1.0, 1.0, 1.0, 1.0, 1.0};
        std::size_t count = 1;
        const auto cut = [&](double from, double to, double side) {
            if ((from < side) != (to < side)) {
                cuts[count++] = (side - from) / (to - from);
            }
        };
        cut(a.x, b.x, box_.min.x);
        cut(a.x, b.x, box_.max.x);
        cut(a.y, b.y, box_.min.y);
        cut(a.y, b.y, box_.max.y);
        std::sort(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(count));
        // Each part lies on one side of every side of the box, so that moving it onto the box passes no place inside.
        for (std::size_t k = 0; k < count; ++k) {
            straightTo(clamped(lerp(a, b, cuts[k])));
        }
        straightTo(clamped(b));
    }

    /// Draws the curve that a segment from a to b follows.
    void curve(const Curve &curve, const CurveStretch &stretch, Vec2 a, Vec2 b) {
        Vec2 from = a;
        double t0 = stretch.t0;
        for (const double t1 : curve.flattenWithin(box_, tolerance_, stretch.t0, stretch.t1)) {
            const Vec2 to = t1 == stretch.t1 ? b : curve.point(t1);
            if (curve.bounds(t0, t1).overlaps(box_)) {
                straightTo(from);
                path_.nodes.push_back(to);
                path_.stretches.push_back({stretch.curve, t0, t1});
            } else {
                straightTo(clamped(from));
                straightTo(clamped(to));
            }
            from = to;
            t0 = t1;
        }
    }

    SvgPath take() { return std::move(path_); }

  private:
    Vec2 clamped(Vec2 p) const {
        return {std::clamp(p.x, box_.min.x, box_.max.x), std::clamp(p.y, box_.min.y, box_.max.y)};
    }

    /// Draws a straight segment, unless it has no length. Of several along one side of the box, one is left.
    void straightTo(Vec2 p) {
        std::vector<Vec2> &nodes = path_.nodes;
        while (nodes.size() > 1 && !path_.stretches.back().follows() &&
               onOneSide(nodes[nodes.size() - 2], nodes.back(), p)) {
            nodes.pop_back();
            path_.stretches.pop_back();
        }
        if (nodes.empty() || nodes.back() != p) {
            if (!nodes.empty()) {
                path_.stretches.emplace_back();
            }
            nodes.push_back(p);
        }
    }

    bool onOneSide(Vec2 p, Vec2 q, Vec2 r) const {
        const auto all = [](double s, double t, double u, double side) { return s == side && t == side && u == side; };
        return all(p.x, q.x, r.x, box_.min.x) || all(p.x, q.x, r.x, box_.max.x) || all(p.y, q.y, r.y, box_.min.y) ||
               all(p.y, q.y, r.y, box_.max.y);
    }

    const Box2 &box_;
    double tolerance_;
    SvgPath path_; ///< nodes and stretches only
};

} // namespace

void crop(SvgPath &path, const Box2 &box, double tolerance) {
    const Box2 bounds = path.bounds();
    if (path.nodes.size() < 2 || (box.contains(bounds.min) && box.contains(bounds.max))) {
        return;
    }
    Cropper cropper(box, tolerance);
    for (std::size_t k = 0; k + 1 < path.nodes.size(); ++k) {
        const CurveStretch &stretch = path.stretches[k];
        if (stretch.follows()) {
            cropper.curve(path.curves[stretch.curve], stretch, path.nodes[k], path.nodes[k + 1]);
        } else {
            cropper.line(path.nodes[k], path.nodes[k + 1]);
        }
    }
    const bool filled = path.painted();
    if (filled || path.closed) {
        cropper.line(path.nodes.back(), path.nodes.front());
    }
    SvgPath cropped = cropper.take();
    path.nodes = std::move(cropped.nodes);
    path.stretches = std::move(cropped.stretches);
    path.paint.filled = filled;
}

} // namespace forefront
