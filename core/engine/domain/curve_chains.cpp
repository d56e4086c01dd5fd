#include "core/engine/domain/curve_chains.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/domain/element_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {

namespace {

constexpr double kOnCurve = 1e-9; ///< fraction of the domain's diagonal

class ChainFinder {
  public:
    explicit ChainFinder(const Domain &domain) : domain_(domain), tolerance_(kOnCurve * domain.bounds().diagonal()) {}

    CurveChains run() {
        result_.ofSegment.assign(domain_.segments.size(), kNoIndex);
        if (domain_.curves.empty()) {
            return std::move(result_);
        }
        collectEnds();
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            if (follows_[s] != 0 && result_.ofSegment[s] == kNoIndex) {
                addChain(s);
            }
        }
        return std::move(result_);
    }

  private:
    void collectEnds() {
        follows_.resize(domain_.segments.size());
        around_.assign(domain_.nodes.size(), {kNoIndex, kNoIndex});
        degree_.assign(domain_.nodes.size(), 0);
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            const DomainSegment &segment = domain_.segments[s];
            if (segment.a >= domain_.nodes.size() || segment.b >= domain_.nodes.size()) {
                continue;
            }
            follows_[s] = follows(s) ? 1 : 0;
            for (const std::uint32_t node : {segment.a, segment.b}) {
                if (degree_[node] < 2) {
                    around_[node][degree_[node]] = s;
                }
                ++degree_[node];
            }
        }
        for (const ConstraintPoint &point : domain_.points) {
            if (point.node < degree_.size()) {
                degree_[point.node] = 0;
            }
        }
    }

    bool follows(std::uint32_t s) const {
        const DomainSegment &segment = domain_.segments[s];
        const CurveStretch &stretch = segment.stretch;
        if (stretch.curve >= domain_.curves.size()) {
            return false;
        }
        const Curve &curve = domain_.curves[stretch.curve];
        const auto inRange = [](double t) { return t >= 0.0 && t <= 1.0; };
        if (curve.kind() == CurveKind::Line || !curve.finite() || !inRange(stretch.t0) || !inRange(stretch.t1) ||
            stretch.t0 == stretch.t1) {
            return false;
        }
        const Vec2 a = domain_.nodes[segment.a], b = domain_.nodes[segment.b];
        const double reach = std::max(tolerance_, 0.5 * distance(a, b));
        return distance(curve.point(stretch.t0), a) <= reach && distance(curve.point(stretch.t1), b) <= reach;
    }

    /// Returns the node at the upper (or lower) end of the segment's parameters.
    std::uint32_t endNode(std::uint32_t s, bool upper) const {
        const DomainSegment &segment = domain_.segments[s];
        return (segment.stretch.t0 < segment.stretch.t1) == upper ? segment.b : segment.a;
    }
    double endParameter(std::uint32_t s, bool upper) const {
        const CurveStretch &stretch = domain_.segments[s].stretch;
        return upper ? std::max(stretch.t0, stretch.t1) : std::min(stretch.t0, stretch.t1);
    }

    /// Returns the segment that continues a chain beyond the upper (or lower) end of its segment `s`, or kNoIndex.
    std::uint32_t next(std::uint32_t s, bool upper) const {
        const std::uint32_t node = endNode(s, upper);
        if (degree_[node] != 2) {
            return kNoIndex;
        }
        const std::uint32_t other = around_[node][around_[node][0] == s ? 1 : 0];
        const DomainSegment &own = domain_.segments[s], &far = domain_.segments[other];
        const double t = endParameter(s, upper);
        const bool continues = other != s && follows_[other] != 0 && own.stretch.curve == far.stretch.curve &&
                               own.tag == far.tag && own.role == far.role && endNode(other, !upper) == node &&
                               endParameter(other, !upper) == t;
        if (!continues || distance(domain_.curves[own.stretch.curve].point(t), domain_.nodes[node]) > tolerance_) {
            return kNoIndex;
        }
        return other;
    }

    void addChain(std::uint32_t s) {
        // The parameter is monotonic along the walk, so that it ends.
        for (std::uint32_t before = next(s, false); before != kNoIndex; before = next(s, false)) {
            s = before;
        }
        CurveChain chain;
        chain.curve = domain_.segments[s].stretch.curve;
        chain.start = endNode(s, false);
        chain.t0 = endParameter(s, false);
        for (; s != kNoIndex; s = next(s, true)) {
            result_.ofSegment[s] = static_cast<std::uint32_t>(result_.list.size());
            chain.segments.push_back(s);
        }
        chain.end = endNode(chain.segments.back(), true);
        chain.t1 = endParameter(chain.segments.back(), true);
        result_.list.push_back(std::move(chain));
    }

    const Domain &domain_;
    double tolerance_;
    std::vector<std::uint8_t> follows_;                ///< per segment
    std::vector<std::array<std::uint32_t, 2>> around_; ///< per node: its first two segments
    std::vector<std::uint32_t> degree_;                ///< per node; 0 for a constraint point
    CurveChains result_;
};

} // namespace

double chordTolerance(const Domain &domain) {
    constexpr double kDefault = 1.0 / 2000.0; // of the diagonal
    return domain.curveTolerance > 0.0 ? domain.curveTolerance : kDefault * domain.bounds().diagonal();
}

std::uint32_t elementsAlong(const Domain &domain, const CurveChain &chain, SegmentElements elements) {
    const std::uint32_t whole = chain.segments.empty() ? 0 : elements[chain.segments.front()];
    if (whole == 0) {
        return 0;
    }
    // The difference of two rounded numbers: with those of the other chains it adds up to the whole.
    const Curve &curve = domain.curves[chain.curve];
    const ElementBias bias = biasAlong(domain, chain, elements);
    double before = 0.0, after = 0.0;
    if (bias.any()) {
        const auto [first, last] = elementsOfChain(domain, chain, elementPlaces(whole, bias));
        before = std::round(first);
        after = std::round(last);
    } else {
        const double share = whole / curve.length(0.0, 1.0);
        before = std::round(share * curve.length(0.0, chain.t0));
        after = std::round(share * curve.length(0.0, chain.t1));
    }
    return static_cast<std::uint32_t>(std::max(after - before, chain.start == chain.end ? 3.0 : 1.0));
}

ElementBias biasAlong(const Domain &domain, const CurveChain &chain, SegmentElements elements) {
    if (chain.segments.empty()) {
        return {};
    }
    const CurveStretch &stretch = domain.segments[chain.segments.front()].stretch;
    const ElementBias bias = elements.bias(chain.segments.front());
    return stretch.t0 <= stretch.t1 ? bias : bias.reversed();
}

std::pair<double, double> elementsOfChain(const Domain &domain, const CurveChain &chain,
                                          const std::vector<double> &places) {
    const Curve &curve = domain.curves[chain.curve];
    const double whole = curve.length();
    return {elementsBefore(places, curve.length(0.0, chain.t0) / whole),
            elementsBefore(places, curve.length(0.0, chain.t1) / whole)};
}

CurveChains curveChains(const Domain &domain) {
    return ChainFinder(domain).run();
}

} // namespace forefront
