#include "core/drawing/arrangement/repeated_lines/outline_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace forefront {

namespace {

/// Searches one chain for parts that repeat outlines.
class RunSearch {
  public:
    RunSearch(std::span<const ChainEdge> chain, std::span<const BesideEdge> about, const EdgeShapes &shapes,
              const OutlineSearch &outlines)
        : chain_(chain), about_(about), shapes_(shapes), outlines_(outlines) {}

    std::vector<ChainRun> run() {
        takeSamples();
        for (std::size_t first = 0, next = 0; first < samples_.size(); first = next) {
            next = first + 1;
            if (samples_[first].near()) {
                search(first, lastOnOneSide(first, next));
            }
        }
        std::sort(runs_.begin(), runs_.end(), [](const ChainRun &s, const ChainRun &t) {
            return std::pair(s.from.edge, s.from.part) < std::pair(t.from.edge, t.from.part);
        });
        return std::move(runs_);
    }

  private:
    static constexpr double kFar = std::numeric_limits<double>::infinity();
    static constexpr double kAside = 1e-3;   ///< fraction of the reach within which curves count as coinciding
    static constexpr double kSlender = 64.0; ///< parts as long as this for their distance may be short for their reach
    static constexpr double kNodeReach = 0.125; ///< fraction of the reach; parts that end so near a node end there

    struct Sample {
        std::size_t edge = 0;
        double part = 0.0;
        double along = 0.0;     ///< length of the chain up to here
        double distance = kFar; ///< from the outlines
        int side = 0;           ///< 1: outlines are on the left, -1: on the right, 0: undecided
        bool near() const { return distance < kFar; }
    };

    double reach(std::size_t edge) const { return about_[chain_[edge].edge].reach; }
    double length(std::size_t edge) const {
        return distance(shapes_.a(chain_[edge].edge), shapes_.b(chain_[edge].edge));
    }
    Vec2 at(std::size_t edge, double part) const { return shapes_.at(chain_[edge].edge, part, chain_[edge].forward); }

    /// Returns the place on outlines within reach of a place.
    std::optional<Vec2> outlineNear(std::size_t edge, double part) const {
        const Vec2 p = at(edge, part);
        const auto q = outlines_.placeNear(p, reach(edge) + shapes_.deviation(chain_[edge].edge));
        return q && distance(p, *q) <= reach(edge) ? q : std::nullopt;
    }

    void takeSamples() {
        constexpr double kPerReach = 2.0, kMin = 4.0, kMax = 32.0; // per edge
        double along = 0.0;
        for (std::size_t k = 0; k < chain_.size(); ++k) {
            starts_.push_back(along);
            const int count = static_cast<int>(std::clamp(std::ceil(kPerReach * length(k) / reach(k)), kMin, kMax));
            for (int step = k == 0 ? 0 : 1; step <= count; ++step) {
                samples_.push_back(sample(k, static_cast<double>(step) / count));
            }
            along += length(k);
        }
    }

    Sample sample(std::size_t edge, double part) const {
        Sample sample{edge, part, starts_[edge] + part * length(edge), kFar, 0};
        if (const auto q = outlineNear(edge, part)) {
            const Vec2 p = at(edge, part), along = at(edge, 1.0) - at(edge, 0.0);
            const double turn = cross(along, *q - p);
            const bool aside = part > 0.0 && part < 1.0 && std::fabs(turn) > kAside * length(edge) * reach(edge);
            sample.side = !aside ? 0 : turn > 0.0 ? 1 : -1;
            sample.distance = distance(p, *q);
        }
        return sample;
    }

    /// Returns the last sample from one on that is near outlines on the same side. `next`: where to go on; samples
    /// whose side is undecided count for both sides.
    std::size_t lastOnOneSide(std::size_t first, std::size_t &next) const {
        int side = 0;
        std::size_t last = first;
        for (std::size_t k = first; k < samples_.size() && samples_[k].near(); ++k) {
            if (samples_[k].side * side < 0) {
                return last;
            }
            last = k;
            side = side == 0 ? samples_[k].side : side;
            next = samples_[k].side != 0 || side == 0 ? k + 1 : next;
        }
        next = last + 1;
        return last;
    }

