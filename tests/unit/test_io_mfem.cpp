#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/mfem/mfem.hpp"
#include "core/files/surfaces/surfaces.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A triangle and a quadrilateral with a boundary edge and a point.
Mesh smallMfem() {
    Mesh mesh;
    mesh.nodes = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {3, 1}};
    const NodeId triangle[] = {NodeId{1}, NodeId{4}, NodeId{2}};
    const NodeId square[] = {NodeId{0}, NodeId{1}, NodeId{2}, NodeId{3}};
    mesh.block(CellKind::Triangle3).add(triangle);
    mesh.block(CellKind::Triangle3).regions = {3};
    mesh.block(CellKind::Quadrilateral4).add(square);
    mesh.block(CellKind::Quadrilateral4).regions = {1};
    mesh.edges = {{NodeId{0}, NodeId{1}, 7}};
    mesh.points = {{NodeId{3}, 4}};
    mesh.boundaryNames = {{7, "in let"}};
    return mesh;
}

const std::string kMfemHead = "MFEM mesh v1.0\n\n# comment\ndimension\n2\n\n";
const std::string kMfemEnd = "vertices\n4\n2\n0 0\n1 0\n1 1\n0 1\n";

std::string mfemRefusal(const std::string &text) {
    const Result<Mesh> mesh = readMfem(sourceOf(text));
    REQUIRE_FALSE(mesh.ok());
    CHECK_MESSAGE(allLocated(mesh.faults()), messages(mesh.faults()));
    return messages(mesh.faults());
}

} // namespace

TEST_CASE("MFEM: the text of a small mesh") {
    CHECK(written(writeMfem, smallMfem()) ==
          "MFEM mesh v1.0\n\n# boundary 4 \"boundary_4\"\n# boundary 7 \"in let\"\n# region 1 \"region_1\"\n"
          "# region 3 \"region_3\"\n# point 3 4\n\ndimension\n2\n\nelements\n2\n3 2 1 4 2\n1 3 0 1 2 3\n\n"
          "boundary\n1\n7 1 0 1\n\nvertices\n5\n2\n0 0\n2 0\n2 2\n0 2\n3 1\n");
}

TEST_CASE("MFEM: meshes of other programs; a third coordinate, the end of v1.2, attributes below 1") {
    const Result<Mesh> mesh =
        readMfem(sourceOf("MFEM mesh v1.2\ndimension\n2\nelements\n1\n0 3 0 1 2 3\nboundary\n1\n"
                          "5 1 0 1\nvertices\n4\n3\n0 0 1\n1 0 1\n1 1 1\n0 1 1\nmfem_mesh_end\n"));
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    CHECK(mesh->blocks.at(0).regions == std::vector<std::int32_t>{1});
    CHECK(mesh->edges.at(0).tag == 5);
}

namespace {

/// A triangle of 6 nodes beside a quadrilateral of `nodes` nodes, with a point and a tagged edge. The nodes in the
/// middles come before some corners. The common edge is curved.
Mesh curvedMfem(std::size_t nodes) {
    Mesh mesh;
    mesh.nodes = {{1, -0.25}, {0, 0}, {2, 0}, {2.25, 1},  {2, 2},    {0, 2},
                  {1, 2},     {0, 1}, {3, 1}, {2.5, 0.5}, {2.5, 1.5}};
    std::vector<NodeId> square;
    for (const std::uint32_t n : {1, 2, 4, 5, 0, 3, 6, 7}) {
        square.push_back(NodeId{n});
    }
    if (nodes == 9) {
        square.push_back(NodeId{11});
        mesh.nodes.push_back({1.25, 1.125});
    }
    const NodeId triangle[] = {NodeId{2}, NodeId{8}, NodeId{4}, NodeId{9}, NodeId{10}, NodeId{3}};
    const CellKind kind = nodes == 9 ? CellKind::Quadrilateral9 : CellKind::Quadrilateral8;
    mesh.block(kind).add(square);
    mesh.block(kind).regions = {1};
    mesh.block(CellKind::Triangle6).add(triangle);
    mesh.block(CellKind::Triangle6).regions = {2};
    mesh.edges = {{NodeId{1}, NodeId{2}, 7, NodeId{0}}};
    mesh.points = {{NodeId{8}, 4}};
    return mesh;
}

/// The places of the nodes of each element, and of the tagged edge.
std::vector<std::vector<Vec2>> placesOfCells(const Mesh &mesh) {
    std::vector<std::vector<Vec2>> cells;
    const MeshView view(mesh);
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        cells.emplace_back();
        for (const NodeId node : view.nodesOf(e)) {
            cells.back().push_back(mesh.nodes[index(node)]);
        }
    }
    for (const TaggedEdge &edge : mesh.edges) {
        cells.push_back({mesh.nodes[index(edge.a)], mesh.nodes[index(edge.b)], mesh.nodes[index(edge.middle)]});
    }
    return cells;
}

} // namespace

