#include "core/spacing/parts/regions/region_part.hpp"

#include "core/base/number_text.hpp"
#include "core/domain/domain_graph.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {
namespace {

/// Part of the maximum area that the equilateral triangle of the spacing has; see spacingForArea().
constexpr double kAreaShare = 0.6;

/// Returns the height of the segment from a to b (a.x < b.x) at x; exact at a.
double heightAt(Vec2 a, Vec2 b, double x) {
    return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x));
}

/// Returns the marker with the smallest maximum area in each face, or kNoIndex.
std::vector<std::uint32_t> tightestMarkers(const Domain &domain, const DomainGraph &graph, const Faces &faces) {
    std::vector<std::uint32_t> markers(faces.count, kNoIndex);
    for (std::uint32_t m = 0; m < graph.regionMarker.size(); ++m) {
        const std::uint32_t point = graph.regionMarker[m];
        const std::uint32_t face = point != kNoIndex ? faces.ofPoint[point] : kNoIndex;
        if (face == kNoIndex || face == 0 || !(domain.regionMarkers[m].maxArea > 0.0)) {
            continue;
        }
        const std::uint32_t known = markers[face];
        if (known == kNoIndex || domain.regionMarkers[m].maxArea < domain.regionMarkers[known].maxArea) {
            markers[face] = m;
        }
    }
    return markers;
}

} // namespace

double spacingForArea(double maxArea) {
    return std::sqrt(kAreaShare * maxArea * 4.0 / std::sqrt(3.0));
}

std::optional<RegionPart> RegionPart::build(const Domain &domain, double minimum) {
    const bool limited = std::any_of(domain.regionMarkers.begin(), domain.regionMarkers.end(),
                                     [](const RegionMarker &marker) { return marker.maxArea > 0.0; });
    if (!limited) {
        return std::nullopt;
    }
    const DomainGraph graph = graphOf(domain);
    const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
    if (sweep.droppedCount > 0) {
        return std::nullopt;
    }
    const Faces faces = findFaces(graph.points, graph.edges, sweep);
    const std::vector<std::uint32_t> markers = tightestMarkers(domain, graph, faces);
    RegionPart part;
    std::vector<std::uint32_t> limitOf(faces.count, kNoIndex);
    for (std::uint32_t face = 0; face < faces.count; ++face) {
        if (markers[face] != kNoIndex) {
            limitOf[face] = static_cast<std::uint32_t>(part.limits_.size());
            const double area = domain.regionMarkers[markers[face]].maxArea;
            part.limits_.push_back({std::max(spacingForArea(area), minimum), area, markers[face]});
            part.minimum_ = std::min(part.minimum_, part.limits_.back().size);
        }
    }
    std::vector<Box2> boxes;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        Wall wall{graph.points[graph.edges[e].a], graph.points[graph.edges[e].b], limitOf[faces.left[e]],
                  limitOf[faces.right[e]]};
        if (wall.above == wall.below) {
            continue;
        }
        if (wall.b.x < wall.a.x) {
            std::swap(wall.a, wall.b);
            std::swap(wall.above, wall.below);
        }
        part.walls_.push_back(wall);
        boxes.push_back(boxOf(wall.a, wall.b));
    }
    if (part.walls_.empty()) {
        return std::nullopt; // all markers lie outside
    }
    part.tree_ = BoxTree(boxes);
    return part;
}

/// Follows a ray from p upwards to the first wall, whose lower side is the face of p.
std::uint32_t RegionPart::faceAt(Vec2 p) const {
    const Wall *first = nullptr;
    double height = std::numeric_limits<double>::infinity();
    const auto meets = [&](const Box2 &box) {
        return box.min.x <= p.x && p.x <= box.max.x && box.max.y >= p.y && box.min.y <= height;
    };
    tree_.search(meets, [&](std::uint32_t item) {
        const Wall &wall = walls_[item];
        if (!(wall.a.x <= p.x && p.x < wall.b.x)) { // half-open, so that a chain of walls is met once
            return true;
        }
        const double y = heightAt(wall.a, wall.b, p.x);
        // Walls that meet the ray in their common left end are distinguished by their slopes.
        const bool lower =
            y < height || (first != nullptr && y == height && cross(wall.b - wall.a, first->b - first->a) > 0.0);
        if (y >= p.y && lower) {
            first = &wall;
            height = y;
        }
        return true;
    });
    return first != nullptr ? first->below : kNoIndex;
}

SpacingSample RegionPart::sample(Vec2 p, const SiteWords &words) const {
    const Limit &limit = limits_[faceAt(p)];
    return {limit.size, SpacingOrigin::Region, limit.marker,
            "maximum area " + numberText(limit.area, 4) + " of region '" + words.regions[limit.marker] + "'"};
}

void RegionPart::addSites(double gradation, SiteSet &sites) const {
    for (const Wall &wall : walls_) {
        const bool fromAbove =
            wall.below == kNoIndex || (wall.above != kNoIndex && limits_[wall.above].size < limits_[wall.below].size);
        const Limit &limit = limits_[fromAbove ? wall.above : wall.below];
        sites.add(SizeSite::segment(wall.a, wall.b, limit.size, gradation),
                  {SpacingOrigin::Region, SiteReason::RegionEdge, limit.marker});
    }
}

} // namespace forefront
