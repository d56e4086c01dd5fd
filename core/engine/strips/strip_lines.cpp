#include "core/engine/strips/strip_lines.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// Returns the curvature at a parameter, positive where the curve turns left.
double curvatureAt(const Curve &curve, double t) {
    const Vec2 d = curve.derivative(t);
    const double speed = length(d);
    return speed > 0.0 ? cross(d, curve.secondDerivative(t)) / (speed * speed * speed) : 0.0;
}

/// Returns the place beside a curve.
Vec2 besideCurve(const Curve &curve, double t, double offset) {
    return curve.point(t) + offset * leftNormal(curve.tangent(t));
}

constexpr int kSamples = 16;              ///< of a curve
constexpr double kLeastFactor = 0.05;     ///< of the length of a parallel relative to its curve
constexpr double kParallelError = 1e-3;   ///< relative to the offset
constexpr std::uint32_t kMaxHalvings = 7; ///< of a curve

/// Returns true if the parallel is as far from the curve as it should be.
bool isParallel(const Curve &parallel, const Curve &curve, double offset) {
    for (int k = 1; k < kSamples; ++k) {
        const Vec2 p = parallel.point(static_cast<double>(k) / kSamples);
        const double off = distance(p, curve.point(curve.nearest(p)));
        if (!(std::abs(off - std::abs(offset)) <= kParallelError * std::abs(offset))) {
            return false;
        }
    }
    return true;
}

/// Finds the lines of one strip.
class LineFinder {
  public:
    LineFinder(const Domain &domain, const StripSpec &spec, const SegmentElements &elements)
        : domain_(domain), spec_(spec), elements_(elements), chains_(curveChains(domain)),
          others_(domain.nodes.size(), kNoIndex) {
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            const DomainSegment &segment = domain.segments[s];
            for (const std::uint32_t node : {segment.a, segment.b}) {
                if (segment.tag == spec.tag) {
                    around_[node].push_back(s);
                } else {
                    others_[node] = s;
                }
            }
        }
        for (const ConstraintPoint &point : domain.points) {
            points_.insert(point.node);
        }
    }

    Result<std::vector<StripLine>> run() {
        for (const auto &[node, segments] : around_) {
            if (Status faults = checkNode(node, segments); !faults.empty()) {
                return faults;
            }
        }
        for (const bool closed : {false, true}) {
            for (const auto &[node, segments] : around_) {
                if ((closed || segments.size() == 1) && !used_.contains(segments.front())) {
                    lines_.push_back(trace(node, closed));
                }
            }
        }
        for (StripLine &line : lines_) {
            if (Status faults = addRuns(line); !faults.empty()) {
                return faults;
            }
        }
        return std::move(lines_);
    }

  private:
    Status fault(const char *code, const std::string &what, const char *advice, Vec2 at) const {
        return stripError(code, domain_, spec_.tag, what, advice, at);
    }

    Status checkNode(std::uint32_t node, const std::vector<std::uint32_t> &segments) const {
        const Vec2 at = domain_.nodes[node];
        if (segments.size() > 2) {
            return fault("strip-meets", "its line branches or crosses itself", "divide it into lines that do not meet",
                         at);
        }
        if (segments.size() == 2 && others_[node] != kNoIndex) {
            return fault("strip-meets",
                         "the line " + boundaryName(domain_.boundaryNames, domain_.segments[others_[node]].tag) +
                             " meets it between its ends",
                         "end the other line beside the strip, or divide the strip into two that end there", at);
        }
        if (points_.contains(node) && (segments.size() == 2 || others_[node] == kNoIndex)) {
            return fault("strip-meets", "a point lies on its line", "remove the point, or move it out of the strip",
                         at);
        }
        return {};
    }

    std::uint32_t otherEnd(std::uint32_t s, std::uint32_t node) const {
        return domain_.segments[s].a == node ? domain_.segments[s].b : domain_.segments[s].a;
    }
    /// Returns the chain of a segment, or nothing for a straight one.
    const CurveChain *chainOf(std::uint32_t s) const {
        const std::uint32_t chain = chains_.ofSegment[s];
        return chain == kNoIndex || domain_.curves[chains_.list[chain].curve].kind() == CurveKind::Line
                   ? nullptr
                   : &chains_.list[chain];
    }

    StripLine trace(std::uint32_t node, bool closed) {
        StripLine line;
        line.closed = closed;
        if (closed) { // begins where a curve does
            for (std::uint32_t s = around_.at(node).front(), at = node;;) {
                const CurveChain *const chain = chainOf(s);
                if (chain == nullptr || chain->start == at || chain->end == at) {
                    node = at;
                    break;
                }
                at = otherEnd(s, at);
                const std::vector<std::uint32_t> &next = around_.at(at);
                s = next.front() == s ? next.back() : next.front();
            }
        }
        line.first = node;
        std::uint32_t s = around_.at(node).front();
        while (used_.insert(s).second) {
            line.segments.push_back(s);
            node = otherEnd(s, node);
            const std::vector<std::uint32_t> &next = around_.at(node);
            if (next.size() < 2) {
                break;
            }
            s = next.front() == s ? next.back() : next.front();
        }
        line.last = node;
        return line;
    }

    Status addRuns(StripLine &line) const {
        std::uint32_t node = line.first;
        for (std::size_t k = 0; k < line.segments.size();) {
            const CurveChain *const chain = chainOf(line.segments[k]);
            if (chain == nullptr) {
                const std::uint32_t s = line.segments[k++], next = otherEnd(s, node);
                const ElementBias bias = elements_.bias(s);
                line.runs.push_back({Curve::line(domain_.nodes[node], domain_.nodes[next]), 1, elements_[s],
                                     domain_.segments[s].a == node ? bias : bias.reversed()});
                node = next;
                continue;
            }
            const bool forward =
                chain->start == chain->end ? chain->segments.front() == line.segments[k] : chain->start == node;
            const Curve part =
                domain_.curves[chain->curve].part(forward ? chain->t0 : chain->t1, forward ? chain->t1 : chain->t0);
            const auto chords = static_cast<std::uint32_t>(chain->segments.size());
            const ElementBias bias = biasAlong(domain_, *chain, elements_);
            const SideRun run{part, chords, elementsAlong(domain_, *chain, elements_),
                              forward ? bias : bias.reversed()};
            if (Status faults = addCurve(run, 0, line); !faults.empty()) {
                return faults;
            }
            node = forward ? chain->end : chain->start;
            k += chain->segments.size();
        }
        return {};
    }

    /// Adds a curve, halved until its parallels are single curves.
    Status addCurve(const SideRun &run, std::uint32_t halvings, StripLine &line) const {
        const Curve &curve = run.curve;
        const double half = 0.5 * spec_.width;
        const std::optional<Curve> left = parallelTo(curve, half), right = parallelTo(curve, -half);
        if (!left || !right) {
            return fault("strip-bend", "its line bends more sharply than half the width of the strip",
                         "choose a smaller width, or a larger radius", curve.point(0.5));
        }
        if (radiusOf(curve) || halvings == kMaxHalvings ||
            (isParallel(*left, curve, half) && isParallel(*right, curve, half))) {
            line.runs.push_back(run);
            line.runs.back().chords = std::max(run.chords, 4U);
            return {};
        }
        if (run.elements > 0) {
            return fault("strip-elements", "its line has a number of elements on a curve whose parallels are several",
                         "leave out the number of elements of the line", curve.point(0.5));
        }
        for (const double t0 : {0.0, 0.5}) {
            if (Status faults = addCurve({curve.part(t0, t0 + 0.5), (run.chords + 1) / 2}, halvings + 1, line);
                !faults.empty()) {
                return faults;
            }
        }
        return {};
    }

    const Domain &domain_;
    const StripSpec &spec_;
    SegmentElements elements_;
    CurveChains chains_;
    std::vector<std::uint32_t> others_;                          ///< per node: a segment with another tag, or kNoIndex
    std::map<std::uint32_t, std::vector<std::uint32_t>> around_; ///< segments of the line, by node
    std::set<std::uint32_t> points_, used_;
    std::vector<StripLine> lines_;
};

} // namespace

