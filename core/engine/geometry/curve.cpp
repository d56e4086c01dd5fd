#include "core/engine/geometry/curve.hpp"

#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace forefront {

namespace {

constexpr double kPi = std::numbers::pi;

/// Appends the roots in (0, 1) of a quadratic a t² + b t + c.
void addRoots(double a, double b, double c, std::vector<double> &roots) {
    const auto add = [&roots](double t) {
        if (t > 0.0 && t < 1.0) {
            roots.push_back(t);
        }
    };
    const double discriminant = b * b - 4.0 * a * c;
    if (!(discriminant >= 0.0)) {
        return;
    }
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b)); // no cancellation
    if (q != 0.0) {
        add(c / q);
    }
    if (a != 0.0) {
        add(q / a);
    }
}

/// Integrates a function by Gauss's rule with 8 nodes, halving intervals until the halves agree with the full interval.
template <class Function>
class GaussIntegral {
  public:
    /// `noise`: bound on the rounding error of the function. Halves that differ by less are accepted: beside a cusp,
    /// the speed of a curve is nothing but such errors.
    GaussIntegral(const Function &function, double noise) : function_(function), noise_(noise) {}

    double over(double a, double b) const {
        const double whole = rule(a, b);
        return refine(a, b, whole, std::fabs(whole) * 1e-13, 40);
    }

  private:
    double rule(double a, double b) const {
        constexpr std::array<double, 4> kNode = {0.18343464249564981, 0.52553240991632899, 0.79666647741362674,
                                                 0.96028985649753623};
        constexpr std::array<double, 4> kWeight = {0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                                   0.10122853629037626};
        const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
        double sum = 0.0;
        for (std::size_t k = 0; k < kNode.size(); ++k) {
            sum += kWeight[k] * (function_(middle - half * kNode[k]) + function_(middle + half * kNode[k]));
        }
        return half * sum;
    }
    double refine(double a, double b, double whole, double tolerance, int depth) const {
        const double middle = 0.5 * (a + b), left = rule(a, middle), right = rule(middle, b);
        if (depth == 0 || !(std::fabs(left + right - whole) > std::max(tolerance, noise_ * (b - a)))) {
            return left + right;
        }
        return refine(a, middle, left, tolerance, depth - 1) + refine(middle, b, right, tolerance, depth - 1);
    }

    const Function &function_;
    double noise_;
};

double angleBetween(Vec2 a, Vec2 b) {
    return std::fabs(std::atan2(cross(a, b), dot(a, b)));
}

} // namespace

Curve Curve::line(Vec2 start, Vec2 end) {
    return fromNumbers(CurveKind::Line, {start.x, start.y, end.x, end.y});
}

Curve Curve::arc(Vec2 centre, Vec2 u, Vec2 v, double startAngle, double sweep) {
    return fromNumbers(CurveKind::Arc, {centre.x, centre.y, u.x, u.y, v.x, v.y, startAngle, sweep});
}

Curve Curve::circle(Vec2 centre, Vec2 onCircle) {
    return arc(centre, onCircle - centre, leftNormal(onCircle - centre));
}

Curve Curve::quadratic(Vec2 start, Vec2 control, Vec2 end) {
    return cubic(start, lerp(start, control, 2.0 / 3.0), lerp(end, control, 2.0 / 3.0), end);
}

Curve Curve::cubic(Vec2 start, Vec2 control1, Vec2 control2, Vec2 end) {
    return fromNumbers(CurveKind::Cubic,
                       {start.x, start.y, control1.x, control1.y, control2.x, control2.y, end.x, end.y});
}

Curve Curve::fromNumbers(CurveKind kind, const std::array<double, 8> &numbers) {
    Curve curve;
    curve.kind_ = kind;
    for (std::size_t k = 0; k < 4; ++k) {
        curve.p_[k] = {numbers[2 * k], numbers[2 * k + 1]};
    }
    if (kind == CurveKind::Line) {
        curve.p_ = {curve.p_[0], {}, {}, curve.p_[1]};
    }
    return curve;
}

std::array<double, 8> Curve::numbers() const {
    if (kind_ == CurveKind::Line) {
        return {p_[0].x, p_[0].y, p_[3].x, p_[3].y};
    }
    return {p_[0].x, p_[0].y, p_[1].x, p_[1].y, p_[2].x, p_[2].y, p_[3].x, p_[3].y};
}

