#include "core/drawing_files/svg/areas/svg_stroke.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace forefront {
namespace {

constexpr double kMaxDashes = 20'000.0;

/// Consecutive curves; without any, a dot at a place on the path.
struct Run {
    std::vector<Curve> curves;
    bool closed = false;
    Vec2 place;
    Vec2 tangent{1.0, 0.0};
};

/// Returns the segments of a path in user space: the part of each curve that consecutive chords follow, and lines.
Run runAlong(const SvgPath &path, const AffineMap &toUser) {
    Run run;
    run.closed = path.closed && !path.joined;
    run.place = toUser(path.nodes.front());
    const std::size_t count = path.nodes.size() - (path.closed ? 0 : 1);
    CurveStretch open; // the part of a curve that goes on
    const auto finish = [&] {
        if (open.follows()) {
            run.curves.push_back(path.curves[open.curve].part(open.t0, open.t1).mapped(toUser));
            open = {};
        }
    };
    for (std::size_t k = 0; k < count; ++k) {
        const CurveStretch stretch = k < path.stretches.size() ? path.stretches[k] : CurveStretch{};
        if (stretch.follows() && stretch.curve == open.curve && stretch.t0 == open.t1) {
            open.t1 = stretch.t1;
            continue;
        }
        finish();
        const Vec2 from = path.nodes[k], to = path.nodes[(k + 1) % path.nodes.size()];
        if (stretch.follows()) {
            open = stretch;
        } else if (from != to) {
            run.curves.push_back(Curve::line(toUser(from), toUser(to)));
        }
    }
    finish();
    return run;
}

/// Returns the parameter at which the part of a curve that begins at another one has a length, by Newton's method
/// within an interval.
double parameterAt(const Curve &curve, double from, double length) {
    constexpr int kSteps = 60;
    constexpr double kAccuracy = 1e-9; // as a fraction of the length
    double low = from, high = 1.0, t = from;
    for (int step = 0; step < kSteps && low < high; ++step) {
        const double excess = curve.length(from, t) - length;
        if (std::fabs(excess) <= kAccuracy * length) {
            break;
        }
        (excess < 0.0 ? low : high) = t;
        t -= excess / forefront::length(curve.derivative(t));
        t = t > low && t < high ? t : std::midpoint(low, high);
    }
    return t;
}

/// Cuts a run into dashes.
class Dasher {
  public:
    explicit Dasher(const SvgLineStyle &style) : dashes_(style.dashes) {
        const double period = std::reduce(dashes_.begin(), dashes_.end());
        double into = std::fmod(style.dashOffset, period);
        into += into < 0.0 ? period : 0.0;
        while (into > 0.0 && into >= dashes_[at_]) {
            into -= dashes_[at_];
            next();
        }
        left_ = dashes_[at_] - into;
        fromStart_ = draws();
    }

    std::vector<Run> cut(const Run &run) {
        begin(run.curves.front(), 0.0);
        for (const Curve &curve : run.curves) {
            const double whole = curve.length();
            double from = 0.0, done = 0.0;
            while (whole - done > left_) {
                done += left_;
                const double to = parameterAt(curve, from, left_);
                draw(curve, from, to);
                from = to;
                next();
                left_ = dashes_[at_];
                begin(curve, to);
            }
            left_ -= whole - done;
            draw(curve, from, 1.0);
        }
        if (run.closed && fromStart_ && draws() && made_.size() > 1) { // one dash through the start
            std::vector<Curve> &last = made_.back().curves, &first = made_.front().curves;
            last.insert(last.end(), first.begin(), first.end());
            made_.erase(made_.begin());
        }
        return std::move(made_);
    }

  private:
    bool draws() const { return at_ % 2 == 0; }
    void next() { at_ = (at_ + 1) % dashes_.size(); }
    void begin(const Curve &curve, double t) {
        if (draws()) {
            made_.push_back({{}, false, curve.point(t), curve.tangent(t)});
        }
    }
    void draw(const Curve &curve, double from, double to) {
        if (draws() && to > from) {
            made_.back().curves.push_back(curve.part(from, to));
        }
    }

