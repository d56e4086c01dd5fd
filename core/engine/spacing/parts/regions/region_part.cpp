#include "core/engine/spacing/parts/regions/region_part.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {
namespace {

/// Parts of the maximum area that the equilateral triangle and the square of the spacing have; see spacingForArea().
constexpr double kTriangleShare = 0.55, kQuadShare = 0.48;

/// Returns the height of the segment from a to b (a.x < b.x) at x; exact at a.
double heightAt(Vec2 a, Vec2 b, double x) {
    return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x));
}

/// Returns the face of each region size, or kNoIndex outside all bounded faces.
std::vector<std::uint32_t> facesOfPlaces(const DomainFaces &found) {
    std::vector<std::uint32_t> list;
    for (const std::uint32_t point : found.graph.place) {
        const std::uint32_t face = point != kNoIndex ? found.faces.ofPoint[point] : kNoIndex;
        list.push_back(face == 0 ? kNoIndex : face);
    }
    return list;
}

bool limitsSpacing(const RegionSize &region) {
    return region.maxArea > 0.0 || region.size > 0.0;
}

} // namespace

double spacingForArea(double maxArea, bool quads) {
    return std::sqrt(quads ? kQuadShare * maxArea : kTriangleShare * maxArea * 4.0 / std::sqrt(3.0));
}

double largestRegionSize(std::span<const RegionSize> regions) {
    double largest = 0.0;
    for (const RegionSize &region : regions) {
        largest = std::max({largest, region.size, spacingForArea(region.maxArea)});
    }
    return largest;
}

std::vector<Vec2> placesOf(std::span<const RegionSize> regions) {
    std::vector<Vec2> places;
    for (const RegionSize &region : regions) {
        places.push_back(region.at);
    }
    return places;
}

std::vector<std::string> namesOf(std::span<const RegionSize> regions, const Domain &domain, const LazyFaces &faces) {
    const DomainFaces *const found = faces.get();
    const std::vector<std::uint32_t> faceOf = found != nullptr ? facesOfPlaces(*found) : std::vector<std::uint32_t>();
    std::vector<std::string> names;
    for (std::size_t k = 0; k < regions.size(); ++k) {
        std::int32_t tag = 1;
        if (const std::uint32_t marker = regionMarkerAt(domain, regions[k].at, k); marker != kNoIndex) {
            tag = domain.regionMarkers[marker].tag;
        } else if (k < faceOf.size() && faceOf[k] != kNoIndex) {
            tag = found->labels.tag[faceOf[k]];
        }
        names.push_back(regionName(domain.regionNames, tag));
    }
    return names;
}

/// Collects the limits of the faces from the sizes in them. Returns the limit of each face, or kNoIndex.
std::vector<std::uint32_t> RegionPart::takeLimits(std::span<const RegionSize> regions, const DomainFaces &found,
                                                  const QuadRegions &quads) {
    const std::vector<std::uint32_t> faceOfRegion = facesOfPlaces(found);
    const std::size_t faces = found.faces.count;
    std::vector<Limit> limitOfFace(faces);
    for (std::uint32_t r = 0; r < regions.size(); ++r) {
        const RegionSize &region = regions[r];
        if (faceOfRegion[r] == kNoIndex) {
            continue;
        }
        Limit &limit = limitOfFace[faceOfRegion[r]];
        const double forArea = spacingForArea(region.maxArea, quads.has(found.labels.tag[faceOfRegion[r]]));
        if (region.maxArea > 0.0 && forArea < limit.area.size) {
            limit.area = {forArea, region.maxArea, limit.area.growth, r};
        }
        if (region.size > 0.0 && region.size < limit.size.size) {
            limit.size = {region.size, region.size, region.growth, r};
        }
    }
    std::vector<std::uint32_t> limitOf(faces, kNoIndex);
    for (std::uint32_t face = 0; face < faces; ++face) {
        Limit &limit = limitOfFace[face];
        limit.least = std::max(std::min(limit.size.size, limit.area.size), raised_);
        if (limit.least < std::numeric_limits<double>::infinity()) {
            limitOf[face] = static_cast<std::uint32_t>(limits_.size());
            limits_.push_back(limit);
            minimum_ = std::min(minimum_, limit.least);
            largest_ = std::max(largest_, limit.least);
        }
    }
    return limitOf;
}

