#include "core/drawing/arrangement/assembly/feature_gaps.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Where features meet, the gap between them begins with a corner, which is narrow beside this many widths.
constexpr double kCorner = 8.0;
/// A gap narrower than this fraction of the segments beside it is hardly meant, even where it is wider than the limit.
constexpr double kSlender = 0.01;
constexpr double kWider = 10.0; ///< limit for such gaps
constexpr double kFar = std::numeric_limits<double>::infinity();

class GapsBetweenFeatures {
  public:
    GapsBetweenFeatures(const Domain &domain, std::span<const std::uint32_t> features)
        : domain_(domain), features_(features), nodeFeature_(domain.nodes.size(), kNoIndex),
          nodeSegment_(domain.nodes.size(), kNoIndex), shortest_(domain.nodes.size(), kFar) {
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            if (domain.segments[s].role == SegmentRole::Boundary) {
                walls_.push_back(s);
                const double size = sizeOf(s);
                for (const std::uint32_t node : {domain.segments[s].a, domain.segments[s].b}) {
                    std::uint32_t &feature = nodeFeature_[node];
                    feature = nodeSegment_[node] == kNoIndex || feature == features[s] ? features[s] : kSeveral;
                    nodeSegment_[node] = nodeSegment_[node] == kNoIndex ? s : nodeSegment_[node];
                    shortest_[node] = std::min(shortest_[node], size);
                }
            }
        }
        for (std::uint32_t node = 0; node < domain.nodes.size(); ++node) {
            if (nodeFeature_[node] == kSeveral) {
                meetings_.push_back(domain.nodes[node]);
            }
        }
    }

    FeatureGaps find(double limit) const {
        std::vector<Box2> boxes;
        for (const std::uint32_t s : walls_) {
            boxes.push_back(boxOf(domain_.nodes[domain_.segments[s].a], domain_.nodes[domain_.segments[s].b]));
        }
        std::vector<Box2> meetings;
        for (const Vec2 place : meetings_) {
            meetings.push_back(boxAround(place, 0.0));
        }
        const BoxTree walls(boxes), ends(meetings);
        FeatureGaps gaps;
        for (std::uint32_t node = 0; node < domain_.nodes.size(); ++node) {
            if (nodeSegment_[node] == kNoIndex || nodeFeature_[node] == kSeveral) {
                continue;
            }
            const Probe probe{domain_.nodes[node], nodeFeature_[node], nodeSegment_[node],
                              std::max(limit, std::min(kWider * limit, kSlender * shortest_[node]))};
            if (const auto wall = nearestTo(probe, walls, ends)) {
                add(gaps, probe, wall->width);
            }
        }
        for (const std::uint32_t s : walls_) { // between nodes where features meet
            const auto [a, b] = endsOf(s);
            if (nodeFeature_[a] == kSeveral && nodeFeature_[b] == kSeveral) {
                addBetween(gaps, s, std::min(kWider * limit, kSlender * sizeOf(s)), walls, ends);
            }
        }
        return gaps;
    }

  private:
    static constexpr std::uint32_t kSeveral = kNoIndex - 1;

    /// A place on the boundary from which the nearest other feature is looked for.
    struct Probe {
        Vec2 at;
        std::uint32_t feature = kNoIndex, segment = kNoIndex;
        double limit = 0.0; ///< maximum distance
    };
    struct Wall {
        std::uint32_t segment = kNoIndex;
        double width = 0.0; ///< distance from the probe
    };

    /// Returns the nearest segment of another feature, unless the gap ends close by.
    std::optional<Wall> nearestTo(const Probe &probe, const BoxTree &walls, const BoxTree &ends) const {
        double width = probe.limit;
        const std::uint32_t found = walls.nearest(probe.at, width, [&](std::uint32_t item) {
            const std::uint32_t feature = features_[walls_[item]];
            return feature == probe.feature || feature == kNoIndex ? kFar : distanceTo(walls_[item], probe.at);
        });
        if (found == kNoIndex) {
            return std::nullopt;
        }
        double toEnd = kCorner * width;
        const auto toMeeting = [&](std::uint32_t item) { return distance(meetings_[item], probe.at); };
        const bool ending = ends.nearest(probe.at, toEnd, toMeeting) != kNoIndex;
        return ending ? std::nullopt : std::optional(Wall{walls_[found], width});
    }

    /// Adds the gap beside the middle of a segment, with the width that it has at the ends if it reaches that far.
    void addBetween(FeatureGaps &gaps, std::uint32_t segment, double limit, const BoxTree &walls,
                    const BoxTree &ends) const {
        const auto [a, b] = endsOf(segment);
        const Probe probe{midpoint(domain_.nodes[a], domain_.nodes[b]), features_[segment], segment, limit};
        const auto wall = nearestTo(probe, walls, ends);
        if (!wall) {
            return;
        }
        double width = wall->width;
        for (const std::uint32_t end : {a, b}) {
            double gap = limit;
            const std::uint32_t found = walls.nearest(domain_.nodes[end], gap, [&](std::uint32_t item) {
                return features_[walls_[item]] == features_[wall->segment]
                           ? distanceTo(walls_[item], domain_.nodes[end])
                           : kFar;
            });
            width = found == kNoIndex ? width : std::max(width, gap);
        }
        add(gaps, probe, width);
    }

    std::pair<std::uint32_t, std::uint32_t> endsOf(std::uint32_t segment) const {
        return {domain_.segments[segment].a, domain_.segments[segment].b};
    }
    double distanceTo(std::uint32_t segment, Vec2 p) const {
        const auto [a, b] = endsOf(segment);
        return distanceToSegment(domain_.nodes[a], domain_.nodes[b], p);
    }
    double sizeOf(std::uint32_t segment) const {
        const auto [a, b] = endsOf(segment);
        return distance(domain_.nodes[a], domain_.nodes[b]);
    }

    void add(FeatureGaps &gaps, const Probe &probe, double width) const {
        if (gaps.count++ == 0) {
            gaps.first = probe.at;
            gaps.segment = probe.segment;
        }
        gaps.widest = std::max(gaps.widest, width);
    }

    const Domain &domain_;
    std::span<const std::uint32_t> features_;
    std::vector<std::uint32_t> walls_;       ///< segments of the boundary
    std::vector<std::uint32_t> nodeFeature_; ///< per node: that of its boundary segments, or kSeveral
    std::vector<std::uint32_t> nodeSegment_; ///< per node: one of its boundary segments, or kNoIndex
    std::vector<double> shortest_;           ///< per node: the length of its shortest boundary segment
    std::vector<Vec2> meetings_;             ///< nodes where features meet
};

} // namespace

FeatureGaps findFeatureGaps(const Domain &domain, std::span<const std::uint32_t> features, double limit) {
    return GapsBetweenFeatures(domain, features).find(limit);
}

} // namespace forefront
