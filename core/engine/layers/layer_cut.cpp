#include "core/engine/layers/layer_cut.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/boundary/spacing_integral.hpp"
#include "core/engine/layers/layer_outline.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace forefront {

namespace {

constexpr double kMaxPieces = 1e7; ///< of one segment
constexpr double kAlike = 1e-6;    ///< distance of the nodes of layers from images of others, relative to their height

/// A segment of the domain along which rays slide: its edges in the discretised boundary, and its nodes in order.
struct SlidSegment {
    std::vector<std::uint32_t> edges; ///< in order from its start
    std::uint32_t start = 0, end = 0; ///< nodes of the given boundary
    LayerRay *fromStart = nullptr;    ///< null: none slides from there
    LayerRay *fromEnd = nullptr;
};

class BoundaryCut {
  public:
    BoundaryCut(const DiscreteDomain &given, std::span<const LayerHeights> heights, const SpacingField &spacing,
                const PeriodicSides *periodic, std::vector<RayChain> &chains, const Progress &progress)
        : given_(given), heights_(heights), spacing_(spacing), periodic_(periodic), chains_(chains),
          progress_(progress) {
        for (const auto &[source, rays] : slidingRays(chains)) {
            slid_[source];
        }
        for (std::uint32_t s = 0; s < given.segments.size(); ++s) {
            if (const auto found = slid_.find(given.segments[s].source); found != slid_.end()) {
                found->second.edges.push_back(s);
            }
        }
        for (const auto &[source, rays] : slidingRays(chains)) {
            arrange(slid_[source], rays);
        }
    }

    Result<CutBoundary> make() {
        CutBoundary result;
        result.domain = given_;
        DiscreteDomain &cut = result.domain;
        keepNodes(cut);
        cut.segments.clear();
        cut.stretches.clear();
        newSegment_.assign(given_.segments.size(), kNoIndex);
        for (std::uint32_t s = 0; s < given_.segments.size(); ++s) {
            const auto slid = slid_.find(given_.segments[s].source);
            if (slid == slid_.end()) {
                newSegment_[s] = static_cast<std::uint32_t>(cut.segments.size());
                add(s, newNode_[given_.segments[s].a], newNode_[given_.segments[s].b], false, result);
            } else if (s == slid->second.edges.front()) {
                if (Diagnostics faults = divide(slid->first, slid->second, result); !faults.empty()) {
                    return faults;
                }
            }
        }
        renumber();
        return result;
    }

  private:
    void arrange(SlidSegment &segment, const std::vector<SlidingRay> &rays) {
        std::map<std::uint32_t, int> uses;
        for (const std::uint32_t s : segment.edges) {
            ++uses[given_.segments[s].a];
            ++uses[given_.segments[s].b];
        }
        for (const std::uint32_t s : segment.edges) {
            if (uses[given_.segments[s].a] == 1) {
                segment.start = given_.segments[s].a;
            }
            if (uses[given_.segments[s].b] == 1) {
                segment.end = given_.segments[s].b;
            }
        }
        const Vec2 start = given_.nodes[segment.start];
        std::sort(segment.edges.begin(), segment.edges.end(), [&](std::uint32_t s, std::uint32_t t) {
            return distanceSquared(start, given_.nodes[given_.segments[s].a]) <
                   distanceSquared(start, given_.nodes[given_.segments[t].a]);
        });
        for (const SlidingRay &ray : rays) {
            (ray.node == segment.start ? segment.fromStart : segment.fromEnd) = &chains_[ray.chain].rays[ray.ray];
        }
    }

    /// Keeps all nodes but those inside segments that are divided anew.
    void keepNodes(DiscreteDomain &cut) {
        newNode_.assign(given_.nodes.size(), 0);
        for (const auto &[source, segment] : slid_) {
            for (const std::uint32_t s : segment.edges) {
                for (const std::uint32_t node : {given_.segments[s].a, given_.segments[s].b}) {
                    newNode_[node] = node == segment.start || node == segment.end ? newNode_[node] : kNoIndex;
                }
            }
        }
        cut.nodes.clear();
        for (std::size_t n = 0; n < newNode_.size(); ++n) {
            if (newNode_[n] != kNoIndex) {
                newNode_[n] = static_cast<std::uint32_t>(cut.nodes.size());
                cut.nodes.push_back(given_.nodes[n]);
            }
        }
        for (ConstraintPoint &point : cut.points) {
            point.node = newNode_[point.node];
        }
    }

    void add(std::uint32_t like, std::uint32_t a, std::uint32_t b, bool besideLayers, CutBoundary &result) const {
        DiscreteSegment segment = given_.segments[like];
        segment.a = a;
        segment.b = b;
        result.domain.segments.push_back(segment);
        if (!given_.stretches.empty()) {
            result.domain.stretches.push_back(given_.stretches[like]);
        }
        result.besideLayers.push_back(besideLayers ? 1 : 0);
    }

    Vec2 topOf(const LayerRay *ray, std::uint32_t end) const {
        return ray != nullptr ? placeOn(*ray, ray->count, heights_) : given_.nodes[end];
    }

    /// The places of the nodes inside a segment.
    struct Places {
        std::vector<Vec2> low, middle, high; ///< from its start; beyond; from its end
    };

    std::vector<Vec2> placesOn(const LayerRay *ray) const {
        std::vector<Vec2> places;
        for (std::uint32_t k = 1; ray != nullptr && k <= ray->count; ++k) {
            places.push_back(placeOn(*ray, k, heights_));
        }
        return places;
    }

