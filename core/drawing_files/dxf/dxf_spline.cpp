#include "core/drawing_files/dxf/dxf_spline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace forefront {

namespace {

constexpr int kMaxDegree = 25;
constexpr int kMaxHalvings = 10; ///< of a span, for cubics within the error

/// A control point in homogeneous coordinates.
struct Weighted {
    Vec2 at; ///< times the weight
    double weight = 1.0;
};

Weighted between(const Weighted &p, const Weighted &q, double t) {
    return {(1.0 - t) * p.at + t * q.at, (1.0 - t) * p.weight + t * q.weight};
}

/// Point and derivative of a rational Bézier curve, by de Casteljau's algorithm.
struct PointAndSlope {
    Vec2 at, slope;
};

PointAndSlope evaluate(std::vector<Weighted> points, double t) {
    const auto degree = static_cast<double>(points.size() - 1);
    while (points.size() > 2) {
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            points[k] = between(points[k], points[k + 1], t);
        }
        points.pop_back();
    }
    const Weighted end = between(points[0], points[1], t);
    const Vec2 at = (1.0 / end.weight) * end.at;
    const Vec2 slope = points[1].at - points[0].at - (points[1].weight - points[0].weight) * at;
    return {at, (degree / end.weight) * slope};
}

/// Appends cubics along a part of a rational Bézier curve, halved until each is near enough.
void appendCubics(const std::vector<Weighted> &points, double from, double to, double error, int halvings,
                  std::vector<Curve> &curves) {
    const PointAndSlope a = evaluate(points, from), b = evaluate(points, to);
    const double third = (to - from) / 3.0;
    const Curve cubic = Curve::cubic(a.at, a.at + third * a.slope, b.at - third * b.slope, b.at);
    bool near = true;
    for (const double t : {0.2, 0.5, 0.8}) {
        near = near && distance(cubic.point(t), evaluate(points, from + t * (to - from)).at) <= error;
    }
    const bool lost =
        !isFinite(a.at) || !isFinite(b.at); // halving leads nowhere; such curves are refused by the reader
    if (near || lost || halvings == kMaxHalvings) {
        curves.push_back(cubic);
        return;
    }
    const double middle = 0.5 * (from + to);
    appendCubics(points, from, middle, error, halvings + 1, curves);
    appendCubics(points, middle, to, error, halvings + 1, curves);
}

/// Returns the Bézier points of the span between knots k and k + 1: values of the polar form (Ramshaw, Blossoming).
std::vector<Weighted> spanOf(const DxfSpline &spline, std::size_t k) {
    const auto p = static_cast<std::size_t>(spline.degree);
    const std::vector<double> &u = spline.knots;
    std::vector<Weighted> points;
    for (std::size_t j = 0; j <= p; ++j) {
        std::vector<Weighted> d(p + 1);
        for (std::size_t i = 0; i <= p; ++i) {
            const double weight = spline.weights.empty() ? 1.0 : spline.weights[k - p + i];
            d[i] = {weight * spline.controls[k - p + i], weight};
        }
        for (std::size_t r = 1; r <= p; ++r) {
            const double argument = r <= p - j ? u[k] : u[k + 1];
            for (std::size_t i = p; i >= r; --i) {
                const double low = u[k - p + i], high = u[i + k - r + 1];
                d[i] = between(d[i - 1], d[i], (argument - low) / (high - low));
            }
        }
        points.push_back(d[p]);
    }
    return points;
}

std::string faultOf(const DxfSpline &spline) {
    const std::size_t count = spline.controls.size();
    if (spline.degree < 1 || spline.degree > kMaxDegree) {
        return "a spline of degree " + std::to_string(spline.degree) + " cannot be read; expected 1 to " +
               std::to_string(kMaxDegree);
    }
    const auto degree = static_cast<std::size_t>(spline.degree);
    if (count < degree + 1) {
        return "a spline of degree " + std::to_string(degree) + " has only " + std::to_string(count) +
               " control points";
    }
    if (spline.knots.size() != count + degree + 1) {
        return "a spline has " + std::to_string(spline.knots.size()) + " knots; expected " +
               std::to_string(count + degree + 1);
    }
    if (!std::is_sorted(spline.knots.begin(), spline.knots.end()) || !(spline.knots[degree] < spline.knots[count])) {
        return "the knots of a spline do not increase";
    }
    if (!spline.weights.empty() &&
        (spline.weights.size() != count ||
         std::any_of(spline.weights.begin(), spline.weights.end(), [](double w) { return !(w > 0.0); }))) {
        return "a spline needs a positive weight for each control point";
    }
    return {};
}

