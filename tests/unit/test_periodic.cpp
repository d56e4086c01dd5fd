#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/engine/mesh/numbering.hpp"
#include "core/engine/mesh/periodic_pairs.hpp"
#include "core/engine/pipeline/optional_periodic.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "tests/support/meshed_job.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace periodic_cases {

/// The unit square with the tags 1 below, 2 right, 3 above, 4 left; finer to the left and below.
MeshingJob cell() {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    for (std::int32_t s = 0; s < 4; ++s) {
        job.domain.segments[static_cast<std::size_t>(s)].tag = s + 1;
    }
    job.domain.boundaryNames = {{1, "below"}, {2, "right"}, {3, "above"}, {4, "left"}};
    job.spacing.expression = "0.03 + 0.07*x + 0.02*y";
    job.periodic = {{4, 2}, {1, 3}};
    job.options.verify = true;
    return job;
}

/// Adds an arc as a chain of chords.
void addArc(Domain &domain, Vec2 centre, double radius, double from, double to, std::uint32_t first, std::uint32_t last,
            std::int32_t tag) {
    constexpr std::uint32_t kChords = 24;
    const auto curve = static_cast<std::uint32_t>(domain.curves.size());
    domain.curves.push_back(Curve::arc(centre, {radius, 0}, {0, radius}, from, to - from));
    std::uint32_t before = first;
    for (std::uint32_t k = 1; k <= kChords; ++k) {
        std::uint32_t next = last;
        const double t = static_cast<double>(k) / kChords;
        if (k < kChords) {
            next = static_cast<std::uint32_t>(domain.nodes.size());
            domain.nodes.push_back(domain.curves.back().point(t));
        }
        domain.segments.push_back(
            {before, next, tag, SegmentRole::Boundary, {curve, static_cast<double>(k - 1) / kChords, t}});
        before = next;
    }
}

/// A passage between two curved sides, the tag 2 above and its copy, the tag 1, below; finer above.
MeshingJob passage() {
    MeshingJob job;
    Domain &domain = job.domain;
    domain.nodes = {{-1, 0}, {1, 0}, {1, 0.7}, {-1, 0.7}};
    const double half = std::atan2(1.0, 2.0), radius = std::sqrt(5.0);
    const double from = 0.5 * std::numbers::pi + half, to = 0.5 * std::numbers::pi - half;
    domain.segments = {{1, 2, 3, SegmentRole::Boundary}, {3, 0, 4, SegmentRole::Boundary}};
    addArc(domain, {0, -2}, radius, from, to, 0, 1, 1);
    addArc(domain, {0, -2 + 0.7}, radius, to, from, 2, 3, 2);
    job.spacing.expression = "0.16 - 0.1*y";
    job.periodic = {{1, 2}};
    job.options.verify = true;
    return job;
}

/// A sector of a ring between the angles 0.3 and 0.3 + `angle`.
MeshingJob sector(double angle, double inner) {
    MeshingJob job;
    const auto at = [](double r, double a) { return Vec2{r * std::cos(a), r * std::sin(a)}; };
    if (inner > 0.0) {
        addLoop(job.domain, {at(inner, 0.3), at(2, 0.3), at(2, 0.3 + angle), at(inner, 0.3 + angle)});
    } else {
        addLoop(job.domain, {{0, 0}, at(2, 0.3), at(2, 0.3 + angle)});
    }
    job.domain.segments[0].tag = 2;
    job.domain.segments.back().tag = inner > 0.0 ? 1 : 3;
    job.domain.segments[2].tag = 3;
    job.spacing.size = 0.15;
    job.periodic = {{2, 3}};
    job.options.verify = true;
    return job;
}

PeriodicPairs pairsOf(const Mesh &mesh, std::size_t link) {
    REQUIRE(mesh.periodic.size() > link);
    CHECK(verifyPeriodic(mesh).empty());
    return periodicPairs(mesh, mesh.periodic[link]);
}

} // namespace periodic_cases

using namespace periodic_cases;

