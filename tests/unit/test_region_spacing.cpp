#include "core/drawing_files/project/project.hpp"
#include "core/engine/mesh/large_elements.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/parts/regions/region_part.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/files/files.hpp"
#include "tests/support/domain_builder.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

using namespace forefront;
using forefront::testing::DomainBuilder;
using forefront::testing::RandomSource;

namespace {

constexpr double kExcess = 1.125; ///< of single elements over the maximum area

/// A rectangle of 2 x 1 that a line divides into region 1 (left) and region 2 (right).
Domain twoSquares() {
    DomainBuilder builder;
    builder.loop({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}, 1);
    builder.segment(1, 4, 2, SegmentRole::Constraint);
    builder.domain.regionMarkers = {{{0.5, 0.5}, 1}, {{1.5, 0.5}, 2}};
    builder.domain.regionNames[1] = "left";
    return builder.domain;
}

/// Returns a spacing with maximum areas of the two squares.
SpacingSpec areas(double left, double right) {
    SpacingSpec spec;
    spec.placed.regions = {{.at = {0.5, 0.5}, .maxArea = left}, {.at = {1.5, 0.5}, .maxArea = right}};
    return spec;
}

std::optional<RegionPart> partOf(const std::vector<RegionSize> &regions, const Domain &domain) {
    return RegionPart::build(regions, LazyFaces(domain, {}, placesOf(regions)), 0.0);
}

struct RegionAreas {
    std::size_t count = 0;
    double largest = 0.0, sum = 0.0;
    std::vector<double> all{};
    std::size_t above(double maximum) const {
        return static_cast<std::size_t>(
            std::count_if(all.begin(), all.end(), [=](double area) { return area > maximum; }));
    }
};

/// `warnings` receives what is said of elements above the maximum areas.
std::map<std::int32_t, RegionAreas> areasByRegion(const MeshingJob &job, Diagnostics *warnings = nullptr) {
    const auto outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome.ok(), toString(outcome.ok() ? Diagnostic{} : outcome.faults().front()));
    std::map<std::int32_t, RegionAreas> areas;
    const TriMesh mesh = takeTriMesh(outcome->mesh);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto &[a, b, c] = mesh.elements[e];
        const Vec2 p = mesh.nodes[index(a)];
        const double area = 0.5 * cross(mesh.nodes[index(b)] - p, mesh.nodes[index(c)] - p);
        RegionAreas &region = areas[mesh.region(static_cast<std::uint32_t>(e))];
        region.largest = std::max(region.largest, area);
        region.sum += area;
        region.all.push_back(area);
        ++region.count;
    }
    if (warnings != nullptr) {
        *warnings = largeElements(mesh, job.domain, job.spacing.placed.regions);
    }
    return areas;
}

} // namespace

TEST_CASE("Region area: the largest triangle respects the maximum") {
    std::map<double, std::size_t> counts;
    for (const double area : {0.01, 0.001}) {
        MeshingJob job{twoSquares(), areas(area, 0.0), {}};
        job.spacing.size = 0.5;
        auto regions = areasByRegion(job);
        CHECK(regions[1].largest <= area);
        CHECK(regions[1].largest >= 0.6 * area); // not much finer than necessary
        CHECK(regions[2].largest > regions[1].largest);
        counts[area] = regions[1].count;
    }
    CHECK(counts[0.001] > 5 * counts[0.01]);
}