TEST_CASE("MFEM: second order is a grid function in the order of vertices, edges and quadrilaterals") {
    const std::string text = written(writeMfem, curvedMfem(9));
    CHECK(text.ends_with("elements\n2\n1 3 0 1 2 3\n2 2 1 4 2\n\nboundary\n1\n7 1 0 1\n\nvertices\n5\n\n"
                         "nodes\nFiniteElementSpace\nFiniteElementCollection: H1_2D_P2\nVDim: 2\nOrdering: 1\n\n"
                         "0 0\n2 0\n2 2\n0 2\n3 1\n" // vertices
                         "1 -0.25\n2.25 1\n1 2\n0 1\n2.5 0.5\n2.5 1.5\n1.25 1.125\n"));
    CHECK(text.find("# point 4 4\n") != std::string::npos);
    // The centre of a quadrilateral of 8 nodes: half the sum of its middles less a quarter of that of its corners.
    CHECK(written(writeMfem, curvedMfem(8)).ends_with("2.5 1.5\n1.125 0.875\n"));
}

TEST_CASE("MFEM: curved meshes come back as they were") {
    for (const std::size_t nodes : {8U, 9U}) {
        const Mesh mesh = curvedMfem(nodes);
        const Result<Mesh> back = readMfem(sourceOf(written(writeMfem, mesh)));
        REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
        CHECK(placesOfCells(*back) == placesOfCells(mesh));
        CHECK(back->nodes.size() == mesh.nodes.size());
        REQUIRE(back->points.size() == 1);
        CHECK(back->nodes[index(back->points[0].node)] == Vec2{3, 1});
    }
}

TEST_CASE("MFEM: quadrilaterals of 8 nodes beside some of 9 get their centre, too") {
    Mesh mesh = curvedMfem(9);
    const NodeId square[] = {NodeId{5}, NodeId{4},  NodeId{13}, NodeId{12},
                             NodeId{6}, NodeId{14}, NodeId{15}, NodeId{16}};
    mesh.nodes.insert(mesh.nodes.end(), {{0, 4}, {2, 4}, {2, 3}, {1, 4}, {0, 3}});
    mesh.block(CellKind::Quadrilateral8).add(square);
    mesh.block(CellKind::Quadrilateral8).regions = {1};
    const Result<Mesh> back = readMfem(sourceOf(written(writeMfem, mesh)));
    REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
    REQUIRE(back->blocks.front().kind() == CellKind::Quadrilateral9);
    CHECK(back->blocks.front().size() == 2);
    CHECK(placesOfCells(*back)[0] == placesOfCells(mesh)[0]);
    CHECK(back->nodes.size() == mesh.nodes.size() + 1);
}

TEST_CASE("MFEM: in a mesh with both orders, elements of first order get straight edges and their centre") {
    Mesh mesh = curvedMfem(8);
    const NodeId square[] = {NodeId{5}, NodeId{4}, NodeId{12}, NodeId{11}};
    mesh.nodes.insert(mesh.nodes.end(), {{0, 4}, {2, 4}});
    mesh.block(CellKind::Quadrilateral4).add(square);
    mesh.block(CellKind::Quadrilateral4).regions = {1};
    const Result<Mesh> back = readMfem(sourceOf(written(writeMfem, mesh)));
    REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
    CHECK(back->elementCount() == 3);
    CHECK(placesOfCells(*back)[1] == std::vector<Vec2>{{0, 2}, {2, 2}, {2, 4}, {0, 4}, {1, 2}, {2, 3}, {1, 4}, {0, 3}});
}

