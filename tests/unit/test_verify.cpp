#include "core/engine/mesh/verify.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>

using namespace forefront;
using samples::Codes;
using samples::codes;
using samples::node;

namespace {

/// Two triangles on a square without tags, room for more.
TriMesh twoTriangles() {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(0), node(2), node(3)}};
    return mesh;
}

/// Adds a moved copy of a mesh with its own nodes.
void append(TriMesh &mesh, const TriMesh &other, Vec2 by) {
    const std::size_t first = mesh.nodes.size();
    for (const Vec2 p : other.nodes) {
        mesh.nodes.push_back(p + by);
    }
    for (const Element &e : other.elements) {
        mesh.elements.push_back({node(first + index(e[0])), node(first + index(e[1])), node(first + index(e[2]))});
    }
}

/// The outermost cells of a square of 6 x 6, nodes numbered anew.
TriMesh squareRing() {
    const TriMesh whole = samples::square(6, 6);
    TriMesh ring;
    std::vector<NodeId> numbers(whole.nodes.size(), kNoNode);
    for (Element e : whole.elements) {
        const Vec2 sum = whole.nodes[index(e[0])] + whole.nodes[index(e[1])] + whole.nodes[index(e[2])];
        if (std::max(std::abs(sum.x - 1.5), std::abs(sum.y - 1.5)) < 1.0) {
            continue;
        }
        for (NodeId &n : e) {
            if (numbers[index(n)] == kNoNode) {
                numbers[index(n)] = node(ring.nodes.size());
                ring.nodes.push_back(whole.nodes[index(n)]);
            }
            n = numbers[index(n)];
        }
        ring.elements.push_back(e);
    }
    return ring;
}

bool at(const Diagnostics &faults, Vec2 place) {
    return std::any_of(faults.begin(), faults.end(), [&](const Diagnostic &d) { return d.at && *d.at == place; });
}

} // namespace

TEST_CASE("verify: valid meshes have no faults, at the origin and far from it") {
    for (const Vec2 offset : {Vec2{}, Vec2{1e5, -1e5}, Vec2{-3e5, 1e-3}}) {
        const TriMesh mesh = samples::square(20, 15, 0.24, offset);
        CHECK_MESSAGE(verify(mesh).empty(), samples::list(verify(mesh)));
    }
    CHECK(verify(twoTriangles()).empty());
    CHECK(verify(TriMesh{}).empty());
}

TEST_CASE("verify: accepts holes, several parts, parts in holes and parts that share one node") {
    const TriMesh ring = squareRing();
    TriMesh parts = ring;
    TriMesh island = twoTriangles();
    for (Vec2 &p : island.nodes) {
        p = 0.25 * p;
    }
    append(parts, island, {0.375, 0.375});
    append(parts, ring, {2.0, 0.0});
    CHECK_MESSAGE(verify(parts).empty(), samples::list(verify(parts)));

    TriMesh pinched = twoTriangles();
    pinched.nodes.insert(pinched.nodes.end(), {{2, 1}, {2, 2}, {1, 2}});
    pinched.elements.insert(pinched.elements.end(), {{node(2), node(4), node(5)}, {node(2), node(5), node(6)}});
    CHECK_MESSAGE(verify(pinched).empty(), samples::list(verify(pinched)));
}

TEST_CASE("verify: accepts a slit with separate nodes on its two sides, with a note") {
    TriMesh mesh = twoTriangles();
    mesh.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 1}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(4), node(5), node(3)}};
    CHECK_FALSE(hasErrors(verify(mesh)));
    CHECK(codes(verify(mesh)) == Codes{"open-line"});
}

TEST_CASE("verify: reports indices that do not exist before using them") {
    TriMesh mesh = twoTriangles();
    mesh.elements[1][2] = node(4);
    CHECK(codes(verify(mesh)) == Codes{"bad-index"});
    mesh = twoTriangles();
    mesh.edges = {{node(0), node(9), 1}};
    CHECK(codes(verify(mesh)) == Codes{"bad-index"});
    mesh = twoTriangles();
    mesh.points = {{kNoNode, 1}};
    CHECK(codes(verify(mesh)) == Codes{"bad-index"});
    mesh = twoTriangles();
    mesh.regions = {1};
    CHECK(codes(verify(mesh)) == Codes{"bad-index"});
}

TEST_CASE("verify: coordinates that are not finite are reported") {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        TriMesh mesh = twoTriangles();
        mesh.nodes[3].y = bad;
        const Diagnostics faults = verify(mesh);
        CHECK(codes(faults) == Codes{"non-finite"});
        CHECK(faults[0].ids == std::vector<std::uint32_t>{3});
    }
}

