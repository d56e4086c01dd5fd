#include "core/engine/spacing/sites/steep_sites.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace forefront {
namespace {

constexpr int kRoots = 128;        ///< cells along the longer side to start with
constexpr int kDeepest = 24;       ///< halvings of those
constexpr double kAccuracy = 0.03; ///< side of the finest cells times gradation, relative to the spacing there
constexpr std::size_t kMaxCells = 3'000'000;

/// Looks for the foot of every steep slope: a place that is not steeply above any neighbour but is steeply below one.
class SlopeSearch {
  public:
    SlopeSearch(const SizesAt &rho, const SiteLabel &label, const Box2 &box, double gradation, SiteSet &sites)
        : rho_(rho), label_(label), box_(box), gradation_(gradation), sites_(sites) {}

    void run(const Progress &progress) {
        const double size = std::max(box_.size().x, box_.size().y) / kRoots;
        std::vector<Vec2> cells;
        for (int j = 0; j * size < box_.size().y || j == 0; ++j) {
            for (int i = 0; i * size < box_.size().x || i == 0; ++i) {
                cells.push_back(box_.min + size * Vec2{static_cast<double>(i), static_cast<double>(j)});
            }
        }
        std::size_t seen = 0;
        double side = size;
        for (int depth = 0; depth <= kDeepest && !cells.empty(); ++depth, side *= 0.5) {
            std::vector<Vec2> next;
            const bool last = depth == kDeepest || seen + 4 * cells.size() > kMaxCells;
            for (const Vec2 corner : cells) {
                if ((++seen & 255U) == 0 && progress.cancelled()) {
                    return;
                }
                searchCell(corner, side, last, next);
            }
            cells.swap(next);
        }
    }

  private:
    static constexpr std::size_t kSamples = 9;
    using Samples = std::array<double, kSamples>; ///< 3 x 3, row by row

    /// Minimum and maximum slope seen in a cell, and how much it may change within it.
    struct Slopes {
        double minimum = std::numeric_limits<double>::infinity();
        double maximum = 0.0;
        double change = 0.0;
    };
    static Slopes slopesOf(const Samples &v, double half) {
        Slopes slopes;
        for (const std::size_t n : {0U, 1U, 3U, 4U}) { // lower left samples of the quarters
            const double dx = 0.5 * (v[n + 1] - v[n] + v[n + 4] - v[n + 3]) / half;
            const double dy = 0.5 * (v[n + 3] - v[n] + v[n + 4] - v[n + 1]) / half;
            const double slope = std::sqrt(dx * dx + dy * dy);
            slopes.minimum = std::min(slopes.minimum, slope);
            slopes.maximum = std::max(slopes.maximum, slope);
            slopes.change = std::max(slopes.change, std::fabs(v[n] - v[n + 1] - v[n + 3] + v[n + 4]) / half);
        }
        for (std::size_t n = 0; n < 3; ++n) {
            slopes.change = std::max({slopes.change, std::fabs(v[3 * n] - 2.0 * v[3 * n + 1] + v[3 * n + 2]) / half,
                                      std::fabs(v[n] - 2.0 * v[n + 3] + v[n + 6]) / half});
        }
        return slopes;
    }

    void searchCell(Vec2 corner, double side, bool last, std::vector<Vec2> &next) {
        if (!box_.overlaps({corner, corner + Vec2{side, side}})) {
            return;
        }
        std::array<Vec2, kSamples> places;
        Samples values{};
        for (std::size_t n = 0; n < kSamples; ++n) {
            places[n] = corner + 0.5 * side * Vec2{static_cast<double>(n % 3), static_cast<double>(n / 3)};
        }
        rho_(places, values);
        const auto lowest = static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
        const Slopes slopes = slopesOf(values, 0.5 * side);
        if (slopes.maximum + 2.0 * slopes.change < 1.005 * gradation_) {
            return; // gentle all over; a slope that equals the gradation must not be searched to the last cell
        }
        const Box2 inner{box_.min + 1e-9 * box_.size(), box_.max - 1e-9 * box_.size()};
        const bool inside = inner.contains(corner) && inner.contains(corner + Vec2{side, side});
        if (inside && slopes.minimum - 2.0 * slopes.change > gradation_) {
            return; // downhill all over: no foot of a slope, but where it leaves the box
        }
        // A foot may be half a cell off its true place, and the next one is a cell away.
        const bool fine = side * gradation_ <= kAccuracy * values[lowest];
        if (!last && !fine) {
            for (std::uint32_t child = 0; child < 4; ++child) {
                next.push_back(corner +
                               0.5 * side * Vec2{static_cast<double>(child & 1U), static_cast<double>(child >> 1)});
            }
            return;
        }
        if (isFoot(places[lowest], values[lowest], 1.5 * side)) {
            const Vec2 foot = descended(places[lowest], 0.25 * side);
            sites_.add(SizeSite::point(foot, at(foot), gradation_), label_);
        }
    }
    /// Finds the minimum near p by pattern search: at a kink, all samples may be well above it. Any place is a valid
    /// site; the lower its value, the better.
    Vec2 descended(Vec2 p, double step) const {
        double value = at(p);
        for (int round = 0; round < 6; ++round, step *= 0.5) {
            for (const Vec2 way : {Vec2{step, 0}, Vec2{-step, 0}, Vec2{0, step}, Vec2{0, -step}}) {
                if (box_.contains(p + way) && at(p + way) < value) {
                    p += way;
                    value = at(p);
                }
            }
        }
        return p;
    }
    /// Returns true if no neighbour undercuts p, and p undercuts one.
    bool isFoot(Vec2 p, double value, double step) const {
        bool useful = false;
        for (int n = 0; n < 8; ++n) {
            const double angle = 0.78539816339744831 * n;
            const Vec2 q = p + step * Vec2{std::cos(angle), std::sin(angle)};
            const double other = box_.contains(q) ? at(q) : value;
            if (other + gradation_ * step < value * (1.0 - 1e-9)) {
                return false;
            }
            useful = useful || value + gradation_ * step < other * (1.0 - 1e-9);
        }
        return useful;
    }

    double at(Vec2 p) const {
        double rho = 0.0;
        rho_({&p, 1}, {&rho, 1});
        return rho;
    }

    const SizesAt &rho_;
    SiteLabel label_;
    Box2 box_;
    double gradation_;
    SiteSet &sites_;
};

} // namespace

void addSteepSites(const SizesAt &rho, const SiteLabel &label, const Box2 &box, double gradation, SiteSet &sites,
                   const Progress &progress) {
    SlopeSearch(rho, label, box, gradation, sites).run(progress);
}

} // namespace forefront
