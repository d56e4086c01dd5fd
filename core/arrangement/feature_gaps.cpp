#include "core/arrangement/feature_gaps.hpp"

#include "core/base/ids.hpp"
#include "core/geometry/box_tree.hpp"
#include "core/geometry/polygon.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace forefront {

namespace {

/// Where features meet, the gap between them begins with a corner, which is narrow beside this many widths.
constexpr double kCorner = 8.0;
constexpr double kFar = std::numeric_limits<double>::infinity();

class GapsBetweenFeatures {
  public:
    GapsBetweenFeatures(const Domain &domain, std::span<const std::uint32_t> features)
        : domain_(domain), features_(features), nodeFeature_(domain.nodes.size(), kNoIndex),
          nodeSegment_(domain.nodes.size(), kNoIndex) {
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            if (domain.segments[s].role == SegmentRole::Boundary) {
                walls_.push_back(s);
                for (const std::uint32_t node : {domain.segments[s].a, domain.segments[s].b}) {
                    std::uint32_t &feature = nodeFeature_[node];
                    feature = nodeSegment_[node] == kNoIndex || feature == features[s] ? features[s] : kSeveral;
                    nodeSegment_[node] = nodeSegment_[node] == kNoIndex ? s : nodeSegment_[node];
                }
            }
        }
    }

    FeatureGaps find(double limit) const {
        std::vector<Box2> boxes;
        for (const std::uint32_t s : walls_) {
            boxes.push_back(boxOf(domain_.nodes[domain_.segments[s].a], domain_.nodes[domain_.segments[s].b]));
        }
        std::vector<Box2> meetings;
        for (std::uint32_t node = 0; node < domain_.nodes.size(); ++node) {
            if (nodeFeature_[node] == kSeveral) {
                meetings.push_back(boxAround(domain_.nodes[node], 0.0));
            }
        }
        const BoxTree walls(boxes), ends(meetings);
        FeatureGaps gaps;
        for (std::uint32_t node = 0; node < domain_.nodes.size(); ++node) {
            if (nodeSegment_[node] == kNoIndex || nodeFeature_[node] == kSeveral) {
                continue;
            }
            double width = limit;
            const auto toWall = [&](std::uint32_t item) { return distanceTo(walls_[item], node); };
            if (walls.nearest(domain_.nodes[node], width, toWall) == kNoIndex) {
                continue;
            }
            double toEnd = kCorner * width;
            const auto toMeeting = [&](std::uint32_t item) {
                return distance(meetings[item].min, domain_.nodes[node]);
            };
            if (ends.nearest(domain_.nodes[node], toEnd, toMeeting) == kNoIndex) {
                add(gaps, node, width);
            }
        }
        return gaps;
    }

  private:
    static constexpr std::uint32_t kSeveral = kNoIndex - 1;

    /// Returns the distance of a node from a segment of another feature.
    double distanceTo(std::uint32_t segment, std::uint32_t node) const {
        const DomainSegment &wall = domain_.segments[segment];
        return features_[segment] == nodeFeature_[node] || features_[segment] == kNoIndex
                   ? kFar
                   : distanceToSegment(domain_.nodes[wall.a], domain_.nodes[wall.b], domain_.nodes[node]);
    }

    void add(FeatureGaps &gaps, std::uint32_t node, double width) const {
        if (gaps.count++ == 0) {
            gaps.first = domain_.nodes[node];
            gaps.segment = nodeSegment_[node];
        }
        gaps.widest = std::max(gaps.widest, width);
    }

    const Domain &domain_;
    std::span<const std::uint32_t> features_;
    std::vector<std::uint32_t> walls_;       ///< segments of the boundary
    std::vector<std::uint32_t> nodeFeature_; ///< per node: that of its boundary segments, or kSeveral
    std::vector<std::uint32_t> nodeSegment_; ///< per node: one of its boundary segments, or kNoIndex
};

} // namespace

FeatureGaps findFeatureGaps(const Domain &domain, std::span<const std::uint32_t> features, double limit) {
    return GapsBetweenFeatures(domain, features).find(limit);
}

} // namespace forefront