TEST_CASE("verify: a clockwise element among others is inverted") {
    TriMesh mesh = twoTriangles();
    append(mesh, twoTriangles(), {3.0, 0.0});
    std::swap(mesh.elements[2][0], mesh.elements[2][1]);
    std::swap(mesh.elements[3][0], mesh.elements[3][1]);
    const Diagnostics faults = verify(mesh);
    CHECK(codes(faults).count("inverted-element") == 1);
    CHECK(at(faults, {11.0 / 3.0, 1.0 / 3.0}));
}

TEST_CASE("verify: a mesh that is turned the other way is said to be so, and nothing else") {
    TriMesh mesh = squareRing();
    for (Element &element : mesh.elements) {
        std::swap(element[1], element[2]);
    }
    Diagnostics faults = verify(mesh);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].code == "clockwise");
    CHECK(faults[0].severity == Severity::Warning);
    CHECK(faults[0].message == "the mesh is turned the other way: its " + std::to_string(mesh.elements.size()) +
                                   " elements are all clockwise; expected counter-clockwise");
    // Its other faults are found as in any mesh.
    mesh.elements.push_back(mesh.elements.back());
    CHECK(codes(verify(mesh)) == Codes{"clockwise", "non-conforming"});
}

TEST_CASE("verify: messages name nodes and elements by the numbers of the file") {
    TriMesh mesh = twoTriangles();
    mesh.nodes.push_back({0.5, 0.0});
    mesh.elements[0] = {node(0), node(4), node(1)};
    const MeshNumbers numbers{PartNumbers(std::vector<std::int64_t>{10, 20, 30, 40, 50}), PartNumbers(7)};
    const Diagnostics faults = verify(mesh, kMaxListedFaults, numbers);
    REQUIRE(codes(faults).count("zero-area") == 1);
    CHECK(faults[0].message == "element 7 has zero area");
    mesh = twoTriangles();
    mesh.nodes.push_back({5.0, 5.0});
    CHECK(verify(mesh, kMaxListedFaults, numbers)[0].message == "node 50 belongs to no element");
    CHECK(verify(mesh)[0].message == "node 4 belongs to no element");
}

TEST_CASE("verify: an inner node moved over the opposite side inverts elements and nothing else") {
    TriMesh mesh = samples::square(4, 4);
    mesh.nodes[6] = {0.5 + 0.3, 0.25}; // node (1,1), its neighbour (2,1) is at (0.5, 0.25)
    CHECK(codes(verify(mesh)) == Codes{"inverted-element"});
}

TEST_CASE("verify: reports an element with zero area by the exact sign") {
    TriMesh mesh;
    mesh.nodes = {{0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}}; // rounded, but all on the line x = y
    mesh.elements = {{node(0), node(1), node(2)}};
    CHECK(codes(verify(mesh)).count("zero-area") == 1);
    mesh.nodes[1].y = std::nextafter(mesh.nodes[1].y, 0.0); // to the right of 0-2 by the least amount
    CHECK(codes(verify(mesh)) == Codes{"flat-element"});    // only a warning
    CHECK_FALSE(hasErrors(verify(mesh)));
    mesh.nodes[1].y = std::nextafter(std::nextafter(mesh.nodes[1].y, 1.0), 1.0);
    CHECK(codes(verify(mesh)) == Codes{"clockwise", "flat-element"});
}

TEST_CASE("verify: an edge with three elements and two elements on one side of an edge do not conform") {
    TriMesh mesh = twoTriangles();
    mesh.nodes.push_back({2, 1.5});
    mesh.elements.push_back({node(0), node(4), node(2)}); // third element at edge 0-2
    Diagnostics faults = verify(mesh);
    CHECK(codes(faults) == Codes{"non-conforming"});
    CHECK(at(faults, {0.5, 0.5}));

    mesh = twoTriangles();
    mesh.elements = {{node(0), node(1), node(2)}, {node(0), node(1), node(3)}};
    faults = verify(mesh);
    CHECK(codes(faults) == Codes{"non-conforming"});
    CHECK(at(faults, {0.5, 0.0}));
}

TEST_CASE("verify: a node inside an edge of another element is a hanging node") {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
    // The line from node 0 to node 2 is one edge of the element below and two edges of those above.
    mesh.elements = {{node(0), node(1), node(2)}, {node(0), node(4), node(3)}, {node(4), node(2), node(3)}};
    const Diagnostics faults = verify(mesh);
    CHECK(codes(faults) == Codes{"hanging-node"});
    CHECK(at(faults, {1, 1}));
    // A part that touches the middle of another part's side with a corner also has a hanging node.
    TriMesh touching = twoTriangles();
    append(touching, twoTriangles(), {1.0, 0.5});
    CHECK(codes(verify(touching)) == Codes{"hanging-node"});
}

