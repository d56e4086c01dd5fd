#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/chord_limit.hpp"
#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/improve/growth_limit.hpp"
#include "core/engine/improve/improve.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/random_curves.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A plate of 120 by 80 with a hole of radius 5, and a size of 4.
MeshingJob holedPlate() {
    const Vec2 corners[] = {{0, 0}, {120, 0}, {120, 80}, {0, 80}};
    CurveLoop outline;
    for (std::size_t k = 0; k < 4; ++k) {
        outline.push_back(Curve::line(corners[k], corners[(k + 1) % 4]));
    }
    MeshingJob job;
    job.domain = curvedDomain({outline, {Curve::circle({60, 40}, {65, 40})}}, 0.01);
    job.spacing.size = 4.0;
    return job;
}

double worstGrowth(const MeshView &mesh) {
    const std::vector<double> growth = measureValues(Measure::AreaRatio, mesh, edgesOf(mesh), nullptr);
    return *std::max_element(growth.begin(), growth.end());
}

double minimumAngle(const MeshView &mesh) {
    const std::vector<double> angles = measureValues(Measure::MinAngle, mesh, edgesOf(mesh), nullptr);
    return *std::min_element(angles.begin(), angles.end());
}

std::shared_ptr<const SpacingField> fieldFor(const MeshingJob &job, GivenSegments segments = GivenSegments::Divided) {
    auto field = SpacingField::build(job.spacing, job.domain, {}, segments);
    REQUIRE(field.ok());
    return *field;
}

/// Returns the area of a mesh's triangles of which the longest edge is at most `length`, within a box.
double areaOfShortEdges(const MeshView &mesh, double length, const Box2 &box) {
    double area = 0.0;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> corners = mesh.cornersOf(e);
        const Vec2 a = mesh.nodes[index(corners[0])], b = mesh.nodes[index(corners[1])],
                   c = mesh.nodes[index(corners[2])];
        const bool within = box.contains(a) && box.contains(b) && box.contains(c);
        if (within && std::max({distance(a, b), distance(b, c), distance(c, a)}) <= length) {
            area += 0.5 * cross(b - a, c - a);
        }
    }
    return area;
}

/// Returns a square with sides of 10, each divided into equal segments.
Domain dividedSquare(int perSide) {
    std::vector<Vec2> outline;
    const Vec2 corners[] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}};
    for (int side = 0; side < 4; ++side) {
        for (int k = 0; k < perSide; ++k) {
            outline.push_back(lerp(corners[side], corners[side + 1], static_cast<double>(k) / perSide));
        }
    }
    DomainBuilder builder;
    builder.loop(outline, 1);
    return builder.domain;
}

} // namespace

TEST_CASE("Curve tolerance: beside a curve, the spacing is at most the chord that the tolerance allows, graded") {
    MeshingJob job = holedPlate();
    const double chord = ChordLimit::longest(1.0 / 5.0, chordTolerance(job.domain));
    REQUIRE(chord < 2.0);
    for (const double gradation : {0.0, 0.1}) {
        CAPTURE(gradation);
        job.spacing.gradation = gradation > 0.0 ? std::optional(gradation) : std::nullopt;
        const auto field = fieldFor(job);
        for (int k = 0; k < 100; ++k) {
            const Vec2 on = polar({60, 40}, 5.0, 0.0628 * k), off = polar({60, 40}, 9.0, 0.0628 * k);
            CHECK(field->at(on) <= 1.02 * chord);
            CHECK(field->at(on) >= 0.9 * chord);
            const double expected = std::min(4.0, chord + 4.0 * (gradation > 0.0 ? gradation : 0.25));
            CHECK(field->at(off) == doctest::Approx(expected).epsilon(0.03));
        }
        CHECK(field->at({10, 10}) == 4.0);
        const SpacingSample sample = field->sample({60, 35});
        CHECK(sample.origin == SpacingOrigin::Boundary);
        CHECK(sample.describe.starts_with("curve tolerance of '"));
        REQUIRE(sample.runnerUp.has_value());
        CHECK(sample.runnerUp->describe == "constant");
        CHECK(field->sample({10, 10}).describe == "constant");
    }
}

