#include "core/drawing/domain/neighbour_sides.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/base/key_order.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace forefront {
namespace {

/// A side of a loop: a straight segment, or the chords of a part of a curve, between nodes that loops share.
struct LoopSide {
    std::uint32_t low = 0, high = 0; ///< nodes at its ends
    std::uint32_t loop = 0;
    SegmentRun run;
    bool areaToLeft = false; ///< of the way from `low` to `high`
    bool boundary = false;

    bool hasSameEnds(const LoopSide &other) const { return low == other.low && high == other.high; }
    friend bool operator<(const LoopSide &a, const LoopSide &b) {
        return std::tuple(a.low, a.high, a.run.first) < std::tuple(b.low, b.high, b.run.first);
    }
};

class SideFinder {
  public:
    SideFinder(const Domain &domain, std::span<const SegmentRun> loops, double tolerance)
        : domain_(domain), loops_(loops), tolerance_(tolerance) {}

    std::vector<NeighbourSide> run() {
        findShared();
        for (std::uint32_t k = 0; k < loops_.size(); ++k) {
            collect(k);
        }
        std::sort(sides_.begin(), sides_.end());
        for (std::size_t k = 0, next = 0; k < sides_.size(); k = next) {
            next = k + 1;
            while (next < sides_.size() && sides_[next].hasSameEnds(sides_[k])) {
                ++next;
            }
            group(std::span(sides_).subspan(k, next - k));
        }
        std::sort(found_.begin(), found_.end(),
                  [](const NeighbourSide &a, const NeighbourSide &b) { return a.dropped.first < b.dropped.first; });
        return std::move(found_);
    }

  private:
    /// Finds for each node whether several loops have it.
    void findShared() {
        std::vector<std::uint32_t> loopOf(domain_.nodes.size(), 0); // number of the first loop, from 1
        shared_.assign(domain_.nodes.size(), false);
        for (std::uint32_t k = 0; k < loops_.size(); ++k) {
            for (std::uint32_t s = loops_[k].first; s < loops_[k].end; ++s) {
                const std::uint32_t node = domain_.segments[s].a;
                shared_[node] = shared_[node] || (loopOf[node] != 0 && loopOf[node] != k + 1);
                loopOf[node] = loopOf[node] == 0 ? k + 1 : loopOf[node];
            }
        }
    }

    /// Returns twice the signed area within the chords of a loop.
    double twiceArea(const SegmentRun &loop) const {
        const Vec2 origin = domain_.nodes[domain_.segments[loop.first].a]; // far from 0, products would lose digits
        double sum = 0.0;
        for (std::uint32_t s = loop.first; s < loop.end; ++s) {
            sum += cross(domain_.nodes[domain_.segments[s].a] - origin, domain_.nodes[domain_.segments[s].b] - origin);
        }
        return sum;
    }

    /// Adds the sides of a loop whose ends are shared.
    void collect(std::uint32_t number) {
        const SegmentRun &loop = loops_[number];
        const bool counterClockwise = twiceArea(loop) > 0.0;
        for (std::uint32_t first = loop.first, end = first; first < loop.end; first = end) {
            end = endOfSide(first, loop.end);
            const std::uint32_t from = domain_.segments[first].a, to = domain_.segments[end - 1].b;
            if (from != to && shared_[from] && shared_[to]) {
                const auto [low, high] = std::minmax(from, to);
                sides_.push_back({low,
                                  high,
                                  number,
                                  {first, end},
                                  counterClockwise == (from == low),
                                  domain_.segments[first].role == SegmentRole::Boundary});
            }
        }
    }

    /// Returns the end of the side of a loop that begins at a segment.
    std::uint32_t endOfSide(std::uint32_t first, std::uint32_t loopEnd) const {
        const CurveStretch &start = domain_.segments[first].stretch;
        std::uint32_t end = first + 1;
        while (start.follows() && end < loopEnd && domain_.segments[end].stretch.curve == start.curve &&
               !shared_[domain_.segments[end].a]) {
            ++end;
        }
        return end;
    }

