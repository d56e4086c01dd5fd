#pragma once

#include "core/engine/boundary/discretise.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <functional>
#include <memory>

namespace forefront::testing {

/// Returns a node spacing given by any function of the plane.
std::shared_ptr<const SpacingField> spacingOf(std::function<double(Vec2)> rho);

/// Builds small discretised domains, edge by edge.
class DiscreteBuilder {
  public:
    std::uint32_t node(Vec2 p);
    /// Adds a closed chain; if counter-clockwise, the domain lies inside.
    DiscreteBuilder &loop(const std::vector<Vec2> &nodes, std::uint32_t left = 0, std::uint32_t right = kOutside);
    /// Adds an open chain inside the domain: both sides are meshed.
    DiscreteBuilder &chain(const std::vector<Vec2> &nodes);
    DiscreteBuilder &point(Vec2 p);
    DiscreteBuilder &region(std::int32_t tag, double area);
    std::shared_ptr<const DiscreteDomain> build() const { return std::make_shared<const DiscreteDomain>(domain_); }

  private:
    DiscreteDomain domain_;
};

/// Returns a regular polygon of n nodes on a circle, counter-clockwise or clockwise.
std::vector<Vec2> circleNodes(Vec2 centre, double radius, int n, bool counterClockwise = true);
/// Returns a rectangle whose sides are cut into pieces no longer than h, counter-clockwise or clockwise.
std::vector<Vec2> rectangleNodes(Vec2 low, Vec2 high, double h, bool counterClockwise = true);

/// Returns a disc of radius 1 with boundary pieces of length h.
std::shared_ptr<const DiscreteDomain> discreteDisc(double h);
/// Returns a unit square with a round hole, a slit and an isolated point.
std::shared_ptr<const DiscreteDomain> discretePlate(double h);

} // namespace forefront::testing