std::optional<RegionPart> RegionPart::build(std::span<const RegionSize> regions, const LazyFaces &lazy, double minimum,
                                            const QuadRegions &quads) {
    if (std::none_of(regions.begin(), regions.end(), limitsSpacing)) {
        return std::nullopt;
    }
    const DomainFaces *const found = lazy.get();
    if (found == nullptr) {
        return std::nullopt;
    }
    const auto &[graph, sweep, faces, labels] = *found;
    FOREFRONT_ASSERT(graph.place.size() == regions.size());
    RegionPart part;
    part.raised_ = minimum;
    const std::vector<std::uint32_t> limitOf = part.takeLimits(regions, *found, quads);
    std::vector<Box2> boxes;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        Wall wall{graph.points[graph.edges[e].a], graph.points[graph.edges[e].b], limitOf[faces.left[e]],
                  limitOf[faces.right[e]]};
        if (wall.above == wall.below) {
            continue;
        }
        const auto isOpen = [&inside = labels.inside, &limitOf](std::uint32_t face) {
            return inside[face] != 0 && limitOf[face] == kNoIndex;
        };
        wall.open = isOpen(faces.left[e]) || isOpen(faces.right[e]);
        if (wall.b.x < wall.a.x) {
            std::swap(wall.a, wall.b);
            std::swap(wall.above, wall.below);
        }
        part.walls_.push_back(wall);
        boxes.push_back(boxOf(wall.a, wall.b));
    }
    if (part.walls_.empty()) {
        return std::nullopt; // all places lie outside
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

SpacingRunnerUp RegionPart::described(const Rule &rule, bool size, const SiteWords &words) const {
    const std::string of = " of region '" + words.regions[rule.region] + "'";
    return {std::max(rule.size, raised_), size ? "size" + of : "maximum area " + numberText(rule.given, 4) + of};
}

SpacingSample RegionPart::sample(Vec2 p, const SiteWords &words) const {
    const std::uint32_t face = faceAt(p);
    if (face == kNoIndex) {
        return {others_, SpacingOrigin::Automatic, 0, "automatic: size of the domain"};
    }
    const Limit &limit = limits_[face];
    const bool bySize = limit.size.size <= limit.area.size;
    const Rule &rule = bySize ? limit.size : limit.area, &other = bySize ? limit.area : limit.size;
    SpacingSample sample{limit.least, SpacingOrigin::Region, rule.region, described(rule, bySize, words).describe};
    if (other.region != kNoIndex) {
        sample.runnerUp = described(other, !bySize, words);
    }
    return sample;
}

void RegionPart::limitOthers(double size, double gradation, SiteSet &sites) {
    others_ = std::max(size, raised_);
    minimum_ = std::min(minimum_, others_);
    for (const Wall &wall : walls_) {
        if (wall.open) {
            sites.add(SizeSite::segment(wall.a, wall.b, others_, gradation),
                      {SpacingOrigin::Automatic, SiteReason::AutomaticEdge, 0});
        }
    }
}

void RegionPart::addSites(double gradation, double givenGradation, SiteSet &sites) const {
    struct Reach {
        const Rule *rule;
        double growth;
        bool size;
    };
    std::vector<Reach> rules;
    for (const Wall &wall : walls_) {
        rules.clear();
        for (const std::uint32_t side : {wall.below, wall.above}) {
            if (side != kNoIndex) {
                const Limit &limit = limits_[side];
                rules.push_back({&limit.area, gradation, false});
                rules.push_back({&limit.size, std::min(limit.size.growth, givenGradation), true});
            }
        }
        std::stable_sort(rules.begin(), rules.end(),
                         [](const Reach &a, const Reach &b) { return a.rule->size < b.rule->size; });
        // A rule is nowhere the smallest if another one has a smaller size and grows no faster.
        double gentlest = std::numeric_limits<double>::infinity(); // growth of the rules so far
        for (const Reach &reach : rules) {
            const Rule &rule = *reach.rule;
            if (rule.region == kNoIndex || !(reach.growth < gentlest)) {
                continue;
            }
            gentlest = reach.growth;
            if (reach.size) {
                sites.add(limited(SizeSite::segment(wall.a, wall.b, rule.size, rule.growth), raised_, givenGradation),
                          {SpacingOrigin::Region, SiteReason::RegionSize, rule.region});
            } else {
                sites.add(SizeSite::segment(wall.a, wall.b, std::max(rule.size, raised_), reach.growth),
                          {SpacingOrigin::Region, SiteReason::RegionEdge, rule.region});
            }
        }
    }
}

} // namespace forefront