    Curve curveOf(const LoopSide &side) const {
        const DomainSegment &first = domain_.segments[side.run.first], &last = domain_.segments[side.run.end - 1];
        return first.stretch.follows() ? domain_.curves[first.stretch.curve].part(first.stretch.t0, last.stretch.t1)
                                       : Curve::line(domain_.nodes[first.a], domain_.nodes[first.b]);
    }

    /// Returns true if two sides with the same ends follow the same line.
    bool sameLine(const LoopSide &a, const LoopSide &b) const {
        const auto straight = [&](const LoopSide &side) { return !domain_.segments[side.run.first].stretch.follows(); };
        if (straight(a) && straight(b)) {
            return true;
        }
        constexpr int kSamples = 8; // more than two different cubics with the same ends have in common
        const Curve one = curveOf(a), other = curveOf(b);
        for (int k = 1; k < kSamples; ++k) {
            const Vec2 at = one.point(static_cast<double>(k) / kSamples);
            if (!(distance(other.point(other.nearest(at)), at) <= tolerance_)) {
                return false;
            }
        }
        return true;
    }

    /// Finds which of the sides between two nodes are the same, and which of those stay.
    void group(std::span<const LoopSide> sides) {
        std::vector<bool> taken(sides.size(), false);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            std::vector<LoopSide> same;
            for (std::size_t m = k; !taken[k] && m < sides.size(); ++m) {
                if (!taken[m] && sameLine(sides[k], sides[m])) {
                    same.push_back(sides[m]);
                    taken[m] = m != k;
                }
            }
            join(same);
        }
    }

    /// Joins sides that follow one line.
    void join(std::span<LoopSide> same) {
        const auto regions =
            std::stable_partition(same.begin(), same.end(), [](const LoopSide &s) { return s.boundary; });
        const auto boundaries = static_cast<std::size_t>(regions - same.begin());
        const bool beside = boundaries == 2 && same[0].loop != same[1].loop && same[0].areaToLeft != same[1].areaToLeft;
        if (boundaries > 1 && !beside) {
            return; // even-odd, the domain has no side there, or three areas claim it
        }
        for (std::size_t k = 1; k < same.size(); ++k) {
            found_.push_back({same[0].run, same[k].run, beside});
        }
    }

    const Domain &domain_;
    std::span<const SegmentRun> loops_;
    double tolerance_;
    std::vector<bool> shared_;
    std::vector<LoopSide> sides_;
    std::vector<NeighbourSide> found_;
};

} // namespace

std::vector<NeighbourSide> neighbourSides(const Domain &domain, std::span<const SegmentRun> loops, double tolerance) {
    return SideFinder(domain, loops, tolerance).run();
}

std::vector<std::uint32_t> drawnTwice(const Domain &domain, std::span<const SegmentRun> loops,
                                      std::span<const std::uint32_t> given, double tolerance) {
    std::vector<bool> dropped(domain.segments.size(), false);
    for (const NeighbourSide &side : neighbourSides(domain, loops, tolerance)) {
        std::fill(dropped.begin() + side.dropped.first, dropped.begin() + side.dropped.end, true);
    }
    std::vector<std::uint64_t> ends;
    for (std::size_t s = 0; s < dropped.size(); ++s) {
        const auto [low, high] = std::minmax(domain.segments[s].a, domain.segments[s].b);
        ends.push_back(dropped[s] ? pairKey(kNoIndex, kNoIndex) : pairKey(low, high));
    }
    const auto isPart = [&](std::uint32_t s) {
        return (s > 0 && given[s - 1] == given[s]) || (s + 1 < given.size() && given[s + 1] == given[s]);
    };
    std::vector<std::uint32_t> twice;
    const std::vector<std::uint32_t> order = orderByKeys(ends);
    for (std::size_t k = 1; k < order.size(); ++k) {
        const std::uint32_t s = order[k - 1], next = order[k];
        if (ends[s] == ends[next] && !dropped[s]) {
            for (const std::uint32_t part : {s, next}) {
                if (isPart(part)) {
                    twice.push_back(given[part]);
                }
            }
        }
    }
    return twice;
}

} // namespace forefront
