#include "core/engine/mesh/verify.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

using namespace forefront;
using samples::Codes;
using samples::codes;
using samples::node;

namespace {

/// A square with an inner constraint along x = 1/2 that separates two regions, and a constraint point.
struct TwoRegions {
    TriMesh mesh;
    DiscreteDomain domain;
};

TwoRegions twoRegions(Vec2 offset = {}) {
    TwoRegions c{samples::square(8, 8, 0.0, offset), {}};
    TriMesh &mesh = c.mesh;
    for (const Element &e : mesh.elements) {
        const Vec2 sum = mesh.nodes[index(e[0])] + mesh.nodes[index(e[1])] + mesh.nodes[index(e[2])];
        mesh.regions.push_back(sum.x - 3.0 * offset.x < 1.5 ? 5 : 6);
    }
    c.domain = samples::squareDomain(mesh);
    for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
        const double x = mesh.nodes[index(mesh.edges[i].a)].x + mesh.nodes[index(mesh.edges[i].b)].x - 2.0 * offset.x;
        c.domain.segments[i].leftRegion = x < 1.0 ? 0 : 1;
    }
    c.domain.regions = {{5, 0.5}, {6, 0.5}};
    for (std::size_t j = 0; j < 8; ++j) {
        const NodeId a = node(9 * j + 4), b = node(9 * j + 13);
        mesh.edges.push_back({a, b, 9});
        const auto first = static_cast<std::uint32_t>(c.domain.nodes.size());
        c.domain.nodes.push_back(mesh.nodes[index(a)]);
        c.domain.nodes.push_back(mesh.nodes[index(b)]);
        c.domain.segments.push_back({first, first + 1, 9, 0, 1, 0});
    }
    mesh.points = {{node(20), 4}};
    c.domain.points = {{static_cast<std::uint32_t>(c.domain.nodes.size()), 4}};
    c.domain.nodes.push_back(mesh.nodes[20]);
    return c;
}

Codes after(void (*change)(TwoRegions &)) {
    TwoRegions c = twoRegions();
    change(c);
    return codes(verifyAgainst(c.mesh, c.domain));
}

} // namespace

TEST_CASE("verifyAgainst: a mesh has no fault against its discrete domain, even far from the origin") {
    for (const Vec2 offset : {Vec2{}, Vec2{1e5, -1e5}, Vec2{1e5 + 0.3, 1e5 + 0.7}}) {
        const TwoRegions c = twoRegions(offset);
        const Diagnostics faults = verifyAgainst(c.mesh, c.domain);
        CHECK_MESSAGE(faults.empty(), samples::list(faults));
    }
}

TEST_CASE("verifyAgainst: the mesh's own faults come first, and notes hide no deviations") {
    CHECK(after([](TwoRegions &c) { c.mesh.nodes.push_back({9, 9}); }) == Codes{"unreferenced-node"});
    CHECK(after([](TwoRegions &c) {
              c.mesh.nodes.push_back({9, 9});
              c.mesh.points.clear();
          }) == Codes{"missing-point", "unreferenced-node"});
    CHECK(after([](TwoRegions &c) { c.mesh.elements.push_back(c.mesh.elements.front()); }).count("missing-point") == 0);
}

TEST_CASE("verifyAgainst: a mesh that is turned the other way is compared like any other") {
    const auto turn = [](TwoRegions &c) {
        for (Element &element : c.mesh.elements) {
            std::swap(element[1], element[2]);
        }
    };
    TwoRegions c = twoRegions();
    turn(c);
    CHECK(codes(verifyAgainst(c.mesh, c.domain)) == Codes{"clockwise"});
    c.mesh.points.clear();
    CHECK(codes(verifyAgainst(c.mesh, c.domain)) == Codes{"clockwise", "missing-point"});
}