bool Curve::finite() const {
    return std::all_of(p_.begin(), p_.end(), [](Vec2 p) { return isFinite(p); });
}

Vec2 Curve::point(double t) const {
    switch (kind_) {
    case CurveKind::Line:
        return t == 1.0 ? p_[3] : lerp(p_[0], p_[3], t);
    case CurveKind::Arc: {
        const double theta = angle(t);
        return p_[0] + (std::cos(theta) * p_[1] + std::sin(theta) * p_[2]);
    }
    case CurveKind::Cubic:
        break;
    }
    if (t == 1.0) {
        return p_[3];
    }
    const Vec2 a = lerp(p_[0], p_[1], t), b = lerp(p_[1], p_[2], t), c = lerp(p_[2], p_[3], t);
    return lerp(lerp(a, b, t), lerp(b, c, t), t);
}

Vec2 Curve::derivative(double t) const {
    switch (kind_) {
    case CurveKind::Line:
        return p_[3] - p_[0];
    case CurveKind::Arc: {
        const double theta = angle(t);
        return p_[3].y * (std::cos(theta) * p_[2] - std::sin(theta) * p_[1]);
    }
    case CurveKind::Cubic:
        break;
    }
    const Vec2 a = p_[1] - p_[0], b = p_[2] - p_[1], c = p_[3] - p_[2];
    return 3.0 * lerp(lerp(a, b, t), lerp(b, c, t), t);
}

Vec2 Curve::secondDerivative(double t) const {
    switch (kind_) {
    case CurveKind::Line:
        return {};
    case CurveKind::Arc: {
        const double theta = angle(t);
        return -p_[3].y * p_[3].y * (std::cos(theta) * p_[1] + std::sin(theta) * p_[2]);
    }
    case CurveKind::Cubic:
        break;
    }
    return 6.0 * lerp(p_[0] - 2.0 * p_[1] + p_[2], p_[1] - 2.0 * p_[2] + p_[3], t);
}

Vec2 Curve::tangent(double t) const {
    constexpr double kVanishes = 1e-13; // fraction of the curve's size
    Vec2 along = derivative(t);
    if (kind_ == CurveKind::Cubic) {
        const double negligible =
            kVanishes * std::max({distance(p_[0], p_[1]), distance(p_[0], p_[2]), distance(p_[0], p_[3])});
        const double ahead = t < 1.0 ? 1.0 : -1.0; // at the end, seen from before it
        if (!(forefront::length(along) > negligible)) {
            along = ahead * secondDerivative(t);
        }
        if (!(forefront::length(along) > negligible)) {
            along = p_[3] - 3.0 * p_[2] + 3.0 * p_[1] - p_[0];
        }
    }
    const double size = forefront::length(along);
    return size > 0.0 ? (1.0 / size) * along : Vec2{};
}

double Curve::length(double t0, double t1) const {
    if (kind_ == CurveKind::Line) {
        return std::fabs(t1 - t0) * distance(p_[0], p_[3]);
    }
    const auto speed = [this](double t) { return forefront::length(derivative(t)); };
    // Where a cubic slows down towards a near cusp, the speed is not smooth: the rule converges on either side.
    std::vector<double> ends = {std::min(t0, t1), std::max(t0, t1)};
    if (kind_ == CurveKind::Cubic) {
        for (const Vec2 axis : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}}) {
            for (const double t : turningPoints(axis)) {
                if (t > ends[0] && t < ends[1]) {
                    ends.push_back(t);
                }
            }
        }
        std::sort(ends.begin(), ends.end());
    }
    double size = 0.0; // bound on the terms that add up to the derivative
    if (kind_ == CurveKind::Arc) {
        const double angles = std::max({1.0, std::fabs(angle(0.0)), std::fabs(angle(1.0))}); // are rounded, too
        size = std::fabs(p_[3].y) * (forefront::length(p_[1]) + forefront::length(p_[2])) * angles;
    } else {
        size = distance(p_[0], p_[1]) + distance(p_[1], p_[2]) + distance(p_[2], p_[3]);
    }
    constexpr double kRoundings = 16.0 * std::numeric_limits<double>::epsilon();
    double sum = 0.0;
    for (std::size_t k = 1; k < ends.size(); ++k) {
        sum += GaussIntegral(speed, kRoundings * size).over(ends[k - 1], ends[k]);
    }
    return sum;
}

