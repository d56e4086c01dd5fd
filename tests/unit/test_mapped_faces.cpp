#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/mapped/mapped_faces.hpp"
#include "core/engine/mapped/row_grid.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "tests/support/meshed_job.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace mapped_cases {

/// A rectangle of 4 by 1 with other sizes to the left and right.
MeshingJob bar() {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
    job.spacing.expression = "0.2 + 0.05*y";
    job.mapped = {{1}};
    job.options.verify = true;
    return job;
}

/// Three squares in a row, with the tags 1, 2 and 3 from the left.
MeshingJob threeSquares() {
    MeshingJob job;
    Domain &domain = job.domain;
    domain.nodes = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}};
    for (std::uint32_t k = 0; k < 8; ++k) {
        domain.segments.push_back({k, (k + 1) % 8, 1, SegmentRole::Boundary});
    }
    domain.segments.push_back({1, 6, 2, SegmentRole::Constraint});
    domain.segments.push_back({2, 5, 2, SegmentRole::Constraint});
    domain.regionMarkers = {{{0.5, 0.5}, 1}, {{1.5, 0.5}, 2}, {{2.5, 0.5}, 3}};
    job.spacing.expression = "0.12 + 0.06*x";
    job.options.verify = true;
    return job;
}

std::map<CellKind, std::size_t> kindsOf(const Mesh &mesh, std::int32_t region) {
    std::map<CellKind, std::size_t> kinds;
    const MeshView view(mesh);
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        kinds[view.kindOf(e)] += view.region(e) == region ? 1 : 0;
    }
    std::erase_if(kinds, [](const auto &kind) { return kind.second == 0; });
    return kinds;
}

} // namespace mapped_cases

using namespace mapped_cases;

TEST_CASE("Mapped faces: rows between opposite sides, quadrilaterals or triangles") {
    MeshingJob job = bar();
    job.options.elements = Elements::Quads;
    const Mesh quads = meshedJob(job).mesh;
    // The lower side asks 20 elements, the upper one 16, the left and right ones 4.
    CHECK(quads.elementCount() == 80);
    CHECK(kindsOf(quads, 1) == std::map<CellKind, std::size_t>{{CellKind::Quadrilateral4, 80}});
    CHECK(quads.nodes.size() == 21 * 5);
    job.options.elements = Elements::Triangles;
    CHECK(meshedJob(job).mesh.elementCount() == 160);
    job.options.order = ElementOrder::Second;
    job.options.elements = Elements::Mixed;
    CHECK(kindsOf(meshedJob(job).mesh, 1).at(CellKind::Quadrilateral8) == 80);
}

TEST_CASE("Mapped faces: numbers pass through neighbours, and other faces fit") {
    for (const Elements elements : {Elements::Triangles, Elements::Quads, Elements::Mixed}) {
        MeshingJob job = threeSquares();
        job.options.elements = elements;
        job.mapped = {{1}, {2}};
        const MeshingOutcome made = meshedJob(job);
        const std::size_t perQuad = elements == Elements::Triangles ? 2 : 1;
        const auto first = kindsOf(made.mesh, 1), second = kindsOf(made.mesh, 2);
        REQUIRE(first.size() == 1);
        REQUIRE(second.size() == 1);
        CHECK(first.begin()->second % (8 * perQuad) == 0); // 8 edges on the finest side, the left one
        CHECK(second.begin()->second % (8 * perQuad) == 0);
        CHECK(!kindsOf(made.mesh, 3).empty());
        if (elements == Elements::Quads) {
            CHECK(kindsOf(made.mesh, 3).size() == 1);
        }
        job.mapped = {{1}, {2}, {3}};
        CHECK(kindsOf(meshedJob(job).mesh, 3).begin()->second % (8 * perQuad) == 0);
    }
}

