#include "core/engine/domain/add_loop.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

using namespace forefront;
using samples::Codes;
using samples::codes;
using samples::node;

namespace {

/// A square of 12 x 12 cells, turned by `turn` so that no side is parallel to an axis, whose right half is region 6,
/// with a constraint point; and the domain of seven segments that it meshes.
struct TurnedSquare {
    TriMesh mesh;
    Domain domain;
};

TurnedSquare turnedSquare(double turn = 0.3, Vec2 offset = {}) {
    TurnedSquare c{samples::square(12, 12, 0.2), {}};
    TriMesh &mesh = c.mesh;
    for (std::size_t j = 0; j <= 12; ++j) {
        mesh.nodes[13 * j + 6].x = 0.5; // the constraint is straight
    }
    for (const Element &e : mesh.elements) {
        const Vec2 sum = mesh.nodes[index(e[0])] + mesh.nodes[index(e[1])] + mesh.nodes[index(e[2])];
        mesh.regions.push_back(sum.x < 1.5 ? 5 : 6);
    }
    for (Vec2 &p : mesh.nodes) {
        p = Vec2{p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn)} + offset;
    }
    for (std::size_t j = 0; j < 12; ++j) {
        mesh.edges.push_back({node(13 * j + 6), node(13 * j + 19), 9});
    }
    mesh.points = {{node(28), 4}};
    for (const std::size_t n : {0U, 6U, 12U, 168U, 162U, 156U, 28U}) {
        c.domain.nodes.push_back(mesh.nodes[n]);
    }
    c.domain.segments = {
        {0, 1, 1}, {1, 2, 1}, {3, 2, 2}, {3, 4, 3}, {5, 4, 3}, {5, 0, 4}, {4, 1, 9, SegmentRole::Constraint}};
    c.domain.points = {{6, 4}};
    c.domain.regionMarkers = {{mesh.nodes[15], 5}, {mesh.nodes[24], 6}};
    return c;
}

Codes after(void (*change)(TurnedSquare &)) {
    TurnedSquare c = turnedSquare();
    change(c);
    return codes(verifyAgainst(c.mesh, c.domain));
}

} // namespace

TEST_CASE("verifyAgainst domain: accepts a mesh that divides segments, rotated and far from the origin") {
    for (const double turn : {0.0, 0.3, 2.0}) {
        for (const Vec2 offset : {Vec2{}, Vec2{1e5, -1e5}, Vec2{123456.7, 1e5 + 0.3}, Vec2{-1e9, 3e8}}) {
            const TurnedSquare c = turnedSquare(turn, offset);
            const Diagnostics faults = verifyAgainst(c.mesh, c.domain);
            CHECK_MESSAGE(faults.empty(), samples::list(faults));
        }
    }
}

TEST_CASE("verifyAgainst domain: accepts meshes of long and thin domains along slanted lines") {
    for (const double aspect : {1e2, 1e4, 1e6, 1e8}) {
        for (const double turn : {0.0, 0.1, 0.6, 1.2, 2.5, 4.0}) {
            for (const Vec2 offset : {Vec2{}, Vec2{0.3 * aspect, -7.7}}) {
                CAPTURE(aspect);
                CAPTURE(turn);
                MeshingJob job;
                std::vector<Vec2> loop{{0, 0}, {aspect, 0}, {aspect, 1}, {0, 1}};
                for (Vec2 &p : loop) {
                    p = Vec2{p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn)} +
                        offset;
                }
                addLoop(job.domain, loop);
                job.domain.nodes.push_back(lerp(loop[0], loop[2], 0.31));
                job.domain.points.push_back({4, 2});
                const auto outcome = meshDomain(job);
                REQUIRE(outcome);
                const Diagnostics faults = verifyAgainst(outcome->mesh, job.domain);
                CHECK_MESSAGE(faults.empty(), samples::list(faults));
                const Diagnostics discrete = verifyAgainst(outcome->mesh, *outcome->boundary);
                CHECK_MESSAGE(discrete.empty(), samples::list(discrete));
            }
        }
    }
}

TEST_CASE("verifyAgainst domain: a missing area far below the largest products is found") {
    // The same mesh on another domain, whose area differs by 1e-12 of it.
    DiscreteDomain domain = samples::squareDomain(samples::square(12, 12, 0.2), 1.0 + 1e-12);
    const TriMesh mesh = samples::square(12, 12, 0.2);
    CHECK(codes(verifyAgainst(mesh, domain)) == Codes{"area"});
}