double Curve::turning(double t0, double t1) const {
    if (kind_ == CurveKind::Line) {
        return 0.0;
    }
    const double low = std::min(t0, t1), high = std::max(t0, t1);
    std::vector<double> ends = {low, high};
    if (kind_ == CurveKind::Cubic) {
        // C' × C'' / 18 is a quadratic; between its roots the curve turns one way.
        const Vec2 a = p_[1] - p_[0], b = p_[2] - p_[1], c = p_[3] - p_[2];
        const double ab = cross(a, b), ac = cross(a, c), bc = cross(b, c);
        std::vector<double> inflections;
        addRoots(ab - ac + bc, ac - 2.0 * ab, ab, inflections);
        std::copy_if(inflections.begin(), inflections.end(), std::back_inserter(ends),
                     [&](double t) { return t > low && t < high; });
        std::sort(ends.begin(), ends.end());
    }
    constexpr int kParts = 8; // each turns by less than half a turn
    double sum = 0.0;
    for (std::size_t k = 1; k < ends.size(); ++k) {
        Vec2 before = tangent(ends[k - 1]);
        for (int i = 1; i <= kParts; ++i) {
            const Vec2 after = tangent(i == kParts ? ends[k] : std::lerp(ends[k - 1], ends[k], i / double{kParts}));
            sum += angleBetween(before, after);
            before = after;
        }
    }
    return sum;
}

/// Returns the parameters in (0, 1) where the curve is parallel to a direction's normal, so that it turns back along
/// the direction.
std::vector<double> Curve::turningPoints(Vec2 direction) const {
    std::vector<double> result;
    if (kind_ == CurveKind::Cubic) {
        const double a = dot(p_[1] - p_[0], direction), b = dot(p_[2] - p_[1], direction),
                     c = dot(p_[3] - p_[2], direction);
        addRoots(a - 2.0 * b + c, 2.0 * (b - a), a, result);
    } else if (kind_ == CurveKind::Arc && p_[3].y != 0.0) {
        const double first = std::atan2(dot(p_[2], direction), dot(p_[1], direction));
        const double low = std::min(angle(0.0), angle(1.0)), high = std::max(angle(0.0), angle(1.0));
        constexpr double kMostTurns = 64.0; // a longer arc repeats itself
        double theta = first + kPi * std::ceil((low - first) / kPi);
        while (theta < std::min(high, low + kMostTurns * kPi)) {
            const double t = (theta - p_[3].x) / p_[3].y;
            if (t > 0.0 && t < 1.0) {
                result.push_back(t);
            }
            theta += kPi;
        }
    }
    return result;
}

Box2 Curve::bounds(double t0, double t1) const {
    Box2 box = boxOf(point(t0), point(t1));
    for (const Vec2 axis : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}}) {
        for (const double t : turningPoints(axis)) {
            if ((t > t0) != (t > t1)) {
                box.add(point(t));
            }
        }
    }
    return box;
}

double Curve::deviation(double t0, double t1) const {
    if (kind_ == CurveKind::Line) {
        return 0.0;
    }
    const Vec2 a = point(t0), b = point(t1);
    double maximum = 0.0;
    const auto consider = [&](Vec2 direction) {
        for (const double t : turningPoints(direction)) {
            if ((t > t0) != (t > t1)) {
                maximum = std::max(maximum, distanceToSegment(a, b, point(t)));
            }
        }
    };
    if (a != b) {
        consider(leftNormal(b - a)); // farthest to its sides
        consider(b - a);             // and beyond its ends
    } else {
        for (const double t : {0.25, 0.5, 0.75}) {
            maximum = std::max(maximum, distance(a, point(std::lerp(t0, t1, t))));
        }
    }
    return maximum;
}

/// Returns true for an arc of a circle, up to rounding.
bool Curve::isCircular() const {
    constexpr double kRounding = 4e-16;
    const Vec2 u = p_[1], v = p_[2], left = leftNormal(u);
    const double limit = kRounding * kRounding * lengthSquared(u);
    return kind_ == CurveKind::Arc && (distanceSquared(v, left) <= limit || distanceSquared(v, Vec2{} - left) <= limit);
}

