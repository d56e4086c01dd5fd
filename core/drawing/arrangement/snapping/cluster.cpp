#include "core/drawing/arrangement/snapping/cluster.hpp"

#include "core/engine/base/ids.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace forefront {

namespace {

/// Places within a strip of the plane, ordered by y.
class PlaceStrip {
  public:
    PlaceStrip(std::span<const Vec2> places, double radius) : places_(places), radius_(radius) {}

    void add(std::uint32_t place) { byHeight_.emplace(places_[place].y, place); }
    void remove(std::uint32_t place) { byHeight_.erase({places_[place].y, place}); }

    /// Returns the nearest place within the radius, by x and y among equals; kNoIndex if there is none.
    std::uint32_t nearest(Vec2 p) const {
        std::uint32_t best = kNoIndex;
        double limit = radius_;
        for (auto it = byHeight_.lower_bound({p.y - radius_, 0}); it != byHeight_.end() && it->first <= p.y + radius_;
             ++it) {
            const Vec2 q = places_[it->second];
            const double gap = distance(p, q);
            if (gap < limit || (gap == limit && (best == kNoIndex || comesBefore(q, places_[best])))) {
                limit = gap;
                best = it->second;
            }
        }
        return best;
    }

  private:
    std::span<const Vec2> places_;
    double radius_;
    std::set<std::pair<double, std::uint32_t>> byHeight_;
};

/// Slides a strip over sites that are sorted by x.
class SlidingStrip {
  public:
    SlidingStrip(std::span<const Vec2> places, const std::vector<std::uint32_t> &sites, double radius)
        : places_(places), sites_(sites), radius_(radius), strip_(places, radius) {}

    std::uint32_t nearest(Vec2 p) {
        while (entering_ < sites_.size() && places_[sites_[entering_]].x <= p.x + radius_) {
            strip_.add(sites_[entering_++]);
        }
        while (leaving_ < entering_ && places_[sites_[leaving_]].x < p.x - radius_) {
            strip_.remove(sites_[leaving_++]);
        }
        return strip_.nearest(p);
    }

  private:
    std::span<const Vec2> places_;
    const std::vector<std::uint32_t> &sites_;
    double radius_;
    PlaceStrip strip_;
    std::size_t entering_ = 0, leaving_ = 0;
};

/// Appends to `leaders` (sorted by x) those of `candidates` (likewise) that keep the distance.
void choose(std::span<const Vec2> places, const std::vector<std::uint32_t> &candidates, double radius,
            std::vector<std::uint32_t> &leaders) {
    const std::vector<std::uint32_t> earlier = leaders;
    SlidingStrip older(places, earlier, radius);
    PlaceStrip chosen(places, radius);
    std::vector<std::uint32_t> fresh;
    std::size_t leaving = 0;
    for (const std::uint32_t candidate : candidates) {
        const Vec2 p = places[candidate];
        for (; leaving < fresh.size() && places[fresh[leaving]].x < p.x - radius; ++leaving) {
            chosen.remove(fresh[leaving]);
        }
        if ((earlier.empty() || older.nearest(p) == kNoIndex) && chosen.nearest(p) == kNoIndex) {
            chosen.add(candidate);
            fresh.push_back(candidate);
        }
    }
    const auto middle = static_cast<std::ptrdiff_t>(leaders.size());
    leaders.insert(leaders.end(), fresh.begin(), fresh.end());
    std::inplace_merge(leaders.begin(), leaders.begin() + middle, leaders.end(),
                       [&](std::uint32_t m, std::uint32_t n) { return comesBefore(places[m], places[n]); });
}

} // namespace

std::vector<std::uint32_t> clusterPlaces(std::span<const Vec2> places, std::span<const std::uint8_t> preferred,
                                         double radius) {
    std::vector<std::uint32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t m, std::uint32_t n) { return comesBefore(places[m], places[n]); });
    std::vector<std::uint32_t> leaders, first;
    if (!preferred.empty()) {
        std::copy_if(order.begin(), order.end(), std::back_inserter(first),
                     [&](std::uint32_t place) { return preferred[place] != 0; });
        choose(places, first, radius, leaders);
    }
    choose(places, order, radius, leaders);

    std::vector<std::uint32_t> leader(places.size(), kNoIndex);
    for (const std::uint32_t place : leaders) {
        leader[place] = place;
    }
    SlidingStrip strip(places, leaders, radius);
    if (leaders.size() < places.size()) {
        for (const std::uint32_t place : order) {
            if (leader[place] == kNoIndex) {
                leader[place] = strip.nearest(places[place]);
            }
        }
    }
    return leader;
}

} // namespace forefront
