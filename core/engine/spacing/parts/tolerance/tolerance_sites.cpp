#include "core/engine/spacing/parts/tolerance/tolerance_sites.hpp"

#include "core/engine/domain/chord_limit.hpp"
#include "core/engine/domain/curve_chains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace forefront {
namespace {

constexpr double kStraight = 0.3;   ///< turning of a part, in radians, that one site represents
constexpr double kSimilar = 1.2;    ///< ratio of the chords of a part that one site represents
constexpr double kShortPart = 0.25; ///< relative to its chord; such a part is not divided
constexpr double kCorner = 1.2;     ///< bends with a smaller radius, relative to the tolerance, are corners

class ToleranceFinder {
  public:
    ToleranceFinder(const Domain &domain, SegmentElements elements, const OtherSizes &others, double minimum,
                    double gradation, SiteSet &sites)
        : domain_(domain), elements_(elements), others_(others), tolerance_(chordTolerance(domain)), minimum_(minimum),
          gradation_(gradation), sites_(sites) {}

    void run(const Progress &progress) {
        for (const CurveChain &chain : curveChains(domain_).list) {
            if (progress.cancelled()) {
                return;
            }
            if (elements_[chain.segments.front()] > 0) {
                continue; // their size is given
            }
            loop_ = chain.start == chain.end;
            for (const std::uint32_t s : chain.segments) {
                addSegment(domain_.curves[chain.curve], s);
            }
        }
    }

  private:
    struct Part {
        double t0, t1, chord0, chord1;
    };

    /// Returns the longest chord at a parameter; infinite at a corner. A whole hole is not a corner, however small.
    double chordAt(const Curve &curve, double t) const {
        const double curvature = curvatureAt(curve, t);
        if (!loop_ && !(curvature * kCorner * tolerance_ < 1.0)) {
            return std::numeric_limits<double>::infinity();
        }
        return ChordLimit::longestAt(curve, t, tolerance_);
    }

    void addSegment(const Curve &curve, std::uint32_t segment) {
        const CurveStretch stretch = domain_.segments[segment].stretch;
        const double largest = others_.largest;
        std::vector<Part> open = {{stretch.t0, stretch.t1, chordAt(curve, stretch.t0), chordAt(curve, stretch.t1)}};
        while (!open.empty()) {
            const Part part = open.back();
            open.pop_back();
            const double middle = 0.5 * (part.t0 + part.t1), chord = chordAt(curve, middle);
            const auto [shortest, longest] = std::minmax({part.chord0, chord, part.chord1});
            const double length = curve.length(part.t0, part.t1);
            const double enough = std::max(kShortPart * std::min(shortest, largest), kShortPart * tolerance_);
            const bool divides =
                length > enough && (curve.turning(part.t0, part.t1) > kStraight || longest > kSimilar * shortest);
            if (divides && middle != part.t0 && middle != part.t1) {
                open.push_back({middle, part.t1, chord, part.chord1});
                open.push_back({part.t0, middle, part.chord0, chord});
            } else if (shortest > 0.0 && shortest < largest) {
                addSite(curve.point(part.t0), curve.point(part.t1), shortest, segment);
            }
        }
    }

    void addSite(Vec2 a, Vec2 b, double chord, std::uint32_t segment) {
        const SizeSite site = limited(SizeSite::segment(a, b, chord, gradation_), minimum_, gradation_);
        constexpr double kFiner = 0.99; // a rule that asks for the same, such as the curvature, keeps its name
        const auto isFiner = [&](Vec2 p) { return site.size < kFiner * others_.at(p); };
        if (isFiner(a) || isFiner(midpoint(a, b)) || isFiner(b)) {
            sites_.add(site, {SpacingOrigin::Boundary, SiteReason::Tolerance, segment});
        }
    }

    const Domain &domain_;
    SegmentElements elements_;
    const OtherSizes &others_;
    double tolerance_, minimum_, gradation_;
    SiteSet &sites_;
    bool loop_ = false; ///< the chain is closed
};

} // namespace

void addToleranceSites(const Domain &domain, SegmentElements elements, const OtherSizes &others, double minimum,
                       double gradation, const Progress &progress, SiteSet &sites) {
    ToleranceFinder(domain, elements, others, minimum, gradation, sites).run(progress);
}

} // namespace forefront
