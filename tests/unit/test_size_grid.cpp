#include "core/engine/domain/add_loop.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/engine/spacing/spec/size_grid.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace forefront {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A grid over [0, 4] x [0, 3] of sizes 0.1 + 0.05·x + 0.02·y.
SizeGrid slopingGrid() {
    SizeGrid grid{.origin = {0, 0}, .pitch = {1.0, 0.5}, .columns = 5, .rows = 7, .values = {}};
    for (std::size_t j = 0; j < grid.rows; ++j) {
        for (std::size_t i = 0; i < grid.columns; ++i) {
            grid.values.push_back(0.1 + 0.05 * grid.place(i, j).x + 0.02 * grid.place(i, j).y);
        }
    }
    return grid;
}

} // namespace

TEST_CASE("SizeGrid: sizes are linear between the values") {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
    const auto background = backgroundOf(slopingGrid());
    REQUIRE(background);
    CHECK((*background)->nodes.size() == 35);
    CHECK((*background)->elements.size() == 2 * 4 * 6);
    job.spacing.background = *background;
    const auto field = SpacingField::build(job.spacing, job.domain);
    REQUIRE(field);
    for (const Vec2 p : {Vec2{0, 0}, Vec2{4, 3}, Vec2{1.3, 0.2}, Vec2{2.9, 2.6}, Vec2{0.1, 2.9}}) {
        CHECK((*field)->at(p) == doctest::Approx(0.1 + 0.05 * p.x + 0.02 * p.y));
        CHECK((*field)->sample(p).origin == SpacingOrigin::Background);
    }
    CHECK(meshDomain(job));
}

TEST_CASE("SizeGrid: NaN means no value, and three values are one triangle") {
    SizeGrid grid{.origin = {1, 1}, .pitch = {1, 1}, .columns = 3, .rows = 2, .values = {1, 2, kNone, 3, kNone, kNone}};
    const auto background = backgroundOf(grid);
    REQUIRE(background);
    CHECK((*background)->nodes == std::vector<Vec2>{{1, 1}, {2, 1}, {1, 2}});
    CHECK((*background)->values == std::vector<double>{1, 2, 3});
    REQUIRE((*background)->elements.size() == 1);
    grid.values[3] = kNone;
    const auto none = backgroundOf(grid);
    REQUIRE_FALSE(none);
    CHECK(none.faults().front().code == "no-values");
    CHECK_FALSE(backgroundOf(SizeGrid()));
}

TEST_CASE("SizeGrid: a bad value is refused with its place, a bad shape with its counts") {
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        SizeGrid grid = slopingGrid();
        grid.values[5 * 2 + 3] = bad;
        const auto refused = backgroundOf(grid);
        REQUIRE_FALSE(refused);
        CHECK(refused.faults().front().code == "bad-grid");
        CHECK(refused.faults().front().at == Vec2{3, 1});
    }
    SizeGrid grid = slopingGrid();
    grid.values.pop_back();
    CHECK(backgroundOf(grid).faults().front().message ==
          "grid of sizes: 34 values for 5 columns and 7 rows; expected one for each");
    grid = slopingGrid();
    grid.columns = std::numeric_limits<std::size_t>::max() / 2;
    CHECK_FALSE(backgroundOf(grid));
    for (const Vec2 pitch : {Vec2{0, 1}, Vec2{1, -1}, Vec2{kNone, 1}}) {
        grid = slopingGrid();
        grid.pitch = pitch;
        CHECK_FALSE(backgroundOf(grid));
    }
}

} // namespace forefront