void appendControlled(const DxfSpline &spline, std::vector<Curve> &curves) {
    const bool rational = std::any_of(spline.weights.begin(), spline.weights.end(),
                                      [&](double weight) { return weight != spline.weights.front(); });
    DxfSpline plain = spline;
    if (!rational) {
        plain.weights.clear();
    }
    Box2 box;
    std::for_each(spline.controls.begin(), spline.controls.end(), [&](Vec2 p) { box.add(p); });
    const auto degree = static_cast<std::size_t>(spline.degree);
    for (std::size_t k = degree; k < spline.controls.size(); ++k) {
        if (!(spline.knots[k] < spline.knots[k + 1])) {
            continue;
        }
        const std::vector<Weighted> b = spanOf(plain, k);
        if (rational || degree > 3) {
            appendCubics(b, 0.0, 1.0, kDxfSplineError * box.diagonal(), 0, curves);
        } else if (degree == 3) {
            curves.push_back(Curve::cubic(b[0].at, b[1].at, b[2].at, b[3].at));
        } else {
            curves.push_back(degree == 2 ? Curve::quadratic(b[0].at, b[1].at, b[2].at) : Curve::line(b[0].at, b[1].at));
        }
    }
}

/// A row of a system of equations: before·x[k-1] + here·x[k] + after·x[k+1] = value.
struct Row {
    double before = 0.0, here = 1.0, after = 0.0;
    Vec2 value;
};

/// Solves a tridiagonal system whose diagonal dominates.
std::vector<Vec2> solve(std::vector<Row> rows) {
    for (std::size_t k = 1; k < rows.size(); ++k) {
        const double factor = rows[k].before / rows[k - 1].here;
        rows[k].here -= factor * rows[k - 1].after;
        rows[k].value = rows[k].value - factor * rows[k - 1].value;
    }
    std::vector<Vec2> x(rows.size());
    for (std::size_t k = rows.size(); k-- > 0;) {
        const Vec2 next = k + 1 < rows.size() ? rows[k].after * x[k + 1] : Vec2{};
        x[k] = (1.0 / rows[k].here) * (rows[k].value - next);
    }
    return x;
}

/// Returns the slopes of a cubic spline through points. A closed one is continued around its ends; the influence of an
/// end fades by a factor of more than 3 at each point.
std::vector<Vec2> slopesOf(const std::vector<Vec2> &points, Vec2 startTangent, Vec2 endTangent) {
    const std::size_t last = points.size() - 1;
    std::vector<double> h;
    for (std::size_t k = 0; k < last; ++k) {
        h.push_back(distance(points[k], points[k + 1]));
    }
    std::vector<Row> rows(points.size());
    const auto unit = [](Vec2 v) { return (1.0 / length(v)) * v; };
    rows[0] = startTangent == Vec2{} ? Row{0.0, 2.0, 1.0, (3.0 / h[0]) * (points[1] - points[0])}
                                     : Row{0.0, 1.0, 0.0, unit(startTangent)};
    rows[last] = endTangent == Vec2{} ? Row{1.0, 2.0, 0.0, (3.0 / h[last - 1]) * (points[last] - points[last - 1])}
                                      : Row{0.0, 1.0, 0.0, unit(endTangent)};
    for (std::size_t k = 1; k < last; ++k) {
        const double p = 1.0 / h[k - 1], q = 1.0 / h[k];
        rows[k] = {p, 2.0 * (p + q), q,
                   (3.0 * p * p) * (points[k] - points[k - 1]) + (3.0 * q * q) * (points[k + 1] - points[k])};
    }
    return solve(std::move(rows));
}

std::string appendThrough(const DxfSpline &spline, std::vector<Curve> &curves) {
    std::vector<Vec2> points = spline.fits;
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (spline.closed && points.size() > 2 && points.front() == points.back()) {
        points.pop_back();
    }
    if (points.size() < 2) {
        return "a spline has neither control points nor two points to pass through";
    }
    std::size_t first = 0, count = points.size() - 1;
    if (spline.closed && points.size() > 2) {
        constexpr std::size_t kBeside = 40; // points on each side of the closed spline
        const std::size_t n = points.size();
        std::vector<Vec2> around;
        for (std::size_t k = 0; k <= n + 2 * kBeside; ++k) {
            around.push_back(points[(k + n * kBeside - kBeside) % n]);
        }
        points = std::move(around);
        first = kBeside;
        count = n;
    }
    const bool open = first == 0;
    const std::vector<Vec2> slopes =
        slopesOf(points, open ? spline.startTangent : Vec2{}, open ? spline.endTangent : Vec2{});
    for (std::size_t k = first; k < first + count; ++k) {
        const double third = distance(points[k], points[k + 1]) / 3.0;
        curves.push_back(Curve::cubic(points[k], points[k] + third * slopes[k], points[k + 1] - third * slopes[k + 1],
                                      points[k + 1]));
    }
    return {};
}

} // namespace

std::string appendSpline(const DxfSpline &spline, std::vector<Curve> &curves) {
    if (spline.controls.empty()) {
        return appendThrough(spline, curves);
    }
    std::string fault = faultOf(spline);
    if (fault.empty()) {
        appendControlled(spline, curves);
    }
    return fault;
}

} // namespace forefront
