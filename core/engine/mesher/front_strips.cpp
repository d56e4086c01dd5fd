#include "core/engine/mesher/front_strips.hpp"

#include "core/engine/boundary/estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace forefront {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMinStrips = 8.0; ///< with fewer, one thread is fast enough
/// Enough for any number of threads.
constexpr double kMaxStrips = 64.0;
/// One boundary segment makes a strip as worthwhile as this number of elements: the part of Γ in a strip and the
/// spacing around it should stay in the caches. With 512 instead of 64 strips, the front of a coast of a million
/// segments and 10 million elements takes two thirds of the time.
constexpr double kElementsPerSegment = 32.0;
constexpr double kMaxStripsOfLong = 512.0;
/// Maximum fraction of coarse elements for more strips than usual. With a larger one, strips would be a few elements
/// wide and leave most of the work to the other phases: with 512 strips, a plate of 250,000 holes and one
/// element size takes a fifth longer and three quarters more memory than with 64.
constexpr double kMostCoarse = 0.1;
constexpr double kMultiple = 2.0;      ///< their number is a multiple, so that two threads both have work to the end
constexpr double kCoarse = 1.0 / 16.0; ///< segments at least this fraction of a strip's width are coarse

/// The distribution of the expected elements along the longer side of a box: ∫ dA/ρ², by cells that are quartered where
/// ρ varies. Small spacing that the samples miss makes strips uneven, which costs time and nothing else.
class ElementProfile {
  public:
    ElementProfile(const Box2 &box, const SpacingField &spacing) : box_(box), spacing_(spacing) {
        constexpr int kColumns = 64;
        constexpr int kDepth = 5;
        const Vec2 size = box.size();
        alongX_ = size.x >= size.y;
        const double cell = std::max(size.x, size.y) / kColumns;
        const auto cells = [&](double extent) { return std::max(1, static_cast<int>(std::round(extent / cell))); };
        const int columns = cells(size.x), rows = cells(size.y);
        const Vec2 half{0.5 * size.x / columns, 0.5 * size.y / rows};
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) {
                const Vec2 centre{box.min.x + (2 * i + 1) * half.x, box.min.y + (2 * j + 1) * half.y};
                add(centre, half, spacing_.at(centre), kDepth);
            }
        }
    }

    /// Returns the places, ascending, that cut the side into `strips` parts with equal shares.
    std::vector<double> cuts(int strips) const {
        double sum = 0.0;
        for (const double share : shares_) {
            sum += share;
        }
        std::vector<double> cuts;
        double before = 0.0;
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            const double after = before + shares_[k];
            for (double target = sum * static_cast<double>(cuts.size() + 1) / strips;
                 static_cast<int>(cuts.size()) + 1 < strips && after >= target && shares_[k] > 0.0;
                 target = sum * static_cast<double>(cuts.size() + 1) / strips) {
                const double part = (static_cast<double>(k) + (target - before) / shares_[k]) / kBins;
                cuts.push_back(low() + part * extent());
            }
            before = after;
        }
        return cuts;
    }

    /// Returns the fraction of the elements that are coarse in the strips between these cuts.
    double coarseShare(const std::vector<double> &cuts) const {
        double sum = 0.0, coarse = 0.0;
        for (const Sample &sample : samples_) {
            const double place = low() + sample.at * extent();
            const auto after = std::upper_bound(cuts.begin(), cuts.end(), place);
            const double from = after == cuts.begin() ? low() : *(after - 1);
            const double to = after == cuts.end() ? low() + extent() : *after;
            sum += sample.share;
            coarse += sample.rho >= kCoarse * (to - from) ? sample.share : 0.0;
        }
        return coarse / sum;
    }

    bool alongX() const { return alongX_; }

  private:
    static constexpr std::size_t kBins = 2048;
    struct Sample {
        double at = 0.0; ///< along the side, from 0 to 1
        double share = 0.0;
        double rho = 0.0;
    };

    double low() const { return alongX() ? box_.min.x : box_.min.y; }
    double extent() const { return alongX() ? box_.size().x : box_.size().y; }

    void add(Vec2 centre, Vec2 half, double rho, int depth) {
        std::array<Vec2, 4> centres{};
        std::array<double, 4> rhos{};
        double min = rho, max = rho;
        for (unsigned k = 0; k < 4; ++k) {
            centres[k] = centre + Vec2{(k % 2 != 0 ? 0.5 : -0.5) * half.x, (k / 2 != 0 ? 0.5 : -0.5) * half.y};
            rhos[k] = spacing_.at(centres[k]);
            min = std::min(min, rhos[k]);
            max = std::max(max, rhos[k]);
        }
        if (depth > 0 && max > 1.3 * min && left_ > 0) {
            --left_;
            for (unsigned k = 0; k < 4; ++k) {
                add(centres[k], 0.5 * half, rhos[k], depth - 1);
            }
            return;
        }
        for (unsigned k = 0; k < 4; ++k) {
            const double at = ((alongX() ? centres[k].x : centres[k].y) - low()) / extent();
            const double share = half.x * half.y / (rhos[k] * rhos[k]);
            shares_[std::min(kBins - 1, static_cast<std::size_t>(at * kBins))] += share;
            samples_.push_back({at, share, rhos[k]});
        }
    }

    Box2 box_;
    const SpacingField &spacing_;
    bool alongX_ = true;
    int left_ = 8'000; ///< cells that may still be quartered, which takes a few milliseconds in all
    std::array<double, kBins> shares_{};
    std::vector<Sample> samples_;
};