Diagnostics stripError(const char *code, const Domain &domain, std::int32_t tag, const std::string &what,
                       const char *advice, Vec2 at) {
    Diagnostics faults = error(code, "strip " + boundaryName(domain.boundaryNames, tag) + ": " + what, advice);
    faults.front().at = at;
    return faults;
}

std::optional<Curve> parallelTo(const Curve &curve, double offset) {
    if (curve.kind() == CurveKind::Line) {
        const Vec2 by = offset * leftNormal(curve.tangent(0.0));
        return Curve::line(curve.point(0.0) + by, curve.point(1.0) + by);
    }
    for (int k = 0; k <= kSamples; ++k) {
        if (!(1.0 - offset * curvatureAt(curve, static_cast<double>(k) / kSamples) >= kLeastFactor)) {
            return std::nullopt;
        }
    }
    if (const std::optional<double> radius = radiusOf(curve)) {
        const std::array<double, 8> n = curve.numbers();
        const double scale = 1.0 - offset * curvatureAt(curve, 0.5);
        return Curve::arc({n[0], n[1]}, scale * Vec2{n[2], n[3]}, scale * Vec2{n[4], n[5]}, n[6], n[7]);
    }
    const Vec2 from = besideCurve(curve, 0.0, offset), to = besideCurve(curve, 1.0, offset);
    const auto handle = [&](double t) { return ((1.0 - offset * curvatureAt(curve, t)) / 3.0) * curve.derivative(t); };
    return Curve::cubic(from, from + handle(0.0), to - handle(1.0), to);
}

Result<std::vector<StripLine>> stripLines(const Domain &domain, const StripSpec &spec,
                                          const SegmentElements &elements) {
    return LineFinder(domain, spec, elements).run();
}

} // namespace forefront