double Curve::nearestOnCircle(Vec2 p, double t0, double t1) const {
    const Vec2 from = p - p_[0];
    const double start = p_[3].x, sweep = p_[3].y;
    const double turn = std::fabs(2.0 * kPi / sweep), low = std::min(t0, t1), high = std::max(t0, t1);
    double t = (std::atan2(dot(from, p_[2]), dot(from, p_[1])) - start) / sweep;
    t += turn * std::ceil((low - t) / turn); // the first one from the lower end
    t = std::clamp(t, low, high);
    for (const double end : {t0, t1}) { // exactly, where an end is as near up to rounding
        t = distanceSquared(point(end), p) <= distanceSquared(point(t), p) ? end : t;
    }
    return t;
}

/// Returns true if the squared distance of the part from p is surely convex: half its second derivative,
/// |C'|² + (C - p)·C", is positive, since the part bends and changes its speed little.
bool Curve::hasOneNearest(Vec2 p, double t0, double t1) const {
    const double bend =
        kind_ == CurveKind::Arc
            ? p_[3].y * p_[3].y * std::sqrt(lengthSquared(p_[1]) + lengthSquared(p_[2]))
            : std::max(forefront::length(secondDerivative(t0)), forefront::length(secondDerivative(t1)));
    const double middle = std::midpoint(t0, t1), half = 0.5 * std::fabs(t1 - t0);
    const double speed = forefront::length(derivative(middle)), change = bend * half;
    const double slowest = speed - change, farthest = distance(point(middle), p) + half * (speed + change);
    return slowest > 0.0 && farthest * bend < slowest * slowest;
}

/// Returns the parameter of a minimum of the distance from p, by Newton's method within an interval at whose start
/// it falls and at whose end it rises.
double Curve::stationary(Vec2 p, double low, double high) const {
    constexpr int kMaxSteps = 60;
    const double enough = 0x1p-53 * std::max({high - low, std::fabs(low), std::fabs(high)});
    double t = std::midpoint(low, high), step = high - low, stepBefore = step;
    for (int i = 0; i < kMaxSteps && std::fabs(step) > enough; ++i) {
        const Vec2 from = point(t) - p, along = derivative(t);
        const double rise = dot(from, along), slope = lengthSquared(along) + dot(from, secondDerivative(t));
        (rise < 0.0 ? low : high) = t;
        const double newton = t - rise / slope, last = t;
        if (newton == t) {
            break;
        }
        const bool converges = newton > low && newton < high && 2.0 * std::fabs(newton - t) < std::fabs(stepBefore);
        t = converges ? newton : std::midpoint(low, high);
        stepBefore = std::exchange(step, t - last);
    }
    return t;
}

double Curve::nearest(Vec2 p, double t0, double t1) const {
    if (isCircular() && p_[3].y != 0.0) {
        return nearestOnCircle(p, t0, t1);
    }
    const auto falls = [&](double t) { return dot(point(t) - p, derivative(t)) < 0.0; };
    double low = std::min(t0, t1), high = std::max(t0, t1);
    if (hasOneNearest(p, low, high)) {
        return !falls(low) ? low : falls(high) ? high : stationary(p, low, high);
    }
    // Zooms in on the nearest of some samples, so that close to a cusp, too, one minimum is left.
    constexpr int kSamples = 16, kZooms = 4;
    double best = low;
    for (int zoom = 0; zoom < kZooms; ++zoom) {
        const auto at = [&](int i) { return i == kSamples ? high : std::lerp(low, high, i / double{kSamples}); };
        int nearest = 0;
        double least = distanceSquared(point(at(0)), p);
        for (int i = 1; i <= kSamples; ++i) {
            if (const double d = distanceSquared(point(at(i)), p); d < least) {
                nearest = i;
                least = d;
            }
        }
        best = at(nearest);
        const double before = at(std::max(nearest - 1, 0)), after = at(std::min(nearest + 1, kSamples));
        low = before;
        high = after;
    }
    if (falls(low) && !falls(high)) {
        return stationary(p, low, high);
    }
    const double ends[] = {low, best, high};
    return *std::min_element(std::begin(ends), std::end(ends), [&](double s, double t) {
        return distanceSquared(point(s), p) < distanceSquared(point(t), p);
    });
}

