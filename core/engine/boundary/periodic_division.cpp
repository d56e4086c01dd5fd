#include "core/engine/boundary/periodic_division.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace forefront {

namespace {

/// The smaller one of the spacings at a place on a first part and at its image.
class PairedField final : public SpacingField {
  public:
    PairedField(const SpacingField &others, const RigidMap &map) : others_(others), map_(map) {}

    double at(Vec2 p) const override { return smaller(others_.at(p), others_.at(map_(p))); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override {
        for (std::size_t k = 0; k < points.size(); ++k) {
            rho[k] = at(points[k]);
        }
    }
    SpacingSample sample(Vec2 p) const override {
        const Vec2 q = map_(p);
        return others_.at(q) < others_.at(p) ? others_.sample(q) : others_.sample(p);
    }
    double minimum() const override { return others_.minimum(); }
    double maximum() const override { return others_.maximum(); }

  private:
    /// Returns a value that is not a number rather than the other one, so that it is refused.
    static double smaller(double a, double b) { return std::isnan(b) || b < a ? b : a; }

    const SpacingField &others_;
    RigidMap map_;
};

double fractionOf(const CurveStretch &stretch, double t) {
    return std::clamp((t - stretch.t0) / (stretch.t1 - stretch.t0), 0.0, 1.0);
}

} // namespace

PeriodicDivision::PeriodicDivision(const Domain &domain, const SpacingField &spacing, const PeriodicSides *sides)
    : domain_(domain), spacing_(spacing), sides_(sides) {
    if (sides_ != nullptr) {
        for (const PeriodicLink &link : sides_->links) {
            paired_.push_back(std::make_unique<PairedField>(spacing, link.map));
        }
    }
}

const SpacingField &PeriodicDivision::spacing(std::uint32_t segment) const {
    return ties(segment) ? *paired_[sides_->mates[segment].link] : spacing_;
}

Vec2 PeriodicDivision::image(std::uint32_t segment, Vec2 p) const {
    return follows(segment) ? sides_->links[sides_->mates[segment].link].map(p) : p;
}

/// Returns the chain that holds the mate of the first segment of a chain.
std::uint32_t PeriodicDivision::tiedChain(const CurveCuts &curves, std::uint32_t chain) const {
    const std::uint32_t s = curves.chain(chain).segments.front();
    return ties(s) ? curves.chainOf(mate(s)) : kNoIndex;
}

/// Returns true if the segments of one chain are tied to those of the other in order.
bool PeriodicDivision::matches(const CurveCuts &curves, std::uint32_t chain, std::uint32_t other) const {
    const std::vector<std::uint32_t> &own = curves.chain(chain).segments, &others = curves.chain(other).segments;
    if (own.size() != others.size()) {
        return false;
    }
    const bool backwards = chainReversed(curves, chain);
    for (std::size_t k = 0; k < own.size(); ++k) {
        if (!ties(own[k]) || mate(own[k]) != others[backwards ? others.size() - 1 - k : k]) {
            return false;
        }
    }
    return true;
}

std::uint32_t PeriodicDivision::leadingChain(const CurveCuts &curves, std::uint32_t chain) const {
    const std::uint32_t s = curves.chain(chain).segments.front();
    if (!ties(s)) {
        return chain;
    }
    const std::uint32_t other = tiedChain(curves, chain);
    if (other == kNoIndex || !matches(curves, chain, other)) {
        return kNoIndex;
    }
    return follows(s) ? other : chain;
}

bool PeriodicDivision::chainReversed(const CurveCuts &curves, std::uint32_t chain) const {
    const std::uint32_t s = curves.chain(chain).segments.front();
    const CurveStretch &own = domain_.segments[s].stretch, &other = domain_.segments[mate(s)].stretch;
    return ((own.t0 < own.t1) != (other.t0 < other.t1)) != reversed(s);
}

std::vector<double> PeriodicDivision::mirroredCuts(const CurveCuts &curves, std::uint32_t leader,
                                                   std::uint32_t follower) const {
    const CurveChain &from = curves.chain(leader), &to = curves.chain(follower);
    const std::vector<double> &cuts = curves.cuts(leader);
    std::vector<double> mirrored{to.t0};
    const bool backwards = chainReversed(curves, follower);
    for (std::size_t k = 1; k + 1 < cuts.size(); ++k) {
        const double t = cuts[backwards ? cuts.size() - 1 - k : k];
        const auto s = std::partition_point(from.segments.begin(), from.segments.end() - 1, [&](std::uint32_t each) {
            const CurveStretch &stretch = domain_.segments[each].stretch;
            return std::max(stretch.t0, stretch.t1) < t;
        });
        const double fraction = fractionOf(domain_.segments[*s].stretch, t);
        const CurveStretch &image = domain_.segments[mate(*s)].stretch;
        mirrored.push_back(std::lerp(image.t0, image.t1, reversed(*s) ? 1.0 - fraction : fraction));
    }
    mirrored.push_back(to.t1);
    return mirrored;
}

Status PeriodicDivision::crossedElsewhere(Vec2 at) {
    Diagnostics faults =
        error("periodic-sides", "a curve of a periodic part and its image are met by others at different nodes",
              "let lines meet both parts at nodes that are images of each other, or set a node there");
    faults.front().at = at;
    return faults;
}

void PeriodicDivision::addMirrored(const CurveCuts &curves, std::vector<ChainPiece> &pieces) const {
    for (std::size_t i = 0, count = pieces.size(); i < count && sides_ != nullptr; ++i) {
        const ChainPiece piece = pieces[i];
        const std::uint32_t other = tiedChain(curves, piece.chain);
        if (other != kNoIndex && matches(curves, piece.chain, other)) {
            const auto last = static_cast<std::uint32_t>(curves.cuts(piece.chain).size() - 2);
            pieces.push_back({other, chainReversed(curves, piece.chain) ? last - piece.index : piece.index});
        }
    }
}

} // namespace forefront
