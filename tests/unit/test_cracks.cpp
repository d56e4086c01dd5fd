#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"
#include "tests/support/meshed_job.hpp"
#include "tests/support/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace crack_cases {

/// A square from (-1, -1) to (1, 1) with inner lines, each with the tag 5.
MeshingJob square(const std::vector<std::vector<Vec2>> &lines) {
    MeshingJob job;
    addLoop(job.domain, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    job.domain.boundaryNames = {{1, "side"}, {5, "joint"}};
    const auto nodeAt = [&](Vec2 p) {
        const auto found = std::find(job.domain.nodes.begin(), job.domain.nodes.end(), p);
        const auto number = static_cast<std::uint32_t>(found - job.domain.nodes.begin());
        if (found == job.domain.nodes.end()) {
            job.domain.nodes.push_back(p);
        }
        return number;
    };
    for (const std::vector<Vec2> &line : lines) {
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            const std::uint32_t a = nodeAt(line[k]), b = nodeAt(line[k + 1]);
            job.domain.segments.push_back({a, b, 5, SegmentRole::Constraint});
        }
    }
    job.spacing.size = 0.25;
    job.cracks = {5};
    job.options.verify = true;
    return job;
}

/// The same with the middle of the right side as a node.
MeshingJob toTheSide() {
    MeshingJob job = square({{{-0.3, 0}, {0.2, 0.1}, {1, 0}}});
    for (std::size_t s = 0; s < 4; ++s) {
        DomainSegment &segment = job.domain.segments[s];
        if (job.domain.nodes[segment.a].x == 1 && job.domain.nodes[segment.b].x == 1) {
            const auto middle = static_cast<std::uint32_t>(
                std::find(job.domain.nodes.begin(), job.domain.nodes.end(), Vec2{1, 0}) - job.domain.nodes.begin());
            DomainSegment second = segment;
            segment.b = middle;
            second.a = middle;
            job.domain.segments.push_back(second);
            break;
        }
    }
    return job;
}

std::size_t nodesAt(const Mesh &mesh, Vec2 place) {
    return static_cast<std::size_t>(std::count(mesh.nodes.begin(), mesh.nodes.end(), place));
}

std::size_t usedNodes(const Mesh &mesh) {
    std::set<NodeId> used;
    for (const CellBlock &block : mesh.blocks) {
        used.insert(block.connectivity().begin(), block.connectivity().end());
    }
    return used.size();
}

} // namespace crack_cases

using namespace crack_cases;

TEST_CASE("Cracks: a node for each sector, one at tips inside the domain") {
    SUBCASE("a line inside") {
        const MeshingOutcome made = meshedJob(square({{{-0.5, 0}, {0.1, 0.2}, {0.5, 0}}}));
        REQUIRE(made.cracks.cracks.size() == 1);
        CHECK(made.cracks.cracks[0].left == 5);
        CHECK(made.cracks.cracks[0].right == 6);
        CHECK(made.mesh.boundaryNames.at(6) == "joint_right");
        CHECK(made.cracks.tips == 2);
        CHECK(made.cracks.addedNodes == made.cracks.cracks[0].edges - 1);
        CHECK(edgesTagged(made.mesh, 5) == edgesTagged(made.mesh, 6));
        CHECK(nodesAt(made.mesh, {-0.5, 0}) == 1);
        CHECK(nodesAt(made.mesh, {0.1, 0.2}) == 2);
        CHECK(made.cracks.cracks[0].length == doctest::Approx(std::hypot(0.6, 0.2) + std::hypot(0.4, 0.2)));
    }
    SUBCASE("a line that ends on the boundary") {
        const MeshingOutcome made = meshedJob(toTheSide());
        CHECK(made.cracks.tips == 1);
        CHECK(nodesAt(made.mesh, {1, 0}) == 2);
        CHECK(nodesAt(made.mesh, {-0.3, 0}) == 1);
    }
    SUBCASE("a branch and a crossing") {
        CHECK(nodesAt(meshedJob(square({{{-0.6, 0}, {0, 0}, {0.5, 0.4}}, {{0, 0}, {0.5, -0.4}}})).mesh, {0, 0}) == 3);
        CHECK(nodesAt(meshedJob(square({{{-0.6, 0}, {0, 0}, {0.6, 0.1}}, {{0, -0.6}, {0, 0}, {0, 0.6}}})).mesh,
                      {0, 0}) == 4);
    }
    SUBCASE("a closed line cuts out a part") {
        const MeshingOutcome made =
            meshedJob(square({{{-0.4, -0.4}, {0.4, -0.4}, {0.4, 0.4}, {-0.4, 0.4}, {-0.4, -0.4}}}));
        CHECK(made.cracks.tips == 0);
        CHECK(made.cracks.addedNodes == made.cracks.cracks[0].edges);
    }
}

