#include "core/engine/mesh/mesh_domain.hpp"
#include "core/files/boundary_parts.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_parts.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Two unit squares of two triangles each, side by side, as regions 1 and 2; `lines` are the rows of line elements.
std::string twoSquares(const std::string &names, const std::string &lines, int lineCount) {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names +
           "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n$Elements\n" +
           std::to_string(4 + lineCount) + "\n" + lines +
           "11 2 2 1 1 1 2 5\n12 2 2 1 1 1 5 4\n13 2 2 2 2 2 3 6\n14 2 2 2 2 2 6 5\n$EndElements\n";
}

TriMesh meshOf(const std::string &text) {
    const auto mesh = triangles(readMsh(sourceOf(text)));
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    return *mesh;
}

std::map<std::int32_t, std::size_t> segmentsByTag(const Domain &domain) {
    std::map<std::int32_t, std::size_t> counts;
    for (const DomainSegment &segment : domain.segments) {
        ++counts[segment.tag];
    }
    return counts;
}

const std::string kInlet = "$PhysicalNames\n1\n1 1 \"inlet\"\n$EndPhysicalNames\n";

} // namespace

TEST_CASE("Gmsh domain: outer edges and interfaces without a group take unused tags, not the first group's") {
    const auto domain = domainOfMesh(meshOf(twoSquares(kInlet, "1 1 2 1 1 4 1\n", 1)));
    REQUIRE(domain.ok());
    CHECK(segmentsByTag(domain->domain) == std::map<std::int32_t, std::size_t>{{1, 1}, {2, 5}, {3, 1}});
    CHECK(domain->domain.boundaryNames == std::map<std::int32_t, std::string>{{1, "inlet"}});
    CHECK(boundaryName(domain->domain.boundaryNames, 2) == "boundary_2");
}

TEST_CASE("Gmsh domain: a mesh without tagged edges gets one tag for its outer boundary and another for interfaces") {
    const auto domain = domainOfMesh(meshOf(twoSquares("", "", 0)));
    REQUIRE(domain.ok());
    CHECK(segmentsByTag(domain->domain) == std::map<std::int32_t, std::size_t>{{1, 6}, {2, 1}});
}

TEST_CASE("Gmsh: an entity without a group does not join the group that has its number") {
    // Line 2 lies on entity 1 without a group, line 1 on entity 7 in group 1.
    const TriMesh mesh = meshOf(twoSquares(kInlet, "1 1 2 1 7 4 1\n2 1 2 0 1 1 2\n", 2));
    REQUIRE(mesh.edges.size() == 2);
    CHECK(mesh.edges[0].tag == 1);
    CHECK(mesh.edges[1].tag == 2);
    // Without any groups the entities distinguish the parts.
    const TriMesh plain = meshOf(twoSquares("", "1 1 2 0 7 4 1\n2 1 2 0 3 1 2\n", 2));
    CHECK(plain.edges[0].tag == 7);
    CHECK(plain.edges[1].tag == 3);
}

TEST_CASE("Gmsh: a default name that a group has already is not given to another part") {
    const std::string names = "$PhysicalNames\n1\n1 1 \"boundary_2\"\n$EndPhysicalNames\n";
    const auto domain = domainOfMesh(meshOf(twoSquares(names, "1 1 2 1 1 4 1\n", 1)));
    REQUIRE(domain.ok());
    CHECK(segmentsByTag(domain->domain) == std::map<std::int32_t, std::size_t>{{1, 1}, {3, 5}, {4, 1}});
}

TEST_CASE("Gmsh: a group of points keeps its name apart from the group of lines with the same number") {
    const std::string names = "$PhysicalNames\n2\n0 1 \"gauge\"\n1 1 \"inlet\"\n$EndPhysicalNames\n";
    const TriMesh mesh = meshOf(twoSquares(names, "1 15 2 1 1 5\n2 1 2 1 1 4 1\n", 2));
    REQUIRE(mesh.points.size() == 1);
    REQUIRE(mesh.edges.size() == 1);
    CHECK(boundaryName(mesh.boundaryNames, mesh.edges[0].tag) == "inlet");
    CHECK(mesh.points[0].tag != mesh.edges[0].tag);
    CHECK(boundaryName(mesh.boundaryNames, mesh.points[0].tag) == "gauge");
}

TEST_CASE("Curve groups: the independent scanner finds names and lengths in MSH 2.2 and 4.1") {
    TriMesh mesh = meshOf(twoSquares(kInlet, "1 1 2 1 1 4 1\n2 1 2 5 2 1 2\n3 1 2 5 3 2 3\n", 3));
    for (const bool version4 : {false, true}) {
        CAPTURE(version4);
        const auto groups = mshCurveGroups(written(version4 ? writeMsh4 : writeMsh2, mesh));
        REQUIRE(groups.has_value());
        double inlet = 0.0, other = 0.0;
        for (const auto &[tag, group] : *groups) {
            (group.name == "inlet" ? inlet : other) += group.length;
        }
        CHECK(inlet == 1.0);
        CHECK(other == 2.0);
    }
    CHECK_FALSE(mshCurveGroups(written(writeMsh4Binary, mesh)).has_value());
    CHECK_FALSE(mshCurveGroups("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0").has_value());
}

TEST_CASE("Boundary parts: detects an inlet that is longer in the mesh than in the domain file") {
    const TemporaryFolder folder;
    std::ofstream(folder / "domain.msh") << twoSquares(kInlet, "1 1 2 1 1 4 1\n", 1);
    TriMesh mesh = meshOf(twoSquares(kInlet, "1 1 2 1 1 4 1\n", 1));
    CHECK(checkBoundaryParts(mesh, folder / "domain.msh").empty());
    mesh.edges.push_back({NodeId{0}, NodeId{1}, 1});
    const Diagnostics faults = checkBoundaryParts(mesh, folder / "domain.msh");
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].code == "wrong-part");
    CHECK(faults[0].message == "boundary part 'inlet' (tag 1) is 2 long in the mesh, but 1 in the domain's file");
}

TEST_CASE("Boundary parts: a length that a repair has changed is expected to differ by that much") {
    const TemporaryFolder folder;
    std::ofstream(folder / "domain.msh") << twoSquares(kInlet, "1 1 2 1 1 4 1\n2 1 2 1 1 1 2\n", 2);
    const TriMesh mesh = meshOf(twoSquares(kInlet, "1 1 2 1 1 4 1\n", 1));
    CHECK(checkBoundaryParts(mesh, folder / "domain.msh", {}, {{1, -1.0}}).empty());
    const Diagnostics faults = checkBoundaryParts(mesh, folder / "domain.msh", {}, {{1, -0.5}});
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].message == "boundary part 'inlet' (tag 1) is 1 long in the mesh, but 2 in the domain's file; "
                               "the repair changes it by -0.5");
}
