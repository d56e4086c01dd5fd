#include "core/engine/boundary/narrow_tips.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/boundary/discretise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace forefront {
namespace {

constexpr double kSharp = 0.8830222215594891; ///< square of the cosine of 20 degrees
constexpr double kNarrow = 0.25;              ///< width of a tip in units of the spacing
constexpr double kStep = 0.25;                ///< between places where the width is compared, likewise

/// A segment that starts or ends at a node, seen from there.
struct Arm {
    std::uint32_t segment = 0;
    bool fromA = true;
    Vec2 along; ///< to its other end
};

/// A side of a tip: a segment, or the chain that it belongs to.
struct Side {
    Vec2 direction;                 ///< unit vector along a straight one
    double length = 0.0;            ///< distance between its ends
    const Curve *curve = nullptr;   ///< null: straight
    double t = 0.0;                 ///< parameter of the last place, at first that of the corner
    double end = 0.0;               ///< that of the other end
    std::uint32_t chain = kNoIndex; ///< of the curve
    double corner = 0.0;            ///< parameter of the corner

    /// Returns the place at distance x from the corner. Call it with x that never decreases.
    Vec2 at(Vec2 tip, double x) {
        if (curve == nullptr) {
            return tip + x * direction;
        }
        double next = t, step = kFirstStep * (end - t);
        while (next != end && !(distance(curve->point(next), tip) >= x)) {
            t = next;
            next = std::fabs(step) < std::fabs(end - next) ? next + step : end;
            step *= 2.0;
        }
        for (int k = 0; k < kHalvings && t != next; ++k) {
            const double middle = std::midpoint(t, next);
            (distance(curve->point(middle), tip) < x ? t : next) = middle;
        }
        return curve->point(t);
    }

  private:
    static constexpr double kFirstStep = 1e-6;
    static constexpr int kHalvings = 24;
};

class TipFinder {
  public:
    TipFinder(const Domain &domain, const SpacingField &spacing, std::span<const std::uint32_t> left,
              std::span<const std::uint32_t> right, const CurveCuts *curves)
        : domain_(domain), spacing_(spacing), left_(left), right_(right), curves_(curves) {}

    std::vector<NarrowEnd> run() {
        listSegments();
        for (std::uint32_t node = 0; node < domain_.nodes.size(); ++node) {
            const auto [first, second] = pair_[node];
            if (second == kNoIndex || second == kMany) {
                continue;
            }
            const Arm arm = armOf(first, node), next = armOf(second, node);
            consider(node, arm, next);
            consider(node, next, arm);
        }
        considerBranches();
        std::sort(ends_.begin(), ends_.end(), [](const NarrowEnd &p, const NarrowEnd &q) {
            return p.segment != q.segment ? p.segment < q.segment : p.atA && !q.atA;
        });
        return std::move(ends_);
    }

  private:
    static constexpr std::uint32_t kMany = kNoIndex - 1; ///< marks a node of more than two segments

    void listSegments() {
        pair_.assign(domain_.nodes.size(), {kNoIndex, kNoIndex});
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            for (const std::uint32_t node : {domain_.segments[s].a, domain_.segments[s].b}) {
                auto &[first, second] = pair_[node];
                if (first == kNoIndex) {
                    first = s;
                } else {
                    second = second == kNoIndex ? s : kMany;
                }
            }
        }
    }

    Arm armOf(std::uint32_t s, std::uint32_t node) const {
        const DomainSegment &segment = domain_.segments[s];
        const bool fromA = segment.a == node;
        return {s, fromA, domain_.nodes[fromA ? segment.b : segment.a] - domain_.nodes[node]};
    }