TEST_CASE("verifyAgainst domain: reports the faults of an invalid domain") {
    CHECK(after([](TurnedSquare &c) {
              c.domain.segments.pop_back(), c.domain.segments.pop_back();
          }).count("open-chain") == 1);
}

TEST_CASE("verifyAgainst domain: given nodes must be nodes of the mesh exactly") {
    CHECK(after([](TurnedSquare &c) { c.domain.nodes[0].x -= 1e-15; }) == Codes{"missing-node"});
    CHECK(after([](TurnedSquare &c) { c.domain.nodes[6].x += 1e-15; }) == Codes{"missing-point"});
}

TEST_CASE("verifyAgainst domain: inserted nodes must lie on their segment") {
    // Node 3 lies on the bottom side; out of it by 1e-12 is rounding, by 1e-6 is a fault.
    CHECK(after([](TurnedSquare &c) { c.mesh.nodes[3].y -= 1e-12; }).empty());
    CHECK(after([](TurnedSquare &c) { c.mesh.nodes[3].y -= 1e-6; }) == Codes{"missing-segment"});
}

TEST_CASE("verifyAgainst domain: reports missing segments with their position") {
    TurnedSquare c = turnedSquare();
    c.domain.segments.push_back({0, 6, 1, SegmentRole::Constraint});
    const Diagnostics faults = verifyAgainst(c.mesh, c.domain);
    CHECK_MESSAGE(codes(faults) == Codes{"missing-segment"}, samples::list(faults));
    CHECK(faults[0].at == midpoint(c.domain.nodes[0], c.domain.nodes[6]));
    CHECK(faults[0].ids == std::vector<std::uint32_t>{7});
}

TEST_CASE("verifyAgainst domain: a mesh of a larger or smaller domain does not pass") {
    // The domain has a hole that the mesh fills.
    CHECK(!after([](TurnedSquare &c) {
               const auto first = static_cast<std::uint32_t>(c.domain.nodes.size());
               for (const std::size_t n : {14U, 15U, 41U}) {
                   c.domain.nodes.push_back(c.mesh.nodes[n]);
               }
               c.domain.segments.insert(c.domain.segments.end(),
                                        {{first, first + 1, 1}, {first + 1, first + 2, 1}, {first + 2, first, 1}});
               c.domain.points.clear();
               c.domain.nodes[6] = c.domain.nodes[8];
               c.domain.nodes.pop_back();
           }).empty());
    // The mesh has a hole that the domain does not have.
    CHECK(after([](TurnedSquare &c) {
              for (const std::size_t e : {31U, 30U}) {
                  c.mesh.elements.erase(c.mesh.elements.begin() + e);
                  c.mesh.regions.erase(c.mesh.regions.begin() + e);
              }
          }).count("unexpected-boundary") == 1);
}

TEST_CASE("verifyAgainst domain: tags and regions are compared") {
    CHECK(after([](TurnedSquare &c) { c.domain.segments[0].tag = 3; }) == Codes{"wrong-tag"});
    CHECK(after([](TurnedSquare &c) { c.mesh.edges[5].tag = 2; }) == Codes{"wrong-tag"});
    CHECK(after([](TurnedSquare &c) { c.domain.points[0].tag = 1; }) == Codes{"wrong-tag"});
    CHECK(after([](TurnedSquare &c) { c.domain.regionMarkers[1].tag = 7; }) == Codes{"wrong-region"});
    CHECK(after([](TurnedSquare &c) {
              c.mesh.edges.push_back({node(14), node(15), 2});
          }) == Codes{"unexpected-tagged-edge"});
}

TEST_CASE("verifyAgainst domain: a mesh from a format without tags is compared by its shape") {
    CHECK(after([](TurnedSquare &c) {
              c.mesh.edges.clear();
              c.mesh.points.clear();
              c.mesh.regions.clear();
          }).empty());
    CHECK(after([](TurnedSquare &c) {
              c.mesh.edges.clear();
              c.mesh.points.clear();
              c.mesh.regions.clear();
              c.domain.nodes[3] += Vec2{1e-3, 1e-3};
          }) == Codes{"missing-node"});
}

