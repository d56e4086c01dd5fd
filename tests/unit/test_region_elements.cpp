#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "tests/support/meshed_job.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace region_cases {

/// A rectangle of 3 by 1 in three squares with the regions 1, 2 and 3.
MeshingJob squares() {
    MeshingJob job;
    Domain &domain = job.domain;
    domain.nodes = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}};
    for (std::uint32_t k = 0; k < 8; ++k) {
        domain.segments.push_back({k, (k + 1) % 8, 1, SegmentRole::Boundary, {}});
    }
    domain.segments.push_back({1, 6, 2, SegmentRole::Constraint, {}});
    domain.segments.push_back({2, 5, 2, SegmentRole::Constraint, {}});
    domain.regionMarkers = {{{0.5, 0.5}, 1}, {{1.5, 0.5}, 2}, {{2.5, 0.5}, 3}};
    job.spacing.expression = "0.07 + 0.03*x";
    job.options.verify = true;
    return job;
}

struct ShapeCounts {
    std::size_t triangles = 0, quads = 0;
};

ShapeCounts countsOf(const Mesh &mesh, std::int32_t region) {
    ShapeCounts counts;
    const MeshView view(mesh);
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        if (view.region(e) == region) {
            ++(traitsOf(view.kindOf(e)).corners == 4 ? counts.quads : counts.triangles);
        }
    }
    return counts;
}

} // namespace region_cases

using namespace region_cases;

TEST_CASE("Elements of regions: each region has its own shapes, conforming at the interfaces") {
    for (const Elements everywhere : {Elements::Triangles, Elements::Quads, Elements::Mixed}) {
        for (const Elements inSecond : {Elements::Triangles, Elements::Quads, Elements::Mixed}) {
            MeshingJob job = squares();
            job.options.elements = everywhere;
            job.regionElements = {{2, inSecond}};
            const Mesh mesh = meshedJob(job).mesh;
            for (const std::int32_t region : {1, 2, 3}) {
                const ShapeCounts counts = countsOf(mesh, region);
                const Elements shapes = region == 2 ? inSecond : everywhere;
                CHECK((counts.quads == 0) == (shapes == Elements::Triangles));
                if (shapes != Elements::Mixed) {
                    CHECK((counts.triangles == 0) == (shapes == Elements::Quads));
                }
            }
        }
    }
}

TEST_CASE("Elements of regions: the report counts the quadrilaterals of all parts, and plans mesh none of them") {
    MeshingJob job = squares();
    job.regionElements = {{1, Elements::Quads}, {3, Elements::Mixed}};
    for (const Elements everywhere : {Elements::Triangles, Elements::Quads}) {
        job.options.elements = everywhere;
        const MeshingOutcome outcome = meshedJob(job);
        std::size_t quads = 0;
        for (const std::int32_t region : {1, 2, 3}) {
            quads += countsOf(outcome.mesh, region).quads;
        }
        CHECK(outcome.quads.quadrilaterals == quads);
    }
    const Result<PreparedJob> plan = planMesh(job);
    REQUIRE(plan);
    CHECK(plan->layers == nullptr);
    CHECK(plan->estimatedElements > 0.0);
}

TEST_CASE("Elements of regions: the same mesh where a region asks for what all have, and whole domains") {
    MeshingJob job = squares();
    const std::uint64_t hash = meshHash(meshedJob(job).mesh);
    job.regionElements = {{2, Elements::Triangles}};
    CHECK(countsOf(meshedJob(job).mesh, 1).quads == 0);
    CHECK(meshHash(meshedJob(job).mesh) == hash);
    job.regionElements = {{1, Elements::Quads}, {2, Elements::Quads}, {3, Elements::Mixed}};
    const Mesh mesh = meshedJob(job).mesh;
    CHECK(countsOf(mesh, 1).triangles == 0);
    CHECK(countsOf(mesh, 2).triangles == 0);
    CHECK(countsOf(mesh, 3).quads > 0);
    CHECK(meshHash(meshedJob(job).mesh) == meshHash(mesh));
}

TEST_CASE("Elements of regions: second order, holes, points, given segments, layers, mapped regions and strips") {
    MeshingJob job = squares();
    job.regionElements = {{2, Elements::Quads}, {3, Elements::Mixed}};
    for (const Vec2 p : {Vec2{0.31, 0.4}, Vec2{1.42, 0.63}, Vec2{2.5, 0.5}}) {
        job.domain.points.push_back({static_cast<std::uint32_t>(job.domain.nodes.size()), 7});
        job.domain.nodes.push_back(p);
    }
    addLoop(job.domain, {{1.6, 0.2}, {1.8, 0.2}, {1.7, 0.35}}, 4);
    CHECK(countsOf(meshedJob(job).mesh, 2).quads > 0);
    job.options.order = ElementOrder::Second;
    CHECK(countsOf(meshedJob(job).mesh, 2).quads > 0);
    job.options.order = ElementOrder::First;
    job.options.keepBoundary = true;
    CHECK(countsOf(meshedJob(job).mesh, 1).quads == 0);
    job.options.keepBoundary = false;
    MeshingJob layered = job;
    layered.layers = {LayerSpec{.tag = 4, .first = 0.01, .count = 3}};
    CHECK(countsOf(meshedJob(layered).mesh, 2).quads > 0);
    job = squares();
    job.regionElements = {{2, Elements::Quads}};
    job.mapped = {{1}, {2}};
    const Mesh rows = meshedJob(job).mesh;
    CHECK(countsOf(rows, 1).quads == 0);
    CHECK(countsOf(rows, 2).triangles == 0);
    job.mapped.clear();
    job.domain.nodes.insert(job.domain.nodes.end(), {{1.2, 0.5}, {1.8, 0.5}});
    job.domain.segments.push_back({8, 9, 5, SegmentRole::Constraint, {}});
    job.domain.regionMarkers[1].at = {1.5, 0.8};
    job.strips = {{5, 0.1, 1}};
    CHECK(countsOf(meshedJob(job).mesh, 2).triangles == 0);
}

