#include "core/drawing_files/svg/values/svg_pen.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

SvgSubpath &SvgPen::subpath() {
    if (subpaths_.empty() || closedLast_) {
        subpaths_.push_back({{at_}, {}, {}, false, 0.0});
        start_ = at_;
        closedLast_ = false;
    }
    return subpaths_.back();
}

void SvgPen::moveTo(Vec2 p) {
    at_ = start_ = p;
    closedLast_ = false;
    subpaths_.push_back({{p}, {}, {}, false, 0.0});
}

void SvgPen::straightTo(Vec2 p) {
    SvgSubpath &line = subpath();
    line.nodes.push_back(p);
    line.stretches.emplace_back();
    at_ = p;
}

/// Flattens a curve that ends in p up to rounding.
void SvgPen::curveTo(const Curve &curve, Vec2 p) {
    if (!curve.finite() || curve.kind() == CurveKind::Line) {
        straightTo(p);
        return;
    }
    SvgSubpath &line = subpath();
    const auto id = static_cast<std::uint32_t>(line.curves.size());
    line.curves.push_back(curve);
    double from = 0.0;
    for (const double to : curve.flatten(*tolerance_)) {
        line.nodes.push_back(to == 1.0 ? p : curve.point(to));
        line.stretches.push_back({id, from, to});
        from = to;
    }
    at_ = p;
}

void SvgPen::lineTo(Vec2 p) {
    straightTo(p);
}

void SvgPen::quadraticTo(Vec2 control, Vec2 p) {
    if (tolerance_) {
        curveTo(Curve::quadratic(at_, control, p), p);
        return;
    }
    straightTo(control);
    straightTo(p);
}

void SvgPen::cubicTo(Vec2 control1, Vec2 control2, Vec2 p) {
    if (tolerance_) {
        curveTo(Curve::cubic(at_, control1, control2, p), p);
        return;
    }
    straightTo(control1);
    straightTo(control2);
    straightTo(p);
}

void SvgPen::arcTo(const EllipticalArc &arc, Vec2 p) {
    if (tolerance_) {
        curveTo(curveOf(at_, arc, p), p);
        return;
    }
    if (arc.largeArc) {
        const double reach = 2.0 * std::max(std::fabs(arc.radiusX), std::fabs(arc.radiusY));
        const Vec2 from = at_;
        straightTo(from + Vec2{reach, reach});
        straightTo(from - Vec2{reach, reach});
    }
    straightTo(p);
}

void SvgPen::close() {
    if (!subpaths_.empty()) {
        subpaths_.back().closed = true;
        at_ = start_;
        closedLast_ = true;
    }
}

void SvgPen::ellipse(Vec2 centre, double radiusX, double radiusY) {
    const Vec2 start = centre + Vec2{radiusX, 0.0};
    moveTo(start);
    if (tolerance_) {
        curveTo(Curve::arc(centre, {radiusX, 0.0}, {0.0, radiusY}), start);
    } else {
        straightTo(centre + Vec2{-radiusX, radiusY});
        straightTo(centre + Vec2{radiusX, -radiusY});
    }
    close();
}

void SvgPen::rectangle(Vec2 corner, Vec2 size, double radiusX, double radiusY) {
    const double rx = std::min(radiusX, 0.5 * size.x);
    const double ry = std::min(radiusY, 0.5 * size.y);
    const Vec2 far = corner + size;
    if (!(rx > 0.0 && ry > 0.0)) {
        moveTo(corner);
        lineTo({far.x, corner.y});
        lineTo(far);
        lineTo({corner.x, far.y});
        close();
        return;
    }
    const EllipticalArc quarter{rx, ry, 0.0, false, true};
    moveTo({corner.x + rx, corner.y});
    lineTo({far.x - rx, corner.y});
    arcTo(quarter, {far.x, corner.y + ry});
    lineTo({far.x, far.y - ry});
    arcTo(quarter, {far.x - rx, far.y});
    lineTo({corner.x + rx, far.y});
    arcTo(quarter, {corner.x, far.y - ry});
    lineTo({corner.x, corner.y + ry});
    arcTo(quarter, {corner.x + rx, corner.y});
    close();
}

} // namespace forefront
