#include "core/io/svg/svg_pen.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

std::vector<Vec2> &SvgPen::nodes() {
    if (subpaths_.empty() || closedLast_) {
        subpaths_.push_back({{at_}, false});
        start_ = at_;
        closedLast_ = false;
    }
    return subpaths_.back().nodes;
}

void SvgPen::moveTo(Vec2 p) {
    at_ = start_ = p;
    closedLast_ = false;
    subpaths_.push_back({{p}, false});
}

void SvgPen::lineTo(Vec2 p) {
    nodes().push_back(p);
    at_ = p;
}

void SvgPen::quadraticTo(Vec2 control, Vec2 p) {
    std::vector<Vec2> &line = nodes();
    if (tolerance_) {
        flattenQuadratic(at_, control, p, *tolerance_, line);
    } else {
        line.insert(line.end(), {control, p});
    }
    at_ = p;
}

void SvgPen::cubicTo(Vec2 control1, Vec2 control2, Vec2 p) {
    std::vector<Vec2> &line = nodes();
    if (tolerance_) {
        flattenCubic(at_, control1, control2, p, *tolerance_, line);
    } else {
        line.insert(line.end(), {control1, control2, p});
    }
    at_ = p;
}

void SvgPen::arcTo(const EllipticalArc &arc, Vec2 p) {
    std::vector<Vec2> &line = nodes();
    if (tolerance_) {
        flattenArc(at_, arc, p, *tolerance_, line);
    } else {
        if (arc.largeArc) {
            const double reach = 2.0 * std::max(std::fabs(arc.radiusX), std::fabs(arc.radiusY));
            line.insert(line.end(), {at_ + Vec2{reach, reach}, at_ - Vec2{reach, reach}});
        }
        line.push_back(p);
    }
    at_ = p;
}

void SvgPen::close() {
    if (!subpaths_.empty()) {
        subpaths_.back().closed = true;
        at_ = start_;
        closedLast_ = true;
    }
}

void SvgPen::ellipse(Vec2 centre, double radiusX, double radiusY) {
    const EllipticalArc quarter{radiusX, radiusY, 0.0, false, true};
    moveTo(centre + Vec2{radiusX, 0.0});
    arcTo(quarter, centre + Vec2{0.0, radiusY});
    arcTo(quarter, centre - Vec2{radiusX, 0.0});
    arcTo(quarter, centre - Vec2{0.0, radiusY});
    arcTo(quarter, centre + Vec2{radiusX, 0.0});
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
