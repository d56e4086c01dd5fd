#include "core/engine/geometry/curve_contacts.hpp"

#include "core/engine/geometry/edge_meetings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace forefront {

namespace {

/// Improves the parameters of a meeting by Newton's method as long as that brings the curves closer.
void polish(const Curve &first, const Curve &second, double &s, double &t) {
    constexpr int kSteps = 20;
    Vec2 gap = second.point(t) - first.point(s);
    for (int step = 0; step < kSteps && gap != Vec2{}; ++step) {
        const Vec2 u = first.derivative(s), v = second.derivative(t);
        const double area = cross(u, v);
        const double nextS = s + cross(gap, v) / area, nextT = t + cross(gap, u) / area;
        if (!std::isfinite(nextS) || !std::isfinite(nextT)) {
            return;
        }
        const Vec2 next = second.point(nextT) - first.point(nextS);
        if (!(lengthSquared(next) < lengthSquared(gap))) {
            return;
        }
        s = nextS;
        t = nextT;
        gap = next;
    }
}

CurveContact crossingAt(const Curve &first, const Curve &second, double s, double t) {
    const Vec2 p = first.point(s), q = second.point(t);
    const Vec2 at = comesBefore(q, p) ? q : p;
    return {s, t, at, at, true};
}

/// Finds the only crossing of parts whose directions differ everywhere.
class SteepCrossing {
  public:
    SteepCrossing(const CurvePart &first, const CurvePart &second)
        : first_(first), second_(second), noise_(std::max(first.noise, second.noise)) {}

    std::optional<CurveContact> run() const { return search(first_, second_, kHalvings); }

  private:
    static constexpr int kHalvings = 100; // both curves together: enough to reach rounding

    /// Newton's method may fail on curves of uneven speed, as near cusps; then the longer part is halved.
    std::optional<CurveContact> search(const CurvePart &first, const CurvePart &second, int halvings) const {
        if (apart(first, second, 0.0)) {
            return std::nullopt;
        }
        if (auto contact = byNewton(first, second); contact || halvings == 0) {
            return contact;
        }
        const bool halveFirst = first.size() >= second.size();
        const CurvePart &whole = halveFirst ? first : second;
        if (whole.size() <= noise_) {
            return std::nullopt;
        }
        const double middle = std::midpoint(whole.t0, whole.t1);
        for (const auto &[t0, t1] : {std::pair(whole.t0, middle), std::pair(middle, whole.t1)}) {
            const CurvePart half(whole.curve, t0, t1);
            const CurvePart &other = halveFirst ? second : first;
            if (const auto contact = search(halveFirst ? half : other, halveFirst ? other : half, halvings - 1)) {
                return contact;
            }
        }
        return std::nullopt;
    }

    /// Returns the crossing within the full parts, found by starting where the chords of these parts cross.
    std::optional<CurveContact> byNewton(const CurvePart &first, const CurvePart &second) const {
        const auto share = [](const CurvePart &part, Vec2 p) {
            const double chord = distance(part.start, part.end);
            return chord > 0.0 ? std::clamp(dot(p - part.start, part.along) / chord, 0.0, 1.0) : 0.5;
        };
        const Vec2 u = first.end - first.start, v = second.end - second.start;
        const double meets = cross(second.start - first.start, v) / cross(u, v);
        const Vec2 guess = lerp(first.start, first.end, std::isfinite(meets) ? std::clamp(meets, 0.0, 1.0) : 0.5);
        double s = std::lerp(first.t0, first.t1, share(first, guess));
        double t = std::lerp(second.t0, second.t1, share(second, guess));
        polish(first.curve, second.curve, s, t);
        const bool within = s >= first_.t0 && s <= first_.t1 && t >= second_.t0 && t <= second_.t1;
        if (!within || distance(first.curve.point(s), second.curve.point(t)) > noise_) {
            return std::nullopt;
        }
        return crossingAt(first.curve, second.curve, s, t);
    }

    const CurvePart &first_;
    const CurvePart &second_;
    double noise_;
};

/// Two parts of similar direction as graphs over one axis.
class GraphStrip {
  public:
    GraphStrip(const CurvePart &first, const CurvePart &second, double tolerance)
        : first_(first, first.start, first.along),
          second_(second, first.start, first.along), curves_{&first.curve, &second.curve}, tolerance_(tolerance),
          noise_(std::max(first.noise, second.noise)) {}

    std::vector<CurveContact> run() {
        const double low = std::max(first_.low(), second_.low()), high = std::min(first_.high(), second_.high());
        if (!(low < high)) {
            return {};
        }
        constexpr int kHalvings = 40;
        const Sample left = sample(low), right = sample(high);
        samples_ = {left};
        clear_ = {0};
        scan(left, right, kHalvings);
        std::vector<CurveContact> contacts;
        for (const auto &[from, to] : nearIntervals()) {
            if (from > low && to < high) {
                contacts.push_back(contactIn(from, to));
            }
        }
        return contacts;
    }

  private:
    struct Sample {
        double x = 0.0;
        double gap = 0.0; ///< of the first curve above the second
        double slope = 0.0;
        double bend = 0.0;
    };

    Sample sample(double x) const {
        const CurveGraph::Value s = first_.at(x), t = second_.at(x);
        return {x, s.y - t.y, s.slope - t.slope, s.bend - t.bend};
    }

