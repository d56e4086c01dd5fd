#include "core/engine/boundary/graded_nodes.hpp"

#include "core/engine/domain/inside_test.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace forefront {

namespace {

// Distances from other nodes and from segments, in sizes. A node over the middle of a segment then makes a triangle
// with angles of 27 degrees at its base.
constexpr double kFromNodes = 0.9;
constexpr double kFromSegments = 0.9;
constexpr double kFineness = 1.0 / 6.0; ///< distance of the places tried, in sizes
constexpr std::size_t kMaxPlaces = 20'000;

/// A place for a node.
struct Place {
    Vec2 at;
    double size;
    int sizeClass;  ///< lower: larger
    double farness; ///< distance from the nodes of the boundary

    auto order() const { return std::tuple(sizeClass, -farness, at.x, at.y); }
};

/// Finds places for nodes in squares that divide until they are fine enough for the size.
class GradedPlacer {
  public:
    GradedPlacer(const KeptField &spacing, const DomainFaces &faces, const DiscreteDomain &boundary)
        : spacing_(spacing), inside_(faces), boundary_(boundary), segments_(treeOf(boundary)) {}

    /// Returns the nodes; none if that takes too many places.
    std::vector<Vec2> run() {
        const Box2 box = boundary_.bounds();
        divide(box.centre(), 0.5 * std::max(box.size().x, box.size().y), 0);
        if (places_.size() > kMaxPlaces) {
            return {};
        }
        std::sort(places_.begin(), places_.end(), [](const Place &a, const Place &b) { return a.order() < b.order(); });
        std::vector<Vec2> nodes;
        for (const Place &place : places_) {
            const double apart = kFromNodes * place.size;
            if (std::none_of(nodes.begin(), nodes.end(), [&](Vec2 p) { return distance(p, place.at) < apart; })) {
                nodes.push_back(place.at);
            }
        }
        return nodes;
    }

  private:
    static BoxTree treeOf(const DiscreteDomain &boundary) {
        std::vector<Box2> boxes;
        for (const DiscreteSegment &segment : boundary.segments) {
            boxes.push_back(boxOf(boundary.nodes[segment.a], boundary.nodes[segment.b]));
        }
        return BoxTree(boxes);
    }

    void divide(Vec2 centre, double half, int depth) {
        constexpr int kMaxDepth = 20;
        const double size = spacing_.at(centre), asked = spacing_.asked(centre);
        const double reach = 1.5 * half; // more than half a diagonal
        if (places_.size() > kMaxPlaces || !(size + KeptField::kSteepestFall * reach > asked)) {
            return;
        }
        if (2.0 * half > kFineness * size && depth < kMaxDepth) {
            const double quarter = 0.5 * half;
            for (const Vec2 corner :
                 {Vec2{-quarter, -quarter}, Vec2{quarter, -quarter}, Vec2{-quarter, quarter}, Vec2{quarter, quarter}}) {
                divide(centre + corner, quarter, depth + 1);
            }
        } else if (size > asked) {
            tryPlace(centre, size);
        }
    }

    void tryPlace(Vec2 at, double size) {
        if (!inside_.contains(at)) {
            return;
        }
        bool free = true;
        segments_.query(boxAround(at, kFromSegments * size), [&](std::uint32_t s) {
            const DiscreteSegment &segment = boundary_.segments[s];
            free = free && distanceToSegment(boundary_.nodes[segment.a], boundary_.nodes[segment.b], at) >=
                               kFromSegments * size;
        });
        double farness = std::numeric_limits<double>::infinity();
        for (const Vec2 node : boundary_.nodes) {
            farness = std::min(farness, distance(node, at));
        }
        if (free && farness >= kFromNodes * size) {
            constexpr double kClassesPerOctave = 3.0;
            places_.push_back({at, size, -static_cast<int>(std::floor(kClassesPerOctave * std::log2(size))), farness});
        }
    }

    const KeptField &spacing_;
    const InsideTest inside_;
    const DiscreteDomain &boundary_;
    const BoxTree segments_;
    std::vector<Place> places_;
};

} // namespace

void addGradedNodes(const KeptField &spacing, const DomainFaces &faces, DiscreteDomain &boundary) {
    constexpr std::size_t kFewSegments = 2000; // with more, elements beside them are small anyway
    if (spacing.crowded().empty() || boundary.segments.size() > kFewSegments) {
        return;
    }
    for (const Vec2 at : GradedPlacer(spacing, faces, boundary).run()) {
        ConstraintPoint point;
        point.node = static_cast<std::uint32_t>(boundary.nodes.size());
        boundary.nodes.push_back(at);
        boundary.points.push_back(point);
        ++boundary.gradedNodes;
    }
}

} // namespace forefront