TEST_CASE("periodic parts: both sides of a cell have nodes with equal coordinates along them") {
    for (const Elements elements : {Elements::Triangles, Elements::Quads}) {
        for (const ElementOrder order : {ElementOrder::First, ElementOrder::Second}) {
            CAPTURE(wordOf(elements));
            MeshingJob job = cell();
            job.options.elements = elements;
            job.options.order = order;
            const Mesh mesh = meshedJob(job).mesh;
            const PeriodicPairs across = pairsOf(mesh, 0), up = pairsOf(mesh, 1);
            CHECK(across.link.map == RigidMap{1, 0, {1, 0}});
            CHECK(up.link.map == RigidMap{1, 0, {0, 1}});
            const std::size_t perEdge = order == ElementOrder::Second ? 2 : 1;
            CHECK(across.pairs.size() == perEdge * edgesTagged(mesh, 4) + 1);
            CHECK(up.pairs.size() == perEdge * edgesTagged(mesh, 1) + 1);
            CHECK(edgesTagged(mesh, 4) > 22); // as the left side asks, not the right one
            CHECK(across.exact == across.pairs.size());
            CHECK(up.exact == up.pairs.size());
            for (const NodePair &pair : across.pairs) {
                CHECK(mesh.nodes[index(pair.from)].y == mesh.nodes[index(pair.to)].y);
                CHECK(mesh.nodes[index(pair.to)].x == 1.0);
            }
        }
    }
}

TEST_CASE("periodic parts: the sizes inside grow from the side that is finer than its spacing") {
    MeshingJob job = cell();
    job.spacing.expression = "0.02 + 0.3*x";
    const MeshingOutcome outcome = meshedJob(job);
    CHECK(outcome.spacing->at({1.0, 0.5}) < 0.03);
    CHECK(outcome.spacing->at({0.9, 0.5}) < 0.06);
    CHECK(outcome.spacing->at({0.5, 0.5}) > 0.1);
    CHECK(edgesTagged(outcome.mesh, 2) == edgesTagged(outcome.mesh, 4));
}

TEST_CASE("periodic parts: the order of the parts and of their nodes does not matter") {
    MeshingJob job = cell();
    job.periodic = {{2, 4}};
    std::swap(job.domain.segments[1].a, job.domain.segments[1].b);
    const Mesh mesh = meshedJob(job).mesh;
    const PeriodicPairs pairs = pairsOf(mesh, 0);
    CHECK(pairs.link.map.shift == Vec2{-1, 0});
    CHECK(pairs.exact == pairs.pairs.size());
    CHECK(edgesTagged(mesh, 4) > 22);
}

TEST_CASE("periodic parts: curved sides") {
    for (const ElementOrder order : {ElementOrder::First, ElementOrder::Second}) {
        MeshingJob job = passage();
        job.options.order = order;
        const Mesh mesh = meshedJob(job).mesh;
        const PeriodicPairs pairs = pairsOf(mesh, 0);
        CHECK(pairs.link.map.translates());
        CHECK(pairs.pairs.size() == (order == ElementOrder::Second ? 2 : 1) * edgesTagged(mesh, 1) + 1);
        CHECK(pairs.exact + 2 >= pairs.pairs.size()); // the ends are given
        CHECK(pairs.deviation < 1e-15);
        CHECK(edgesTagged(mesh, 1) >= 18);
    }
}

TEST_CASE("periodic parts: turned sides") {
    for (const double inner : {0.0, 1.0}) {
        for (const double angle : {0.2, 0.5, 0.5 * std::numbers::pi, 2.0}) {
            CAPTURE(inner);
            CAPTURE(angle);
            const Mesh mesh = meshedJob(sector(angle, inner)).mesh;
            const PeriodicPairs pairs = pairsOf(mesh, 0);
            CHECK(std::atan2(pairs.link.map.s, pairs.link.map.c) == doctest::Approx(angle));
            CHECK(length(pairs.link.map.shift) < 1e-12);
            CHECK(pairs.pairs.size() == edgesTagged(mesh, 2) + (inner > 0.0 ? 1 : 0));
            CHECK(pairs.exact + 2 >= pairs.pairs.size());
            CHECK(pairs.deviation < 1e-14);
        }
    }
}

