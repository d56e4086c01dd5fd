#pragma once

#include "core/engine/domain/lazy_faces.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/spacing/sites/site_words.hpp"
#include "core/engine/spacing/spec/placed_sizes.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace forefront {

/// Returns the spacing that aims at a maximum area: the side of an equilateral triangle of 0.55 times that area, since
/// the largest triangles of a mesh have up to about 1.85 times the area that the spacing implies; for quadrilaterals,
/// the side of a square of 0.48 times that area. Where shapes are irregular, single elements may exceed it by up to an
/// eighth; largeElements() tells which.
double spacingForArea(double maxArea, bool quads = false);

/// Returns the largest size that a region has or that its maximum area implies; 0 if none has one.
double largestRegionSize(std::span<const RegionSize> regions);

/// Returns the places of region sizes, for LazyFaces.
std::vector<Vec2> placesOf(std::span<const RegionSize> regions);

/// Returns the names of regions with sizes, for descriptions: the name of a marker at the same position, or else of the
/// face.
std::vector<std::string> namesOf(std::span<const RegionSize> regions, const Domain &domain, const LazyFaces &faces);

/// The sizes and maximum element areas of regions as spacing: constant in each face that has one.
class RegionPart {
  public:
    /// Returns the part, or std::nullopt if no face has a size or a maximum area, or if segments cross so that there
    /// are no faces. Spacings are raised to `minimum`. `faces` must know the places of the regions.
    static std::optional<RegionPart> build(std::span<const RegionSize> regions, const LazyFaces &faces, double minimum,
                                           const QuadRegions &quads = {});

    /// Returns the spacing of the face that contains p, which is infinite for faces without a rule unless limitOthers()
    /// was called.
    double at(Vec2 p) const {
        const std::uint32_t face = faceAt(p);
        return face == kNoIndex ? others_ : limits_[face].least;
    }
    /// Returns the maximum area of an element in the face that contains p; infinity if there is none. `region`
    /// receives the index of the region that sets it.
    double maxAreaAt(Vec2 p, std::uint32_t &region) const {
        const std::uint32_t face = faceAt(p);
        if (face == kNoIndex || limits_[face].area.region == kNoIndex) {
            return std::numeric_limits<double>::infinity();
        }
        region = limits_[face].area.region;
        return limits_[face].area.given;
    }
    /// Returns the finite spacing at p and the name of its region.
    SpacingSample sample(Vec2 p, const SiteWords &words) const;
    double minimum() const { return minimum_; }
    double maximum() const { return std::max(largest_, others_); }
    /// Returns the largest spacing of a face that has a rule.
    double largest() const { return largest_; }

    /// Gives the faces without a rule the automatic spacing `size`, which grows by `gradation` into the others.
    void limitOthers(double size, double gradation, SiteSet &sites);

    /// Adds the edges of the faces, from which the spacing grows into their surroundings: for a maximum area by
    /// `gradation`, for a size by its own growth, at most `givenGradation` (infinity: no limit).
    void addSites(double gradation, double givenGradation, SiteSet &sites) const;

  private:
    /// A rule for the spacing in a face.
    struct Rule {
        double size = std::numeric_limits<double>::infinity(); ///< infinite: there is none
        double given = 0.0;                                    ///< size or maximum area
        double growth = std::numeric_limits<double>::infinity();
        std::uint32_t region = kNoIndex;
    };
    struct Limit {
        Rule size, area;
        double least = 0.0; ///< the smaller spacing of the two, raised to the minimum
    };
    std::vector<std::uint32_t> takeLimits(std::span<const RegionSize> regions, const DomainFaces &found,
                                          const QuadRegions &quads);
    /// Describes a rule; `size`: it is a size, not an area.
    SpacingRunnerUp described(const Rule &rule, bool size, const SiteWords &words) const;
    /// An edge between faces of different limits, directed to the right (increasing x) unless it is vertical.
    struct Wall {
        Vec2 a;
        Vec2 b;
        std::uint32_t above = kNoIndex; ///< index into limits_
        std::uint32_t below = kNoIndex;
        bool open = false; ///< a side is inside the domain and has no limit
    };
    std::uint32_t faceAt(Vec2 p) const;

    std::vector<Limit> limits_;
    std::vector<Wall> walls_;
    BoxTree tree_; ///< of the walls
    double minimum_ = std::numeric_limits<double>::infinity();
    double largest_ = 0.0;
    double others_ = std::numeric_limits<double>::infinity(); ///< in faces without a limit
    double raised_ = 0.0;                                     ///< the minimum spacing that others are raised to
};

} // namespace forefront