/// Returns the cuts between the strips.
std::vector<double> cutsFor(const ElementProfile &profile, double elements, std::size_t segments, double perStrip) {
    const auto rounded = [](double strips) { return static_cast<int>(kMultiple * std::ceil(strips / kMultiple)); };
    const int byElements = rounded(std::min(kMaxStrips, elements / perStrip));
    const int bySegments =
        rounded(std::min(kMaxStripsOfLong, static_cast<double>(segments) * kElementsPerSegment / perStrip));
    for (int strips = bySegments; strips > byElements; strips = rounded(0.5 * strips)) {
        std::vector<double> found = profile.cuts(strips);
        if (profile.coarseShare(found) <= kMostCoarse) {
            return found;
        }
    }
    return profile.cuts(byElements);
}

Box2 strip(bool alongX, double from, double to) {
    return alongX ? Box2{{from, -kInfinity}, {to, kInfinity}} : Box2{{-kInfinity, from}, {kInfinity, to}};
}

} // namespace

FrontStrips::FrontStrips() : phases{0, 1} {
    boxes.push_back({{-kInfinity, -kInfinity}, {kInfinity, kInfinity}});
}

FrontStrips::FrontStrips(const DiscreteDomain &domain, const SpacingField &spacing, double perStrip) : FrontStrips() {
    const Box2 box = domain.bounds();
    // The minimum spacing gives an upper bound, so that most domains need no estimate.
    const double maxElements = domain.area() * 4.0 / (std::numbers::sqrt3 * spacing.minimum() * spacing.minimum());
    if (!(maxElements > kMinStrips * perStrip)) {
        return;
    }
    const double elements =
        domain.estimatedElements > 0.0 ? domain.estimatedElements : estimateElements(domain, spacing);
    if (!(elements > kMinStrips * perStrip)) {
        return;
    }
    const ElementProfile profile(box, spacing);
    const std::vector<double> cuts = cutsFor(profile, elements, domain.segments.size(), perStrip);
    if (cuts.empty()) {
        return;
    }
    const Box2 everything = boxes.front();
    const double low = profile.alongX() ? box.min.x : box.min.y, high = profile.alongX() ? box.max.x : box.max.y;
    double from = -kInfinity;
    for (const double cut : cuts) {
        boxes.push_back(strip(profile.alongX(), from, cut));
        minCoarse.push_back(kCoarse * (cut - std::max(from, low)));
        from = cut;
    }
    boxes.push_back(strip(profile.alongX(), from, kInfinity));
    minCoarse.push_back(kCoarse * (high - from));
    phases.push_back(boxes.size());
    for (std::size_t k = 0; k < cuts.size(); ++k) { // from the middle of one strip to the middle of the next
        const double left = k == 0 ? -kInfinity : 0.5 * (cuts[k - 1] + cuts[k]);
        const double right = k + 1 == cuts.size() ? kInfinity : 0.5 * (cuts[k] + cuts[k + 1]);
        boxes.push_back(strip(profile.alongX(), left, right));
    }
    phases.push_back(boxes.size());
    boxes.push_back(everything);
    phases.push_back(boxes.size());
}

std::size_t FrontStrips::phaseOf(std::size_t strip) const {
    return static_cast<std::size_t>(std::upper_bound(phases.begin(), phases.end(), strip) - phases.begin()) - 1;
}

std::size_t FrontStrips::stripAt(std::size_t phase, Vec2 place) const {
    const auto first = boxes.begin() + static_cast<std::ptrdiff_t>(phases[phase]);
    const auto last = boxes.begin() + static_cast<std::ptrdiff_t>(phases[phase + 1]) - 1;
    const auto before = [&](const Box2 &box) { return !(place.x < box.max.x && place.y < box.max.y); };
    return static_cast<std::size_t>(std::partition_point(first, last, before) - boxes.begin());
}

} // namespace forefront