TEST_CASE("MFEM: grid functions with the coordinates one after the other, of order 1, and in three dimensions") {
    const std::string head = "MFEM mesh v1.0\ndimension\n2\nelements\n1\n1 2 0 1 2\nboundary\n1\n5 1 0 1\nvertices\n3\n"
                             "nodes\nFiniteElementSpace\nFiniteElementCollection: ";
    const Result<Mesh> curved =
        readMfem(sourceOf(head + "Quadratic\nVDim: 3\nOrdering: 0\n\n0 4 0 2 2 0\n0 0 4 -.5 2 2\n7 7 7 7 7 7\n"));
    REQUIRE_MESSAGE(curved.ok(), messages(curved.faults()));
    CHECK(placesOfCells(*curved)[0] == std::vector<Vec2>{{0, 0}, {4, 0}, {0, 4}, {2, -0.5}, {2, 2}, {0, 2}});
    CHECK(curved->nodes[index(curved->edges.at(0).middle)] == Vec2{2, -0.5});
    const Result<Mesh> straight =
        readMfem(sourceOf(head + "H1_2D_P1\nVDim: 2\nOrdering: 1\n\n0 0\n4 0\n0 4\nmfem_mesh_end\n"));
    REQUIRE_MESSAGE(straight.ok(), messages(straight.faults()));
    CHECK(straight->isTriangular());
    const Result<Mesh> spatial =
        readMfem(sourceOf(head + "Quadratic\nVDim: 3\nOrdering: 0\n\n0 4 0 2 2 0\n0 0 4 -.5 2 2\n7 7 8 7 7 7\n"));
    REQUIRE_FALSE(spatial.ok());
    CHECK(messages(spatial.faults()).find("do not lie in one plane") != std::string::npos);
}

TEST_CASE("MFEM: what cannot be read is refused with its place") {
    const auto refuses = [](const std::string &text, const char *words) {
        const std::string said = mfemRefusal(text);
        CHECK_MESSAGE(said.find(words) != std::string::npos, said);
    };
    const std::string elements = "elements\n1\n1 3 0 1 2 3\n";
    refuses("MFEM NC mesh v1.0\n", "expected MFEM mesh v1.0 or v1.2");
    refuses("MFEM mesh v1.0\ndimension\n3\n", "dimension");
    const std::string curved = kMfemHead + elements + "boundary\n0\nvertices\n4\n\nnodes\nFiniteElementSpace\n";
    refuses(curved, "FiniteElementCollection:");
    refuses(curved + "FiniteElementCollection: L2_T1_2D_P2\n", "nodes of 'L2_T1_2D_P2' cannot be read");
    const std::string order2 = curved + "FiniteElementCollection: H1_2D_P2\nVDim: 2\nOrdering: 1\n\n";
    refuses(order2 + "0 0 1 0 1 1\n", "has 3 places; the elements need 4");
    refuses(order2 + "0 0 1 0 1 1 0 1\n", "has 4 places; the elements need 9");
    refuses(order2 + "0 0 1 0 1 1 0 x\n", "the coordinates of nodes");
    refuses(curved + "FiniteElementCollection: Linear\nVDim: 2\nOrdering: 1\n\n0 0 1 0 1 1 0 1 2 2\n",
            "has 5 places; the elements need 4");
    refuses(kMfemHead + "elements\n1\n1 5 0 1 2 3\nboundary\n0\n" + kMfemEnd, "is of geometry 5");
    refuses(kMfemHead + elements + "boundary\n1\n1 2 0 1 2\n" + kMfemEnd, "is of geometry 2");
    refuses(kMfemHead + "elements\n1\n1 3 0 1 2 9\nboundary\n0\n" + kMfemEnd, "node 9, which does not exist");
    refuses(kMfemHead + "elements\n3000000\n1 3 0 1 2 3\n", "bytes follow");
    refuses(kMfemHead + elements + "boundary\n3\n1 1 0 1                    \n", "has 1 lines instead of 3");
    refuses(kMfemHead + elements + "boundary\n5\n1 1 0 1\n" + kMfemEnd, "expected vertices");
    CHECK(looksLikeMfem("MFEM mesh v1.0"));
    CHECK_FALSE(looksLikeMfem("MeshVersionFormatted 2"));
}

TEST_CASE("PLY, STL and OFF: the text of small meshes") {
    CHECK(written(writePly, smallMfem()) ==
          "ply\nformat ascii 1.0\ncomment Plane mesh\nelement vertex 5\nproperty double x\nproperty double y\n"
          "property double z\nelement face 2\nproperty list uchar int vertex_indices\nproperty int region\nend_header\n"
          "0 0 0\n2 0 0\n2 2 0\n0 2 0\n3 1 0\n3 1 4 2 3\n4 0 1 2 3 1\n");
    CHECK(written(writeOff, smallMfem()) == "OFF\n5 2 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n3 1 0\n3 1 4 2\n4 0 1 2 3\n");
    TriMesh mesh = samples::square(1, 1);
    mesh.elements.resize(1);
    mesh.regions = {2};
    mesh.regionNames = {{2, "sea bed"}};
    const std::string text = written(writeStl, mesh);
    CHECK(text.starts_with("solid sea_bed\nfacet normal 0 0 1\nouter loop\nvertex "));
    CHECK(text.ends_with(" 0\nendloop\nendfacet\nendsolid sea_bed\n"));
    CHECK(messages(noteStlChanges(mesh)).find("region 'sea bed' is sea_bed") != std::string::npos);
}
