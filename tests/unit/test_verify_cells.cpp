#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/jacobian.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/engine/mesh/orientation.hpp"
#include "core/engine/mesh/verify.hpp"
#include "tests/unit/block_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace forefront;
using samples::Codes;
using samples::node;

namespace {

/// Returns a mesh of one element. `nodes`: corners, then middles.
Mesh alone(CellKind kind, std::vector<Vec2> places) {
    Mesh mesh;
    mesh.nodes = std::move(places);
    std::vector<NodeId> nodes;
    for (std::size_t k = 0; k < traitsOf(kind).nodes; ++k) {
        nodes.push_back(node(k));
    }
    mesh.block(kind).add(nodes);
    return mesh;
}

Mesh quadrilateralOf(const std::vector<Vec2> &corners) {
    return alone(CellKind::Quadrilateral4, corners);
}

/// Returns an element of second order over a square or half of one with its middle nodes moved at random.
Mesh bulged(CellKind kind, samples::Random &random, double amount) {
    samples::BlockMaker maker({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    std::vector<NodeId> corners = {node(0), node(1), node(2), node(3)};
    corners.resize(traitsOf(kind).corners);
    maker.add(kind, corners);
    Mesh mesh = std::move(maker.mesh);
    for (std::size_t k = corners.size(); k < traitsOf(kind).nodes; ++k) {
        mesh.nodes[index(mesh.blocks[0].nodesOf(0)[k])] += {random(-amount, amount), random(-amount, amount)};
    }
    return mesh;
}

/// Returns the minimum of the Jacobian determinant over a grid on the reference element.
double sampledMinimum(const PlacedCell &cell, int steps) {
    double least = 1e300;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j <= (cell.traits().corners == 3 ? steps - i : steps); ++j) {
            least = std::min(least, jacobianAt(cell, {static_cast<double>(i) / steps, static_cast<double>(j) / steps}));
        }
    }
    return least;
}

bool hasFault(const Diagnostics &faults, const std::string &code) {
    return samples::codes(faults).contains(code);
}

} // namespace

TEST_CASE("verify cells: meshes of every kind have no fault, straight and bent, and turned ones get a warning") {
    std::vector<Mesh> meshes = {samples::mixedSample(), samples::secondOrderSample(),
                                samples::bent(samples::secondOrderSample(), 0.15), samples::allKindsSample()};
    for (const CellKind kind : kElementKinds) {
        meshes.push_back(samples::sampleMesh(kind));
        meshes.push_back(samples::bent(samples::sampleMesh(kind), 0.1));
    }
    for (const Mesh &mesh : meshes) {
        const Diagnostics faults = verify(mesh);
        CHECK_MESSAGE(faults.empty(), samples::list(faults));
        CHECK_FALSE(isClockwise(mesh));
        const Mesh other = turned(mesh);
        CHECK(isClockwise(other));
        const Diagnostics ofOther = verify(other);
        CHECK_MESSAGE(samples::codes(ofOther) == Codes{"clockwise"}, samples::list(ofOther));
        CHECK(meshHash(turned(other)) == meshHash(mesh));
    }
    CHECK_FALSE(isClockwise(Mesh()));
}