TEST_CASE("verifyAgainst domain: distinguishes adjacent segments at the angle of a needle") {
    // Two constraints leave node 0 at an angle of 1e-8 and are cut at different places.
    TriMesh mesh;
    const double h = 1e-8;
    mesh.nodes = {{0, 0}, {2, 0}, {2, 2 * h}, {1, 0}, {1.5, 1.5 * h}, {1, -1}, {1, 1}};
    mesh.elements = {{node(0), node(3), node(4)}, {node(3), node(1), node(4)}, {node(1), node(2), node(4)},
                     {node(0), node(5), node(3)}, {node(5), node(1), node(3)}, {node(0), node(4), node(6)},
                     {node(4), node(2), node(6)}};
    mesh.edges = {{node(0), node(5), 1}, {node(5), node(1), 1}, {node(1), node(2), 1},
                  {node(2), node(6), 1}, {node(6), node(0), 1}, {node(0), node(3), 2},
                  {node(3), node(1), 2}, {node(0), node(4), 3}, {node(4), node(2), 3}};
    Domain domain;
    domain.nodes = {{0, 0}, {2, 0}, {2, 2 * h}, {1, -1}, {1, 1}};
    domain.segments = {{0, 3, 1},
                       {3, 1, 1},
                       {1, 2, 1},
                       {2, 4, 1},
                       {4, 0, 1},
                       {0, 1, 2, SegmentRole::Constraint},
                       {0, 2, 3, SegmentRole::Constraint}};
    const Diagnostics faults = verifyAgainst(mesh, domain);
    CHECK_MESSAGE(faults.empty(), samples::list(faults));
}

TEST_CASE("verifyAgainst domain: tells the sides of a needle apart where they are closer than the tolerance") {
    // Beside the tip, the nearest node of each side, 7 and 8, is on the other one to rounding.
    const double h = 1e-8;
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {2, 0}, {2, 2 * h}, {1, 0}, {1.5, 1.5 * h}, {1, -1}, {1, 1}, {2e-6, 0}, {1e-6, 1e-6 * h}};
    mesh.elements = {{node(0), node(7), node(8)}, {node(7), node(3), node(8)}, {node(8), node(3), node(4)},
                     {node(3), node(1), node(4)}, {node(1), node(2), node(4)}, {node(0), node(5), node(7)},
                     {node(7), node(5), node(3)}, {node(5), node(1), node(3)}, {node(0), node(8), node(6)},
                     {node(8), node(4), node(6)}, {node(4), node(2), node(6)}};
    Domain domain;
    domain.nodes = {{0, 0}, {2, 0}, {2, 2 * h}, {1, -1}, {1, 1}};
    domain.segments = {{0, 3, 1}, {3, 1, 1}, {1, 2, 1}, {2, 4, 1}, {4, 0, 1}};
    for (const bool curved : {false, true}) {
        CAPTURE(curved);
        Domain needle = domain;
        needle.segments.push_back({0, 1, 2, SegmentRole::Constraint});
        needle.segments.push_back({0, 2, 3, SegmentRole::Constraint});
        if (curved) {
            for (const std::uint32_t side : {0U, 1U}) {
                const Vec2 end = domain.nodes[side + 1];
                needle.curves.push_back(Curve::cubic({0, 0}, (1.0 / 3.0) * end, (2.0 / 3.0) * end, end));
                needle.segments[5 + side].stretch = {side, 0.0, 1.0};
            }
        }
        const std::vector<TaggedEdge> lower = {{node(0), node(7), 2}, {node(7), node(3), 2}, {node(3), node(1), 2}};
        const std::vector<TaggedEdge> upper = {{node(0), node(8), 3}, {node(8), node(4), 3}, {node(4), node(2), 3}};
        for (const bool lowerFirst : {false, true}) {
            mesh.edges = {{node(0), node(5), 1},
                          {node(5), node(1), 1},
                          {node(1), node(2), 1},
                          {node(2), node(6), 1},
                          {node(6), node(0), 1}};
            for (const std::vector<TaggedEdge> &side : {lowerFirst ? lower : upper, lowerFirst ? upper : lower}) {
                mesh.edges.insert(mesh.edges.end(), side.begin(), side.end());
            }
            const Diagnostics faults = verifyAgainst(mesh, needle);
            CHECK_MESSAGE(faults.empty(), samples::list(faults));
        }
        mesh.edges.pop_back(); // an edge of a side is missing
        CHECK(codes(verifyAgainst(mesh, needle)) == Codes{"missing-segment"});
    }
}

TEST_CASE("verifyAgainst domain: a needle whose tip is within the tolerance of its sides keeps both sides") {
    // From the tip, the nodes of both sides are ahead, and within the rounding of 1e17 of either.
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {4, 0}, {4, 1e17}, {0, 2}});
    const Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE(outcome);
    CHECK(codes(verifyAgainst(outcome->mesh, job.domain)) == Codes{});
    Mesh wrong = outcome->mesh; // a side that is not covered is still found
    for (Vec2 &place : wrong.nodes) {
        place = place == Vec2{0, 2} ? Vec2{0, 3} : place;
    }
    CHECK_FALSE(verifyAgainst(wrong, job.domain).empty());
}
