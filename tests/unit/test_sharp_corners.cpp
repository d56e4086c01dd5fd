#include "core/engine/mesh/sharp_corners.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

using namespace forefront;
using samples::node;

namespace {

/// A needle of 10 degrees with its tip at the origin and a nearly equilateral element at its other end.
TriMesh needle() {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {1, std::tan(10.0 * 0.017453292519943295)}, {1.15, 0.09}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(1), node(3), node(2)}};
    mesh.edges = {{node(0), node(1), 1}, {node(1), node(3), 2}, {node(3), node(2), 2}, {node(2), node(0), 3}};
    return mesh;
}

} // namespace

TEST_CASE("sharpCorners: reports the tip of a needle with its position and angle") {
    const SharpCorners sharp = sharpCorners(needle(), 20.0);
    REQUIRE(sharp.corners.size() == 1);
    CHECK(sharp.corners[0].node == node(0));
    CHECK(sharp.corners[0].at == Vec2{});
    CHECK(sharp.corners[0].angle == doctest::Approx(10.0));
    CHECK(sharp.minAngleElsewhere > 55.0);
    CHECK(sharpCorners(needle(), 9.0).corners.empty());
    CHECK(sharpCorners(needle(), 9.0).minAngleElsewhere == doctest::Approx(10.0));
}

TEST_CASE("sharpCorners: elements along a needle belong to its tip, but a needle elsewhere does not") {
    // Two lines 2 degrees apart with nodes at 1, 2, 3; beyond them a flat element with a separate edge.
    TriMesh mesh;
    const double slope = std::tan(2.0 * 0.017453292519943295);
    mesh.nodes = {{0, 0}, {1, 0}, {1, slope}, {2, 0}, {2, 2 * slope}, {3, 0}, {3, 3 * slope}, {7, 0}, {9, 0}, {9, 0.2}};
    mesh.elements = {{node(0), node(1), node(2)},
                     {node(1), node(3), node(2)},
                     {node(3), node(4), node(2)},
                     {node(3), node(5), node(4)},
                     {node(5), node(6), node(4)}};
    mesh.edges = {{node(0), node(1), 1}, {node(1), node(3), 1}, {node(3), node(5), 1}, {node(5), node(6), 1},
                  {node(6), node(4), 1}, {node(4), node(2), 1}, {node(2), node(0), 1}};
    const SharpCorners strip = sharpCorners(mesh, 20.0);
    REQUIRE(strip.corners.size() == 1);
    CHECK(strip.minAngleElsewhere == 60.0); // nothing is elsewhere
    mesh.elements.push_back({node(7), node(8), node(9)});
    const SharpCorners both = sharpCorners(mesh, 20.0);
    CHECK(both.corners.size() == 1);
    CHECK(both.minAngleElsewhere == doctest::Approx(5.71).epsilon(0.01));
}

TEST_CASE("sharpCorners: reports a slot without room for good elements, but not a cut-off flat corner") {
    // A slot of width 0.01 and length 3, closed at its right end, with nodes at 0, 1, 2, 3 on both sides.
    TriMesh mesh;
    for (int i = 0; i <= 3; ++i) {
        mesh.nodes.insert(mesh.nodes.end(), {{1.0 * i, 0.0}, {1.0 * i, 0.01}});
    }
    for (unsigned i = 0; i < 6; i += 2) {
        mesh.elements.push_back({node(i), node(i + 2), node(i + 1)});
        mesh.elements.push_back({node(i + 2), node(i + 3), node(i + 1)});
        mesh.edges.push_back({node(i), node(i + 2), 1});
        mesh.edges.push_back({node(i + 1), node(i + 3), 1});
    }
    mesh.edges.push_back({node(6), node(7), 1});
    const SharpCorners slot = sharpCorners(mesh, 20.0);
    CHECK(slot.corners.empty());
    REQUIRE(slot.narrow.size() == 1);
    CHECK(slot.narrow[0].elements == 6);
    CHECK(slot.narrow[0].width == doctest::Approx(0.01).epsilon(0.001));
    CHECK(slot.minAngleElsewhere == 60.0);
    mesh.nodes.insert(mesh.nodes.end(), {{5, 0}, {6, -0.01}, {7, 0}});
    mesh.elements.push_back({node(8), node(9), node(10)});
    mesh.edges.insert(mesh.edges.end(), {{node(8), node(9), 1}, {node(9), node(10), 1}});
    const SharpCorners both = sharpCorners(mesh, 20.0);
    CHECK(both.narrow.size() == 1);
    CHECK(both.minAngleElsewhere < 1.0);
}