TEST_CASE("periodic parts: random sides") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    for (int round = 0; round < 20; ++round) {
        std::vector<Vec2> side;
        for (int k = 0; k <= 4; ++k) {
            side.push_back({0.3 * number(random), 0.25 * k + (k % 4 == 0 ? 0.0 : 0.1 * number(random))});
        }
        const Vec2 shift = {0.5 + number(random), number(random) - 0.5};
        MeshingJob job;
        std::vector<Vec2> loop = side;
        std::for_each(side.rbegin(), side.rend(), [&](Vec2 p) { loop.push_back(p + shift); });
        addLoop(job.domain, loop);
        for (std::size_t s = 0; s < 9; ++s) {
            job.domain.segments[s].tag = s < 4 ? 2 : s == 4 ? 1 : 3;
        }
        job.spacing.expression = "0.05 + 0.1*x";
        job.periodic = {{2, 3}};
        job.options.verify = true;
        job.options.elements = round % 2 == 0 ? Elements::Triangles : Elements::Quads;
        const Mesh mesh = meshedJob(job).mesh;
        const PeriodicPairs pairs = pairsOf(mesh, 0);
        CHECK(pairs.pairs.size() == edgesTagged(mesh, 2) + 1);
        CHECK(edgesTagged(mesh, 2) == edgesTagged(mesh, 3));
        CHECK(pairs.exact + 5 >= pairs.pairs.size());
    }
}

TEST_CASE("periodic parts: numbers of elements count on the first part, and given segments stay") {
    MeshingJob job = cell();
    job.spacing.placed.elements = {0, 0, 0, 7};
    CHECK(edgesTagged(meshedJob(job).mesh, 2) == 7);
    job.spacing.placed.elements = {0, 6, 0, 7};
    CHECK(refusalOf(job) == "periodic-elements");
    job.spacing.placed.elements = {0, 6, 0, 0};
    CHECK(refusalOf(job) == "periodic-elements");
    job.spacing.placed.elements = {};
    job.options.keepBoundary = true;
    CHECK(pairsOf(meshedJob(job).mesh, 0).pairs.size() == 2);
}

TEST_CASE("periodic parts: a least angle leaves them as they are divided") {
    MeshingJob job = cell();
    const std::size_t right = edgesTagged(meshedJob(job).mesh, 2);
    job.options.leastAngle = 28.0;
    const MeshingOutcome outcome = meshedJob(job);
    CHECK(pairsOf(outcome.mesh, 0).exact == pairsOf(outcome.mesh, 0).pairs.size());
    CHECK(edgesTagged(outcome.mesh, 2) == right);
    CHECK(pairsOf(outcome.mesh, 1).exact == pairsOf(outcome.mesh, 1).pairs.size());
}

TEST_CASE("periodic parts: boundary layers that end along them are alike on both, those inside are free") {
    MeshingJob job = cell();
    job.periodic = {{4, 2}};
    job.layers = {LayerSpec{.tag = 1, .first = 0.01, .growth = 1.3, .count = 5},
                  LayerSpec{.tag = 3, .first = 0.02, .count = 3}};
    for (const Elements elements : {Elements::Triangles, Elements::Quads}) {
        job.options.elements = elements;
        const MeshingOutcome outcome = meshedJob(job);
        const PeriodicPairs pairs = pairsOf(outcome.mesh, 0);
        CHECK(pairs.exact == pairs.pairs.size());
        CHECK(outcome.layers.quadrilaterals > 0);
        CHECK(outcome.layers.shortened.empty());
        CHECK(
            std::ranges::any_of(outcome.mesh.nodes, [](Vec2 p) { return p.x == 0.0 && p.y == doctest::Approx(0.01); }));
        CHECK(
            std::ranges::any_of(outcome.mesh.nodes, [](Vec2 p) { return p.x == 1.0 && p.y == doctest::Approx(0.01); }));
    }
    // Along one part alone they end, with a report.
    job = cell();
    job.periodic = {{4, 2}};
    job.domain.nodes.push_back({0.5, 0.0});
    job.domain.segments[0] = {0, 4, 1, SegmentRole::Boundary};
    job.domain.segments.push_back({4, 1, 5, SegmentRole::Boundary});
    job.layers = {LayerSpec{.tag = 1, .first = 0.01, .count = 3}};
    const MeshingOutcome onOne = meshedJob(job);
    CHECK_FALSE(onOne.layers.shortened.empty());
    CHECK(pairsOf(onOne.mesh, 0).exact == pairsOf(onOne.mesh, 0).pairs.size());
    // Of other heights, they are refused with the place.
    job.layers.push_back(LayerSpec{.tag = 5, .first = 0.02, .count = 3});
    const Result<MeshingOutcome> differ = meshDomain(job);
    REQUIRE_FALSE(differ);
    CHECK(differ.faults().front().code == "periodic-layers");
    CHECK(differ.faults().front().at.has_value());
    // Around a hole, they meet no periodic part.
    job = cell();
    addLoop(job.domain, {{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}}, 9);
    job.layers = {LayerSpec{.tag = 9, .first = 0.01, .count = 3}};
    const Mesh around = meshedJob(job).mesh;
    for (std::size_t link : {0U, 1U}) {
        CHECK(pairsOf(around, link).exact == pairsOf(around, link).pairs.size());
    }
}

