#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/spacing/parts/expression/plane_function.hpp"
#include "core/engine/spacing/parts/expression/raster_function.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

/// The distance to segments as a function of the position, in O(log n) for each place.
class SegmentDistance final : public PlaneFunction {
  public:
    struct Wall {
        Vec2 a, b;
    };
    /// `walls` may be empty: then the distance is 0.
    explicit SegmentDistance(std::vector<Wall> walls);

    double at(Vec2 p) const override;
    ValueRange range(const Box2 &box) const override;
    Diagnostics gaps(const Domain &, const InsideTest *) const override { return {}; }

  private:
    std::vector<Wall> walls_;
    BoxTree tree_;
};

/// The functions that the expression of a spacing may call, for a raster with the name depth: depth(x, y), and
/// depth_x(x, y), depth_y(x, y), its changes per unit of length; and shore(x, y), the distance to the boundary, or
/// shore(x, y, 'coast', 'pier') to the segments of named parts, by their chords.
class SpacingFunctions final : public FormulaFunctions {
  public:
    /// `domain` must outlive this object. Null: the expression is only checked, not evaluated; all parts are accepted.
    SpacingFunctions(const SpacingSpec &spec, const Domain *domain);

    std::shared_ptr<const PlaneFunction> find(std::string_view name) const override;
    std::string names() const override;
    std::variant<std::shared_ptr<const PlaneFunction>, std::string>
    shore(std::span<const std::string> parts) const override;

  private:
    const RasterMap &rasters_;
    const Domain *domain_;
    mutable std::map<std::string, std::shared_ptr<const FilledRaster>, std::less<>> filled_; ///< those that are used
};

/// Returns the error in the name of a raster; empty if it is valid: letters, digits and _, not a name with another
/// meaning in expressions, and without the endings _x and _y.
std::string checkRasterName(std::string_view name);

} // namespace forefront
