#include "core/drawing/arrangement/snapping/snap_lines.hpp"

#include "core/drawing/arrangement/snapping/cluster.hpp"
#include "core/drawing/arrangement/snapping/place_table.hpp"
#include "core/drawing/arrangement/snapping/snapper.hpp"
#include "core/engine/base/key_order.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

namespace forefront {

namespace {

/// Limits on joining again with more pins. Where many lines are crowded, new pins only move others off their lines.
constexpr int kMaxAttempts = 8;
constexpr std::size_t kFewPins = 16;  ///< up to so many, attempts go on
constexpr double kMaxPinsLeft = 0.75; ///< share of the pins of the attempt before
/// Factor by which rounding may enlarge a distance.
constexpr double kSlack = 1.0 + 1e-9;

/// Lines, some of them cut at places that must not move.
class PinnedLines {
  public:
    /// No line should end up farther from its path than `limit`. `known`: pins that lines probably need.
    PinnedLines(std::span<const SnapLine> lines, double radius, double limit, std::span<const LinePin> known)
        : lines_(lines), radius_(radius), limit_(limit) {
        std::multimap<Ends, double> parts;
        for (const LinePin &pin : known) {
            parts.emplace(endsOf(pin.line), pin.part);
        }
        for (std::uint32_t i = 0; i < lines_.size() && !parts.empty(); ++i) {
            const auto [first, last] = parts.equal_range(endsOf(ordered(i)));
            std::for_each(first, last, [&](const auto &pin) { pins_.push_back({i, pin.second}); });
        }
        sortPins();
    }

    SnappedLines run(const std::stop_token &stop) {
        SnappedLines result = pins_.empty() ? Snapper(lines_, {}, radius_).run(stop) : runPinned(stop);
        result.displacement = measure(result);
        bool helps = true;
        for (int attempt = 0; result.finished && attempt < kMaxAttempts && helps && keepNewPins(); ++attempt) {
            const std::size_t passes = result.passes, before = found_.size();
            result = runPinned(stop);
            result.passes += passes;
            result.displacement = measure(result);
            helps = found_.size() <= kFewPins ||
                    static_cast<double>(found_.size()) <= kMaxPinsLeft * static_cast<double>(before);
        }
        for (const Pin &pin : pins_) {
            result.pins.push_back({ordered(pin.line), pin.part});
        }
        return result;
    }

  private:
    /// A place on a line, at a fraction of the way from the end that comes first by x, then y.
    struct Pin {
        std::uint32_t line = 0;
        double part = 0.0;
        friend auto operator<=>(const Pin &, const Pin &) = default;
    };

    using Ends = std::array<double, 4>;
    static Ends endsOf(const SnapLine &line) { return {line.a.x, line.a.y, line.b.x, line.b.y}; }

    /// Returns the line from the end that comes first, so that its direction as given does not matter.
    SnapLine ordered(std::uint32_t line) const {
        const SnapLine &given = lines_[line];
        return comesBefore(given.b, given.a) ? SnapLine{given.b, given.a} : given;
    }

    /// Returns the maximum distance between a line and its path, and finds pins for lines where it is beyond the
    /// limit.
    double measure(const SnappedLines &snapped) {
        found_.clear();
        double maximum = 0.0;
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            const SnapLine line = ordered(i);
            std::uint32_t node = snapped.first[i];
            Vec2 worst = snapped.nodes[node];
            double farthest = distance(lines_[i].a, worst);
            for (std::uint32_t k = snapped.starts[i]; k < snapped.starts[i + 1]; ++k) {
                const PlaneEdge &edge = snapped.edges[snapped.ways[k] / 2];
                node = edge.a == node ? edge.b : edge.a;
                const Vec2 p = snapped.nodes[node];
                const bool last = k + 1 == snapped.starts[i + 1];
                const double gap = last ? distance(lines_[i].b, p) : distanceToSegment(line.a, line.b, p);
                if (gap > farthest || (gap == farthest && comesBefore(p, worst))) {
                    farthest = gap;
                    worst = p;
                }
            }
            maximum = std::max(maximum, farthest);
            if (farthest > kSlack * limit_) {
                const Vec2 along = line.b - line.a;
                found_.push_back({i, dot(worst - line.a, along) / lengthSquared(along)});
            }
        }
        return maximum;
    }