TEST_CASE("verify cells: quadrilaterals that are not convex are refused by exact signs") {
    CHECK(verify(quadrilateralOf({{0, 0}, {1, 0}, {1, 1}, {0, 1}})).empty());
    const Diagnostics reflex = verify(quadrilateralOf({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}));
    REQUIRE(samples::codes(reflex) == Codes{"concave-element"});
    CHECK(reflex[0].message ==
          "element 0 is not convex: its corner at node 2 is reflex; expected angles below 180 degrees");
    CHECK(reflex[0].at == Vec2{0.5, 0.5});
    const Diagnostics flat = verify(quadrilateralOf({{0, 0}, {2, 0}, {1, 1}, {0, 2}}));
    REQUIRE(samples::codes(flat) == Codes{"concave-element"});
    CHECK(flat[0].message.find("node 2 is flat") != std::string::npos);
    const Diagnostics crossing = verify(quadrilateralOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
    CHECK(hasFault(crossing, "concave-element"));
    CHECK(samples::list(crossing).find("crosses itself") != std::string::npos);
    CHECK(hasFault(verify(quadrilateralOf({{0, 0}, {1, 0}, {2, 0}, {3, 0}})), "zero-area"));
    // Beside another element that is not clockwise, so that the mesh is not turned.
    for (const bool reflexed : {false, true}) {
        Mesh mesh =
            samples::joined({quadrilateralOf({{5, 0}, {6, 0}, {6, 1}, {5, 1}}),
                             quadrilateralOf({{0, 0}, {0, 2}, {reflexed ? 0.5 : 1.5, reflexed ? 0.5 : 1.5}, {2, 0}})});
        CHECK(hasFault(verify(mesh), "inverted-element"));
        CHECK_FALSE(hasFault(verify(mesh), "concave-element"));
    }
    const double tiny = 0x1p-52;
    CHECK(samples::codes(verify(quadrilateralOf({{0, 0}, {2, 0}, {1 + tiny, 1 + tiny}, {0, 2}}))) ==
          Codes{"flat-element"});
    CHECK(samples::codes(verify(quadrilateralOf({{0, 0}, {2, 0}, {1 - tiny, 1 - tiny}, {0, 2}}))) ==
          Codes{"concave-element"});
}

TEST_CASE("verify cells: the signs of quadrilaterals decide the sign of their area") {
    samples::Random random(5);
    const std::vector<NodeId> corners = {node(0), node(1), node(2), node(3)};
    std::size_t crossing = 0;
    for (int round = 0; round < 2000; ++round) { // on few places, so that many are collinear
        std::vector<Vec2> p;
        for (int k = 0; k < 4; ++k) {
            p.push_back({static_cast<double>(random.below(4)), static_cast<double>(random.below(4))});
        }
        const double area = cross(p[2] - p[0], p[3] - p[1]);
        const CornerSigns signs = cornerSigns(p, corners);
        if (signs.positive == 2 && signs.negative == 2) {
            ++crossing;
        } else {
            CHECK(signs.ofArea() == (area > 0.0 ? 1 : area < 0.0 ? -1 : 0));
        }
    }
    CHECK(crossing > 10);
}

TEST_CASE("verify cells: elements of second order that fold are found, with the place") {
    const Diagnostics folded =
        verify(alone(CellKind::Triangle6, {{0, 0}, {1, 0}, {0, 1}, {0.5, 0.6}, {0.5, 0.5}, {0, 0.5}}));
    REQUIRE(samples::codes(folded) == Codes{"folded-element"});
    REQUIRE(folded[0].at.has_value());
    CHECK(folded[0].message.find("element 0 is folded") == 0);
    // At a quarter of its edge, a middle node makes the determinant zero at the corner.
    CHECK(
        samples::codes(verify(alone(CellKind::Triangle6, {{0, 0}, {1, 0}, {0, 1}, {0.25, 0}, {0.5, 0.5}, {0, 0.5}}))) ==
        Codes{"folded-element"});
    CHECK(verify(alone(CellKind::Triangle6, {{0, 0}, {1, 0}, {0, 1}, {0.26, 0}, {0.5, 0.5}, {0, 0.5}})).empty());
    // All corners and edges of this one are good: only its inside folds.
    const Mesh inside = alone(CellKind::Quadrilateral9,
                              {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}, {0.95, 0.5}});
    const PlacedCell cell(MeshView(inside), 0);
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}) {
        CHECK(jacobianAt(cell, corner) > 0.5);
    }
    CHECK(hasFault(verify(inside), "folded-element"));
    // A corner that is reflex between chords, but not between the curved edges.
    std::vector<Vec2> places = {{0, 0}, {2, 0},           {0.95, 0.95},     {0, 2},
                                {1, 0}, {1.2375, 0.3875}, {0.3875, 1.2375}, {0, 1}};
    CHECK(verify(alone(CellKind::Quadrilateral8, places)).empty());
    places[5] = midpoint(places[1], places[2]);
    places[6] = midpoint(places[2], places[3]);
    CHECK(samples::codes(verify(alone(CellKind::Quadrilateral8, places))) == Codes{"concave-element"});
}

TEST_CASE("verify cells: the bound on the determinant agrees with samples") {
    samples::Random random(11);
    std::size_t valid = 0, folded = 0;
    for (const CellKind kind : {CellKind::Triangle6, CellKind::Quadrilateral8, CellKind::Quadrilateral9}) {
        for (int round = 0; round < 400; ++round) {
            const Mesh mesh = bulged(kind, random, random(0.05, 0.4));
            const PlacedCell cell(MeshView(mesh), 0);
            const double sampled = sampledMinimum(cell, 40);
            const std::optional<Vec2> fold = foldIn(cell);
            CAPTURE(wordOf(kind));
            CAPTURE(round);
            if (fold) {
                ++folded;
                CHECK(sampled < 0.02); // the grid may miss the worst place by a little
            } else {
                ++valid;
                CHECK(sampled > 0.0);
            }
            // The reference elements have the determinant 1 everywhere.
            const double ratio = leastJacobianRatio(cell);
            CHECK(ratio <= sampled + 1e-5);
            CHECK(ratio >= sampled - 0.02);
        }
    }
    CHECK(valid > 200);
    CHECK(folded > 200);
}