    /// Appends samples from the left one (excluded) to the right one between which the gap is linear to a fraction of
    /// the tolerance; marks intervals without contact.
    void scan(const Sample &left, const Sample &right, int halvings) {
        const Sample middle = sample(std::midpoint(left.x, right.x));
        const double width = right.x - left.x;
        // The bend between the samples is taken to be at most twice as large as at them.
        const double bend = 2.0 * std::max({std::fabs(left.bend), std::fabs(middle.bend), std::fabs(right.bend)});
        const double off = bend * width * width / 8.0;
        const double least = std::min({std::fabs(left.gap), std::fabs(middle.gap), std::fabs(right.gap)});
        const bool sameSide = (left.gap > 0.0) == (right.gap > 0.0) && (left.gap > 0.0) == (middle.gap > 0.0);
        if (sameSide && least > off + tolerance_) {
            append(right, true);
        } else if (off <= 0.25 * tolerance_ || width <= noise_ || halvings == 0) { // bends within noise are arbitrary
            append(middle, false);
            append(right, false);
        } else {
            scan(left, middle, halvings - 1);
            scan(middle, right, halvings - 1);
        }
    }

    void append(const Sample &next, bool clear) {
        samples_.push_back(next);
        clear_.push_back(clear ? 1 : 0);
    }

    /// Returns the maximal intervals in which the curves are within the tolerance of each other.
    std::vector<std::pair<double, double>> nearIntervals() const {
        std::vector<std::pair<double, double>> intervals;
        for (std::size_t i = 1; i < samples_.size(); ++i) {
            const Sample &p = samples_[i - 1], &q = samples_[i];
            const bool beyond = std::min(p.gap, q.gap) > tolerance_ || std::max(p.gap, q.gap) < -tolerance_;
            if (clear_[i] != 0 || beyond) {
                continue;
            }
            const auto within = [&](const Sample &end) {
                if (std::fabs(end.gap) <= tolerance_) {
                    return end.x;
                }
                const double level = std::copysign(tolerance_, end.gap);
                return std::lerp(p.x, q.x, std::clamp((level - p.gap) / (q.gap - p.gap), 0.0, 1.0));
            };
            const double from = within(p), to = within(q);
            if (!intervals.empty() && intervals.back().second == from) {
                intervals.back().second = to;
            } else {
                intervals.emplace_back(from, to);
            }
        }
        return intervals;
    }

    /// Returns the x between two where a function of the samples changes its sign.
    template <class Function>
    double root(double from, double to, const Function &of) const {
        constexpr int kSteps = 60;
        const bool positive = of(sample(from)) > 0.0;
        for (int step = 0; step < kSteps; ++step) {
            const double middle = std::midpoint(from, to);
            ((of(sample(middle)) > 0.0) == positive ? from : to) = middle;
        }
        return std::midpoint(from, to);
    }

    CurveContact contactIn(double from, double to) const {
        const Sample left = sample(from), right = sample(to);
        if ((left.gap > 0.0) != (right.gap > 0.0)) {
            const double x = root(from, to, [](const Sample &at) { return at.gap; });
            double s = first_.at(x).t, t = second_.at(x).t;
            polish(*curves_[0], *curves_[1], s, t);
            return crossingAt(*curves_[0], *curves_[1], s, t);
        }
        double x = std::midpoint(from, to);
        if ((left.slope > 0.0) != (right.slope > 0.0)) { // parallel where they are closest
            x = root(from, to, [](const Sample &at) { return at.slope; });
        }
        const double s = first_.at(x).t, t = second_.at(x).t;
        return {s, t, curves_[0]->point(s), curves_[1]->point(t), false};
    }

    CurveGraph first_;
    CurveGraph second_;
    const Curve *curves_[2];
    double tolerance_, noise_;
    std::vector<Sample> samples_;
    std::vector<std::uint8_t> clear_; ///< per sample: the curves are apart between it and the one before
};

auto keyOf(const CurvePart &part) {
    return std::tuple(part.curve.kind(), part.curve.numbers(), part.t0, part.t1);
}

} // namespace

std::vector<CurveContact> curveContacts(const CurvePart &first, const CurvePart &second, double tolerance) {
    if (keyOf(second) < keyOf(first)) {
        std::vector<CurveContact> contacts = curveContacts(second, first, tolerance);
        for (CurveContact &contact : contacts) {
            std::swap(contact.first, contact.second);
            std::swap(contact.onFirst, contact.onSecond);
        }
        return contacts;
    }
    if (first.start == first.end || second.start == second.end) {
        return {};
    }
    constexpr double kSteep = 1e-3; // in addition to what the parts turn
    const double angle =
        std::atan2(std::fabs(cross(first.along, second.along)), std::fabs(dot(first.along, second.along)));
    std::vector<CurveContact> contacts;
    if (angle <= first.turn + second.turn + kSteep) {
        contacts = GraphStrip(first, second, tolerance).run();
    } else if (const auto crossing = SteepCrossing(first, second).run()) {
        contacts.push_back(*crossing);
    }
    std::erase_if(contacts, [&](const CurveContact &contact) { // the end is the place to join
        const auto nearEnd = [&](Vec2 p, const CurvePart &part) {
            return distance(p, part.start) <= tolerance || distance(p, part.end) <= tolerance;
        };
        return nearEnd(contact.onFirst, first) || nearEnd(contact.onFirst, second) ||
               nearEnd(contact.onSecond, first) || nearEnd(contact.onSecond, second);
    });
    return contacts;
}

} // namespace forefront