    /// Adds the pins found last. Returns false if all of them were known: then joining again would change nothing.
    bool keepNewPins() {
        const std::size_t before = pins_.size();
        pins_.insert(pins_.end(), found_.begin(), found_.end());
        sortPins();
        return pins_.size() > before;
    }

    void sortPins() {
        std::sort(pins_.begin(), pins_.end());
        pins_.erase(std::unique(pins_.begin(), pins_.end()), pins_.end());
    }

    SnappedLines runPinned(const std::stop_token &stop) {
        std::vector<SnapLine> parts;
        std::vector<std::uint8_t> pinned;
        std::vector<std::size_t> partStarts;
        std::size_t next = 0;
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            partStarts.push_back(parts.size());
            const SnapLine line = ordered(i);
            std::vector<Vec2> stations{line.a};
            for (; next < pins_.size() && pins_[next].line == i; ++next) {
                const Vec2 at = lerp(line.a, line.b, pins_[next].part);
                if (pins_[next].part > 0.0 && pins_[next].part < 1.0 && at != stations.back() && at != line.b) {
                    stations.push_back(at);
                }
            }
            stations.push_back(line.b);
            if (line.a != lines_[i].a) {
                std::reverse(stations.begin(), stations.end());
            }
            for (std::size_t k = 1; k < stations.size(); ++k) {
                parts.push_back({stations[k - 1], stations[k]});
                pinned.push_back(k > 1 ? 1 : 0);
            }
        }
        partStarts.push_back(parts.size());
        SnappedLines result = Snapper(parts, pinned, radius_).run(stop);
        std::vector<std::uint32_t> starts, first;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            starts.push_back(result.starts[partStarts[i]]);
            first.push_back(result.first[partStarts[i]]);
        }
        starts.push_back(result.starts.back());
        result.starts = std::move(starts);
        result.first = std::move(first);
        return result;
    }

    std::span<const SnapLine> lines_;
    double radius_, limit_;
    std::vector<Pin> pins_;  ///< sorted
    std::vector<Pin> found_; ///< of the last result, by line
};

} // namespace

double resolutionOf(const Box2 &box) {
    constexpr double kResolution = 4e-15;
    double magnitude = 0.0;
    if (!box.empty()) {
        magnitude = std::max({std::fabs(box.min.x), std::fabs(box.max.x), std::fabs(box.min.y), std::fabs(box.max.y)});
    }
    return std::max(kResolution * magnitude, std::numeric_limits<double>::min());
}

SnappedLines unsnapped(std::span<const SnapLine> lines) {
    SnappedLines result;
    PlaceTable table(2 * lines.size());
    std::unordered_map<std::uint64_t, std::uint32_t> edgeOf; // only looked up
    result.starts.push_back(0);
    for (const SnapLine &line : lines) {
        const std::uint32_t a = table.indexOf(line.a, result.nodes), b = table.indexOf(line.b, result.nodes);
        result.first.push_back(a);
        if (a != b) {
            const auto [entry, added] = edgeOf.try_emplace(pairKey(std::min(a, b), std::max(a, b)),
                                                           static_cast<std::uint32_t>(result.edges.size()));
            if (added) {
                result.edges.push_back({a, b});
            }
            result.ways.push_back(2 * entry->second + (result.edges[entry->second].a == a ? 0U : 1U));
        }
        result.starts.push_back(static_cast<std::uint32_t>(result.ways.size()));
    }
    result.crossing.assign(result.nodes.size(), 0);
    return result;
}

SnappedLines snapLines(std::span<const SnapLine> lines, double tolerance, const std::stop_token &stop) {
    return snapLines(lines, tolerance, SnappedLines(), stop);
}

SnappedLines snapLines(std::span<const SnapLine> lines, double tolerance, const SnappedLines &before,
                       const std::stop_token &stop) {
    SnappedLines result;
    std::span<const LinePin> known = before.pins;
    double radius = before.radius > 0.0 ? before.radius : tolerance;
    for (;;) {
        const std::size_t passes = result.passes;
        result = PinnedLines(lines, radius, tolerance, known).run(stop);
        result.passes += passes;
        result.radius = radius;
        if (!result.finished || result.displacement <= kSlack * tolerance) {
            return result;
        }
        if (known.empty()) {
            radius *= 0.5;
        }
        known = {}; // they may have moved other lines too far
    }
}

} // namespace forefront