TEST_CASE("periodic parts: random passages with layers keep their pairs") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    for (int round = 0; round < 12; ++round) {
        MeshingJob job;
        const double lean = number(random) - 0.5, height = 0.6 + number(random);
        addLoop(job.domain, {{0, 0}, {0.5, 0.2 * number(random)}, {1, 0}, {1 + lean, height}, {lean, height}});
        for (std::size_t s = 0; s < 5; ++s) {
            job.domain.segments[s].tag = std::vector<std::int32_t>{1, 1, 2, 3, 4}[s];
        }
        job.spacing.expression = "0.05 + 0.05*x + 0.04*y";
        job.periodic = {{4, 2}};
        job.layers = {LayerSpec{.tag = 1, .first = 0.004 + 0.02 * number(random), .growth = 1.2}};
        if (round % 2 == 0) {
            job.layers.push_back(LayerSpec{.tag = 3, .first = 0.01, .growth = 1.4, .count = 4});
        }
        job.options.verify = true;
        const Mesh mesh = meshedJob(job).mesh;
        CHECK(pairsOf(mesh, 0).exact == pairsOf(mesh, 0).pairs.size());
    }
}

TEST_CASE("periodic parts: what cannot be paired is refused with its place") {
    MeshingJob job = cell();
    job.domain.nodes[2].y = 1.01;
    Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_FALSE(outcome);
    CHECK(outcome.faults().front().code == "periodic-sides");
    CHECK(outcome.faults().front().at.has_value());
    CHECK(outcome.faults().front().message.find("nearest node of right is 0.00") != std::string::npos);
    job = cell();
    job.periodic = {{4, 9}};
    CHECK(refusalOf(job) == "unknown-boundary");
    job.periodic = {{4, 4}};
    CHECK(refusalOf(job) == "repeated-periodic");
    job.periodic = {{4, 2}, {2, 1}};
    CHECK(refusalOf(job) == "repeated-periodic");
    job = cell();
    job.layers = {LayerSpec{.tag = 1, .first = 0.01, .count = 2}};
    CHECK(refusalOf(job) == "periodic-layers");
    job = cell(); // a line inside, and its copy on the boundary
    job.domain.nodes.insert(job.domain.nodes.end(), {{0.5, 0.0}, {0.5, 1.0}});
    job.domain.segments[0] = {0, 4, 1, SegmentRole::Boundary};
    job.domain.segments[2] = {2, 5, 3, SegmentRole::Boundary};
    job.domain.segments.push_back({4, 1, 1, SegmentRole::Boundary});
    job.domain.segments.push_back({5, 3, 3, SegmentRole::Boundary});
    job.domain.segments.push_back({4, 5, 8, SegmentRole::Constraint});
    job.periodic = {{4, 8}};
    CHECK(refusalOf(job) == "periodic-inside");
    job.periodic = {{1, 3}, {4, 2}};
    CHECK(refusalOf(job).empty());
}

TEST_CASE("periodic parts: a mesh whose pairs were disturbed is found") {
    Mesh mesh = meshedJob(cell()).mesh;
    const PeriodicPairs pairs = pairsOf(mesh, 0);
    mesh.nodes[index(pairs.pairs[5].to)].y += 1e-6;
    REQUIRE(verifyPeriodic(mesh).size() == 1);
    CHECK(verifyPeriodic(mesh).front().code == "periodic-pairs");
}