    /// Divides a segment by its layers and the spacing.
    Diagnostics place(const SlidSegment &segment, Places &places) {
        const Vec2 from = topOf(segment.fromStart, segment.start), to = topOf(segment.fromEnd, segment.end);
        std::vector<double> fractions;
        using Outcome = SpacingIntegral::Outcome;
        const Outcome outcome = integral_.integrate(spacing_, from, to, spacing_.at(from), spacing_.at(to),
                                                    distance(from, to) / 8.0, kMaxPieces, progress_);
        if (outcome == Outcome::Cancelled) {
            return cancelled("meshing");
        }
        if (outcome != Outcome::Done) {
            return error("too-many-nodes", "a segment beside boundary layers needs more than 10000000 nodes",
                         "choose a larger element size");
        }
        integral_.cut(static_cast<std::uint32_t>(integral_.pieces()), fractions);
        places.low = placesOn(segment.fromStart);
        places.high = placesOn(segment.fromEnd);
        for (const double t : fractions) {
            places.middle.push_back(lerp(from, to, t));
        }
        return {};
    }

    /// Divides a segment of a second periodic part by the images of the nodes of its first one.
    Diagnostics placeImages(std::uint32_t source, const SlidSegment &segment, Places &places) {
        const PeriodicMate &mate = periodic_->mates[source];
        const SlidSegment &first = slid_.at(mate.segment); // layers end along both or none
        if (Diagnostics faults = place(first, places); !faults.empty()) {
            return faults;
        }
        const RigidMap &map = periodic_->links[mate.link].map;
        for (std::vector<Vec2> *const list : {&places.low, &places.middle, &places.high}) {
            std::ranges::transform(*list, list->begin(), map);
        }
        const Vec2 start = map(given_.nodes[first.start]);
        if (distance(start, given_.nodes[segment.start]) > distance(start, given_.nodes[segment.end])) {
            std::swap(places.low, places.high);
            std::ranges::reverse(places.middle);
        }
        for (const auto &[ray, images] :
             {std::pair(segment.fromStart, &places.low), std::pair(segment.fromEnd, &places.high)}) {
            const std::vector<Vec2> own = placesOn(ray);
            const double height = own.empty() ? 0.0 : distance(own.back(), ray->base);
            if (!std::ranges::equal(own, *images, [&](Vec2 p, Vec2 q) { return distance(p, q) <= kAlike * height; })) {
                Diagnostics faults =
                    error("periodic-layers", "boundary layers of different heights end at images of periodic parts",
                          "give the parts on which they lie the same layers");
                faults.front().at = ray != nullptr ? ray->base : given_.nodes[segment.start];
                return faults;
            }
        }
        return {};
    }

    /// Adds nodes and returns their numbers.
    static std::vector<std::uint32_t> addNodes(const std::vector<Vec2> &places, std::vector<Vec2> &nodes) {
        std::vector<std::uint32_t> numbers;
        for (const Vec2 p : places) {
            numbers.push_back(static_cast<std::uint32_t>(nodes.size()));
            nodes.push_back(p);
        }
        return numbers;
    }

    Diagnostics divide(std::uint32_t source, const SlidSegment &segment, CutBoundary &result) {
        Places places;
        const bool image = periodic_ != nullptr && periodic_->ties(source) && periodic_->mates[source].follows;
        if (Diagnostics faults = image ? placeImages(source, segment, places) : place(segment, places);
            !faults.empty()) {
            return faults;
        }
        std::vector<Vec2> &nodes = result.domain.nodes;
        std::vector<std::uint32_t> numbers{newNode_[segment.start]};
        const std::vector<std::uint32_t> low = addNodes(places.low, nodes), middle = addNodes(places.middle, nodes),
                                         high = addNodes(places.high, nodes);
        numbers.insert(numbers.end(), low.begin(), low.end());
        numbers.insert(numbers.end(), middle.begin(), middle.end());
        numbers.insert(numbers.end(), high.rbegin(), high.rend());
        numbers.push_back(newNode_[segment.end]);
        for (const auto &[ray, own] : {std::pair(segment.fromStart, &low), std::pair(segment.fromEnd, &high)}) {
            if (!own->empty()) {
                ray->slidNode = own->front();
            }
        }
        for (std::size_t i = 0; i + 1 < numbers.size(); ++i) {
            const bool besideLayers = i < low.size() || i + 1 >= numbers.size() - high.size();
            add(segment.edges.front(), numbers[i], numbers[i + 1], besideLayers, result);
        }
        return {};
    }

    void renumber() {
        for (RayChain &chain : chains_) {
            for (LayerRay &ray : chain.rays) {
                ray.node = newNode_[ray.node];
            }
            for (WallEdge &edge : chain.columns) {
                edge.a = newNode_[edge.a];
                edge.b = newNode_[edge.b];
                edge.segment = newSegment_[edge.segment];
            }
        }
    }

    const DiscreteDomain &given_;
    std::span<const LayerHeights> heights_;
    const SpacingField &spacing_;
    const PeriodicSides *periodic_; ///< null: none
    std::vector<RayChain> &chains_;
    const Progress &progress_;
    std::map<std::uint32_t, SlidSegment> slid_; ///< by index of the domain's segment
    std::vector<std::uint32_t> newNode_;        ///< per given node; kNoIndex: dropped
    std::vector<std::uint32_t> newSegment_;     ///< per given segment that is not divided anew
    SpacingIntegral integral_;
};

} // namespace

Result<CutBoundary> cutWhereSliding(const DiscreteDomain &boundary, std::span<const LayerHeights> heights,
                                    const SpacingField &spacing, const PeriodicSides *periodic,
                                    std::vector<RayChain> &chains, const Progress &progress) {
    return BoundaryCut(boundary, heights, spacing, periodic, chains, progress).make();
}

} // namespace forefront