TEST_CASE("Cracks: the left face keeps the tag") {
    const Mesh mesh = meshedJob(square({{{-0.5, 0}, {0.5, 0}}})).mesh;
    for (const TaggedEdge &edge : mesh.edges) {
        if (edge.tag < 5) {
            continue;
        }
        for (const Element &element : mesh.triangles()) {
            const auto has = [&](NodeId n) { return std::find(element.begin(), element.end(), n) != element.end(); };
            if (has(edge.a) && has(edge.b)) {
                double y = 0.0;
                for (const NodeId n : element) {
                    y += mesh.nodes[index(n)].y;
                }
                CHECK((y > 0.0) == (edge.tag == 5));
            }
        }
    }
}

TEST_CASE("Cracks: opened in meshes of every kind, and closed again") {
    for (const Elements elements : {Elements::Triangles, Elements::Quads, Elements::Mixed}) {
        for (const ElementOrder order : {ElementOrder::First, ElementOrder::Second}) {
            MeshingJob job = square({{{-0.6, 0}, {0, 0}, {0.6, 0.1}}, {{0, -0.6}, {0, 0}, {0, 0.6}}});
            job.options.elements = elements;
            job.options.order = order;
            const MeshingOutcome made = meshedJob(job);
            job.cracks.clear();
            const Mesh whole = meshedJob(job).mesh;
            CHECK(usedNodes(made.mesh) == usedNodes(whole) + made.cracks.addedNodes);
            const std::int32_t cracks[] = {5};
            CHECK(verifyCracks(made.mesh, cracks).empty());
            const ClosedMesh closed = closeCracks(made.mesh);
            REQUIRE(closed.lines.size() == 1);
            CHECK(closed.lines[0].tag == 5);
            CHECK(closed.lines[0].other == 6);
            CHECK(closed.lines[0].edges == edgesTagged(made.mesh, 5));
            CHECK(usedNodes(closed.mesh) == usedNodes(whole));
            CHECK(closed.mesh.edges.size() == whole.edges.size());
            const Diagnostics found = verify(made.mesh);
            REQUIRE(found.size() == 1);
            CHECK(found.front().code == "open-line");
        }
    }
}

TEST_CASE("Cracks: random lines") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-0.8, 0.8);
    for (int round = 0; round < 30; ++round) {
        std::vector<Vec2> line;
        for (int k = 0; k <= 3; ++k) {
            line.push_back({-0.8 + 0.5 * k + 0.1 * number(random), number(random)});
        }
        MeshingJob job = square({line});
        job.spacing.size = 0.2 + 0.1 * number(random);
        job.options.elements = round % 3 == 0 ? Elements::Quads : Elements::Triangles;
        job.options.order = round % 4 == 1 ? ElementOrder::Second : ElementOrder::First;
        const MeshingOutcome made = meshedJob(job); // checks itself
        CHECK(made.cracks.tips == 2);
    }
}