TEST_CASE("verify cells: the determinant is that of the map's derivatives") {
    samples::Random random(3);
    for (const CellKind kind : {CellKind::Triangle6, CellKind::Quadrilateral8, CellKind::Quadrilateral9}) {
        const Mesh mesh = samples::bent(samples::sampleMesh(kind), 0.1);
        double area = 0.0;
        const PlacedCell cell(MeshView(mesh), 1);
        constexpr int kSteps = 200;
        for (int i = 0; i < kSteps; ++i) { // by the midpoint rule
            for (int j = 0; j < kSteps; ++j) {
                const Vec2 at{(i + 0.5) / kSteps, (j + 0.5) / kSteps};
                const bool inside = cell.traits().corners == 4 || i + j < kSteps - 1;
                const double share = cell.traits().corners == 3 && i + j == kSteps - 1 ? 0.5 : 1.0;
                area += inside || share < 1.0 ? share * jacobianAt(cell, at) / (kSteps * kSteps) : 0.0;
            }
        }
        CHECK(area == doctest::Approx(0.5 * twiceArea(cell)).epsilon(1e-4));
    }
}

TEST_CASE("verify cells: references of all nodes are checked") {
    Mesh mesh = samples::secondOrderSample();
    mesh.blocks[0].connectivity()[5] = node(9999);
    CHECK(samples::codes(verify(mesh)) == Codes{"bad-index"});
    mesh = samples::secondOrderSample();
    mesh.edges[0].middle = node(9999);
    CHECK(samples::codes(verify(mesh)) == Codes{"bad-index"});
    mesh = samples::mixedSample();
    mesh.blocks[1].regions.pop_back();
    CHECK(samples::list(verify(mesh)).find("region tags") != std::string::npos);
    mesh = samples::sampleMesh(CellKind::Quadrilateral8);
    mesh.blocks[0].connectivity()[7] = mesh.blocks[0].connectivity()[4];
    const Diagnostics twice = verify(mesh);
    CHECK(samples::codes(twice) == Codes{"repeated-node"});
    CHECK(twice[0].message.find("expected eight different nodes") != std::string::npos);
}

TEST_CASE("verify cells: elements and tagged edges share the middle nodes of edges") {
    // The first element gets a middle node of its own on an edge that it shares.
    Mesh mesh = samples::sampleMesh(CellKind::Triangle6);
    const NodeId shared = mesh.blocks[0].nodesOf(0)[5]; // of its diagonal
    mesh.nodes.push_back(mesh.nodes[index(shared)]);
    mesh.blocks[0].connectivity()[5] = node(mesh.nodes.size() - 1);
    CHECK(samples::codes(verify(mesh)) == Codes{"middle-node"});
    CHECK(samples::list(verify(mesh)).find("expected the same in both") != std::string::npos);

    // A triangle of 3 nodes beside one of 6.
    mesh = alone(CellKind::Triangle6, {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}});
    mesh.nodes.push_back({1, 1});
    mesh.block(CellKind::Triangle3).add(std::vector<NodeId>{node(1), node(6), node(2)});
    CHECK(samples::codes(verify(mesh)) == Codes{"middle-node"});
    CHECK(samples::list(verify(mesh)).find("no middle node in element 1") != std::string::npos);

    // Two triangles on the halves of an edge.
    mesh = alone(CellKind::Triangle6, {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}});
    mesh.nodes.push_back({0.5, -1});
    mesh.block(CellKind::Triangle3).add(std::vector<NodeId>{node(0), node(6), node(3)});
    mesh.block(CellKind::Triangle3).add(std::vector<NodeId>{node(3), node(6), node(1)});
    CHECK(hasFault(verify(mesh), "middle-node"));
    CHECK(hasFault(verify(mesh), "hanging-node"));

    mesh = samples::sampleMesh(CellKind::Quadrilateral9);
    mesh.blocks[0].connectivity()[17] = mesh.blocks[0].connectivity()[8]; // two elements with one centre
    CHECK(hasFault(verify(mesh), "middle-node"));

    mesh = samples::secondOrderSample();
    mesh.edges[0].middle = mesh.edges[1].middle;
    CHECK(samples::codes(verify(mesh)) == Codes{"middle-node"});
    mesh.edges[0].middle = kNoNode; // an edge of 2 nodes names no other
    CHECK(verify(mesh).empty());
    mesh = samples::mixedSample();
    mesh.edges[0].middle = mesh.edges[5].a;
    CHECK(samples::list(verify(mesh)).find("expected that of its element, which has none") != std::string::npos);
}

