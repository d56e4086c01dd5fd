#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/region_fill.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/grid/grid_kind.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/parts/regions/region_part.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/files/files.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/support/spacing_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace forefront;
using namespace forefront::edit_test;
using forefront::testing::DomainBuilder;
using forefront::testing::fieldOf;
using forefront::testing::RandomSource;

namespace {

/// A rectangle of 2 x 1 that a line divides into region 1, "left", and region 2, "right".
Domain halves() {
    DomainBuilder builder;
    builder.loop({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, 1);
    builder.segment(1, 4, 2, SegmentRole::Constraint);
    builder.domain.regionMarkers = {{{0.5, 0.5}, 1}, {{1.5, 0.5}, 2}};
    builder.domain.regionNames = {{1, "left"}, {2, "right"}};
    return builder.domain;
}

RegionSize sized(double size, double growth, double maxArea = 0.0) {
    return {{}, maxArea, size, growth};
}

/// Adds the sizes of the halves to a spacing.
SpacingSpec with(SpacingSpec spec, RegionSize left, RegionSize right) {
    left.at = {0.5, 0.5};
    right.at = {1.5, 0.5};
    spec.placed.regions = {left, right};
    return spec;
}

SpacingSpec coarse() {
    SpacingSpec spec;
    spec.size = 1.0;
    return spec;
}

/// Returns the mean length of the edges of elements whose centre has an x between two bounds.
double meanEdge(const TriMesh &mesh, double from, double to) {
    double sum = 0.0, count = 0.0;
    for (const Element &e : mesh.elements) {
        const Vec2 a = mesh.nodes[index(e[0])], b = mesh.nodes[index(e[1])], c = mesh.nodes[index(e[2])];
        const double x = (a.x + b.x + c.x) / 3.0;
        if (x >= from && x < to) {
            sum += distance(a, b) + distance(b, c) + distance(c, a);
            count += 3.0;
        }
    }
    REQUIRE(count > 0.0);
    return sum / count;
}

} // namespace

TEST_CASE("Region size: the size is constant in its region, grows outside by its growth, and is named") {
    const auto field = fieldOf(with(coarse(), sized(0.02, 0.5), sized(0.1, 0.2)), halves());
    for (const Vec2 p : {Vec2{0.5, 0.5}, Vec2{0.01, 0.99}, Vec2{0.99, 0.01}, Vec2{1, 0.5}, Vec2{0, 0.5}}) {
        CHECK(field->at(p) == doctest::Approx(0.02));
    }
    CHECK(field->at({1.04, 0.5}) == doctest::Approx(0.04));
    CHECK(field->at({1.5, 0.5}) == doctest::Approx(0.1));
    CHECK(field->sample({0.5, 0.5}).origin == SpacingOrigin::Region);
    CHECK(field->sample({0.5, 0.5}).describe == "size of region 'left'");
    CHECK(field->sample({1.04, 0.5}).describe == "size of region 'left'");
    REQUIRE(field->sample({1.04, 0.5}).runnerUp.has_value());
    CHECK(field->sample({1.04, 0.5}).runnerUp->describe == "size of region 'right'");
    CHECK(field->sample({1.5, 0.5}).describe == "size of region 'right'");
}

TEST_CASE("Region size: two regions are meshed with their sizes, the same with every grid and number of threads") {
    MeshingJob job{halves(), with(coarse(), sized(0.02, 0.1), sized(0.1, 0.2)), {}};
    const auto mesh = meshDomain(job);
    REQUIRE(mesh.ok());
    CHECK(meanEdge(takeTriMesh(mesh->mesh), 0.0, 0.95) == doctest::Approx(0.02).epsilon(0.05));
    // At a distance d from the interface, the size is 0.02 + 0.1 d.
    for (const double d : {0.1, 0.3, 0.5}) {
        CHECK(meanEdge(takeTriMesh(mesh->mesh), 0.95 + d, 1.05 + d) == doctest::Approx(0.02 + 0.1 * d).epsilon(0.1));
    }
    job.spacing = with(coarse(), sized(0.02, 1.0), sized(0.1, 0.2));
    const auto steep = meshDomain(job);
    REQUIRE(steep.ok());
    CHECK(meanEdge(takeTriMesh(steep->mesh), 1.4, 2.0) == doctest::Approx(0.1).epsilon(0.1));
    for (const GridKind grid : valuesOf<GridKind>()) {
        for (const int threads : {1, 2, 3}) {
            CAPTURE(wordOf(grid));
            CAPTURE(threads);
            job.options.grid = grid;
            job.options.threads = threads;
            const auto other = meshDomain(job);
            REQUIRE(other.ok());
            REQUIRE(other->mesh.nodes == steep->mesh.nodes);
            REQUIRE(std::ranges::equal(other->mesh.triangles(), steep->mesh.triangles()));
        }
    }
}

TEST_CASE("Region size: where the minimum and the gradation limit it, it grows as other sizes do") {
    SpacingSpec spec = coarse();
    spec.minimum = 0.1;
    spec.gradation = 0.2;
    const auto field = fieldOf(with(spec, sized(0.02, 1.0), sized(0.5, 0.2)), halves());
    // max(0.1, 0.02 + d) begins to grow at d = 0.08, by at most 0.2.
    CHECK(field->at({1.07, 0.5}) == doctest::Approx(0.1));
    CHECK(field->at({1.3, 0.5}) == doctest::Approx(0.1 + 0.2 * 0.22).epsilon(0.02));
}

TEST_CASE("Region size: every point gets the smallest spacing of the regions, their areas and their growths") {
    RandomSource random(3);
    for (int round = 0; round < 40; ++round) {
        const auto any = [&] {
            return sized(random.integer(0, 3) == 0 ? 0.0 : random.between(0.02, 0.3), random.between(0.0, 1.0),
                         random.integer(0, 1) == 0 ? 0.0 : random.between(0.001, 0.05));
        };
        const RegionSize left = any(), right = any();
        SpacingSpec spec;
        spec.size = 1.0;
        spec.minimum = random.between(0.01, 0.05);
        const auto field = fieldOf(with(spec, left, right), halves());
        for (int k = 0; k < 50; ++k) {
            const Vec2 p{random.between(0.0, 2.0), random.between(0.0, 1.0)};
            double expected = 1.0;
            for (const auto &[region, d] :
                 {std::pair{left, std::max(0.0, p.x - 1.0)}, std::pair{right, std::max(0.0, 1.0 - p.x)}}) {
                if (region.size > 0.0) {
                    expected = std::min(expected, std::max(*spec.minimum, region.size + region.growth * d));
                }
                if (region.maxArea > 0.0) {
                    const double size = std::max(*spec.minimum, spacingForArea(region.maxArea));
                    expected = std::min(expected, size + 0.25 * d);
                }
            }
            CAPTURE(round);
            CAPTURE(p.x);
            REQUIRE(field->at(p) == doctest::Approx(expected).epsilon(1e-9));
            const SpacingSample sample = field->sample(p);
            REQUIRE(sample.rho == doctest::Approx(expected).epsilon(1e-9));
        }
    }
}

TEST_CASE("Region size: beside a maximum area the finer one wins, and the other is the runner-up") {
    const double areaSize = spacingForArea(0.001);
    const auto byArea = fieldOf(with(coarse(), sized(2.0 * areaSize, 0.2, 0.001), sized(0.0, 0.2)), halves());
    SpacingSample sample = byArea->sample({0.5, 0.5});
    CHECK(sample.describe == "maximum area 0.001 of region 'left'");
    REQUIRE(sample.runnerUp.has_value());
    CHECK(sample.runnerUp->describe == "size of region 'left'");
    const auto bySize = fieldOf(with(coarse(), sized(0.5 * areaSize, 0.2, 0.001), sized(0.0, 0.2)), halves());
    sample = bySize->sample({0.5, 0.5});
    CHECK(sample.describe == "size of region 'left'");
    CHECK(sample.runnerUp->describe == "maximum area 0.001 of region 'left'");
}

TEST_CASE("Region size: it needs no marker, and belongs to its place, whatever the order of markers and faces") {
    Domain domain = halves();
    const SpacingSpec spec = with(coarse(), sized(0.02, 0.5), sized(0.1, 0.2));
    const auto first = fieldOf(spec, domain);
    std::swap(domain.regionMarkers[0], domain.regionMarkers[1]);
    std::reverse(domain.segments.begin(), domain.segments.end());
    const auto reordered = fieldOf(spec, domain);
    domain.regionMarkers.clear();
    const auto unmarked = fieldOf(spec, domain);
    for (const Vec2 p : {Vec2{0.5, 0.5}, Vec2{0.99, 0.01}, Vec2{1.04, 0.5}, Vec2{1.5, 0.5}}) {
        CHECK(reordered->at(p) == first->at(p));
        CHECK(unmarked->at(p) == first->at(p));
        CHECK(reordered->sample(p).describe == first->sample(p).describe);
    }
    CHECK(unmarked->sample({0.5, 0.5}).describe == "size of region 'left'"); // faces without a marker are region 1
    domain.regionMarkers = {{{0.7, 0.2}, 2}};                                // elsewhere in the same face
    CHECK(fieldOf(spec, domain)->sample({0.5, 0.5}).describe == "size of region 'right'");
}

TEST_CASE("Region size: a given gradation limits the growth") {
    SpacingSpec spec;
    spec.size = 0.5;
    spec.gradation = 0.1;
    const auto field = fieldOf(with(spec, sized(0.02, 0.8), sized(0.0, 0.2)), halves());
    CHECK(field->at({1.5, 0.5}) == doctest::Approx(0.07));
}

TEST_CASE("Region size: commands set, check and remove it, and fillRegion keeps it") {
    Document document = *addShape({}, square({0, 0}, 10));
    document = *addRegionMarker(document, {{5, 5}, 2});
    const auto set = setRegionSize(document, 0, PartSize{0.5, 0.1});
    REQUIRE(set.ok());
    CHECK(set->regionMarkers[0] == MarkedRegion{{5, 5}, 2, 0.0, 0.5, 0.1});
    CHECK(setRegionSize(*set, 0, std::nullopt)->regionMarkers == document.regionMarkers);
    const auto refused = setRegionSize(document, 0, PartSize{-1.0, 0.1});
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().code == "bad-source");
    CHECK(refused.faults().front().message == "region 'region_2' has the size -1; expected a number above 0");
    CHECK_FALSE(setRegionSize(document, 0, PartSize{1.0, -0.5}).ok());
    CHECK(setRegionSize(document, 1, std::nullopt).faults().front().code == "no-such-marker");
    CHECK_FALSE(addRegionMarker(document, {{5, 5}, 2, 0.0, -1.0}).ok());
    const Document filled = *fillRegion(*set, {1, 1}, 7);
    REQUIRE(filled.regionMarkers.size() == 1);
    CHECK(filled.regionMarkers[0] == MarkedRegion{{1, 1}, 7, 0.0, 0.5, 0.1});
    const Document inserted = insertDrawing({}, *set, 2.0, nullptr);
    CHECK(inserted.regionMarkers[0] == MarkedRegion{{10, 10}, 2, 0.0, 1.0, 0.1});