TEST_CASE("Cracks: points on them are kept on all copies of their nodes") {
    MeshingJob job = square({{{-0.5, 0}, {0.1, 0.2}, {0.5, 0}}});
    job.cracks.clear();
    Mesh mesh = meshedJob(job).mesh;
    const auto bend = std::find(mesh.nodes.begin(), mesh.nodes.end(), Vec2{0.1, 0.2});
    mesh.points.push_back({NodeId{static_cast<std::uint32_t>(bend - mesh.nodes.begin())}, 9});
    const std::int32_t cracks[] = {5};
    const Result<CrackReport> report = openCracks(mesh, cracks);
    REQUIRE(report);
    REQUIRE(mesh.points.size() == 2);
    CHECK(mesh.points[1].tag == 9);
    CHECK(mesh.points[1].node != mesh.points[0].node);
    CHECK(mesh.nodes[index(mesh.points[1].node)] == Vec2{0.1, 0.2});
    CHECK(report->cracks[0].right == 10); // above the tags of points, too
}

TEST_CASE("Cracks: where the highest tag is used, the right face gets an unused one") {
    MeshingJob job = square({{{-0.5, 0}, {0.5, 0}}});
    job.cracks.clear();
    Mesh mesh = meshedJob(job).mesh;
    mesh.points.push_back({mesh.edges[0].a, std::numeric_limits<std::int32_t>::max()});
    const std::int32_t cracks[] = {5};
    const Result<CrackReport> report = openCracks(mesh, cracks);
    REQUIRE(report);
    CHECK(report->cracks[0].right == 2);
}

TEST_CASE("Cracks: what cannot open is refused with its place") {
    MeshingJob job = square({{{-0.05, 0}, {0.05, 0}}});
    Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_FALSE(outcome);
    CHECK(outcome.faults().front().code == "crack-edge");
    CHECK(outcome.faults().front().at == Vec2{0, 0});
    job = square({{{-0.5, 0}, {0.5, 0}}});
    job.cracks = {1};
    CHECK(refusalOf(job) == "crack-outside");
    job.cracks = {5, 5};
    CHECK(refusalOf(job) == "repeated-crack");
    job.cracks = {7};
    CHECK(refusalOf(job) == "unknown-boundary");
    job.cracks = {5};
    job.domain.boundaryNames[1] = "joint_right";
    CHECK(refusalOf(job) == "crack-name");
    job = toTheSide();
    for (DomainSegment &segment : job.domain.segments) {
        const double x = job.domain.nodes[segment.a].x + job.domain.nodes[segment.b].x;
        segment.tag = segment.role == SegmentRole::Constraint ? 5 : x == -2 ? 2 : x == 2 ? 3 : 1;
    }
    job.cracks.clear();
    job.periodic = {{2, 3}};
    CHECK(refusalOf(job) == "periodic-sides"); // the node of the tip has no image
    job.domain.nodes.push_back({-1, 0});
    const auto left = static_cast<std::uint32_t>(job.domain.nodes.size() - 1);
    for (std::size_t s = 0; s < job.domain.segments.size(); ++s) {
        if (job.domain.segments[s].tag == 2) {
            DomainSegment second = job.domain.segments[s];
            job.domain.segments[s].b = left;
            second.a = left;
            job.domain.segments.push_back(second);
            break;
        }
    }
    CHECK(refusalOf(job).empty());
    job.cracks = {5};
    CHECK(refusalOf(job) == "crack-periodic");
}

TEST_CASE("Cracks: faults of their nodes are found") {
    const MeshingJob job = square({{{-0.6, 0}, {0, 0}, {0.6, 0.1}}, {{0, -0.6}, {0, 0}, {0, 0.6}}});
    const std::int32_t cracks[] = {5};
    MeshingJob uncracked = job;
    uncracked.cracks.clear();
    Mesh mesh = meshedJob(uncracked).mesh;
    REQUIRE(verifyCracks(mesh, cracks).size() == 1);
    CHECK(verifyCracks(mesh, cracks).front().code == "crack-closed");
    CHECK(verifyAgainst(mesh, job.domain, {}, kMaxListedFaults, {}, true, cracks).front().code == "crack-closed");
    mesh = meshedJob(job).mesh;
    CHECK(verifyAgainst(mesh, job.domain).front().code != "open-line"); // without cracks, double edges are faults
    std::vector<NodeId> copies;                                         // of the crossing
    for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
        if (mesh.nodes[n] == Vec2{0, 0}) {
            copies.push_back(NodeId{n});
        }
    }
    REQUIRE(copies.size() == 4);
    for (CellBlock &block : mesh.blocks) {
        for (NodeId &node : block.connectivity()) {
            node = node == copies[3] ? copies[1] : node;
        }
    }
    for (TaggedEdge &edge : mesh.edges) {
        edge.a = edge.a == copies[3] ? copies[1] : edge.a;
        edge.b = edge.b == copies[3] ? copies[1] : edge.b;
    }
    REQUIRE(verifyCracks(mesh, cracks).size() == 1);
    CHECK(verifyCracks(mesh, cracks).front().code == "crack-nodes");
}