TEST_CASE(
    "Region area: on irregular domains, few elements exceed it, by at most an eighth, and a warning counts them") {
    RandomSource random(11);
    const std::map<std::int32_t, double> maxima = {{5, 0.005}, {6, 0.05}};
    std::size_t elements = 0, above = 0;
    for (int round = 0; round < 6; ++round) {
        DomainBuilder builder;
        builder.loop(forefront::testing::star(random, {0, 0}, 4.0, 0.7, 1.0, 24), 1);
        builder.loop(forefront::testing::star(random, {0, 0}, 2.0, 0.7, 1.0, 12), 2, SegmentRole::Constraint);
        builder.domain.regionMarkers = {{{0, 0}, 5}, {{0, 2.4}, 6}};
        for (const Method method : {Method::Fast, Method::Classic}) {
            MeshingJob job{builder.domain, {}, {}};
            job.spacing.placed.regions = {{.at = {0, 0}, .maxArea = 0.005}, {.at = {0, 2.4}, .maxArea = 0.05}};
            job.options.method = method;
            Diagnostics warnings;
            auto regions = areasByRegion(job, &warnings);
            for (const auto &[tag, maximum] : maxima) {
                const std::size_t count = regions[tag].above(maximum);
                CHECK(regions[tag].largest <= kExcess * maximum);
                CHECK(regions[tag].sum <= 0.6 * maximum * static_cast<double>(regions[tag].count));
                const auto said =
                    std::find_if(warnings.begin(), warnings.end(), [tag = tag](const Diagnostic &warning) {
                        return warning.message.find(" of region 'region_" + std::to_string(tag) + "'") !=
                               std::string::npos;
                    });
                REQUIRE((said != warnings.end()) == (count > 0));
                CHECK((count == 0 || said->message.starts_with(std::to_string(count) + ' ')));
                elements += regions[tag].count;
                above += count;
            }
        }
    }
    CHECK(above > 0); // so that the warnings are tested
    CHECK(500 * above <= elements);
}

TEST_CASE("Region area: quadrilaterals respect the maximum, too, where a region has them") {
    const auto largest = [](const MeshingJob &job) {
        const auto outcome = meshDomain(job);
        REQUIRE(outcome.ok());
        std::map<std::int32_t, double> areas;
        const MeshView view(outcome->mesh);
        forEachCell(view, [&](const PlacedCell &cell, std::size_t e) {
            double &area = areas[view.region(e)];
            area = std::max(area, 0.5 * twiceArea(cell));
        });
        return areas;
    };
    for (const double area : {0.01, 0.001}) {
        MeshingJob job{twoSquares(), areas(area, area), {}};
        job.spacing.size = 0.5;
        job.options.elements = Elements::Quads;
        for (const auto &[tag, most] : largest(job)) {
            CHECK(most <= kExcess * area);
            CHECK(most >= 0.45 * area); // not much finer than necessary
        }
        job.regionElements = {{2, Elements::Triangles}};
        for (const auto &[tag, most] : largest(job)) {
            CHECK(most <= kExcess * area);
        }
        job.options.elements = Elements::Triangles;
        job.regionElements = {{1, Elements::Quads}};
        for (const auto &[tag, most] : largest(job)) {
            CHECK(most <= kExcess * area);
        }
    }
    const Domain domain = twoSquares();
    const std::vector<RegionSize> regions = areas(0.01, 0.01).placed.regions;
    const auto part = RegionPart::build(regions, LazyFaces(domain, {}, placesOf(regions)), 0.0, {false, {2}});
    REQUIRE(part);
    CHECK(part->at({0.5, 0.5}) == spacingForArea(0.01));
    CHECK(part->at({1.5, 0.5}) == spacingForArea(0.01, true));
    CHECK(spacingForArea(0.01, true) < 0.1);
}

TEST_CASE("Region area: elements that a minimum size keeps above it are warned of, with the place of the largest") {
    MeshingJob job{twoSquares(), areas(0.001, 0.0), {}};
    job.spacing.size = 0.5;
    job.spacing.minimum = 0.2;
    const auto outcome = meshDomain(job);
    REQUIRE(outcome.ok());
    const Diagnostics warnings = largeElements(outcome->mesh, job.domain, job.spacing.placed.regions);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].severity == Severity::Warning);
    CHECK(warnings[0].code == "large-elements");
    CHECK(warnings[0].message.find(" elements exceed the maximum area 0.001 of region 'left'; the largest has 0.0") !=
          std::string::npos);
    REQUIRE(warnings[0].at.has_value());
    CHECK(warnings[0].at->x < 1.0);
    CHECK(largeElements(outcome->mesh, job.domain, {}).empty());
    CHECK(largeElements(outcome->mesh, job.domain, areas(0.1, 0.1).placed.regions).empty());
}