TEST_CASE("periodic parts: MSH files hold the pairs, Abaqus files tell them") {
    const Mesh mesh = meshedJob(cell()).mesh;
    const std::size_t pairs = pairsOf(mesh, 0).pairs.size();
    const std::string msh2 = written(writeMsh2, mesh), msh4 = written(writeMsh4, mesh),
                      binary = written(writeMsh4Binary, mesh), abaqus = written(writeAbaqus, mesh);
    CHECK(msh2.find("$Periodic\n2\n1 2 4\nAffine 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1\n" + std::to_string(pairs) + "\n") !=
          std::string::npos);
    CHECK(msh4.find("\n16 1 0 0 1 0 1 0 0 0 0 1 0 0 0 0 1\n" + std::to_string(pairs) + "\n") != std::string::npos);
    CHECK(binary.find("$Periodic\n") != std::string::npos);
    CHECK(abaqus.find("** periodic: right is the image of left, " + std::to_string(pairs) + " pairs") !=
          std::string::npos);
    CHECK(abaqus.find("** *EQUATION\n** 2\n** ") != std::string::npos);
    const Mesh renumbered = forefront::renumbered(mesh, forefront::reverseCuthillMcKee(mesh));
    CHECK(periodicPairs(renumbered, mesh.periodic[0]).exact == pairs);
    CHECK(renumbered.periodic == mesh.periodic);
    for (const std::string *text : {&msh2, &msh4, &binary}) {
        const Result<Mesh> read = readMsh(sourceOf(*text));
        REQUIRE(read);
        REQUIRE(read->periodic.size() == mesh.periodic.size());
        for (const PeriodicLink &link : mesh.periodic) {
            CHECK(std::find(read->periodic.begin(), read->periodic.end(), link) != read->periodic.end());
        }
        CHECK(verifyPeriodic(*read).empty());
    }
}

TEST_CASE("periodic parts: pairs with unknown nodes are skipped, those of other dimensions not looked up") {
    std::string text = written(writeMsh2, meshedJob(cell()).mesh);
    const std::string section = "$Periodic\n2\n";
    const std::size_t at = text.find(section);
    REQUIRE(at != std::string::npos);
    // A point and a curve whose nodes the file does not have, before those of the parts.
    text.replace(at, section.size(), "$Periodic\n4\n0 1 2\n1\n900001 900002\n1 8 9\n1\n900001 900002\n");
    const Result<Mesh> read = readMsh(sourceOf(text));
    REQUIRE(read);
    CHECK(read->periodic.size() == 2);
}

TEST_CASE("periodic parts: those of a mesh are left out beside what excludes them, those asked for are kept") {
    MeshingJob job = cell();
    const std::vector<PeriodicSpec> ofMesh{{4, 2}};
    job.options.leastAngle = 25.0;
    CHECK(leaveOutExcludedPeriodic(job, ofMesh).empty());
    job.layers = {LayerSpec{.tag = 2, .first = 0.01, .count = 2}};
    CHECK(leaveOutExcludedPeriodic(job, ofMesh).size() == 1);
    CHECK(job.periodic == std::vector<PeriodicSpec>{{1, 3}});
}

TEST_CASE("periodic parts: a mesh becomes a domain with those that bound it") {
    Mesh mesh = meshedJob(cell()).mesh;
    Result<MeshDomain> outline = domainOfMesh(mesh);
    REQUIRE(outline);
    CHECK(outline->periodic.size() == 2);
    CHECK(outline->cracks.empty());
    mesh.periodic[0].to = 77; // no part of the boundary
    outline = domainOfMesh(mesh);
    REQUIRE(outline);
    CHECK(outline->periodic.size() == 1);
}

TEST_CASE("Project: periodic parts are kept, and given to the job where both exist") {
    const auto project = [](const std::string &periodic) {
        return parseProject(R"({"format": "forefront", "version": 1, "shapes": [
            {"id": 1, "kind": "polygon", "use": "boundary", "tag": 1, "name": "", "nodes": [[0, 0], [4, 0], [4, 3], [0, 3]],
             "segmentTags": [1, 2, 3, 4]}], "periodic": )" +
                                periodic + R"(, "nextId": 2})",
                            "cell.json");
    };
    const Result<Document> document = project(R"([{"from": 4, "to": 2}, {"from": 1, "to": 9}])");
    REQUIRE(document);
    CHECK(document->periodic == std::vector<PeriodicSpec>{{4, 2}, {1, 9}});
    const Result<Document> again = parseProject(projectText(*document), "again.json");
    REQUIRE(again);
    CHECK(sameContent(*again, *document));
    Document other = *document;
    other.periodic.pop_back();
    CHECK_FALSE(sameContent(other, *document));
    CHECK(jobOf(*document).periodic == std::vector<PeriodicSpec>{{4, 2}});
    for (const char *const wrong : {"{}", R"([{"from": 4}])", R"([{"from": 4, "to": 4}])",
                                    R"([{"from": 4, "to": 2}, {"from": 2, "to": 1}])", R"([{"from": 0, "to": 2}])"}) {
        CHECK_FALSE(project(wrong));
    }
}