TEST_CASE("Cracks: meshes that are read are meshed again with them") {
    const MeshingJob job = toTheSide();
    const Mesh mesh = meshedJob(job).mesh;
    Result<MeshDomain> outline = domainOfMesh(mesh);
    REQUIRE(outline);
    CHECK(outline->cracks == std::vector<std::int32_t>{5});
    CHECK(outline->domain.boundaryNames.count(6) == 0);
    MeshingJob again;
    again.domain = outline->domain;
    again.spacing.size = 0.1;
    again.cracks = outline->cracks;
    again.options.verify = true;
    CHECK(meshedJob(again).cracks.tips == 1);
    Mesh bare = mesh;
    bare.edges.clear();
    bare.boundaryNames.clear();
    outline = domainOfMesh(bare);
    REQUIRE(outline);
    REQUIRE(outline->cracks.size() == 1);
    CHECK(outline->domain.boundaryNames.at(outline->cracks[0]) == "crack");
    again.domain = outline->domain;
    again.cracks = outline->cracks;
    CHECK(meshedJob(again).cracks.tips == 1);
}

namespace crack_cases {

/// Two unit squares side by side whose nodes at x = 1 are not merged. `left`, `right`: tags of their outlines.
Mesh twoBlocks(std::int32_t left, std::int32_t right) {
    Mesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1}};
    CellBlock &block = mesh.block(CellKind::Quadrilateral4);
    for (const std::uint32_t first : {0U, 4U}) {
        const std::array<NodeId, 4> corners{NodeId{first}, NodeId{first + 1}, NodeId{first + 2}, NodeId{first + 3}};
        block.add(corners);
        block.regions.push_back(1);
        for (std::uint32_t k = 0; k < 4; ++k) {
            mesh.edges.push_back({corners[k], corners[(k + 1) % 4], first == 0 ? left : right, kNoNode});
        }
    }
    mesh.boundaryNames = {{1, "a"}, {2, "b"}};
    return mesh;
}

} // namespace crack_cases

TEST_CASE("Cracks: blocks whose nodes are not merged keep their tags, and their contact has one of its own") {
    for (const std::int32_t right : {2, 1}) {
        CAPTURE(right);
        const Mesh mesh = twoBlocks(1, right);
        const Result<MeshDomain> outline = domainOfMesh(mesh);
        REQUIRE(outline);
        CHECK(outline->cracks == std::vector<std::int32_t>{3});
        CHECK(outline->domain.boundaryNames == std::map<std::int32_t, std::string>{{1, "a"}, {2, "b"}, {3, "crack"}});
        const auto has = [&](std::int32_t tag) {
            return std::count_if(outline->domain.segments.begin(), outline->domain.segments.end(),
                                 [tag](const DomainSegment &segment) { return segment.tag == tag; });
        };
        CHECK(has(1) == (right == 1 ? 6 : 3));
        CHECK(has(3) == 1);
        MeshingJob job;
        job.domain = outline->domain;
        job.cracks = outline->cracks;
        job.spacing.size = 0.3;
        job.options.verify = true;
        CHECK(meshedJob(job).cracks.tips == 0);
        const Result<MeshDomain> left = domainOfMesh(mesh, {}, OpenLineRule::OwnTags);
        REQUIRE(left);
        CHECK(left->cracks.empty());
        CHECK(left->domain.segments.size() == 8); // repair() merges those at the contact
    }
}