TEST_CASE("Mapped faces: three corners, curved sides and given corners") {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {3, -0.6}, {3, 0.6}});
    job.spacing.size = 0.3;
    job.mapped = {{1}};
    job.options.verify = true;
    job.options.elements = Elements::Quads;
    const auto kinds = kindsOf(meshedJob(job).mesh, 1);
    CHECK(kinds.at(CellKind::Triangle3) == 4);
    CHECK(kinds.at(CellKind::Quadrilateral4) % 4 == 0);

    // A quarter of a ring: arcs as chains of chords.
    MeshingJob ring;
    Domain &domain = ring.domain;
    domain.nodes = {{1, 0}, {2, 0}, {0, 2}, {0, 1}};
    const double quarter = 0.5 * std::acos(-1.0);
    domain.segments = {{0, 1, 1, SegmentRole::Boundary}, {2, 3, 1, SegmentRole::Boundary}};
    for (const bool outer : {true, false}) {
        const auto curve = static_cast<std::uint32_t>(domain.curves.size());
        const double radius = outer ? 2.0 : 1.0;
        domain.curves.push_back(Curve::arc({0, 0}, {radius, 0}, {0, radius}, 0.0, quarter));
        std::uint32_t before = outer ? 1 : 0;
        for (int k = 1; k <= 8; ++k) {
            std::uint32_t next = outer ? 2 : 3;
            if (k < 8) {
                next = static_cast<std::uint32_t>(domain.nodes.size());
                domain.nodes.push_back(domain.curves.back().point(k / 8.0));
            }
            domain.segments.push_back({before, next, 1, SegmentRole::Boundary, {curve, (k - 1) / 8.0, k / 8.0}});
            before = next;
        }
    }
    ring.spacing.size = 0.2;
    domain.curveTolerance = 0.1;
    ring.mapped = {{1}};
    ring.options.verify = true;
    ring.options.elements = Elements::Quads;
    const Mesh mesh = meshedJob(ring).mesh;
    CHECK(mesh.elementCount() == 16 * 5); // the outer arc asks 16 elements, of which the inner one gets as many
    for (const Vec2 p : mesh.nodes) {
        const double r = std::hypot(p.x, p.y);
        CHECK(std::abs(5.0 * r - std::round(5.0 * r)) < 1e-9); // the rows are arcs
    }
    ring.mapped[0].corners = {{1, 0}, {2, 0}, {0, 2}, {0, 1}};
    CHECK(meshedJob(ring).mesh.elementCount() == mesh.elementCount());
    ring.mapped[0].corners[2] = domain.nodes[6];
    CHECK(refusalOf(ring) == "mapped-corners"); // inside the arc
    domain.points.push_back({6, 4});
    CHECK(refusalOf(ring).empty());
}

TEST_CASE("Mapped faces: random quadrangles and bent ones") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    int refused = 0;
    for (int round = 0; round < 60; ++round) {
        const auto near = [&](double x, double y) { return Vec2{x + 0.8 * number(random), y + 0.8 * number(random)}; };
        MeshingJob job;
        const std::vector<Vec2> corners = {near(0, 0), near(3, 0), near(3, 2), near(0, 2)};
        std::vector<Vec2> loop = corners;
        if (round % 2 == 1) {
            loop.insert(loop.begin() + 1, {1.6 + 0.4 * number(random), 2.0 * number(random) - 0.2});
        }
        addLoop(job.domain, loop);
        job.spacing.size = 0.25;
        job.mapped = {{1, corners}};
        job.options.verify = true;
        job.options.elements = round % 3 == 0 ? Elements::Triangles : Elements::Quads;
        const Result<MeshingOutcome> outcome = meshDomain(job);
        if (!outcome) {
            CHECK(outcome.faults().front().code == "mapped-inverted");
            CHECK(outcome.faults().front().at.has_value());
            ++refused;
        }
    }
    CHECK(refused < 20);
}

TEST_CASE("Mapped faces: a side may turn inwards, but a corner of quadrilaterals may not") {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}});
    job.options.verify = true;
    for (const double size : {0.5, 0.25, 0.1}) {
        job.spacing.size = size;
        for (const Elements elements : {Elements::Quads, Elements::Triangles}) {
            job.options.elements = elements;
            job.mapped = {{1, {{0, 0}, {4, 0}, {4, 2}, {0, 4}}}}; // the node (2, 2) is inside a side
            CHECK(refusalOf(job).empty());
            job.mapped = {{1, {{0, 0}, {4, 2}, {2, 4}, {0, 4}}}};
            CHECK(refusalOf(job).empty());
        }
    }
    job.options.elements = Elements::Quads;
    job.mapped = {{1, {{0, 0}, {4, 0}, {2, 2}, {0, 4}}}};
    const Result<MeshingOutcome> refused = meshDomain(job);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().code == "mapped-corners");
    CHECK(refused.faults().front().at == Vec2{2, 2});
    CHECK(refused.faults().front().message.find("270 degrees") != std::string::npos);
    job.spacing.size = 0.25;
    job.options.elements = Elements::Triangles; // two of them share the corner
    CHECK(refusalOf(job).empty());
}

