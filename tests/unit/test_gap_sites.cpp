#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/elements_across.hpp"
#include "core/engine/mesh/tri_mesh.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/spacing_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

Domain outlineOf(const std::vector<Vec2> &loop) {
    Domain domain;
    addLoop(domain, loop);
    return domain;
}

TriMesh meshOf(const Domain &domain, const SpacingSpec &spacing, const MeshingOptions &options = {}) {
    const auto outcome = meshDomain({domain, spacing, options});
    REQUIRE(outcome.ok());
    return takeTriMesh(outcome->mesh);
}

/// Returns the smallest number of elements across any gap of the mesh.
double fewestAcross(const TriMesh &mesh) {
    double fewest = std::numeric_limits<double>::infinity();
    for (const double value : elementsAcross(mesh, edgesOf(mesh))) {
        fewest = value < fewest ? value : fewest; // false for NaN
    }
    return fewest;
}

/// Two basins of 40 x 30, joined by a channel of width 1 and length 20.
const std::vector<Vec2> kBasins{{0, 0},    {40, 0},  {40, 15}, {60, 15}, {60, 0},  {100, 0},
                                {100, 30}, {60, 30}, {60, 16}, {40, 16}, {40, 30}, {0, 30}};

/// A plate of 10 x 5 with a layer of thickness 0.2 between two regions, or with an inclusion as thin. With `markers`,
/// all lines are boundaries and holes are marked, as in a .poly file; else the inner ones are constraints.
Domain layered(bool inclusion, bool markers) {
    Domain domain;
    domain.insideRule = markers ? InsideRule::HoleMarkers : InsideRule::EvenOdd;
    const SegmentRole inner = markers ? SegmentRole::Boundary : SegmentRole::Constraint;
    domain.regionMarkers = {{{5, 1}, 1}, {{5, 2.1}, 2}};
    if (inclusion) {
        addLoop(domain, std::vector<Vec2>{{0, 0}, {10, 0}, {10, 5}, {0, 5}});
        addLoop(domain, std::vector<Vec2>{{2, 2}, {8, 2}, {8, 2.2}, {2, 2.2}});
        for (std::size_t s = 4; s < 8; ++s) {
            domain.segments[s].role = inner;
        }
        return domain;
    }
    addLoop(domain, std::vector<Vec2>{{0, 0}, {10, 0}, {10, 2}, {10, 2.2}, {10, 5}, {0, 5}, {0, 2.2}, {0, 2}});
    domain.segments.push_back({7, 2, 5, inner});
    domain.segments.push_back({6, 3, 6, inner});
    domain.regionMarkers.push_back({{5, 4}, 3});
    return domain;
}

/// A wedge of that angle, in degrees, whose sides are 20 long.
Domain wedge(double degrees) {
    const double angle = degrees * 0.017453292519943295;
    return outlineOf({{0, 0}, {20, 0}, {20 * std::cos(angle), 20 * std::sin(angle)}});
}

} // namespace

TEST_CASE("Elements across gaps: a channel gets the number with a given size, an expression, sources and automatic") {
    const Domain domain = outlineOf(kBasins);
    SizeSource source;
    source.size = 3.0;
    std::vector<SpacingSpec> specs(4);
    specs[0].size = 5.0;
    specs[1].expression = "5 + 0.01*x";
    specs[2].sources = {source};
    for (SpacingSpec &spec : specs) {
        for (const double count : {4.0, 7.0}) {
            spec.elementsAcross = count;
            const TriMesh mesh = meshOf(domain, spec);
            CAPTURE(count);
            CHECK(fewestAcross(mesh) >= count);
            CHECK(fewestAcross(mesh) <= 1.5 * count + 1.0);
            CHECK(fieldOf(spec, domain)->at({50.0, 15.5}) == doctest::Approx(1.0 / count).epsilon(0.02));
        }
        spec.elementsAcross.reset();
    }
    CHECK(fewestAcross(meshOf(domain, specs[0])) < 2.0);
    specs[0].elementsAcross = 4.0;
    const auto field = fieldOf(specs[0], domain);
    CHECK(field->at({5.0, 4.0}) == doctest::Approx(5.0)); // the basins stay coarse
    CHECK(field->sample({50.0, 15.2}).describe == "narrow channel beside 'boundary_1' at (50, 15)");
}

TEST_CASE("Elements across gaps: walls of short segments, slanted and curved walls") {
    std::vector<Vec2> wall; // a channel of width 1 that winds
    constexpr int kPieces = 60;
    for (int k = 0; k <= kPieces; ++k) {
        wall.push_back({0.5 * k, 2.0 * std::sin(0.1 * k)});
    }
    for (int k = kPieces; k >= 0; --k) {
        wall.push_back({0.5 * k, 2.0 * std::sin(0.1 * k) + 1.0});
    }
    SpacingSpec spec;
    spec.size = 5.0;
    spec.elementsAcross = 5.0;
    CHECK(fewestAcross(meshOf(outlineOf(wall), spec)) >= 5.0);

    const Document ring = edit_test::documentOf({edit_test::makeShape(ShapeKind::Circle, {{0, 0}, {5, 0}}),
                                                 edit_test::makeShape(ShapeKind::Circle, {{0.2, 0}, {4.2, 0}})});
    const TriMesh mesh = meshOf(toDomain(ring), spec);
    CHECK(fewestAcross(mesh) >= 5.0);
    CHECK(mesh.elements.size() < 5000);
}