    const std::vector<double> &dashes_;
    std::size_t at_ = 0;     ///< the current dash or gap
    double left_ = 0.0;      ///< of it
    bool fromStart_ = false; ///< the path begins with a dash
    std::vector<Run> made_;
};

std::vector<Run> runsOf(Run whole, const SvgLineStyle &style) {
    const double period = std::reduce(style.dashes.begin(), style.dashes.end());
    double length = 0.0;
    for (const Curve &curve : whole.curves) {
        length += curve.length();
    }
    const auto pieces = static_cast<double>(style.dashes.size());
    bool gaps = false; // longer than 0
    for (std::size_t k = 1; k < style.dashes.size(); k += 2) {
        gaps = gaps || style.dashes[k] > 0.0;
    }
    if (whole.curves.empty() || !gaps || !std::isfinite(period) || length / period * pieces > kMaxDashes) {
        std::vector<Run> solid;
        solid.push_back(std::move(whole));
        return solid;
    }
    return Dasher(style).cut(whole);
}

/// Adds the end of a stroke that goes in the direction `tangent`; `forward` is false at its start.
void addEnd(Vec2 end, Vec2 tangent, bool forward, const SvgLineStyle &style, std::vector<BandPart> &parts) {
    const double reach = 0.5 * style.width;
    const Vec2 arm = reach * leftNormal(tangent), ahead = (forward ? reach : -reach) * tangent;
    if (style.cap == SvgCap::Round) {
        parts.push_back(roundEnd(end, arm, forward));
    } else if (style.cap == SvgCap::Square) {
        parts.push_back({{end + arm, end - arm, end - arm + ahead, end + arm + ahead}, std::vector<Curve>(4), 0});
    }
}

std::vector<BandPart> partsOf(const Run &run, const SvgLineStyle &style) {
    constexpr double kAccuracy = 1e-4, kAccuracyOfWidth = 0.005;
    constexpr double kMaxDot = 0.0101; // icons write dots as lines of .01, which would leave sides as short as that
    std::vector<BandPart> parts;
    if (run.curves.empty()) {
        addEnd(run.place, run.tangent, false, style, parts);
        addEnd(run.place, run.tangent, true, style, parts);
        return parts;
    }
    Box2 box;
    for (const Curve &curve : run.curves) {
        box.add(curve.bounds());
    }
    const double reach = 0.5 * style.width, length = box.diagonal();
    if (style.cap == SvgCap::Round && length <= kMaxDot * style.width) {
        SvgLineStyle disc = style; // has the area of the short line
        disc.width = 2.0 * std::sqrt(reach * reach + 2.0 * reach * length / std::numbers::pi);
        addEnd(box.centre(), {1.0, 0.0}, false, disc, parts);
        addEnd(box.centre(), {1.0, 0.0}, true, disc, parts);
        return parts;
    }
    const double size = length + reach;
    const double accuracy = std::min(kAccuracy, kAccuracyOfWidth * style.width / size);
    const BandStyle bands{style.corner, style.miterLimit, accuracy, true};
    parts = bandsBeside(run.curves, run.closed, std::array{reach, -reach}, bands);
    if (!run.closed) {
        const Curve &first = run.curves.front(), &last = run.curves.back();
        addEnd(first.point(0.0), first.tangent(0.0), false, style, parts);
        addEnd(last.point(1.0), last.tangent(1.0), true, style, parts);
    }
    return parts;
}

} // namespace

std::vector<BandPart> strokeParts(const SvgPath &path) {
    const SvgLineStyle &style = path.paint.line;
    const std::optional<AffineMap> toUser = path.frame.inverse();
    if (!toUser || !(style.width > 0.0)) {
        return {};
    }
    std::vector<BandPart> parts;
    for (const Run &run : runsOf(runAlong(path, *toUser), style)) {
        std::vector<BandPart> some = partsOf(run, style);
        std::move(some.begin(), some.end(), std::back_inserter(parts));
    }
    for (BandPart &part : parts) {
        std::transform(part.nodes.begin(), part.nodes.end(), part.nodes.begin(), path.frame);
        for (Curve &curve : part.curves) {
            curve = curve.mapped(path.frame);
        }
    }
    return parts;
}

} // namespace forefront