TEST_CASE("Mapped faces: what cannot be mapped is refused with its place") {
    MeshingJob job = bar();
    job.mapped = {{2}};
    CHECK(refusalOf(job) == "unknown-region");
    job.mapped = {{1}, {1}};
    CHECK(refusalOf(job) == "repeated-mapped");
    job.mapped = {{1, {{0, 0}, {4, 0}, {4, 1}, {0.5, 1}}}};
    CHECK(refusalOf(job) == "mapped-corners");
    job.mapped = {{1, {{0, 0}, {4, 0}}}};
    CHECK(refusalOf(job) == "mapped-corners");
    job = bar();
    job.options.leastAngle = 25.0;
    CHECK(refusalOf(job) == "least-angle");
    job = bar();
    job.layers = {LayerSpec{.tag = 1, .first = 0.01, .count = 2}};
    CHECK(refusalOf(job) == "mapped-layers");
    job = bar();
    addLoop(job.domain, {{1, 0.3}, {2, 0.3}, {2, 0.6}});
    CHECK(refusalOf(job) == "mapped-outline");
    job = bar();
    job.domain.nodes.push_back({1, 0.5});
    job.domain.points.push_back({4, 1});
    CHECK(refusalOf(job) == "mapped-outline");
    job = bar();
    job.spacing.placed.elements = {7, 0, 9, 0};
    const Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_FALSE(outcome);
    CHECK(outcome.faults().front().code == "mapped-sides");
    CHECK(outcome.faults().front().at.has_value());
    job.spacing.placed.elements = {7, 0, 0, 0}; // the other side asks for more
    CHECK(refusalOf(job) == "mapped-sides");
    job.spacing.placed.elements = {33, 0, 0, 0};
    CHECK(refusalOf(job).empty());
    job = MeshingJob();
    addLoop(job.domain, {{0, 0}, {2, 0}, {3, 1}, {1, 2.5}, {-1, 1}});
    job.mapped = {{1}};
    job.spacing.size = 0.3;
    CHECK(refusalOf(job) == "mapped-corners");
}

TEST_CASE("Mapped faces: numbers that cannot be equal end with a message, in a project with 100,000 of them, too") {
    // Around a hexagon, each side is longer than the opposite one, which is a part of the next side.
    MeshingJob job;
    Domain &domain = job.domain;
    for (const double r : {1.0, 2.0, 2.2}) {
        for (int k = 0; k < 6; ++k) {
            const double angle = k * std::numbers::pi / 3.0;
            domain.nodes.push_back({r * std::cos(angle), r * std::sin(angle)});
        }
    }
    for (std::uint32_t k = 0; k < 6; ++k) {
        const std::uint32_t next = (k + 1) % 6;
        domain.segments.push_back({k, next, 1, SegmentRole::Boundary, {}});
        domain.segments.push_back({6 + k, 12 + next, 2, SegmentRole::Boundary, {}});
        domain.segments.push_back({12 + next, 6 + next, 2, SegmentRole::Boundary, {}});
        domain.segments.push_back({k, 6 + k, 3, SegmentRole::Constraint, {}});
    }
    job.spacing.size = 0.4;
    CHECK(refusalOf(job).empty());
    job.mapped = {{1}};
    const Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_FALSE(outcome);
    CHECK(outcome.faults().front().code == "mapped-sides");
    CHECK(outcome.faults().front().at.has_value());
    CHECK(outcome.faults().front().message.find("no numbers make both equal") != std::string::npos);

    std::string list;
    for (int k = 1; k <= 100'000; ++k) {
        list += (k > 1 ? "," : "") + ("{\"tag\":" + std::to_string(k)) + ",\"first\":0.01,\"count\":2}";
    }
    const auto project = [&](const std::string &layers) {
        return parseProject(R"({"format": "forefront", "version": 1, "shapes": [
            {"id": 1, "kind": "rectangle", "use": "boundary", "tag": 7, "name": "", "nodes": [[0, 0], [4, 3]]}],
            "layers": [)" + layers +
                                R"(], "nextId": 2})",
                            "many.json");
    };
    const Result<Document> document = project(list);
    REQUIRE(document);
    CHECK(document->layers.size() == 100'000);
    CHECK(jobOf(*document).layers.size() == 1);
    CHECK_FALSE(project(list + R"(,{"tag": 7, "first": 0.01})"));
}