TEST_CASE("Curve tolerance: limits, other rules and tolerances that are met anyway keep their say") {
    MeshingJob job = holedPlate();
    job.spacing.minimum = 3.0;
    CHECK(fieldFor(job)->at({60, 35}) == doctest::Approx(3.0));
    job.spacing.minimum.reset();
    job.domain.curveTolerance = 5.0; // an eighth of a turn is still asked for
    CHECK(fieldFor(job)->at({60, 35}) == doctest::Approx(0.25 * 3.14159265 * 5.0).epsilon(0.01));
    job.domain.curveTolerance = 0.0;
    job.spacing.size = 1.0;
    const auto fine = fieldFor(job);
    CHECK(fine->sample({60, 35}).describe == "constant");
    CHECK(fine->minimum() == 1.0);
    CHECK(fine->maximum() == 1.0);
    job.spacing.size = 4.0;
    for (const DomainSegment &segment : job.domain.segments) {
        job.spacing.placed.elements.push_back(segment.stretch.follows() ? 12 : 0); // stands above the tolerance
    }
    CHECK(fieldFor(job)->at({60, 35}) == 4.0);
    CHECK(fieldFor(holedPlate(), GivenSegments::Kept)->at({60, 35}) == 4.0);
}

TEST_CASE("Curve tolerance: sizes grade from a hole, and its edges are no longer than before") {
    for (const Method method : {Method::Fast, Method::Classic}) {
        for (const ImproveLevel level : {ImproveLevel::Default, ImproveLevel::Best}) {
            MeshingJob job = holedPlate();
            job.options.method = method;
            job.options.improve = level;
            const auto outcome = meshDomain(job);
            REQUIRE(outcome);
            CHECK(verifyAgainst(outcome->mesh, job.domain).empty());
            CHECK(worstGrowth(outcome->mesh) < 2.0); // was 2.8
            CHECK(minimumAngle(outcome->mesh) > 35.0);
            std::size_t around = 0;
            for (const TaggedEdge &edge : outcome->mesh.edges) {
                around += distance(outcome->mesh.nodes[index(edge.a)], {60, 40}) < 5.1 ? 1 : 0;
            }
            CHECK(around >= 19); // as many as the tolerance needs
        }
    }
}

TEST_CASE("limitGrowth: evens areas without spoiling shapes") {
    TriMesh mesh;
    const int n = 8; // a grid with one node out of place
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            mesh.nodes.push_back({i + 0.5 * j, 0.8660254 * j});
        }
    }
    const auto id = [&](int i, int j) { return NodeId{static_cast<std::uint32_t>(j * (n + 1) + i)}; };
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            mesh.elements.push_back({id(i, j), id(i + 1, j), id(i, j + 1)});
            mesh.elements.push_back({id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    }
    mesh.nodes[index(id(4, 4))].x += 0.4;
    const double before = worstGrowth(mesh), angle = minimumAngle(mesh);
    REQUIRE(before > 1.6);
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    work.measureAlpha();
    CHECK(limitGrowth(work, {.growth = 1.4}, {}) > 0);
    CHECK(worstGrowth(mesh) <= 1.4 * 1.001);
    CHECK(minimumAngle(mesh) >= angle);
    CHECK(limitGrowth(work, {.growth = 1.4}, {}) == 0);
}

TEST_CASE("limitGrowth: areas on both sides of a tagged edge count, and are evened") {
    const auto node = [](std::uint32_t n) { return NodeId{n}; };
    TriMesh mesh; // a tagged edge from (0, 0) to (2, 0), and free nodes above and below it, at unlike distances
    mesh.nodes = {{0, 0}, {2, 0}, {1, 1}, {1, -0.4}, {1, 2}, {-1, 0.8}, {3, 0.8}, {1, -2}, {-1, -0.8}, {3, -0.8}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(1), node(0), node(3)}, {node(2), node(1), node(6)},
                     {node(2), node(6), node(4)}, {node(2), node(4), node(5)}, {node(2), node(5), node(0)},
                     {node(3), node(0), node(8)}, {node(3), node(8), node(7)}, {node(3), node(7), node(9)},
                     {node(3), node(9), node(1)}};
    mesh.edges = {{node(0), node(1), 5}};
    ThreadPool pool(1);
    ImproveWorkspace work(mesh, pool);
    work.measureAlpha();
    CHECK(growthOf(work) == doctest::Approx(worstGrowth(mesh)));
    REQUIRE(worstGrowth(mesh) > 2.4);
    CHECK(limitGrowth(work, {.growth = 1.5, .alpha = 0.5, .angle = 20.0}, {}) > 0);
    CHECK(worstGrowth(mesh) < 1.7);
    CHECK(growthOf(work) == doctest::Approx(worstGrowth(mesh)));
}