TEST_CASE("verify cells: overlaps, missing edges and unused nodes are found among mixed elements") {
    const Mesh sample = samples::allKindsSample();
    Mesh shifted = samples::mixedSample();
    for (Vec2 &p : shifted.nodes) {
        p += {0.3, 0.3};
    }
    CHECK(hasFault(verify(samples::joined({sample, shifted})), "overlapping"));
    Mesh mesh = sample;
    mesh.edges.push_back({node(0), node(12), 3});
    CHECK(samples::codes(verify(mesh)) == Codes{"missing-tagged-edge"});
    mesh = sample;
    mesh.nodes.push_back({9, 9});
    CHECK(samples::codes(verify(mesh)) == Codes{"unreferenced-node"});
    mesh = samples::mixedSample(); // an edge with three elements
    const std::vector<NodeId> again(mesh.blocks[0].nodesOf(0).begin(), mesh.blocks[0].nodesOf(0).end());
    mesh.blocks[0].add(again);
    mesh.blocks[0].regions.push_back(1);
    CHECK(hasFault(verify(mesh), "non-conforming"));
}

TEST_CASE("verify cells: meshes are compared with the domain that they cover") {
    for (const Mesh &mesh : {samples::mixedSample(), samples::secondOrderSample(), samples::allKindsSample(),
                             samples::bent(samples::secondOrderSample(), 0.1)}) {
        const auto domain = domainOfMesh(mesh);
        REQUIRE(domain.ok());
        const Diagnostics faults = verifyAgainst(mesh, domain->domain);
        CHECK_MESSAGE(faults.empty(), samples::list(faults));
        const Diagnostics ofTurned = verifyAgainst(turned(mesh), domain->domain);
        CHECK_MESSAGE(samples::codes(ofTurned) == Codes{"clockwise"}, samples::list(ofTurned));
        Mesh other = mesh;
        other.blocks[0].regions[0] = 77;
        CHECK(hasFault(verifyAgainst(other, domain->domain), "wrong-region"));
        other = mesh;
        other.edges[0].tag = 77;
        CHECK(hasFault(verifyAgainst(other, domain->domain), "wrong-tag"));
    }
}

TEST_CASE("verify cells: middle nodes must lie on the segments of the domain or their curves") {
    Mesh mesh = samples::secondOrderSample();
    const auto straight = domainOfMesh(mesh);
    REQUIRE(straight.ok());
    CHECK(straight->domain.curves.empty());
    mesh.nodes[index(mesh.edges[0].middle)].y -= 0.02; // the bottom bulges outwards
    CHECK(samples::codes(verifyAgainst(mesh, straight->domain)) == Codes{"middle-node"});
    const auto curved = domainOfMesh(mesh);
    REQUIRE(curved.ok());
    CHECK(curved->domain.curves.size() == 1);
    CHECK(verifyAgainst(mesh, curved->domain).empty());
    mesh.nodes[index(mesh.edges[0].middle)].y += 0.02; // on the chord again
    CHECK(verifyAgainst(mesh, curved->domain).empty());
    mesh.nodes[index(mesh.edges[0].middle)].y -= 0.01;
    CHECK(samples::codes(verifyAgainst(mesh, curved->domain)) == Codes{"middle-node"});
}

TEST_CASE("domainOfMesh: edges of 3 nodes follow the parabola through their middle") {
    const Mesh mesh = samples::bent(samples::secondOrderSample(), 0.1);
    const auto domain = domainOfMesh(mesh);
    REQUIRE(domain.ok());
    std::size_t checked = 0;
    for (const DomainSegment &segment : domain->domain.segments) {
        const Vec2 a = domain->domain.nodes[segment.a], b = domain->domain.nodes[segment.b];
        const auto edge = std::find_if(mesh.edges.begin(), mesh.edges.end(), [&](const TaggedEdge &tagged) {
            const Vec2 from = mesh.nodes[index(tagged.a)], to = mesh.nodes[index(tagged.b)];
            return (from == a && to == b) || (from == b && to == a);
        });
        REQUIRE(edge != mesh.edges.end());
        CHECK(edge->tag == segment.tag);
        if (segment.stretch.follows()) {
            const Curve &curve = domain->domain.curves[segment.stretch.curve];
            CHECK(distance(curve.point(segment.stretch.t0), a) < 1e-15);
            CHECK(distance(curve.point(segment.stretch.t1), b) < 1e-15);
            CHECK(distance(curve.point(0.5), mesh.nodes[index(edge->middle)]) < 1e-15);
            ++checked;
        }
    }
    CHECK(checked == domain->domain.curves.size());
    CHECK(checked == mesh.edges.size());
    CHECK(domain->domain.regionMarkers.size() == 2);
    // The same without tags: outer edges and the interface take the middle nodes of their elements.
    Mesh untagged = mesh;
    untagged.edges.clear();
    const auto plain = domainOfMesh(untagged);
    REQUIRE(plain.ok());
    CHECK(plain->domain.curves.size() == domain->domain.curves.size());
    CHECK(plain->domain.segments.size() == domain->domain.segments.size());
}