TEST_CASE("Mapped faces: corners are kept where nodes are inserted into their sides") {
    const Result<Document> document = parseProject(R"({"format": "forefront", "version": 1, "shapes": [
        {"id": 1, "kind": "polygon", "use": "boundary", "tag": 1, "name": "",
         "nodes": [[0, 0], [4, 0], [4, 1], [0, 1]]}],
        "mapped": [{"region": 1, "corners": [[0, 0], [4, 0], [4, 1], [0, 1]]}],
        "nextId": 2})",
                                                   "corners.json");
    REQUIRE_MESSAGE(document, toString(document ? Diagnostic() : document.faults().front()));
    const Result<Document> more = insertNode(*document, {1, 2}, {2, 1.2});
    REQUIRE(more);
    MeshingJob mappedJob = jobOf(*more);
    mappedJob.spacing.size = 0.25;
    mappedJob.options.elements = Elements::Quads;
    mappedJob.options.verify = true;
    const Mesh mesh = meshedJob(mappedJob).mesh;
    CHECK(kindsOf(mesh, 1).size() == 1);
    CHECK(mesh.elementCount() % 4 == 0);
}

TEST_CASE("Mapped faces: too many elements are refused before they are made, and smoothing is cancelled") {
    MeshingJob job = bar();
    job.spacing = {};
    job.spacing.size = 1.0;
    job.spacing.placed.elements = {3000, 3000, 3000, 3000};
    job.options.maxElements = 1'000'000;
    const Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_FALSE(outcome);
    CHECK(outcome.faults().front().code == "too-many-elements");
    RowGrid grid(2, 2);
    for (std::size_t i = 0; i <= 2; ++i) {
        for (std::size_t j = 0; j <= 2; ++j) {
            grid.at(i, j) = {static_cast<double>(i), static_cast<double>(j)};
        }
    }
    grid.at(1, 1) = {5, 5};
    Progress progress;
    std::stop_source stop;
    progress.stop = stop.get_token();
    stop.request_stop();
    CHECK_FALSE(grid.smoothUntilValid(false, progress));
    CHECK(grid.at(1, 1) == Vec2{5, 5});
}

TEST_CASE("Mapped faces: nodes between the chords of a curve are no corners") {
    MeshingJob job;
    Domain &domain = job.domain;
    domain.nodes = {{-1, 0}, {-1, -1}, {1, -1}, {1, 0}};
    for (std::uint32_t k = 0; k < 3; ++k) {
        domain.segments.push_back({k, k + 1, 1, SegmentRole::Boundary});
    }
    domain.curves.push_back(Curve::arc({0, 0}, {1, 0}, {0, 1}, 0.0, std::acos(-1.0)));
    std::uint32_t before = 3;
    for (int k = 1; k <= 4; ++k) { // chords at angles of 135 degrees
        std::uint32_t next = 0;
        if (k < 4) {
            next = static_cast<std::uint32_t>(domain.nodes.size());
            domain.nodes.push_back(domain.curves[0].point(k / 4.0));
        }
        domain.segments.push_back({before, next, 1, SegmentRole::Boundary, {0, (k - 1) / 4.0, k / 4.0}});
        before = next;
    }
    job.spacing.size = 0.3;
    job.mapped = {{1}};
    CHECK(refusalOf(job) == "mapped-corners"); // the sides meet the arc smoothly: two corners are left
    job.mapped[0].corners = {{-1, 0}, {-1, -1}, {1, -1}, {1, 0}};
    CHECK(refusalOf(job).empty());
}

TEST_CASE("Mapped faces: the stepper has nothing to do where they fill the domain") {
    Result<MeshStepper> stepper = MeshStepper::create(bar());
    REQUIRE(stepper);
    CHECK(stepper->finish());
    CHECK(stepper->atEnd());
    CHECK(meshHash(stepper->mesh()) == meshHash(meshedJob(bar()).mesh));
}

TEST_CASE("Mapped faces: cracks and periodic sides") {
    MeshingJob job = threeSquares();
    job.mapped = {{1}, {2}, {3}};
    job.cracks = {2};
    CHECK(meshedJob(job).cracks.addedNodes > 0);
    job.cracks.clear();
    for (std::size_t s : {0U, 1U, 2U}) {
        job.domain.segments[s].tag = 5;
        job.domain.segments[s + 4].tag = 6;
    }
    job.periodic = {{5, 6}};
    job.spacing.expression = "0.12 + 0.06*x + 0.1*y";
    CHECK(meshedJob(job).mesh.periodic.size() == 1);
}