TEST_CASE("verify: parts that cross, cover or contain each other overlap") {
    for (const Vec2 by : {Vec2{0.5, 0.5}, Vec2{0.5, 0.0}, Vec2{0.3, -0.2}, Vec2{0.0, 0.0}}) {
        TriMesh mesh = twoTriangles();
        append(mesh, twoTriangles(), by);
        CHECK(codes(verify(mesh)).count("overlapping") == 1);
    }
    TriMesh crossing = twoTriangles();
    append(crossing, twoTriangles(), {0.5, 0.5});
    CHECK(codes(verify(crossing)) == Codes{"overlapping"});
    TriMesh inner = twoTriangles();
    for (Vec2 &p : inner.nodes) {
        p = 0.5 * p;
    }
    TriMesh mesh = twoTriangles();
    append(mesh, inner, {0.25, 0.25});
    CHECK(codes(verify(mesh)) == Codes{"overlapping"});
}

TEST_CASE("verify: a band that winds onto itself overlaps") {
    // A strip of quadrilaterals around the origin, a bit more than one turn at constant radius.
    TriMesh mesh;
    const std::size_t steps = 36;
    for (std::size_t i = 0; i <= steps + 3; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(steps) + 0.01;
        const double drift = 0.01 * static_cast<double>(i);
        for (const double r : {1.0 + drift, 2.0 + drift}) {
            mesh.nodes.push_back({r * std::cos(angle), r * std::sin(angle)});
        }
    }
    for (std::size_t i = 0; i < steps + 3; ++i) {
        mesh.elements.push_back({node(2 * i), node(2 * i + 1), node(2 * i + 3)});
        mesh.elements.push_back({node(2 * i), node(2 * i + 3), node(2 * i + 2)});
    }
    CHECK(codes(verify(mesh)) == Codes{"overlapping"});
    mesh.elements.resize(2 * (steps - 3)); // less than a turn
    mesh.nodes.resize(2 * (steps - 2));
    CHECK_MESSAGE(verify(mesh).empty(), samples::list(verify(mesh)));
}

TEST_CASE("verify: elements that go twice around an inner node overlap, though all are counter-clockwise") {
    TriMesh mesh;
    mesh.nodes.push_back({0, 0});
    const std::size_t n = 12; // two turns of six
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
        const double r = i < 6 ? 1.0 : 1.3;
        mesh.nodes.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    for (std::size_t i = 0; i < n; ++i) {
        mesh.elements.push_back({node(0), node(1 + i), node(1 + (i + 1) % n)});
    }
    CHECK(codes(verify(mesh)).count("overlapping") == 1);
}

namespace {

/// Returns true if the interiors of two counter-clockwise triangles meet: no side of either has the whole other on its
/// right. Exact for small whole coordinates.
bool interiorsMeet(const std::array<Vec2, 3> &t, const std::array<Vec2, 3> &u) {
    const auto parted = [](const std::array<Vec2, 3> &p, const std::array<Vec2, 3> &q) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 a = p[k], b = p[(k + 1) % 3];
            if (std::all_of(q.begin(), q.end(), [&](Vec2 c) { return cross(b - a, c - a) <= 0.0; })) {
                return true;
            }
        }
        return false;
    };
    return !parted(t, u) && !parted(u, t);
}

bool insideSide(Vec2 p, Vec2 a, Vec2 b) {
    return cross(b - a, p - a) == 0.0 && dot(p - a, p - b) < 0.0;
}

} // namespace

TEST_CASE(
    "verify: triangles strewn on a small lattice overlap or hang exactly when a comparison of all pairs says so") {
    samples::Random random(2024);
    std::size_t overlapping = 0, hanging = 0, clean = 0;
    for (int round = 0; round < 6000; ++round) {
        const double width = random(2.0, 12.0);
        std::vector<std::array<Vec2, 3>> triangles;
        const std::size_t count = 2 + random.below(4);
        while (triangles.size() < count) {
            std::array<Vec2, 3> t;
            const Vec2 corner{std::floor(random(0.0, width)), std::floor(random(0.0, width))};
            for (Vec2 &p : t) {
                p = corner + Vec2{std::floor(random(0.0, 4.0)), std::floor(random(0.0, 4.0))};
            }
            if (cross(t[1] - t[0], t[2] - t[0]) > 0.0) {
                triangles.push_back(t);
            }
        }
        TriMesh mesh;
        bool overlap = false, hang = false;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = 0; j < count; ++j) {
                overlap = overlap || (i < j && interiorsMeet(triangles[i], triangles[j]));
                for (unsigned k = 0; k < 9; ++k) {
                    hang = hang || insideSide(triangles[i][k / 3], triangles[j][k % 3], triangles[j][(k + 1) % 3]);
                }
            }
            mesh.elements.push_back({node(3 * i), node(3 * i + 1), node(3 * i + 2)});
            mesh.nodes.insert(mesh.nodes.end(), triangles[i].begin(), triangles[i].end());
        }
        Codes found = codes(verify(mesh));
        found.erase("open-line"); // a note: sides that coincide without common nodes
        CHECK((found.count("overlapping") == 1) == overlap);
        if (!overlap) {
            CHECK(found == (hang ? Codes{"hanging-node"} : Codes{}));
        }
        (overlap ? overlapping : hang ? hanging : clean) += 1;
    }
    CHECK(overlapping > 500);
    CHECK(hanging > 200);
    CHECK(clean > 500);
}