TEST_CASE("improve: level Best leaves no areas of neighbours more unlike than level Default does, or than 2 to 1") {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        RandomSource random(seed);
        MeshingJob job;
        addLoop(job.domain, star(random, {0, 0}, 4.0, 0.7, 1.0, 24));
        job.spacing.size = 0.25;
        job.options.improve = ImproveLevel::None;
        const auto front = meshDomain(job);
        REQUIRE(front);
        TriMesh byDefault = takeTriMesh(front->mesh), byBest = byDefault;
        improve(byDefault, {ImproveLevel::Default, 1, front->spacing.get()});
        improve(byBest, {ImproveLevel::Best, 1, front->spacing.get()});
        CHECK(worstGrowth(byBest) <= std::max(2.0, worstGrowth(byDefault)));
        CHECK(verify(byBest).empty());
    }
}

TEST_CASE("improve: progress of all levels rises to the end") {
    MeshingJob job = holedPlate();
    job.options.improve = ImproveLevel::None;
    const auto front = meshDomain(job);
    REQUIRE(front);
    for (const ImproveLevel level : {ImproveLevel::Default, ImproveLevel::Best}) {
        TriMesh mesh = takeTriMesh(front->mesh);
        std::vector<double> fractions;
        Progress progress;
        progress.report = [&](std::string_view, double fraction) { fractions.push_back(fraction); };
        improve(mesh, {level, 1, front->spacing.get()}, progress);
        REQUIRE(fractions.size() > 3);
        CHECK(std::is_sorted(fractions.begin(), fractions.end()));
        CHECK(fractions.back() <= 1.0);
        CHECK(fractions.back() >= (level == ImproveLevel::Best ? 1.0 : 0.7));
    }
}

TEST_CASE("Kept segments: the size asked for holds inside, with good shapes on long segments") {
    for (const int perSide : {4, 10}) {
        for (const Method method : {Method::Fast, Method::Classic}) {
            for (const ImproveLevel level : {ImproveLevel::None, ImproveLevel::Default, ImproveLevel::Best}) {
                CAPTURE(perSide);
                MeshingJob job;
                job.domain = dividedSquare(perSide);
                job.spacing.size = 0.1;
                job.options.keepBoundary = true;
                job.options.method = method;
                job.options.improve = level;
                const auto outcome = meshDomain(job);
                REQUIRE(outcome);
                CHECK(verifyAgainst(outcome->mesh, job.domain).empty());
                CHECK(outcome->mesh.edges.size() == 4U * static_cast<std::size_t>(perSide));
                const double reach = 7.0 / perSide;
                const Box2 inner{{reach + 0.3, reach + 0.3}, {9.7 - reach, 9.7 - reach}};
                const double area = areaOfShortEdges(outcome->mesh, 0.2, inner);
                CHECK(area > 0.9 * inner.size().x * inner.size().y);
                if (level != ImproveLevel::None) {
                    CHECK(minimumAngle(outcome->mesh) > 25.0); // was 7 to 18
                }
                REQUIRE(outcome->spacing->notes().size() == 1);
                CHECK(outcome->spacing->notes().front().code == "long-segments");
                CHECK(outcome->spacing->notes().front().severity == Severity::Warning);
            }
        }
    }
}

TEST_CASE("Kept segments: the size falls from long segments, not from those that fit it, and short ones stay") {
    MeshingJob job;
    job.domain = squareDomain(10.0);
    job.spacing.size = 0.5;
    const auto field = fieldFor(job, GivenSegments::Kept);
    CHECK(field->at({5, 0}) == doctest::Approx(5.77));
    CHECK(field->at({5, 2}) == doctest::Approx(5.77 - 2.0 * 1.15)); // steeper, so that the middle has the size
    CHECK(field->at({5, 5}) == 0.5);
    CHECK(field->sample({5, 0}).describe == "kept segment of 'boundary_1' at (5, 0)");
    CHECK(field->maximum() >= 5.77);
    REQUIRE(field->notes().size() == 1);
    CHECK(field->notes().front().message.find("up to 20 times longer than the size") != std::string::npos);
    CHECK(fieldFor(job)->at({5, 0}) == 0.5); // divided segments follow the size
    CHECK(fieldFor(job)->notes().empty());
    job.spacing.size = 4.0; // not far below the lengths
    CHECK(fieldFor(job, GivenSegments::Kept)->at({5, 0}) == 4.0);
    job.spacing.size = 0.5;
    DomainBuilder builder; // a side of short segments among long ones
    std::vector<Vec2> outline = {{0, 10}, {0, 0}};
    for (int k = 1; k <= 20; ++k) {
        outline.push_back({0.5 * k, 0.0});
    }
    outline.push_back({10, 10});
    builder.loop(outline, 1);
    job.domain = builder.domain;
    const auto mixed = fieldFor(job, GivenSegments::Kept);
    CHECK(mixed->at({5, 0}) < 1.0);
    CHECK(mixed->at({0.25, 0}) < 1.0);
    CHECK(mixed->at({5, 10}) == doctest::Approx(5.77));
}