TEST_CASE("sharpCorners: reports the gap between two tips, but not a short edge between long ones") {
    // Tips of two needles outside the mesh, 0.02 apart; the nodes above and below them are free.
    TriMesh mesh;
    mesh.nodes = {{-0.01, 0}, {0.01, 0}, {0, 0.2}, {0, -0.2}, {-1, 0.01}, {-1, -0.01}, {1, 0.01}, {1, -0.01}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(1), node(0), node(3)}, {node(0), node(2), node(4)},
                     {node(0), node(5), node(3)}, {node(1), node(6), node(2)}, {node(1), node(3), node(7)}};
    mesh.edges = {{node(0), node(4), 1}, {node(0), node(5), 1}, {node(1), node(6), 1}, {node(1), node(7), 1}};
    const SharpCorners gap = sharpCorners(mesh, 20.0);
    REQUIRE(gap.narrow.size() == 1);
    CHECK(gap.narrow[0].width == doctest::Approx(0.02).epsilon(0.01));
    CHECK(gap.narrow[0].elements == 2);
    CHECK(gap.minAngleElsewhere == 60.0); // the others are next to them
    mesh.edges.push_back({node(0), node(1), 1});
    CHECK(sharpCorners(mesh, 20.0).narrow.empty());
    CHECK(sharpCorners(mesh, 20.0).minAngleElsewhere < 6.0);
}

TEST_CASE("sharpCorners: the gap between a point and an edge is a narrow place") {
    TriMesh mesh;
    mesh.nodes = {{-0.5, 0}, {0.5, 0}, {0, 0.05}};
    mesh.elements = {{node(0), node(1), node(2)}};
    mesh.edges = {{node(0), node(1), 1}};
    CHECK(sharpCorners(mesh, 20.0).narrow.empty());
    CHECK(sharpCorners(mesh, 20.0).minAngleElsewhere < 6.0);
    mesh.points = {{node(2), 1}};
    REQUIRE(sharpCorners(mesh, 20.0).narrow.size() == 1);
    CHECK(sharpCorners(mesh, 20.0).narrow[0].width == doctest::Approx(0.05));
    CHECK(sharpCorners(mesh, 20.0).minAngleElsewhere == 60.0);
}

TEST_CASE("sharpCorners: sharp elements that share nodes with those in a gap count with it, others do not") {
    // Two tips a gap apart, above them a free node, to its right a row of sharp elements that share single nodes.
    TriMesh mesh;
    mesh.nodes = {{-0.02, 0}, {0.02, 0}, {0, 0.2}, {1, 0.2}, {1, 0.4}, {2, 0.2}, {2, 0.4}, {-1, -1}, {1, -1}, {5, 0}};
    mesh.elements = {{node(2), node(3), node(4)}, {node(3), node(5), node(6)}};
    mesh.edges = {{node(0), node(7), 1}, {node(1), node(8), 1}};
    CHECK(sharpCorners(mesh, 20.0).minAngleElsewhere == doctest::Approx(11.31).epsilon(0.001));
    mesh.elements.push_back({node(0), node(1), node(2)});
    CHECK(sharpCorners(mesh, 20.0).minAngleElsewhere == 60.0);
    mesh.elements[1] = {node(5), node(9), node(6)}; // shares no node with the others
    CHECK(sharpCorners(mesh, 20.0).minAngleElsewhere < 11.0);
}

TEST_CASE("sharpCorners: a wedge outside the mesh does not count, but one between inner lines does") {
    TriMesh mesh = needle();
    mesh.elements.erase(mesh.elements.begin()); // what is left lies beyond the tip
    CHECK(sharpCorners(mesh, 20.0).corners.empty());
    TriMesh square = samples::square(8, 8);
    CHECK(sharpCorners(square, 89.0).corners.empty());
    CHECK(sharpCorners(square, 91.0).corners.size() == 4);
    const Element inner = square.elements[60];
    square.edges.push_back({inner[0], inner[1], 9});
    square.edges.push_back({inner[0], inner[2], 9});
    CHECK(sharpCorners(square, 91.0).corners.size() == 5);
}

TEST_CASE("sharpCorners: a mesh without elements has none") {
    CHECK(sharpCorners(TriMesh(), 20.0).corners.empty());
    CHECK(sharpCorners(TriMesh(), 20.0).minAngleElsewhere == 0.0);
}