TEST_CASE("Cracks: a line with two other faces is one crack") {
    Mesh mesh = twoBlocks(1, 2);
    const auto tag = [&](NodeId a, NodeId b, std::int32_t is) {
        for (TaggedEdge &edge : mesh.edges) {
            edge.tag = edge.a == a && edge.b == b ? is : edge.tag;
        }
    };
    // A second contact: a third block above the first one.
    mesh.nodes.insert(mesh.nodes.end(), {{0, 1}, {1, 1}, {1, 2}, {0, 2}});
    const std::array<NodeId, 4> corners{NodeId{8}, NodeId{9}, NodeId{10}, NodeId{11}};
    CellBlock &block = mesh.block(CellKind::Quadrilateral4);
    block.add(corners);
    block.regions.push_back(1);
    for (std::uint32_t k = 0; k < 4; ++k) {
        mesh.edges.push_back({corners[k], corners[(k + 1) % 4], 2, kNoNode});
    }
    tag(NodeId{1}, NodeId{2}, 7);
    tag(NodeId{2}, NodeId{3}, 7);
    tag(NodeId{7}, NodeId{4}, 8);
    tag(NodeId{8}, NodeId{9}, 9);
    const Result<MeshDomain> outline = domainOfMesh(mesh);
    REQUIRE(outline);
    CHECK(outline->lines.size() == 2);
    CHECK(outline->cracks == std::vector<std::int32_t>{7});
}

TEST_CASE("Cracks: every format with names holds both faces") {
    const Mesh mesh = meshedJob(square({{{-0.5, 0}, {0.1, 0.2}, {0.5, 0}}})).mesh;
    const TemporaryFolder folder;
    for (const char *const name : {"m.msh", "m.vtu", "m.mesh", "m.inp", "m.su2", "m.unv", "m.bdf", "m.ele"}) {
        const std::filesystem::path path = folder / name;
        REQUIRE_FALSE(hasErrors(writeMesh(path, mesh)));
        const Result<Mesh> read = readMesh(path);
        REQUIRE_MESSAGE(read, name);
        CHECK_MESSAGE(openLines(*read).size() == 1, name);
        CHECK_MESSAGE(verify(*read).size() == 1, name);
        ImportNotes notes;
        const Result<DomainFile> file = readDomain(path, {}, &notes);
        REQUIRE_MESSAGE(file, name);
        CHECK_MESSAGE(file->cracks.size() == 1, name);
    }
}

TEST_CASE("Project: cracks are kept, and given to the job where their lines exist") {
    const auto project = [](const std::string &cracks) {
        return parseProject(R"({"format": "forefront", "version": 1, "shapes": [
            {"id": 1, "kind": "rectangle", "use": "boundary", "tag": 1, "name": "", "nodes": [[0, 0], [4, 3]]},
            {"id": 2, "kind": "polyline", "use": "constraint", "tag": 4, "name": "", "nodes": [[1, 1], [3, 2]]}],
            "cracks": )" + cracks +
                                R"(, "nextId": 3})",
                            "crack.json");
    };
    const Result<Document> document = project("[4, 9]");
    REQUIRE(document);
    CHECK(document->cracks == std::vector<std::int32_t>{4, 9});
    const Result<Document> again = parseProject(projectText(*document), "again.json");
    REQUIRE(again);
    CHECK(sameContent(*again, *document));
    Document other = *document;
    other.cracks.pop_back();
    CHECK_FALSE(sameContent(other, *document));
    CHECK(jobOf(*document).cracks == std::vector<std::int32_t>{4});
    CHECK(meshedJob(jobOf(*document)).cracks.tips == 2);
    for (const char *const wrong : {"{}", "[0]", "[4, 4]", "[\"a\"]"}) {
        CHECK_FALSE(project(wrong));
    }
}