    /// Adds the longest part between two samples that is long enough for its distance, or else those on either side of
    /// the place that is farthest away.
    void search(std::size_t first, std::size_t last) {
        std::size_t from = first, to = first, farthest = first;
        for (std::size_t k = first; k <= last; ++k) {
            from = gain(samples_[k], -1.0) > gain(samples_[from], -1.0) ? k : from;
            to = gain(samples_[k], 1.0) >= gain(samples_[to], 1.0) ? k : to;
        }
        if (from >= to) {
            return;
        }
        for (std::size_t k = farthest = from; k <= to; ++k) {
            farthest = samples_[k].distance > samples_[farthest].distance ? k : farthest;
        }
        const double length = samples_[to].along - samples_[from].along, away = samples_[farthest].distance;
        if (length >= std::min(kMinRunToDistance * away + reach(samples_[farthest].edge), kSlender * away)) {
            if (!leadsAcross(from, -1.0) && !leadsAcross(to, 1.0)) {
                add(from, to, samples_[farthest].distance);
            }
            return;
        }
        if (farthest > first) {
            search(first, farthest - 1);
        }
        if (farthest < last) {
            search(farthest + 1, last);
        }
    }

    /// Returns true if a part would go on beyond an end if the next outline were not on the other side.
    bool leadsAcross(std::size_t end, double direction) const {
        const std::size_t beyond = direction > 0.0 ? end + 1 : end - 1; // wraps around
        return beyond < samples_.size() && samples_[beyond].near() &&
               gain(samples_[beyond], direction) > gain(samples_[end], direction);
    }

    /// Returns the gain of a part from ending at a sample: it gets longer, but also farther away from outlines.
    /// `direction`: 1 for its end, -1 for its start.
    static double gain(const Sample &sample, double direction) {
        return direction * sample.along - kMinRunToDistance * sample.distance;
    }

    void add(std::size_t from, std::size_t to, double distance) {
        const OutlinePlace start = refined(from, -1.0), end = refined(to, 1.0);
        if (std::pair(start.edge, start.part) < std::pair(end.edge, end.part)) {
            runs_.push_back({start, end, distance});
        }
    }

    /// Returns the place near a sample where a part ends best.
    OutlinePlace refined(std::size_t index, double direction) const {
        Sample best = samples_[index];
        if (index > 0) {
            best = better(best, index, true, direction);
        }
        if (index + 1 < samples_.size()) {
            best = better(best, index + 1, false, direction);
        }
        for (const double end : {0.0, 1.0}) { // no tiny parts beside nodes
            const Sample node = sample(best.edge, end);
            if (node.near() && std::fabs(node.along - best.along) <= kNodeReach * reach(best.edge)) {
                best = node;
                break;
            }
        }
        const double limit = reach(best.edge) + shapes_.deviation(chain_[best.edge].edge);
        const Vec2 p = at(best.edge, best.part);
        return {best.edge, best.part, outlines_.anchorNear(p, limit).value_or(p)};
    }

    /// Returns the best place between two samples that follow each other if it is better than a known one. `index`: the
    /// later sample; `before`: the known place is near that one.
    Sample better(const Sample &known, std::size_t index, bool before, double direction) const {
        constexpr int kSteps = 80;      // of 2/3: to rounding
        constexpr double kLeast = 1e-3; // fraction of the reach
        const std::size_t edge = samples_[index].edge;
        double low = samples_[index - 1].edge == edge ? samples_[index - 1].part : 0.0, high = samples_[index].part;
        for (int step = 0; step < kSteps; ++step) { // the gain rises up to there, and falls beyond
            const double third = (high - low) / 3.0;
            const Sample s = sample(edge, low + third), t = sample(edge, high - third);
            const bool rises = s.near() || t.near() ? gain(s, direction) < gain(t, direction) : before;
            (rises ? low : high) = rises ? low + third : high - third;
        }
        const Sample found = sample(edge, before ? high : low);
        return gain(found, direction) > gain(known, direction) + kLeast * reach(edge) ? found : known;
    }

    std::span<const ChainEdge> chain_;
    std::span<const BesideEdge> about_;
    const EdgeShapes &shapes_;
    const OutlineSearch &outlines_;
    std::vector<double> starts_; ///< per edge: length of the chain up to it
    std::vector<Sample> samples_;
    std::vector<ChainRun> runs_;
};

} // namespace

std::vector<ChainRun> runsBesideOutlines(std::span<const ChainEdge> chain, std::span<const BesideEdge> about,
                                         const EdgeShapes &shapes, const OutlineSearch &outlines) {
    return RunSearch(chain, about, shapes, outlines).run();
}

} // namespace forefront
