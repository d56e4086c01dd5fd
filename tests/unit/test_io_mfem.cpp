#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/mfem/mfem.hpp"
#include "core/files/surfaces/surfaces.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <string>

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

TEST_CASE("MFEM: what cannot be read is refused with its place") {
    const auto refuses = [](const std::string &text, const char *words) {
        const std::string said = mfemRefusal(text);
        CHECK_MESSAGE(said.find(words) != std::string::npos, said);
    };
    const std::string elements = "elements\n1\n1 3 0 1 2 3\n";
    refuses("MFEM NC mesh v1.0\n", "expected MFEM mesh v1.0 or v1.2");
    refuses("MFEM mesh v1.0\ndimension\n3\n", "dimension");
    refuses(kMfemHead + elements + "boundary\n0\nvertices\n4\n\nnodes\n", "curved edges");
    refuses(kMfemHead + elements + "boundary\n0\n" + kMfemEnd + "nodes\n", "curved edges");
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
