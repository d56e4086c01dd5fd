#include "core/engine/geometry/plane_sweep.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/base/rows.hpp"
#include "core/engine/geometry/sweep_status.hpp"

#include <algorithm>
#include <span>

namespace forefront {

namespace {

class Sweeper {
  public:
    Sweeper(std::span<const Vec2> points, std::span<const PlaneEdge> edges)
        : points_(points), ends_(orderPoints(edges)), status_(ends_) {
        linkEdges();
    }

    PlaneSweepResult run(const std::stop_token &stop) {
        std::size_t visited = 0;
        for (const std::uint32_t point : result_.order) {
            if (++visited % 4096 == 0 && stop.stop_requested()) {
                break;
            }
            visit(point);
        }
        return std::move(result_);
    }

  private:
    /// Returns the points in the order of their places, those at the same place by index.
    std::vector<std::uint32_t> sortedPoints() const {
        std::vector<std::uint64_t> keys;
        keys.reserve(points_.size());
        for (const Vec2 p : points_) {
            keys.push_back(sortKey(p.x));
        }
        std::vector<std::uint32_t> sorted = orderByKeys(keys);
        for (auto first = sorted.begin(); first != sorted.end();) {
            const auto last = std::find_if(first + 1, sorted.end(),
                                           [&](std::uint32_t i) { return points_[i].x != points_[*first].x; });
            std::sort(first, last, [&](std::uint32_t i, std::uint32_t j) {
                return points_[i].y != points_[j].y ? points_[i].y < points_[j].y : i < j;
            });
            first = last;
        }
        return sorted;
    }

    /// Fills `canonical` and `order` and returns the ends of the edges.
    std::vector<SweepStatus::Ends> orderPoints(std::span<const PlaneEdge> edges) {
        const auto count = static_cast<std::uint32_t>(points_.size());
        const std::vector<std::uint32_t> sorted = sortedPoints();
        result_.canonical.resize(count);
        rank_.resize(count);
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            const bool same = i > 0 && points_[sorted[i]] == points_[sorted[i - 1]];
            if (!same) {
                result_.order.push_back(sorted[i]);
            }
            result_.canonical[sorted[i]] = result_.order.back();
            rank_[sorted[i]] = static_cast<std::uint32_t>(result_.order.size() - 1);
        }
        result_.below.assign(count, kNoIndex);
        result_.on.assign(count, kNoIndex);
        result_.dropped.assign(edges.size(), 0);
        std::vector<SweepStatus::Ends> ends(edges.size());
        low_.resize(edges.size());
        high_.resize(edges.size());
        for (std::size_t e = 0; e < edges.size(); ++e) {
            // Ranks order the ends as their coordinates do.
            low_[e] = std::min(rank_[edges[e].a], rank_[edges[e].b]);
            high_[e] = std::max(rank_[edges[e].a], rank_[edges[e].b]);
            ends[e] = {points_[result_.order[low_[e]]], points_[result_.order[high_[e]]]};
        }
        return ends;
    }

    /// Edges by their lower end, and one edge that ends at each point, kept up to date while sweeping.
    void linkEdges() {
        ending_.assign(result_.order.size(), kNoIndex);
        for (std::uint32_t e = 0; e < low_.size(); ++e) {
            if (low_[e] == high_[e]) {
                markDropped(e);
            }
        }
        outgoing_ = Rows<std::uint32_t>(result_.order.size(), [this](const auto &add) {
            for (std::uint32_t e = 0; e < low_.size(); ++e) {
                if (low_[e] != high_[e]) {
                    add(low_[e], e);
                }
            }
        });
    }

    void markDropped(std::uint32_t edge) {
        result_.dropped[edge] = 1;
        ++result_.droppedCount;
    }
    void drop(std::uint32_t edge) {
        markDropped(edge);
        status_.erase(edge);
    }

    void visit(std::uint32_t point) {
        const std::uint32_t rank = rank_[point];
        const Vec2 p = points_[point];
        const std::span<std::uint32_t> leaving = outgoing_[rank];
        const auto first = leaving.begin(), last = leaving.end();
        std::uint32_t below = kNoIndex;
        std::uint32_t spare = kNoIndex; // an ended edge whose place in the tree can be reused
        const std::uint32_t ended = endingAt(rank);
        if (ended != kNoIndex) {
            below = removeEnded(ended, rank, spare, first != last);
        } else {
            SweepStatus::Place place = status_.find(p);
            while (place.hit != kNoIndex) {
                if (first == last) {
                    result_.on[point] = place.hit;
                    return;
                }
                const std::uint32_t lower = status_.previous(place.hit);
                drop(place.hit);
                settle(lower);
                place = status_.find(p);
            }
            below = place.below;
        }
        result_.below[point] = below;
        if (first == last) {
            settle(below);
            return;
        }
        sortByAngle(p, first, last);
        insertStarting(p, first, last, below, spare);
        if (below != kNoIndex && result_.dropped[below] == 0) { // otherwise everything above it was settled before
            settle(below);
        }
    }