TEST_CASE("verifyAgainst: a segment that is not an edge of the mesh is missing, with its place") {
    TwoRegions c = twoRegions();
    const auto first = static_cast<std::uint32_t>(c.domain.nodes.size());
    c.domain.nodes.insert(c.domain.nodes.end(), {{0.0, 0.0}, {0.25, 0.125}});
    c.domain.segments.push_back({first, first + 1, 9, 0, 0, 0});
    const Diagnostics faults = verifyAgainst(c.mesh, c.domain);
    CHECK(codes(faults) == Codes{"missing-segment"});
    CHECK(faults[0].at == Vec2{0.125, 0.0625});
}

TEST_CASE("verifyAgainst: edge tags must be present, correct, single and on segments") {
    CHECK(after([](TwoRegions &c) { c.mesh.edges[3].tag = 77; }) == Codes{"wrong-tag"});
    // The nodes of the edge taken away stay known by their other edges.
    CHECK(after([](TwoRegions &c) { c.mesh.edges.erase(c.mesh.edges.begin() + 4); }) == Codes{"missing-tagged-edge"});
    CHECK(after([](TwoRegions &c) { c.mesh.edges.push_back(c.mesh.edges[0]); }) == Codes{"duplicate-tagged-edge"});
    CHECK(after([](TwoRegions &c) {
              c.mesh.edges.push_back({node(10), node(11), 1});
          }) == Codes{"unexpected-tagged-edge"});
}

TEST_CASE("verifyAgainst: regions must be correct on both sides of segments and change nowhere else") {
    CHECK(after([](TwoRegions &c) { c.domain.regions[1].tag = 8; }) == Codes{"wrong-region"});
    CHECK(after([](TwoRegions &c) { c.mesh.regions[36] = 6; }) == Codes{"wrong-region"});
    // An element that no segment borders: only the change of region across its edges shows the fault.
    CHECK(after([](TwoRegions &c) { c.mesh.regions[2 * 9 + 1] = 7; }) == Codes{"wrong-region"});
}

TEST_CASE("verifyAgainst: elements must cover the inside and nothing else") {
    CHECK(after([](TwoRegions &c) { c.domain.segments[0].leftRegion = kOutside; }).count("element-outside") == 1);
    CHECK(after([](TwoRegions &c) { c.domain.segments[0].rightRegion = 0; }).count("missing-element") == 1);
    // A mesh with a hole that the domain does not have.
    CHECK(after([](TwoRegions &c) {
              for (const std::size_t e : {37U, 36U}) {
                  c.mesh.elements.erase(c.mesh.elements.begin() + e);
                  c.mesh.regions.erase(c.mesh.regions.begin() + e);
              }
          }).count("unexpected-boundary") == 1);
}

TEST_CASE("verifyAgainst: constraint points must be tagged nodes") {
    CHECK(after([](TwoRegions &c) { c.mesh.points[0].tag = 5; }) == Codes{"wrong-tag"});
    CHECK(after([](TwoRegions &c) { c.mesh.points.clear(); }) == Codes{"missing-point"});
    CHECK(after([](TwoRegions &c) { c.domain.nodes.back() += {1e-12, 0.0}; }) == Codes{"missing-point"});
}

TEST_CASE("verifyAgainst: the area must be the domain's within rounding") {
    CHECK(after([](TwoRegions &c) { c.domain.regions[0].area += 1e-9; }) == Codes{"area"});
    CHECK(after([](TwoRegions &c) { c.domain.regions[0].area += 1e-15; }).empty());
}

TEST_CASE("verifyAgainst: a mesh without any tags is compared by its shape alone") {
    TwoRegions c = twoRegions();
    c.mesh.edges.clear();
    c.mesh.points.clear();
    c.mesh.regions.clear();
    CHECK_MESSAGE(verifyAgainst(c.mesh, c.domain).empty(), samples::list(verifyAgainst(c.mesh, c.domain)));
    c.mesh.nodes[40].x += 1e-3; // middle node of the constraint
    CHECK(codes(verifyAgainst(c.mesh, c.domain)).count("missing-segment") == 1);
}