    /// Considers the wedges between neighbouring segments where more than two meet.
    void considerBranches() {
        std::vector<std::pair<std::uint32_t, Arm>> branches; // by node
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            for (const std::uint32_t node : {domain_.segments[s].a, domain_.segments[s].b}) {
                if (pair_[node][1] == kMany) {
                    branches.emplace_back(node, armOf(s, node));
                }
            }
        }
        const auto angle = [](const Arm &arm) { return std::atan2(arm.along.y, arm.along.x); };
        std::sort(branches.begin(), branches.end(), [&](const auto &p, const auto &q) {
            return p.first != q.first ? p.first < q.first : angle(p.second) < angle(q.second);
        });
        for (std::size_t begin = 0, end = 0; begin < branches.size(); begin = end) {
            const std::uint32_t node = branches[begin].first;
            while (end < branches.size() && branches[end].first == node) {
                ++end;
            }
            for (std::size_t k = begin; k < end; ++k) {
                consider(node, branches[k].second, branches[k + 1 < end ? k + 1 : begin].second);
            }
        }
    }

    /// Considers the wedge left of the first arm, up to the second.
    void consider(std::uint32_t node, const Arm &first, const Arm &second) {
        const double cosine = dot(first.along, second.along);
        if (!(cosine > 0.0) ||
            !(cosine * cosine > kSharp * dot(first.along, first.along) * dot(second.along, second.along)) ||
            !(cross(first.along, second.along) > 0.0)) {
            return;
        }
        const auto leftOf = [&](const Arm &arm) { return (arm.fromA ? left_ : right_)[arm.segment]; };
        const auto rightOf = [&](const Arm &arm) { return (arm.fromA ? right_ : left_)[arm.segment]; };
        if (leftOf(first) == kOutside || rightOf(first) != kOutside || leftOf(second) != kOutside) {
            return;
        }
        const std::optional<Side> sideA = sideOf(first), sideB = sideOf(second);
        const double tip = sideA && sideB ? tipLength(domain_.nodes[node], *sideA, *sideB) : 0.0;
        for (const Arm &arm : {first, second}) {
            if (tip > 0.0) {
                ends_.push_back({arm.segment, arm.fromA, tip});
            }
        }
    }

    /// Returns the side that begins with an arm; none for a loop.
    std::optional<Side> sideOf(const Arm &arm) const {
        const std::uint32_t c = curves_ != nullptr ? curves_->chainOf(arm.segment) : kNoIndex;
        if (c == kNoIndex) {
            const double length = forefront::length(arm.along);
            return Side{(1.0 / length) * arm.along, length};
        }
        const CurveStretch &stretch = domain_.segments[arm.segment].stretch;
        const CurveChain &chain = curves_->chain(c);
        const Curve &curve = curves_->curve(c);
        const double t = arm.fromA ? stretch.t0 : stretch.t1;
        if (chain.start == chain.end || (t != chain.t0 && t != chain.t1)) {
            return std::nullopt;
        }
        const double far = t == chain.t0 ? chain.t1 : chain.t0;
        return Side{{}, distance(curve.point(t), curve.point(far)), &curve, t, far, c, t};
    }

    /// Returns how far from the corner the tip is narrow.
    double tipLength(Vec2 corner, Side a, Side b) const {
        const bool straight = a.curve == nullptr && b.curve == nullptr;
        const Vec2 middle = 0.5 * (a.direction + b.direction);
        const double opening = length(b.direction - a.direction);
        const double longest = std::min(a.length, b.length);
        double narrow = 0.0;
        for (double x = 0.0; narrow < longest;) {
            const Vec2 p = straight ? Vec2{} : a.at(corner, x), q = straight ? Vec2{} : b.at(corner, x);
            const double width = straight ? x * opening : distance(p, q);
            const double rho = spacing_.at(straight ? corner + x * middle : midpoint(p, q));
            if (!(width < kNarrow * rho) || !(x + kStep * rho > x) || !canBeWhole(a) || !canBeWhole(b)) {
                break;
            }
            narrow = x;
            x = std::min(longest, x + kStep * rho);
        }
        return narrow;
    }

    /// Returns true if a side can be one piece from the corner to its last place.
    bool canBeWhole(const Side &side) const {
        return side.curve == nullptr || curves_->allowsPiece(side.chain, side.corner, side.t);
    }

    const Domain &domain_;
    const SpacingField &spacing_;
    std::span<const std::uint32_t> left_, right_;
    const CurveCuts *curves_;
    std::vector<std::array<std::uint32_t, 2>> pair_; // per node: its segments
    std::vector<NarrowEnd> ends_;
};

} // namespace

std::vector<NarrowEnd> findNarrowEnds(const Domain &domain, const SpacingField &spacing,
                                      std::span<const std::uint32_t> left, std::span<const std::uint32_t> right,
                                      const CurveCuts *curves) {
    return TipFinder(domain, spacing, left, right, curves).run();
}

} // namespace forefront