TEST_CASE("Region area: the spacing is constant in its region, grows outside, and is named") {
    const auto field = SpacingField::build(areas(0.001, 0.0), twoSquares());
    REQUIRE(field.ok());
    const double size = spacingForArea(0.001);
    for (const Vec2 p : {Vec2{0.5, 0.5}, Vec2{0.01, 0.99}, Vec2{0.99, 0.01}, Vec2{1, 0.5}, Vec2{0, 0.5}}) {
        CHECK((*field)->at(p) == doctest::Approx(size));
    }
    CHECK((*field)->minimum() == doctest::Approx(size));
    const SpacingSample inside = (*field)->sample({0.5, 0.5});
    CHECK(inside.origin == SpacingOrigin::Region);
    CHECK(inside.source == 0);
    CHECK(inside.describe == "maximum area 0.001 of region 'left'");
    CHECK((*field)->at({1.01, 0.5}) == doctest::Approx(size + 0.25 * 0.01));
    const SpacingSample beside = (*field)->sample({1.01, 0.5});
    CHECK(beside.origin == SpacingOrigin::Gradation);
    CHECK(beside.describe == "limited by gradation 0.25 from region 'left' at (1, 0.5)");
}

TEST_CASE("Region area: combined with other parts, the finest wins") {
    SpacingSpec spec = areas(0.01, 0.0);
    spec.size = 0.02;
    const auto fine = SpacingField::build(spec, twoSquares());
    REQUIRE(fine.ok());
    CHECK((*fine)->at({0.5, 0.5}) == 0.02);
    spec.size = 0.5;
    spec.minimum = 0.2;
    const auto raised = SpacingField::build(spec, twoSquares());
    REQUIRE(raised.ok());
    CHECK((*raised)->at({0.5, 0.5}) == 0.2);
}

TEST_CASE("Region area: the smallest of several areas in a face applies") {
    SpacingSpec spec = areas(0.01, 0.0);
    spec.placed.regions.push_back({.at = {0.2, 0.2}, .maxArea = 0.002});
    const auto part = partOf(spec.placed.regions, twoSquares());
    REQUIRE(part.has_value());
    CHECK(part->at({0.5, 0.5}) == spacingForArea(0.002));
}

TEST_CASE("Region area: every point gets the limit of its face") {
    // Columns of faces between vertical and slanting walls that meet in common nodes.
    DomainBuilder builder;
    constexpr int kColumns = 6;
    for (int i = 0; i <= kColumns; ++i) {
        builder.node({static_cast<double>(i), 0});
        builder.node({static_cast<double>(i), 3});
    }
    for (std::uint32_t i = 0; i < kColumns; ++i) {
        builder.segment(2 * i, 2 * i + 2, 1);
        builder.segment(2 * i + 1, 2 * i + 3, 1);
        builder.segment(2 * i, 2 * i + 3, 2, SegmentRole::Constraint); // diagonal
    }
    for (std::uint32_t i = 0; i <= kColumns; ++i) {
        builder.segment(2 * i, 2 * i + 1, 1, i == 0 || i == kColumns ? SegmentRole::Boundary : SegmentRole::Constraint);
    }
    std::vector<RegionSize> regions;
    for (int i = 0; i < kColumns; ++i) {
        regions.push_back({.at = {i + 0.75, 1.0}, .maxArea = i % 3 == 1 ? 0.0 : 0.01 * (i + 1)}); // below
        regions.push_back({.at = {i + 0.25, 2.0}, .maxArea = 0.001 * (i + 1)});                   // above
    }
    const auto part = partOf(regions, builder.domain);
    REQUIRE(part.has_value());
    RandomSource random(5);
    for (int k = 0; k < 5000; ++k) {
        const Vec2 p{random.between(-0.5, kColumns + 0.5), random.between(-0.5, 3.5)};
        const double column = std::floor(p.x);
        double expected = std::numeric_limits<double>::infinity();
        if (p.x > 0 && p.x < kColumns && p.y > 0 && p.y < 3) {
            const bool below = p.y < 3 * (p.x - column);
            const double area =
                below ? (static_cast<int>(column) % 3 == 1 ? 0.0 : 0.01 * (column + 1)) : 0.001 * (column + 1);
            expected = area > 0.0 ? spacingForArea(area) : expected;
        }
        REQUIRE(part->at(p) == expected);
    }
    // On a vertical wall the face to its right counts.
    CHECK(part->at({2, 2}) == spacingForArea(0.003));
    CHECK(part->at({2, 0.5}) == spacingForArea(0.003));
}

