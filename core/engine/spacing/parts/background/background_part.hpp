#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/spacing/sites/site_set.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace forefront {

/// Nodal spacing on a triangle mesh, prepared for point location in a table of cells, each the root of a quadtree whose
/// leaves list the triangles that touch them.
class BackgroundPart {
  public:
    /// Prepares a mesh. Errors: bad-background, with a place if there is one (counts that do not match, invalid values
    /// or coordinates, indices out of range, inverted or degenerate triangles by an exact test); cancelled.
    static Result<BackgroundPart> build(const BackgroundMesh &mesh, double minimum, const Progress &progress);

    /// Returns the spacing at p, linear in each triangle; infinity outside the mesh. Where triangles overlap, the one
    /// with the largest minimum barycentric coordinate counts.
    double at(Vec2 p) const {
        const double u = (p.x - corner_.x) * toCells_;
        const double v = (p.y - corner_.y) * toCells_;
        if (!(u >= 0.0 && v >= 0.0 && u < columns_ && v < rows_)) {
            return std::numeric_limits<double>::infinity();
        }
        const auto i = static_cast<std::uint32_t>(u);
        const auto j = static_cast<std::uint32_t>(v);
        const std::uint32_t *cell = &cells_[j * columns_ + i];
        double s = u - i;
        double t = v - j;
        while (*cell & kSplit) {
            s *= 2.0;
            t *= 2.0;
            const bool right = s >= 1.0;
            const bool upper = t >= 1.0;
            cell = &cells_[(*cell & ~kSplit) + (right ? 1U : 0U) + (upper ? 2U : 0U)];
            s -= right ? 1.0 : 0.0;
            t -= upper ? 1.0 : 0.0;
        }
        return valueAmong(&lists_[*cell], p);
    }
    /// Returns the smallest value, after raising values to the given minimum.
    double minimum() const { return minimum_; }
    double maximum() const { return maximum_; }
    /// Returns the triangle that determines the value at p, if any.
    std::optional<std::uint32_t> triangleAt(Vec2 p) const;

    /// Adds the border edges of the mesh, beyond which its spacing grows by `gradation`. Incomplete if cancelled.
    static void addBorderSites(const BackgroundMesh &mesh, double minimum, double gradation, SiteSet &sites,
                               const Progress &progress);
    /// Adds the edges of triangles steeper than `gradation`, which limit them.
    static void addSteepSites(const BackgroundMesh &mesh, double minimum, double gradation, SiteSet &sites);

  private:
    friend class BackgroundBuilder;
    static constexpr std::uint32_t kSplit = 0x80000000U;

    /// Barycentric coordinates and value as linear functions of p − a.
    struct Triangle {
        Vec2 a;
        Vec2 toSecond; ///< gradient of the coordinate of the second node
        Vec2 toThird;
        double value = 0.0;  ///< at a
        double second = 0.0; ///< value at the second node minus value at the first
        double third = 0.0;
    };
    double valueAmong(const std::uint32_t *entry, Vec2 p) const {
        double deepest = -1e-9; // on an edge, rounding must not lose the point
        double value = std::numeric_limits<double>::infinity();
        for (std::uint32_t n = *entry++; n > 0; --n) {
            const Triangle &triangle = triangles_[*entry++];
            const Vec2 d = p - triangle.a;
            const double second = dot(triangle.toSecond, d);
            const double third = dot(triangle.toThird, d);
            const double depth = std::min(std::min(second, third), 1.0 - second - third);
            if (depth > deepest) {
                deepest = depth;
                value = triangle.value + second * triangle.second + third * triangle.third;
            }
        }
        // Just outside its triangle, the linear function may leave the range of the nodes.
        return value < minimum_ ? minimum_ : value;
    }

    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> cells_;
    std::vector<std::uint32_t> lists_;
    Vec2 corner_;
    double toCells_ = 1.0;
    std::uint32_t columns_ = 0;
    std::uint32_t rows_ = 0;
    double minimum_ = 0.0;
    double maximum_ = 0.0;
};

} // namespace forefront
