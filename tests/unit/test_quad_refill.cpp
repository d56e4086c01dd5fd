#include "core/engine/quads/polygon_fill.hpp"
#include "core/engine/quads/quad_refill.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "tests/support/quad_jobs.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/spacing_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace refill_cases {

PolygonFill filled(const std::vector<Vec2> &nodes, double triangleCost = 1e5) {
    const std::optional<PolygonFill> fill =
        fillPolygon(nodes, {[](std::size_t, std::size_t) { return false; }, triangleCost});
    REQUIRE(fill);
    return *fill;
}

bool isFillable(const std::vector<Vec2> &nodes) {
    return fillPolygon(nodes, {[](std::size_t, std::size_t) { return false; }, 1.0}).has_value();
}

double areaOf(const QuadCell &cell, const std::vector<Vec2> &nodes) {
    double area = 0.0;
    for (unsigned k = 0; k < cornersOf(cell); ++k) {
        area += 0.5 * cross(nodes[cell[k]], nodes[nextCorner(cell, k)]);
    }
    return area;
}

double areaOf(const QuadWorkspace &mesh) {
    double area = 0.0;
    for (const QuadCell &cell : mesh.cells) {
        area += isAlive(cell) ? areaOf(cell, mesh.nodes) : 0.0;
    }
    return area;
}

bool isConvex(const QuadWorkspace &mesh) {
    return std::ranges::all_of(
        mesh.cells, [&](const QuadCell &cell) { return !isAlive(cell) || isClearlyConvex(cell, mesh.nodes); });
}

std::size_t trianglesOf(const QuadWorkspace &mesh) {
    return static_cast<std::size_t>(
        std::ranges::count_if(mesh.cells, [](const QuadCell &cell) { return isAlive(cell) && isTriangle(cell); }));
}

/// A lattice of n by n unit squares with its outline tagged, and the column of edges at x = `line`, if that is not 0.
QuadWorkspace lattice(std::uint32_t n, std::uint32_t line = 0) {
    std::vector<Vec2> nodes;
    std::vector<QuadCell> cells;
    std::vector<std::array<std::uint32_t, 2>> tagged;
    const auto node = [n](std::uint32_t x, std::uint32_t y) { return y * (n + 1) + x; };
    for (std::uint32_t y = 0; y <= n; ++y) {
        for (std::uint32_t x = 0; x <= n; ++x) {
            nodes.push_back({double(x), double(y)});
            if (x < n && y < n) {
                cells.push_back({node(x, y), node(x + 1, y), node(x + 1, y + 1), node(x, y + 1)});
            }
        }
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        tagged.insert(tagged.end(), {{node(i, 0), node(i + 1, 0)}, {node(i, n), node(i + 1, n)}});
        tagged.insert(tagged.end(), {{node(0, i), node(0, i + 1)}, {node(n, i), node(n, i + 1)}});
        if (line > 0) {
            tagged.push_back({node(line, i), node(line, i + 1)});
        }
    }
    return {std::move(nodes), std::move(cells), {}, tagged, {}, constantSpacing(1.0)};
}

} // namespace refill_cases

using namespace refill_cases;