Curve Curve::part(double t0, double t1) const {
    Curve part = *this;
    switch (kind_) {
    case CurveKind::Line:
        part.p_[0] = point(t0);
        part.p_[3] = point(t1);
        break;
    case CurveKind::Arc:
        part.p_[3] = {angle(t0), (t1 - t0) * p_[3].y};
        break;
    case CurveKind::Cubic: { // by its polar form, which is symmetric and linear in each of three parameters
        const auto polar = [this](double r, double s, double t) {
            const Vec2 a = lerp(p_[0], p_[1], r), b = lerp(p_[1], p_[2], r), c = lerp(p_[2], p_[3], r);
            return lerp(lerp(a, b, s), lerp(b, c, s), t);
        };
        part.p_ = {point(t0), polar(t0, t0, t1), polar(t0, t1, t1), point(t1)};
        break;
    }
    }
    return part;
}

std::vector<double> Curve::flatten(double tolerance, double t0, double t1) const {
    std::vector<double> result;
    if (!finite() || kind_ == CurveKind::Line) {
        return {t1};
    }
    constexpr double kMostTurn = 0.5 * kPi; // a piece that turned farther would lose the shape
    if (kind_ == CurveKind::Arc) {
        // The arc is the image of one of the unit circle, whose sagitta 1 - cos(turn / 2) = 2 sin²(turn / 4) it
        // stretches by at most the longer half-axis.
        const double uu = lengthSquared(p_[1]), vv = lengthSquared(p_[2]), uv = dot(p_[1], p_[2]);
        const double longest = std::sqrt(0.5 * (uu + vv) + std::hypot(0.5 * (uu - vv), uv));
        const double turn = tolerance < longest ? 4.0 * std::asin(std::sqrt(0.5 * tolerance / longest)) : kMostTurn;
        const double pieces = std::ceil(std::fabs((t1 - t0) * p_[3].y) / std::clamp(turn, 1e-9, kMostTurn) - 1e-9);
        const auto count = static_cast<std::size_t>(std::clamp(pieces, 1.0, static_cast<double>(kMaxPieces)));
        for (std::size_t i = 1; i < count; ++i) {
            result.push_back(std::lerp(t0, t1, static_cast<double>(i) / static_cast<double>(count)));
        }
        result.push_back(t1);
        return result;
    }
    std::vector<std::pair<double, int>> open = {{t1, 0}}; // ends of pieces and how often they were halved
    double from = t0;
    constexpr int kMostHalvings = 24;
    constexpr double kCusp = 0.125; // a part this small, in tolerances, may turn back
    while (!open.empty()) {
        const auto [to, halvings] = open.back();
        const bool fine = halvings == kMostHalvings || result.size() + open.size() >= kMaxPieces ||
                          (deviation(from, to) <= tolerance &&
                           (turning(from, to) <= kMostTurn || bounds(from, to).diagonal() <= kCusp * tolerance));
        if (fine) {
            result.push_back(to);
            from = to;
            open.pop_back();
        } else {
            open.back().second = halvings + 1;
            open.emplace_back(std::midpoint(from, to), halvings + 1);
        }
    }
    return result;
}

std::vector<double> Curve::flattenWithin(const Box2 &box, double tolerance, double t0, double t1) const {
    std::vector<double> result;
    if (!finite() || kind_ == CurveKind::Line) {
        return {t1};
    }
    constexpr int kMostHalvings = 40;
    const double small = box.diagonal();
    std::vector<std::pair<double, int>> open = {{t1, 0}}; // ends of pieces and how often they were halved
    double from = t0;
    while (!open.empty()) {
        const auto [to, halvings] = open.back();
        const Box2 piece = bounds(from, to);
        if (piece.overlaps(box) && piece.diagonal() > small && halvings < kMostHalvings &&
            result.size() + open.size() < kMaxPieces) {
            open.back().second = halvings + 1;
            open.emplace_back(std::midpoint(from, to), halvings + 1);
            continue;
        }
        if (piece.overlaps(box)) {
            const std::vector<double> fine = flatten(tolerance, from, to);
            result.insert(result.end(), fine.begin(), fine.end());
        } else {
            result.push_back(to);
        }
        from = to;
        open.pop_back();
    }
    return result;
}

} // namespace forefront