    const auto faulty = SpacingField::build(with({}, sized(-0.5, 0.2), sized(0.0, 0.2)), halves());
    REQUIRE_FALSE(faulty.ok());
    CHECK(faulty.faults()[0].code == "bad-source");
    CHECK(faulty.faults()[0].ids == std::vector<std::uint32_t>{0});
    CHECK(faulty.faults()[0].at == Vec2{0.5, 0.5});
}

TEST_CASE("Region size: project files keep it, and older ones have none") {
    Document document;
    document.regionMarkers = {{{1, 2}, 3, 0.125, 0.25, 0.0}, {{4, 5}, 6}};
    const std::string text = projectText(document);
    const auto read = parseProject(text, "test");
    REQUIRE(read.ok());
    CHECK(read->regionMarkers == document.regionMarkers);
    CHECK(text.find("\"size\": 0.25, \"growth\": 0}") != std::string::npos);
    CHECK(text.find("{\"at\": [4, 5], \"tag\": 6}") != std::string::npos);
    const auto refused = parseProject("{\"format\": \"forefront\", \"version\": 2, \"shapes\": [],\n"
                                      "\"regionMarkers\": [{\"at\": [0, 0], \"tag\": 1, \"size\": 0}]}",
                                      "test");
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().line == 2);
}

TEST_CASE("Region size: formulas set it; they must not set it to 0") {
    Document document = *setParameters({}, {{"h", "0.5"}});
    document = *addRegionMarker(document, {{5, 5}, 2, 0.0, 0.5, 0.25});
    document.formulas = {{"region/0/growth"_number, "h/2"}, {"region/0/size"_number, "h"}};
    pruneFormulas(document);
    REQUIRE(document.formulas.size() == 2);
    const auto finer = overrideParameters(document, {{"h", "0.1"}});
    REQUIRE(finer.ok());
    CHECK(finer->regionMarkers[0].size == 0.1);
    CHECK(finer->regionMarkers[0].growth == 0.05);
    const auto refused = overrideParameters(document, {{"h", "0"}});
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().code == "bad-number");
    Document none = *setRegionSize(document, 0, std::nullopt);
    CHECK_FALSE(readNumber(none, "region/0/size"_number).has_value());
    pruneFormulas(none);
    CHECK(none.formulas.empty());
}