TEST_CASE("Elements across gaps: wide places and corners stay as they are") {
    SpacingSpec spec, with;
    spec.size = with.size = 1.0;
    with.elementsAcross = 4.0;
    const auto same = [&](const Domain &domain) {
        CHECK(meshHash(meshOf(domain, spec)) == meshHash(meshOf(domain, with)));
    };
    same(outlineOf({{0, 0}, {10, 0}, {10, 8}, {0, 8}}));
    same(wedge(60.0));
    same(wedge(25.0));
    // A needle is followed down to a width of 1/8 of the size.
    const Domain needle = wedge(5.0);
    const auto field = fieldOf(with, needle);
    CHECK(field->at({18.0, 0.5}) < 0.45);
    CHECK(field->minimum() >= 1.0 / 8.0 / 4.0);
    CHECK(meshOf(needle, with).elements.size() < 2000);
    with.size = spec.size = 5.0;
    CHECK(meshOf(needle, with).elements.size() < 800);
}

TEST_CASE("Elements across gaps: 0 leaves narrow places to the other parts, the minimum spacing stays") {
    const Domain domain = outlineOf(kBasins);
    SpacingSpec none, off, least;
    off.elementsAcross = 0.0;
    CHECK(meshOf(domain, off).elements.size() < meshOf(domain, none).elements.size());
    least.size = 5.0;
    least.elementsAcross = 20.0;
    least.minimum = 0.25;
    CHECK(fieldOf(least, domain)->at({50.0, 15.5}) == doctest::Approx(0.25));
    SpacingSpec bad;
    bad.elementsAcross = -1.0;
    CHECK(checkSpacing(bad, domain).front().message ==
          "invalid number of elements across narrow places -1; expected 0 or more");
}

TEST_CASE("Elements across gaps: the mesh depends neither on the grid nor on the threads") {
    const Domain domain = outlineOf(kBasins);
    SpacingSpec spec;
    spec.size = 2.0;
    spec.elementsAcross = 4.0;
    const auto hash = meshHash(meshOf(domain, spec));
    for (const GridKind grid : {GridKind::None, GridKind::Uniform, GridKind::Hierarchical}) {
        CHECK(meshHash(meshOf(domain, spec, {.grid = grid})) == hash);
    }
    for (const unsigned threads : {2U, 3U}) {
        CHECK(meshHash(meshOf(domain, spec, {.threads = threads})) == hash);
    }
}

TEST_CASE("Elements across gaps: layers and inclusions between boundaries count as those between constraints") {
    SpacingSpec given;
    given.size = 1.0;
    given.elementsAcross = 4.0;
    for (const bool inclusion : {false, true}) {
        CAPTURE(inclusion);
        const Domain domain = layered(inclusion, true);
        CHECK(fewestAcross(meshOf(domain, {})) >= 2.0);
        CHECK(fewestAcross(meshOf(domain, given)) >= 4.0);
        CHECK(meshHash(meshOf(domain, {})) == meshHash(meshOf(layered(inclusion, false), {})));
        CHECK(meshHash(meshOf(domain, given)) == meshHash(meshOf(layered(inclusion, false), given)));
    }
}

TEST_CASE("Elements across gaps: a hole and the inside of an inclusion with a hole marker stay outside") {
    SpacingSpec given;
    given.size = 1.0;
    given.elementsAcross = 4.0;
    Domain hole = layered(true, true);
    hole.holeMarkers = {{5, 2.1}};
    hole.regionMarkers.pop_back();
    CHECK(fieldOf(given, hole)->at({5, 2.1}) == doctest::Approx(0.5)); // from the gap of 2 below the hole
    CHECK(fieldOf(given, layered(true, true))->at({5, 2.1}) == doctest::Approx(0.05));
}

TEST_CASE("Elements across gaps: the measure counts across interfaces and constraints") {
    SpacingSpec coarse;
    coarse.size = 1.0;
    for (const bool inclusion : {false, true}) {
        for (const bool markers : {false, true}) {
            TriMesh mesh = meshOf(layered(inclusion, markers), coarse);
            CHECK(fewestAcross(mesh) == 1.0);
            mesh.regions.clear(); // the tagged edges remain
            CHECK(fewestAcross(mesh) == 1.0);
            mesh = meshOf(layered(inclusion, markers), coarse);
            std::erase_if(mesh.edges, [](const TaggedEdge &edge) { return edge.tag > 1; }); // the regions remain
            CHECK(fewestAcross(mesh) == 1.0);
        }
    }
    Domain slit = outlineOf({{0, 0}, {10, 0}, {10, 8}, {0, 8}}); // a free end faces nothing
    slit.nodes.insert(slit.nodes.end(), {{3, 4}, {7, 4}});
    slit.segments.push_back({4, 5, 2, SegmentRole::Constraint});
    coarse.size = 0.5;
    CHECK(fewestAcross(meshOf(slit, coarse)) >= 5.0);
}