TEST_CASE("fillPolygon: an L of six nodes is two quadrilaterals, and a pentagon has one triangle") {
    const PolygonFill l = filled({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
    CHECK(l.cells.size() == 2);
    CHECK(l.triangles == 0);
    CHECK(l.leastShape == doctest::Approx(std::sqrt(0.5)));
    const PolygonFill pentagon = filled({{0, 0}, {2, 0}, {2, 2}, {1, 3}, {0, 2}});
    CHECK(pentagon.cells.size() == 2);
    CHECK(pentagon.triangles == 1);
}

TEST_CASE("fillPolygon: four nodes of a dart, or with one in the line of its neighbours, are two triangles") {
    for (const Vec2 inner : {Vec2{0.5, 0.5}, Vec2{1, 1}}) {
        const std::vector<Vec2> nodes = {{0, 0}, {2, 0}, inner, {0, 2}};
        const PolygonFill fill = filled(nodes);
        CHECK(fill.triangles == 2);
        for (const QuadCell &cell : fill.cells) {
            CHECK(areaOf(cell, nodes) > 0.0);
        }
    }
}

TEST_CASE("fillPolygon: cheap triangles take the place of poor quadrilaterals") {
    const std::vector<Vec2> kite = {{0, 0}, {1, -0.05}, {2, 0}, {1, 1.7}};
    CHECK(filled(kite).triangles == 0);
    CHECK(filled(kite, 0.1).triangles == 2);
}

TEST_CASE("fillPolygon: polygons that are clockwise, cross themselves or have too many nodes are refused") {
    CHECK_FALSE(isFillable({{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
    CHECK_FALSE(isFillable({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
    CHECK_FALSE(isFillable({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));
    CHECK_FALSE(isFillable({{0, 0}, {1, 0}, {2, 0}}));
    CHECK(isFillable(discOutline(kMaxFillNodes, 1.0)));
    CHECK_FALSE(isFillable(discOutline(kMaxFillNodes + 2, 1.0)));
}

TEST_CASE("fillPolygon: an edge that the rules forbid is not made") {
    const std::vector<Vec2> hexagon = discOutline(6, 1.0);
    for (std::size_t forbidden = 0; forbidden < 3; ++forbidden) {
        const std::optional<PolygonFill> fill =
            fillPolygon(hexagon, {[&](std::size_t i, std::size_t j) {
                                      return std::min(i, j) == forbidden && std::max(i, j) == forbidden + 3;
                                  },
                                  1e5});
        REQUIRE(fill);
        CHECK(fill->triangles == 0);
        for (const QuadCell &cell : fill->cells) {
            const auto from = static_cast<std::uint32_t>(forbidden);
            CHECK(std::ranges::count(cell, from) + std::ranges::count(cell, from + 3) < 2);
        }
    }
    CHECK_FALSE(fillPolygon(hexagon, {[](std::size_t, std::size_t) { return true; }, 1e5}));
}

TEST_CASE("refillPockets: elements turned by a node outside its neighbours are replaced by convex ones") {
    QuadWorkspace mesh = lattice(6);
    mesh.nodes[3 * 7 + 3] = {4.6, 4.7}; // the middle, beyond the opposite corner of one of its elements
    REQUIRE_FALSE(isConvex(mesh));
    const std::vector<QuadCell> before = mesh.cells;
    CHECK(refillPockets(mesh, Elements::Quads).empty());
    CHECK(isConvex(mesh));
    CHECK(trianglesOf(mesh) == 0);
    CHECK(areaOf(mesh) == doctest::Approx(36.0));
    for (std::uint32_t cell : {0U, 5U, 30U, 35U}) { // the corners are far from it
        CHECK(mesh.cells[cell] == before[cell]);
    }
}

TEST_CASE("refillPockets: a mesh of convex elements stays as it is") {
    QuadWorkspace mesh = lattice(4);
    const std::vector<QuadCell> before = mesh.cells;
    const std::vector<Vec2> places = mesh.nodes;
    CHECK(refillPockets(mesh, Elements::Quads).empty());
    CHECK(mesh.cells == before);
    CHECK(mesh.nodes == places);
}

TEST_CASE("refillPockets: tagged edges stay, and each side of them keeps its area") {
    QuadWorkspace mesh = lattice(6, 3);
    mesh.nodes[3 * 7 + 4] = {2.2, 3.4}; // a free node beyond the line
    CHECK(refillPockets(mesh, Elements::Quads).empty());
    CHECK(isConvex(mesh));
    double left = 0.0;
    for (const QuadCell &cell : mesh.cells) {
        const bool isLeft =
            isAlive(cell) && std::ranges::all_of(cell, [&](std::uint32_t n) { return mesh.nodes[n].x <= 3.0; });
        left += isLeft ? areaOf(cell, mesh.nodes) : 0.0;
    }
    CHECK(left == doctest::Approx(18.0));
    CHECK(areaOf(mesh) == doctest::Approx(36.0));
}

TEST_CASE("refillPockets: where all nodes are fixed, triangles are left and their place is told") {
    const std::vector<std::array<std::uint32_t, 2>> outline = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    const auto dart = [&] {
        return QuadWorkspace({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, {{0, 1, 2, 3}}, {}, outline, {},
                             constantSpacing(1.0));
    };
    QuadWorkspace mesh = dart(), mixed = dart();
    const std::vector<Vec2> places = refillPockets(mesh, Elements::Quads);
    REQUIRE(places.size() == 1);
    CHECK(length(places[0]) < 1.5);
    CHECK(trianglesOf(mesh) == 2);
    CHECK(isConvex(mesh));
    CHECK(refillPockets(mixed, Elements::Mixed).empty()); // triangles may be anywhere
    CHECK(isConvex(mixed));
}

TEST_CASE("refillPockets: nothing is changed once the run is cancelled") {
    QuadWorkspace mesh = lattice(6);
    mesh.nodes[3 * 7 + 3] = {4.6, 4.7};
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    progress.stop = stop.get_token();
    const std::vector<QuadCell> before = mesh.cells;
    CHECK(refillPockets(mesh, Elements::Quads, progress).empty());
    CHECK(mesh.cells == before);
}

TEST_CASE("refillPockets: a stepped run leads through the mending, forward and back, to the same mesh") {
    MeshingJob job;
    job.domain = randomDomain(34); // spikes with tips below a degree
    job.options.elements = Elements::Quads;
    MeshStepper stepper = quadStepper(job);
    stepper.stepImprovement();
    REQUIRE(stepper.finish());
    const std::size_t steps = stepper.snapshot()->improveSteps;
    stepper.seek(stepper.known());
    std::size_t mended = 0;
    std::vector<std::uint64_t> hashes{meshHash(stepper.mesh())};
    for (std::size_t k = 1; k <= steps; ++k) {
        stepper.step(Granularity::Advance, 1);
        const std::shared_ptr<const SessionSnapshot> here = stepper.snapshot();
        REQUIRE(here->improvement);
        if (here->improvement->change == ImproveChange::Refill && !here->improvement->addedEdges.empty()) {
            ++mended;
            CHECK(caption(*here->improvement, steps).find("not convex replaced") != std::string::npos);
        }
        hashes.push_back(meshHash(stepper.mesh()));
    }
    CHECK(mended > 0);
    CHECK(hashes.back() == hashOfMeshed(job));
    for (std::size_t k = steps; k-- > 0;) {
        stepper.step(Granularity::Advance, -1);
        REQUIRE(meshHash(stepper.mesh()) == hashes[k]);
    }
}