TEST_CASE("Elements of regions: what is wrong is refused, and the stepper follows") {
    MeshingJob job = squares();
    job.regionElements = {{9, Elements::Quads}};
    CHECK(refusalOf(job) == "unknown-region");
    job.regionElements = {{2, Elements::Quads}, {2, Elements::Mixed}};
    CHECK(refusalOf(job) == "repeated-region");
    job.regionElements = {{2, Elements::Quads}};
    const Mesh whole = meshedJob(job).mesh;
    Result<MeshStepper> stepper = MeshStepper::create(job);
    REQUIRE(stepper);
    job.options.leastAngle = 20.0;
    CHECK(refusalOf(job) == "least-angle");
}

TEST_CASE("Elements of regions: settings of the faces without a marker stay when there are none left") {
    MeshingJob job = squares();
    job.domain.regionMarkers[0].tag = 4;
    const std::uint64_t hash = meshHash(meshedJob(job).mesh);
    job.regionElements = {{1, Elements::Quads}};
    job.mapped = {{1, {{0, 0}, {3, 0}, {3, 1}, {0, 1}}}};
    CHECK(meshHash(meshedJob(job).mesh) == hash);
}

TEST_CASE("Elements of regions: random lines through a square") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(0.2, 0.8);
    for (int round = 0; round < 12; ++round) {
        MeshingJob job;
        const double low = number(random), high = number(random);
        job.domain.nodes = {{0, 0}, {low, 0}, {1, 0}, {1, 1}, {high, 1}, {0, 1}};
        for (std::uint32_t k = 0; k < 6; ++k) {
            job.domain.segments.push_back({k, (k + 1) % 6, 1, SegmentRole::Boundary, {}});
        }
        job.domain.segments.push_back({1, 4, 2, SegmentRole::Constraint, {}});
        job.domain.regionMarkers = {{{0.05, 0.5}, 1}, {{0.95, 0.5}, 2}};
        job.spacing.size = 0.06 + 0.1 * number(random);
        job.options.elements = static_cast<Elements>(round % 3);
        job.regionElements = {{2, static_cast<Elements>((round + 1 + round / 3) % 3)}};
        job.options.verify = true;
        const Mesh mesh = meshedJob(job).mesh;
        for (const std::int32_t region : {1, 2}) {
            const Elements shapes = region == 2 ? job.regionElements[0].elements : job.options.elements;
            if (shapes == Elements::Quads) {
                CHECK(countsOf(mesh, region).triangles == 0);
            }
        }
    }
}

TEST_CASE("Project: elements of regions are kept, and given to the job where their regions exist") {
    const auto project = [](const std::string &elements) {
        return parseProject(R"({"format": "forefront", "version": 1, "shapes": [
            {"id": 1, "kind": "rectangle", "use": "boundary", "tag": 1, "name": "", "nodes": [[0, 0], [4, 3]]}],
            "regionMarkers": [{"at": [1, 1], "tag": 4}], "regionElements": )" +
                                elements + R"(, "nextId": 2})",
                            "elements.json");
    };
    const Result<Document> document =
        project(R"([{"region": 4, "elements": "quads"}, {"region": 9, "elements": "mixed"}])");
    REQUIRE(document);
    REQUIRE(document->regionElements.size() == 2);
    const Result<Document> again = parseProject(projectText(*document), "again.json");
    REQUIRE(again);
    CHECK(sameContent(*again, *document));
    Document other = *document;
    other.regionElements[0].elements = Elements::Mixed;
    CHECK_FALSE(sameContent(other, *document));
    CHECK(jobOf(*document).regionElements.size() == 1);
    CHECK(countsOf(meshedJob(jobOf(*document)).mesh, 4).triangles == 0);
    for (const char *const wrong :
         {"{}", "[4]", "[{}]", R"([{"region": 4, "elements": "hexes"}])", R"([{"region": 4}])",
          R"([{"region": 4, "elements": "quads"}, {"region": 4, "elements": "quads"}])"}) {
        CHECK_FALSE(project(wrong));
    }
}
