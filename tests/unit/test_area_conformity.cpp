#include "core/engine/mesh/area_conformity.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

using namespace forefront;

namespace {

/// The distance to (0.5, 0.5) times a slope, at least a minimum; a slope of 0: the minimum everywhere.
class ConeSpacing final : public SpacingField {
  public:
    ConeSpacing(double slope, double least) : slope_(slope), least_(least) {}
    double at(Vec2 p) const override { return std::max(least_, slope_ * distance(p, {0.5, 0.5})); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override {
        std::transform(points.begin(), points.end(), rho.begin(), [this](Vec2 p) { return at(p); });
    }
    SpacingSample sample(Vec2 p) const override { return {at(p), SpacingOrigin::Function, 0, "cone"}; }
    double minimum() const override { return least_; }
    double maximum() const override { return least_ + 10.0 * slope_; }

  private:
    double slope_, least_;
};

} // namespace

TEST_CASE("Conformity over the area: elements of the size of the spacing have 1, twice or half as large 0.5") {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {0.5, 0.5 * std::numbers::sqrt3}};
    mesh.elements = {{NodeId{0}, NodeId{1}, NodeId{2}}};
    mesh.regions = {1};
    for (const auto &[size, expected] : {std::pair{1.0, 1.0}, {2.0, 0.5}, {0.5, 0.5}}) {
        CHECK(conformityOverArea(mesh, ConeSpacing(0.0, size)) == doctest::Approx(expected));
    }
    std::swap(mesh.elements[0][0], mesh.elements[0][1]); // inverted
    CHECK(conformityOverArea(mesh, ConeSpacing(0.0, 1.0)) == 0.0);
    samples::BlockMaker squares({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    squares.add(CellKind::Quadrilateral8, {NodeId{0}, NodeId{1}, NodeId{2}, NodeId{3}});
    CHECK(conformityOverArea(squares.mesh, ConeSpacing(0.0, 2.0)) == doctest::Approx(1.0));
}

TEST_CASE("Conformity over the area: elements weigh by area, a spacing that is ignored inside shows") {
    const TriMesh fine = samples::square(64, 64); // many more elements than a block
    const double size = std::sqrt(2.0 / std::numbers::sqrt3) / 64.0;
    CHECK(conformityOverArea(fine, ConeSpacing(0.0, size)) == doctest::Approx(1.0).epsilon(1e-9));
    const TriMesh coarse = samples::square(1, 1); // two triangles, with small sizes only in the middle
    const ConeSpacing cone(2.0, 0.01);
    const MeshQuality quality = measureQuality(coarse, &cone);
    CHECK(quality.deltaMean > 0.55);
    CHECK(quality.deltaAreaMean == conformityOverArea(coarse, cone));
    // The exact value of the mean of min(h/ρ, ρ/h), h = √(2/√3), by sums over a fine grid.
    double exact = 0.0;
    constexpr int kGrid = 400;
    for (int i = 0; i < kGrid; ++i) {
        for (int j = 0; j < kGrid; ++j) {
            const Vec2 place{(i + 0.5) / kGrid, (j + 0.5) / kGrid};
            exact += spacingConformity(std::sqrt(2.0 / std::numbers::sqrt3), cone.at(place)) / (kGrid * kGrid);
        }
    }
    CHECK(quality.deltaAreaMean == doctest::Approx(exact).epsilon(0.03));
    CHECK(measureQuality(coarse, nullptr).deltaAreaMean == 0.0);
}