TEST_CASE("RowGrid: straight sides give a lattice, and Winslow's equations undo a fold") {
    RowGrid grid(4, 3);
    for (std::size_t i = 0; i <= 4; ++i) {
        for (std::size_t j = 0; j <= 3; ++j) {
            if (i == 0 || i == 4 || j == 0 || j == 3) {
                grid.at(i, j) = {static_cast<double>(i), 2.0 * static_cast<double>(j)};
            }
        }
    }
    grid.interpolate();
    CHECK(distance(grid.at(2, 1), {2, 2}) < 1e-12);
    CHECK_FALSE(grid.invertedCell(false));
    std::swap(grid.at(1, 1), grid.at(3, 1));
    REQUIRE(grid.invertedCell(false));
    CHECK(grid.smoothUntilValid(false));
    CHECK_FALSE(grid.invertedCell(false));
}

TEST_CASE("Project: mapped regions are kept, and given to the job where they exist") {
    const auto project = [](const std::string &mapped) {
        return parseProject(R"({"format": "forefront", "version": 1, "shapes": [
            {"id": 1, "kind": "rectangle", "use": "boundary", "tag": 1, "name": "", "nodes": [[0, 0], [4, 3]]}],
            "regionMarkers": [{"at": [1, 1], "tag": 4}], "mapped": )" +
                                mapped + R"(, "nextId": 2})",
                            "mapped.json");
    };
    const Result<Document> document =
        project(R"([{"region": 4, "corners": [[0, 0], [4, 0], [4, 3], [0, 3]]}, {"region": 9}])");
    REQUIRE(document);
    REQUIRE(document->mapped.size() == 2);
    const Result<Document> again = parseProject(projectText(*document), "again.json");
    REQUIRE(again);
    CHECK(sameContent(*again, *document));
    Document other = *document;
    other.mapped[0].corners.pop_back();
    CHECK_FALSE(sameContent(other, *document));
    CHECK(jobOf(*document).mapped.size() == 1);
    CHECK(refusalOf(jobOf(*document)).empty());
    for (const char *const wrong :
         {"{}", "[4]", "[{}]", R"([{"region": 4}, {"region": 4}])", R"([{"region": 4, "corners": [[1]]}])"}) {
        CHECK_FALSE(project(wrong));
    }
}

TEST_CASE("Mapped faces: outlines tell which nodes can be corners, also where the corners are unclear") {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {6, 0}, {6, 3}, {3, 3}, {3, 6}, {0, 6}});
    DomainFaces faces;
    REQUIRE(validate(job.domain, 10, &faces).empty());
    std::vector<MappedOutline> outlines = mappedOutlines({1, {}}, job.domain, faces);
    REQUIRE(outlines.size() == 1);
    CHECK(outlines.front().nodes.size() == 6);
    CHECK(outlines.front().able.size() == 6);
    CHECK(outlines.front().corners.empty()); // five corners of 90 degrees
    CHECK(std::ranges::count_if(outlines.front().angles, [](double a) { return std::abs(a - 90.0) < 1e-9; }) == 5);
    CHECK(std::ranges::count_if(outlines.front().angles, [](double a) { return std::abs(a - 270.0) < 1e-9; }) == 1);
    outlines = mappedOutlines({1, {{6, 3}, {0, 6}, {0, 0}, {6, 0}}}, job.domain, faces);
    REQUIRE(outlines.front().corners.size() == 4);
    const MappedOutline &given = outlines.front();
    CHECK(given.nodes[given.corners.front()] == Vec2{6, 3}); // the first one given
    CHECK(given.nodes[given.corners[1]] == Vec2{0, 6});      // then counter-clockwise
    CHECK(mappedOutlines({1, {{6, 3}, {1, 6}, {0, 0}}}, job.domain, faces).front().corners.empty());
    CHECK(mappedOutlines({2, {}}, job.domain, faces).empty());
    addLoop(job.domain, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}, 2);
    REQUIRE(validate(job.domain, 10, &faces).empty());
    CHECK(mappedOutlines({1, {}}, job.domain, faces).empty()); // it has a hole
}