TEST_CASE("Region area: crossing segments disable it; invalid areas are refused with their place") {
    Domain crossed = twoSquares();
    crossed.segments.push_back({0, 3, 1, SegmentRole::Constraint});
    CHECK_FALSE(partOf(areas(0.01, 0.0).placed.regions, crossed).has_value());
    CHECK_FALSE(partOf(areas(0.0, 0.0).placed.regions, twoSquares()).has_value());

    const auto refused = SpacingField::build(areas(0.01, -1.0), twoSquares());
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().size() == 1);
    CHECK(refused.faults()[0].code == "bad-region-area");
    CHECK(refused.faults()[0].ids == std::vector<std::uint32_t>{1});
    CHECK(refused.faults()[0].at == Vec2{1.5, 0.5});
}

TEST_CASE("Region area: project files keep it") {
    Document document;
    document.regionMarkers = {{{1, 2}, 3, 0.125}, {{4, 5}, 6}};
    const auto read = parseProject(projectText(document), "test");
    REQUIRE(read.ok());
    CHECK(read->regionMarkers == document.regionMarkers);
    CHECK(projectText(document).find("\"maxArea\": 0.125") != std::string::npos);
}

TEST_CASE("Region area: an area larger than the automatic one is the size where it is given") {
    DomainBuilder builder; // 100 x 60, divided at x = 60
    builder.loop({{0, 0}, {60, 0}, {100, 0}, {100, 60}, {60, 60}, {0, 60}}, 1);
    builder.segment(1, 4, 2, SegmentRole::Constraint);
    Domain &domain = builder.domain;
    domain.regionNames[1] = "soil";
    const double automatic = domain.bounds().diagonal() / 45.0;
    for (const double byArea : {0.0, 1.0}) {
        domain.regionMarkers = {{{30, 30}, 1}, {{80, 30}, 2}};
        const double size = spacingForArea(50.0);
        REQUIRE(size > 2.0 * automatic);
        SpacingSpec spec;
        spec.placed.regions = {{.at = {30, 30}, .maxArea = byArea * 50.0, .size = (1.0 - byArea) * size}};
        const auto field = SpacingField::build(spec, domain);
        REQUIRE(field.ok());
        CHECK((*field)->at({20, 30}) == doctest::Approx(size));
        CHECK((*field)->sample({20, 30}).describe ==
              (byArea > 0.0 ? "maximum area 50 of region 'soil'" : "size of region 'soil'"));
        CHECK((*field)->at({80, 30}) == doctest::Approx(automatic));
        CHECK((*field)->sample({80, 30}).describe == "automatic: size of the domain");
        CHECK((*field)->at({58, 30}) == doctest::Approx(automatic + 0.25 * 2.0));
        CHECK((*field)->sample({58, 30}).describe == "limited by gradation 0.25 from the automatic sizes at (60, 30)");
        CHECK((*field)->maximum() == doctest::Approx(size));
        auto regions = areasByRegion({domain, spec, {}});
        const double mean = 3600.0 / static_cast<double>(regions[1].count);
        CHECK(regions[1].largest <= 50.0);
        CHECK(mean > 12.0); // 4 without the region
        CHECK(2400.0 / static_cast<double>(regions[2].count) < 6.0);
    }
    // What the boundary forces stays: a channel of width 1, and short segments.
    DomainBuilder narrow;
    narrow.loop({{0, 0}, {100, 0}, {100, 30}, {140, 30}, {140, 31}, {100, 31}, {100, 60}, {0, 60}}, 1);
    SpacingSpec maximum;
    maximum.placed.regions = {{.at = {30, 30}, .maxArea = 50.0}};
    const auto field = SpacingField::build(maximum, narrow.domain);
    REQUIRE(field.ok());
    CHECK((*field)->at({120, 30.5}) < 0.8);
    CHECK((*field)->at({30, 30}) == doctest::Approx(spacingForArea(50.0)));
    maximum.maximum = 2.0; // still limits all
    CHECK((*SpacingField::build(maximum, narrow.domain))->at({30, 30}) == 2.0);
}