TEST_CASE("verify: a handle contradicts Euler's formula") {
    // Two square rings, seven cells wide, that cross in cells (6,3) and (3,6). They share the first one, as a torus
    // with a hole laid flat would, and lie upon each other in the second.
    TriMesh mesh;
    std::map<std::array<int, 3>, NodeId> ids;
    const auto at = [&](int x, int y, int ring) {
        const bool shared = (x == 6 || x == 7) && (y == 3 || y == 4);
        const auto [it, fresh] = ids.try_emplace({x, y, shared ? 0 : ring}, node(mesh.nodes.size()));
        if (fresh) {
            mesh.nodes.push_back({static_cast<double>(x), static_cast<double>(y)});
        }
        return it->second;
    };
    for (const int ring : {1, 2}) {
        for (int i = 0; i < 49; ++i) {
            const int x = i % 7 + (ring == 2 ? 3 : 0), y = i / 7 + (ring == 2 ? 3 : 0);
            const bool rim = i % 7 == 0 || i % 7 == 6 || i / 7 == 0 || i / 7 == 6;
            if (rim && !(ring == 2 && x == 6 && y == 3)) {
                const NodeId a = at(x, y, ring), b = at(x + 1, y, ring), c = at(x + 1, y + 1, ring),
                             d = at(x, y + 1, ring);
                mesh.elements.insert(mesh.elements.end(), {{a, b, c}, {a, c, d}});
            }
        }
    }
    CHECK(codes(verify(mesh)) == Codes{"euler", "overlapping"});
}

TEST_CASE("verify: reports nodes without elements and tagged edges that are not edges") {
    TriMesh mesh = twoTriangles();
    mesh.nodes.push_back({5, 5});
    Diagnostics faults = verify(mesh);
    CHECK(codes(faults) == Codes{"unreferenced-node"});
    CHECK(faults[0].severity == Severity::Note);
    CHECK(at(faults, {5, 5}));
    mesh.nodes.push_back({6, 5});
    faults = verify(mesh);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].message == "2 nodes belong to no element, the first is node 4");
    mesh = twoTriangles();
    mesh.edges = {{node(0), node(1), 1}, {node(1), node(3), 7}};
    faults = verify(mesh);
    CHECK(codes(faults) == Codes{"missing-tagged-edge"});
    CHECK(at(faults, {0.5, 0.5}));
}

TEST_CASE("verify: reports an element that refers to a node twice") {
    for (const Element &bad : {Element{node(0), node(1), node(0)}, Element{node(3), node(3), node(2)},
                               Element{node(2), node(0), node(0)}, Element{node(1), node(1), node(1)}}) {
        TriMesh alone = twoTriangles();
        alone.elements = {bad};
        CHECK(codes(verify(alone)) == Codes{"repeated-node"});
        TriMesh among = twoTriangles();
        among.elements.push_back(bad);
        CHECK(codes(verify(among)) == Codes{"repeated-node"});
    }
}

TEST_CASE("verify: a kind of fault that occurs often is listed once with its count") {
    TriMesh mesh = samples::square(30, 30);
    for (std::size_t e = 0; e + 1 < mesh.elements.size(); ++e) {
        std::swap(mesh.elements[e][0], mesh.elements[e][1]);
    }
    mesh.nodes.push_back({5.0, 5.0});
    const Diagnostics faults = verify(mesh);
    const auto inverted =
        std::count_if(faults.begin(), faults.end(), [](const Diagnostic &d) { return d.code == "inverted-element"; });
    CHECK(inverted == 1);
    CHECK(faults.front().message == "element 0 is clockwise (the first of 1799 such faults)");
    CHECK(codes(faults).count("unreferenced-node") == 1);
}

TEST_CASE("verify: lists at most `limit` faults and counts the rest") {
    TriMesh mesh = twoTriangles();
    for (int i = 0; i < 10; ++i) {
        mesh.nodes.push_back({5.0 + i, 5});
        mesh.edges.push_back({node(0), node(4 + i), 1});
    }
    Diagnostics faults = verify(mesh, 4);
    REQUIRE(faults.size() == 6);
    CHECK(faults.back().code == "unreferenced-node"); // a note, which the limit does not count
    faults.pop_back();
    REQUIRE(faults.size() == 5);
    CHECK(faults.back().severity == Severity::Note);
    CHECK(faults.back().message.find('6') != std::string::npos);
}
