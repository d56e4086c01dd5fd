#pragma once

#include "core/domain/domain.hpp"
#include "core/geometry/box_tree.hpp"
#include "core/spacing/sites/site_words.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace forefront {

/// Returns the spacing whose triangles stay below a maximum area: the side of an equilateral triangle of 0.6 times that
/// area, since the largest triangles of a mesh have about 1.65 times the area that the spacing implies. A test requires
/// that they stay within `maxArea`.
double spacingForArea(double maxArea);

/// The maximum element areas of a domain's regions as spacing: constant in each face that has one.
class RegionPart {
  public:
    /// Returns the part, or std::nullopt if no face has a maximum area, or if segments cross so that there are no
    /// faces. Spacings are raised to `minimum`. Of several markers in one face, the smallest area counts.
    static std::optional<RegionPart> build(const Domain &domain, double minimum);

    /// Returns the spacing of the face that contains p; infinity if it has no maximum area.
    double at(Vec2 p) const {
        const std::uint32_t face = faceAt(p);
        return face == kNoIndex ? std::numeric_limits<double>::infinity() : limits_[face].size;
    }
    /// Returns the spacing at p and the name of its region, which must have a maximum area.
    SpacingSample sample(Vec2 p, const SiteWords &words) const;
    double minimum() const { return minimum_; }
    double maximum() const { return std::numeric_limits<double>::infinity(); }

    /// Adds the edges of the faces, from which the spacing grows into their surroundings by `gradation`.
    void addSites(double gradation, SiteSet &sites) const;

  private:
    struct Limit {
        double size = 0.0;
        double area = 0.0; ///< as given
        std::uint32_t marker = 0;
    };
    /// An edge between faces of different limits, directed to the right (increasing x) unless it is vertical.
    struct Wall {
        Vec2 a;
        Vec2 b;
        std::uint32_t above = kNoIndex; ///< index into limits_
        std::uint32_t below = kNoIndex;
    };
    std::uint32_t faceAt(Vec2 p) const;

    std::vector<Limit> limits_;
    std::vector<Wall> walls_;
    BoxTree tree_; ///< of the walls
    double minimum_ = std::numeric_limits<double>::infinity();
};

} // namespace forefront