    /// Returns an edge in the status that ends at the point of this rank, or kNoIndex.
    std::uint32_t endingAt(std::uint32_t rank) const {
        const std::uint32_t edge = ending_[rank];
        if (edge == kNoIndex || result_.dropped[edge] == 0) {
            return edge;
        }
        // The remembered edge has since been dropped; the position of the point leads to another one.
        const SweepStatus::Place place = status_.find(points_[result_.order[rank]]);
        return place.hit != kNoIndex && high_[place.hit] == rank ? place.hit : kNoIndex;
    }

    /// Removes all edges that end at the point, which are neighbours; keeps one as `spare` on request.
    std::uint32_t removeEnded(std::uint32_t edge, std::uint32_t rank, std::uint32_t &spare, bool keepSpare) {
        const auto ends = [&](std::uint32_t e) { return e != kNoIndex && high_[e] == rank; };
        while (ends(status_.previous(edge))) {
            edge = status_.previous(edge);
        }
        const std::uint32_t below = status_.previous(edge);
        if (keepSpare) {
            spare = edge;
            edge = status_.next(edge);
        }
        while (ends(edge)) {
            const std::uint32_t above = status_.next(edge);
            status_.erase(edge);
            edge = above;
        }
        return below;
    }

    template <class Iterator>
    void sortByAngle(Vec2 p, Iterator first, Iterator last) const {
        if (last - first == 1) {
            return;
        }
        std::sort(first, last, [&](std::uint32_t e, std::uint32_t f) {
            const int turn = orientation(p, ends_[e].high, ends_[f].high);
            return turn != 0 ? turn > 0 : e < f;
        });
    }

    template <class Iterator>
    void insertStarting(Vec2 p, Iterator first, Iterator last, std::uint32_t below, std::uint32_t spare) {
        std::uint32_t lower = below;
        for (auto e = first; e != last; ++e) {
            if (e != first && orientation(p, ends_[lower].high, ends_[*e].high) == 0) {
                markDropped(*e); // it lies on the one before
                continue;
            }
            if (spare != kNoIndex) {
                status_.replace(spare, *e);
                spare = kNoIndex;
            } else {
                status_.insertAbove(lower, *e);
            }
            ending_[high_[*e]] = *e;
            lower = *e;
        }
        settle(lower);
    }

    /// Tests `lower` (kNoIndex: nothing to test) against its upper neighbour. If they meet, drops one and continues
    /// with the new neighbours.
    void settle(std::uint32_t lower) {
        while (lower != kNoIndex) {
            const std::uint32_t upper = status_.next(lower);
            if (upper == kNoIndex || !meetAhead(lower, upper)) {
                return;
            }
            const std::uint32_t before = status_.previous(lower);
            if (lower > upper) {
                drop(lower);
                lower = before;
            } else {
                drop(upper);
            }
        }
    }

    /// Returns true if neighbours, ordered correctly at the sweep line, meet to the right of it. One test decides that.
    bool meetAhead(std::uint32_t lower, std::uint32_t upper) const {
        if (high_[lower] == high_[upper]) {
            return false;
        }
        return high_[lower] < high_[upper] ? orientation(ends_[upper].low, ends_[upper].high, ends_[lower].high) >= 0
                                           : orientation(ends_[lower].low, ends_[lower].high, ends_[upper].high) <= 0;
    }

    std::span<const Vec2> points_;
    PlaneSweepResult result_;
    std::vector<std::uint32_t> rank_;       // per point: position in order
    std::vector<std::uint32_t> low_, high_; // per edge: ranks of its ends
    std::vector<SweepStatus::Ends> ends_;
    Rows<std::uint32_t> outgoing_;      // edges by rank of the lower end
    std::vector<std::uint32_t> ending_; // per rank: the last inserted edge that ends there
    SweepStatus status_;
};

} // namespace

PlaneSweepResult sweepPlane(std::span<const Vec2> points, std::span<const PlaneEdge> edges,
                            const std::stop_token &stop) {
    return Sweeper(points, edges).run(stop);
}

} // namespace forefront
