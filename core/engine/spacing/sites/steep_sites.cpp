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
constexpr int kSureDepth = 3; ///< halvings after which slopes between samples are believed, unless a gradation is given

/// Looks for the foot of every steep slope: a place that is not steeply above any neighbour but is steeply below one.
class SlopeSearch {
  public:
    SlopeSearch(const SizesAt &rho, const SiteLabel &label, const SteepSearch &search, SiteSet &sites)
        : rho_(rho), label_(label), box_(search.box), inside_(search.inside), gradation_(search.gradation),
          thorough_(search.thorough), sites_(sites) {}

    void run(const Progress &progress) {
        const double size = std::max(box_.size().x, box_.size().y) / kRoots;
        std::vector<Cell> cells;
        for (int j = 0; j * size < box_.size().y || j == 0; ++j) {
            for (int i = 0; i * size < box_.size().x || i == 0; ++i) {
                cells.push_back({box_.min + size * Vec2{static_cast<double>(i), static_cast<double>(j)}});
            }
        }
        std::size_t seen = 0;
        double side = size;
        for (int depth = 0; depth <= kDeepest && !cells.empty(); ++depth, side *= 0.5) {
            std::vector<Cell> next;
            const bool last = depth == kDeepest || seen + 4 * cells.size() > kMaxCells;
            doubt_ = thorough_ || depth < kSureDepth ? 2.0 : 0.0;
            for (const Cell &cell : cells) {
                if ((++seen & 255U) == 0 && progress.cancelled()) {
                    return;
                }
                searchCell(cell, side, last, next);
            }
            cells.swap(next);
        }
    }

  private:
    static constexpr std::size_t kSamples = 9;
    using Samples = std::array<double, kSamples>; ///< 3 x 3, row by row
    struct Cell {
        Vec2 corner;
        bool within = false; ///< known to be inside the domain as a whole
    };

    /// Minimum and maximum slope seen in a cell, and how much it may change within it.
    struct Slopes {
        double minimum = std::numeric_limits<double>::infinity();
        double maximum = 0.0;
        double change = 0.0;
        Vec2 upwards; ///< sum of the gradients
    };
    static Slopes slopesOf(const Samples &v, double half) {
        Slopes slopes;
        for (const std::size_t n : {0U, 1U, 3U, 4U}) { // lower left samples of the quarters
            const double dx = 0.5 * (v[n + 1] - v[n] + v[n + 4] - v[n + 3]) / half;
            const double dy = 0.5 * (v[n + 3] - v[n] + v[n + 4] - v[n + 1]) / half;
            const double slope = std::sqrt(dx * dx + dy * dy);
            slopes.upwards += {dx, dy};
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

    bool isInside(Vec2 p) const { return box_.contains(p) && (inside_ == nullptr || inside_->contains(p)); }
    /// Returns true if a cell lies inside the domain as a whole.
    bool isWithin(const Box2 &cell) const {
        const Box2 inner{box_.min + 1e-9 * box_.size(), box_.max - 1e-9 * box_.size()};
        return inner.contains(cell.min) && inner.contains(cell.max) &&
               (inside_ == nullptr || !inside_->boundaryMeets(cell));
    }

    void searchCell(Cell cell, double side, bool last, std::vector<Cell> &next) {
        const Vec2 corner = cell.corner;
        const Box2 extent{corner, corner + Vec2{side, side}};
        if (!cell.within) {
            if (!box_.overlaps(extent) || (inside_ != nullptr && !inside_->meets(extent))) {
                return;
            }
            cell.within = isWithin(extent);
        }
        std::array<Vec2, kSamples> places;
        Samples values{};
        for (std::size_t n = 0; n < kSamples; ++n) {
            places[n] = corner + 0.5 * side * Vec2{static_cast<double>(n % 3), static_cast<double>(n / 3)};
        }
        rho_(places, values);
        const Slopes slopes = slopesOf(values, 0.5 * side);
        if (slopes.maximum + doubt_ * slopes.change < 1.005 * gradation_) {
            return; // gentle all over; a slope that equals the gradation must not be searched to the last cell
        }
        if (cell.within && slopes.minimum - 2.0 * slopes.change > gradation_ &&
            leadsOut(places, values, slopes.upwards, 0.5 * side)) {
            return; // downhill all over: no foot of a slope, but where it leaves the domain
        }
        for (std::size_t n = 0; n < kSamples && !cell.within; ++n) {
            values[n] = isInside(places[n]) ? values[n] : std::numeric_limits<double>::infinity();
        }
        const auto lowest = static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
        // A foot may be half a cell off its true place, and the next one is a cell away.
        const double least = std::min(values[lowest], at(places[kSamples / 2]));
        const bool fine = side * gradation_ <= kAccuracy * least;
        if (!last && !fine) {
            for (std::uint32_t child = 0; child < 4; ++child) {
                next.push_back(
                    {corner + 0.5 * side * Vec2{static_cast<double>(child & 1U), static_cast<double>(child >> 1)},
                     cell.within});
            }
            return;
        }
        if (std::isfinite(values[lowest]) && isFoot(places[lowest], values[lowest], 1.5 * side)) {
            const Vec2 foot = descended(places[lowest], 0.25 * side);
            sites_.add(SizeSite::point(foot, at(foot), gradation_), label_);
        }
    }
    /// Returns true if a slope that goes down all over a cell goes on below its lowest sample. Where it does not, its
    /// foot is on the rim, which no cell has inside, such as a fold along the middle of the box.
    bool leadsOut(const std::array<Vec2, kSamples> &places, const Samples &values, Vec2 upwards, double step) const {
        const auto lowest = static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
        const Vec2 below = places[lowest] - (step / length(upwards)) * upwards;
        return !isInside(below) || at(below) + gradation_ * step < values[lowest];
    }
    /// Finds the minimum near p by pattern search: at a kink, all samples may be well above it. Any place is a valid
    /// site; the lower its value, the better.
    Vec2 descended(Vec2 p, double step) const {
        double value = at(p);
        for (int round = 0; round < 6; ++round, step *= 0.5) {
            for (const Vec2 way : {Vec2{step, 0}, Vec2{-step, 0}, Vec2{0, step}, Vec2{0, -step}}) {
                if (isInside(p + way) && at(p + way) < value) {
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
            const double other = isInside(q) ? at(q) : value;
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
    const InsideTest *inside_; ///< null: all of the box is inside
    double gradation_;
    bool thorough_;
    double doubt_ = 0.0; ///< how many times the change of the slope within a cell may be hidden between samples
    SiteSet &sites_;
};

} // namespace

void addSteepSites(const SizesAt &rho, const SiteLabel &label, const SteepSearch &search, SiteSet &sites,
                   const Progress &progress) {
    SlopeSearch(rho, label, search, sites).run(progress);
}

} // namespace forefront
