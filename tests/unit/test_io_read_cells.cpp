#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/common/names.hpp"
#include "core/files/files.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_parts.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/netgen/netgen.hpp"
#include "core/files/obj/obj.hpp"
#include "core/files/su2/su2.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/vtk/vtk.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// The parts of a mesh that a file must keep, independently of the order of elements, edges and points.
auto keptCells(const Mesh &mesh) {
    const MeshView view(mesh);
    std::multiset<std::tuple<CellKind, std::vector<NodeId>, std::int32_t>> elements;
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        const auto nodes = view.nodesOf(e);
        elements.emplace(view.kindOf(e), std::vector<NodeId>(nodes.begin(), nodes.end()), view.region(e));
    }
    std::multiset<std::tuple<NodeId, NodeId, NodeId, std::int32_t>> edges;
    for (const TaggedEdge &edge : mesh.edges) {
        edges.emplace(std::min(edge.a, edge.b), std::max(edge.a, edge.b), edge.middle, edge.tag);
    }
    std::set<std::pair<NodeId, std::int32_t>> points;
    for (const TaggedNode &point : mesh.points) {
        points.emplace(point.node, point.tag);
    }
    const TagList tags = tagsOf(mesh);
    return std::tuple(mesh.nodes, elements, edges, points, tags.edges, tags.points, tags.regions);
}

/// As keptCells(), with places for nodes.
auto placedCells(const Mesh &mesh) {
    const auto place = [&mesh](NodeId node) {
        return node == kNoNode ? std::pair(0.0, 0.0) : std::pair(mesh.nodes[index(node)].x, mesh.nodes[index(node)].y);
    };
    const MeshView view(mesh);
    std::multiset<std::tuple<CellKind, std::vector<std::pair<double, double>>, std::int32_t>> elements;
    for (std::size_t e = 0; e < view.elementCount(); ++e) {
        std::vector<std::pair<double, double>> places;
        std::ranges::transform(view.nodesOf(e), std::back_inserter(places), place);
        elements.emplace(view.kindOf(e), places, view.region(e));
    }
    std::multiset<std::tuple<std::pair<double, double>, std::pair<double, double>, std::int32_t>> edges, points;
    for (const TaggedEdge &edge : mesh.edges) {
        edges.emplace(std::min(place(edge.a), place(edge.b)), place(edge.middle), edge.tag);
    }
    for (const TaggedNode &point : mesh.points) {
        points.emplace(place(point.node), std::pair(0.0, 0.0), point.tag);
    }
    return std::tuple(mesh.nodes.size(), elements, edges, points);
}

/// Returns true if some elements are of first order and others of second, or quadrilaterals have 8 and 9 nodes.
bool mixesOrders(const Mesh &mesh) {
    std::set<CellKind> kinds;
    std::size_t first = 0;
    for (const CellBlock &block : mesh.blocks) {
        kinds.insert(block.kind());
        first += block.traits().order == 1 ? 1 : 0;
    }
    return (first > 0 && first < mesh.blocks.size()) ||
           (kinds.contains(CellKind::Quadrilateral8) && kinds.contains(CellKind::Quadrilateral9));
}

/// The nodes 0 0, 2 0, 2 2, 0 2, those in the middles of the edges, then that in the centre.
const std::vector<Vec2> kPlaces = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};

std::string placeLines(const char *after, std::size_t firstNumber = 0) {
    std::string text;
    for (std::size_t n = 0; n < kPlaces.size(); ++n) {
        text += (firstNumber > 0 ? std::to_string(n + firstNumber) + ' ' : "") + std::to_string(int(kPlaces[n].x)) +
                ' ' + std::to_string(int(kPlaces[n].y)) + after + '\n';
    }
    return text;
}

std::vector<NodeId> ids(std::initializer_list<std::uint32_t> numbers) {
    std::vector<NodeId> nodes;
    for (const std::uint32_t n : numbers) {
        nodes.push_back(NodeId{n});
    }
    return nodes;
}

/// The nodes of the only element, which is of this kind.
std::vector<NodeId> onlyElement(const Result<Mesh> &mesh, CellKind kind) {
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    REQUIRE(mesh->blocks.size() == 1);
    REQUIRE(mesh->blocks.front().kind() == kind);
    REQUIRE(mesh->blocks.front().size() == 1);
    const auto nodes = mesh->blocks.front().nodesOf(0);
    return {nodes.begin(), nodes.end()};
}

/// Checks that a reader refuses a text because of its elements, and says this.
void checkRefusedCell(Result<Mesh> (*read)(const SourceText &), const std::string &text, const char *words) {
    const Result<Mesh> mesh = read(sourceOf(text));
    REQUIRE_FALSE(mesh.ok());
    CAPTURE(messages(mesh.faults()));
    CHECK(hasCode(mesh.faults(), "unknown-element"));
    CHECK(messages(mesh.faults()).find(words) != std::string::npos);
    CHECK(allLocated(mesh.faults()));
}

/// Returns a mesh with its nodes at multiples of 1e-12.
Mesh roughly(Mesh mesh) {
    for (Vec2 &node : mesh.nodes) {
        node = {std::round(node.x * 1e12) / 1e12, std::round(node.y * 1e12) / 1e12};
    }
    return mesh;
}

std::string msh2Of(const std::string &elements, std::size_t count) {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n" + placeLines(" 0", 1) + "$EndNodes\n$Elements\n" +
           std::to_string(count) + '\n' + elements + "$EndElements\n";
}

std::string vtkOf(const std::string &cells, std::size_t numbers, const std::string &types, std::size_t count) {
    return "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 9 double\n" + placeLines(" 0") +
           "CELLS " + std::to_string(count) + ' ' + std::to_string(numbers) + '\n' + cells + "CELL_TYPES " +
           std::to_string(count) + '\n' + types;
}

const std::string kAbaqusNodes = [] {
    std::string text = "*NODE\n";
    for (std::size_t n = 0; n < kPlaces.size(); ++n) {
        text += std::to_string(n + 1) + ", " + std::to_string(int(kPlaces[n].x)) + ", " +
                std::to_string(int(kPlaces[n].y)) + '\n';
    }
    return text;
}();

} // namespace

TEST_CASE("Read cells: each format reads back each kind that it writes, with middle nodes, tags and names") {
    const TemporaryFolder folder;
    std::vector<Mesh> meshes = {samples::mixedSample(), samples::secondOrderSample(), samples::allKindsSample()};
    for (const CellKind kind : kElementKinds) {
        meshes.push_back(samples::sampleMesh(kind));
        meshes.push_back(samples::bent(samples::sampleMesh(kind), 0.1));
    }
    std::size_t written = 0;
    for (const FileFormat &format : allFormats().list()) {
        const bool keepsKinds = format.hasOpenBoundaries; // of boundaries alone, without tags
        if (!format.writesMesh || !format.readsMesh || keepsKinds) {
            continue;
        }
        CAPTURE(format.id);
        for (const Mesh &mesh : meshes) {
            CAPTURE(mesh.blocks.front().traits().name);
            if (!checkElements(format, mesh).empty()) {
                continue;
            }
            const auto path = folder / (std::string("mesh") + format.extension);
            REQUIRE(writeMesh(path, mesh, format.id).empty());
            ImportNotes notes;
            const Result<Mesh> back = allFormats().readMesh(path, {}, &notes);
            REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
            const bool rounded = hasCode(exportNotes(path, mesh, format.id), "rounded-coordinates"); // Abaqus
            const bool ordersNodes = std::string_view(format.id) == "mfem"; // all elements of one order, nodes by kind
            if (!ordersNodes) {
                CHECK((rounded ? keptCells(roughly(*back)) == keptCells(roughly(mesh))
                               : keptCells(*back) == keptCells(mesh)));
            } else if (!mixesOrders(mesh)) {
                CHECK(placedCells(*back) == placedCells(mesh));
            }
            CHECK_MESSAGE(notes.empty(), messages(notes.diagnostics()));
            CHECK_MESSAGE(verify(*back).empty(), messages(verify(*back)));
            ++written;
        }
    }
    CHECK(written > 60);
}

TEST_CASE("Read cells: MSH 2.2 keeps each kind and refuses others by name") {
    const std::vector<NodeId> all = ids({0, 1, 2, 3, 4, 5, 6, 7, 8});
    for (const CellKind kind : kElementKinds) {
        const CellTraits &traits = traitsOf(kind);
        std::string row = "7 " + std::to_string(traits.gmsh) + " 2 3 3";
        for (std::size_t n = 1; n <= traits.nodes; ++n) {
            row += ' ' + std::to_string(n);
        }
        const auto mesh = readMsh(sourceOf(msh2Of(row + "\n8 8 2 5 5 1 2 5\n", 2)));
        CHECK(onlyElement(mesh, kind) == std::vector<NodeId>(all.begin(), all.begin() + traits.nodes));
        REQUIRE(mesh->edges.size() == 1);
        CHECK(mesh->edges[0].middle == NodeId{4});
        CHECK(mesh->edges[0].tag == 5);
    }
    checkRefusedCell(readMsh, msh2Of("1 4 2 1 1 1 2 3 4\n", 1), "element 1 is of MSH type 4 (a tetrahedron)");
    checkRefusedCell(readMsh, msh2Of("1 21 2 1 1 1 2 3 4 5 6 7 8 9 1\n", 1), "(a triangle of 10 nodes)");
    checkRefusedCell(readMsh, msh2Of("1 77 2 1 1 1 2 3 4\n", 1), "is of MSH type 77; only points, lines");
    const auto twice = readMsh(sourceOf(msh2Of("1 9 2 1 1 1 2 3 4 5 4\n", 1)));
    CHECK(hasCode(twice.faults(), "degenerate-element"));
}

TEST_CASE("Read cells: elements are grouped by kind, and numbers and values follow") {
    const std::string text = msh2Of("10 2 2 4 4 1 2 9\n20 3 2 5 5 1 9 7 4\n30 2 2 6 6 2 3 9\n", 3) +
                             "$ElementData\n1\n\"flux\"\n1\n0\n3\n0\n1\n3\n30 3\n20 2\n10 1\n$EndElementData\n";
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto read = readMshFields(source);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    const MeshView view(read->mesh);
    REQUIRE(view.blocks().size() == 2);
    CHECK(view.kindOf(0) == CellKind::Triangle3);
    CHECK(view.kindOf(2) == CellKind::Quadrilateral4);
    CHECK(read->elementFields.at("flux") == std::vector<double>{1, 3, 2});
    CHECK(std::vector{view.region(0), view.region(1), view.region(2)} == std::vector<std::int32_t>{4, 6, 5});
    CHECK(notes.numbers().elements.of(0) == 10);
    CHECK(notes.numbers().elements.of(1) == 30);
    CHECK(notes.numbers().elements.of(2) == 20);

    const std::string vtk = vtkOf("2 0 1\n3 0 1 8\n4 0 8 6 3\n3 1 2 8\n", 16, "3\n5\n9\n5\n", 4) +
                            "CELL_DATA 4\nSCALARS flux double 1\nLOOKUP_TABLE default\n0\n1\n2\n3\n"
                            "SCALARS region int 1\nLOOKUP_TABLE default\n0\n4\n5\n6\n";
    SourceText legacy = sourceOf(vtk);
    ImportNotes more;
    legacy.notes = &more;
    const auto cells = readVtkFields(legacy);
    REQUIRE_MESSAGE(cells.ok(), messages(cells.faults()));
    CHECK(cells->elementFields.at("flux") == std::vector<double>{1, 3, 2});
    CHECK(cells->mesh.blocks[0].regions == std::vector<std::int32_t>{4, 6});
    CHECK(cells->mesh.blocks[1].regions == std::vector<std::int32_t>{5});
    CHECK(more.numbers().elements.of(1) == 3);
    CHECK(more.numbers().elements.of(2) == 2);
}

TEST_CASE("Read cells: MSH 2.2 lists a quadrilateral once for each of its groups; the first is kept") {
    const auto mesh = readMsh(sourceOf(msh2Of("1 3 2 4 1 1 2 3 4\n2 2 2 4 1 2 3 6\n3 3 2 5 1 1 2 3 4\n", 3)));
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    CHECK(mesh->elementCount() == 2);
    CHECK(mesh->blocks.front().regions == std::vector<std::int32_t>{4});
}

TEST_CASE("Read cells: VTK refuses polygons and volume cells by name, and a wrong number of nodes") {
    checkRefusedCell(readVtk, vtkOf("5 0 1 5 6 3\n", 6, "7\n", 1), "cell 0 is of VTK type 7 (a polygon)");
    checkRefusedCell(readVtk, vtkOf("4 0 1 2 3\n", 5, "10\n", 1), "(a tetrahedron)");
    checkRefusedCell(readVtk, vtkOf("7 0 1 2 4 5 8 6\n", 8, "34\n", 1), "(a triangle of 7 nodes)");
    CHECK(hasCode(readVtk(sourceOf(vtkOf("5 0 1 2 3 4\n", 6, "9\n", 1))).faults(), "bad-count"));
    CHECK(onlyElement(readVtk(sourceOf(vtkOf("9 0 1 2 3 4 5 6 7 8\n", 10, "28\n", 1))), CellKind::Quadrilateral9) ==
          ids({0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST_CASE("Read cells: MEDIT sections of second order; others are refused by name") {
    const std::string head = "MeshVersionFormatted 2\nDimension 2\nVertices 9\n" + placeLines(" 0");
    const auto mesh = readMedit(sourceOf(
        head + "EdgesP2 1\n1 2 5 3\nTrianglesP2 1\n1 2 3 5 6 9 4\nQuadrilaterals 1\n1 9 7 4 2\nTriangles 1\n2 3 "
               "9 4\nEnd\n"));
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    REQUIRE(mesh->blocks.size() == 3);
    const auto nodes = mesh->blocks[0].nodesOf(0);
    CHECK(std::vector<NodeId>(nodes.begin(), nodes.end()) == ids({0, 1, 2, 4, 5, 8}));
    CHECK(mesh->blocks[1].regions == std::vector<std::int32_t>{2});
    CHECK(mesh->edges.at(0).middle == NodeId{4});
    CHECK(mesh->edges.at(0).tag == 3);
    CHECK(onlyElement(readMedit(sourceOf(head + "QuadrilateralsQ2 1\n1 2 3 4 5 6 7 8 9 1\nEnd\n")),
                      CellKind::Quadrilateral9) == ids({0, 1, 2, 3, 4, 5, 6, 7, 8}));
    for (const char *section : {"TrianglesP3", "EdgesP3", "QuadrilateralsQ3", "Tetrahedra", "Hexahedra"}) {
        checkRefusedCell(readMedit, head + section + " 1\n1 2 3 4 5\nEnd\n", section);
    }
}

TEST_CASE("Read cells: Abaqus types by family and number of nodes; sides have the middle nodes of their elements") {
    const auto typed = [](const std::string &type, const std::string &nodes) {
        return readAbaqus(sourceOf(kAbaqusNodes + "*ELEMENT, TYPE=" + type + "\n1, " + nodes + '\n'));
    };
    for (const char *type : {"CPS4", "CPE4R", "CAX4", "S4R", "M3D4", "DC2D4", "cps4i"}) {
        CHECK(onlyElement(typed(type, "1, 2, 3, 4"), CellKind::Quadrilateral4) == ids({0, 1, 2, 3}));
    }
    for (const char *type : {"CPS6", "CPE6M", "STRI65", "S6"}) {
        CHECK(onlyElement(typed(type, "1, 2, 3, 5, 6, 9"), CellKind::Triangle6) == ids({0, 1, 2, 4, 5, 8}));
    }
    for (const char *type : {"CPS8", "CPE8R", "S8R5", "DC2D8"}) {
        CHECK(onlyElement(typed(type, "1, 2, 3, 4, 5, 6, 7, 8"), CellKind::Quadrilateral8) ==
              ids({0, 1, 2, 3, 4, 5, 6, 7}));
    }
    CHECK(onlyElement(typed("M3D9", "1, 2, 3, 4, 5, 6, 7, 8, 9"), CellKind::Quadrilateral9).size() == 9);
    for (const char *type : {"C3D4", "C3D8R", "CPE5", "CPS10", "SC8R", "COH2D4", ""}) {
        CAPTURE(type);
        CHECK(hasCode(typed(type, "1, 2, 3, 4").faults(), "unknown-element"));
    }
    CHECK(messages(typed("C3D4", "1, 2, 3, 4").faults()).find("'C3D4'") != std::string::npos);

    const std::string text = kAbaqusNodes + "*ELEMENT, TYPE=CPS8, ELSET=a\n5, 1, 2, 3, 4, 5, 6, 7, 8\n"
                                            "*ELEMENT, TYPE=B32, ELSET=bar\n9, 2, 6, 3\n*SURFACE, NAME=top\n5, S3\n";
    const auto mesh = readAbaqus(sourceOf(text));
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    REQUIRE(mesh->edges.size() == 2);
    CHECK(mesh->edges[0].b == NodeId{2}); // its nodes are end, middle, end
    CHECK(mesh->edges[0].middle == NodeId{5});
    CHECK(mesh->edges[1].a == NodeId{2});
    CHECK(mesh->edges[1].middle == NodeId{6});
    CHECK(verify(*mesh).size() <= 1); // the node in the centre has no element
    const std::string triangle = kAbaqusNodes + "*ELEMENT, TYPE=CPS3\n5, 1, 2, 3\n*SURFACE, NAME=top\n5, S4\n";
    const auto wrong = readAbaqus(sourceOf(triangle));
    CHECK(hasCode(wrong.faults(), "bad-side"));
    CHECK(allLocated(wrong.faults()));
}

TEST_CASE("Read cells: Abaqus numbers elements of several kinds in turn") {
    const std::string text = kAbaqusNodes + "*ELEMENT, TYPE=CPS4, ELSET=a\n2, 1, 9, 7, 4\n"
                                            "*ELEMENT, TYPE=CPS3, ELSET=b\n3, 2, 3, 9\n1, 1, 2, 9\n";
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto mesh = readAbaqus(source);
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    REQUIRE(mesh->blocks.size() == 2); // element 1, a triangle, comes first
    CHECK(mesh->blocks[0].kind() == CellKind::Triangle3);
    CHECK(notes.numbers().elements.of(0) == 1);
    CHECK(notes.numbers().elements.of(1) == 3);
    CHECK(notes.numbers().elements.of(2) == 2);
    CHECK(mesh->regionNames.at(mesh->blocks[1].regions[0]) == "a");
}

TEST_CASE("Read cells: Netgen lists the middle nodes in its own order, and none of edges") {
    const auto of = [](const std::string &element) {
        return readNetgen(sourceOf("mesh3d\ndimension\n2\nsurfaceelements\n1\n2 1 0 0 " + element +
                                   "\nedgesegmentsgi2\n1\n4 0 1 2 -1 -1 1 0 1 0 1 0.5\npoints\n9\n" + placeLines(" 0") +
                                   "endmesh\n"));
    };
    CHECK(onlyElement(of("4 1 2 3 4"), CellKind::Quadrilateral4) == ids({0, 1, 2, 3}));
    const auto triangle = of("6 1 2 3 6 9 5"); // opposite to the corners 1, 2 and 3
    CHECK(onlyElement(triangle, CellKind::Triangle6) == ids({0, 1, 2, 4, 5, 8}));
    CHECK(triangle->edges.at(0).middle == NodeId{4});
    const auto quadrilateral = of("8 1 2 3 4 5 7 8 6");
    CHECK(onlyElement(quadrilateral, CellKind::Quadrilateral8) == ids({0, 1, 2, 3, 4, 5, 6, 7}));
    CHECK(quadrilateral->edges.at(0).middle == NodeId{4});
    CHECK(quadrilateral->edges.at(0).tag == 4);
    CHECK(of("3 1 2 3")->edges.at(0).middle == kNoNode);
    const auto pentagon = of("5 1 2 3 7 8");
    CHECK(hasCode(pentagon.faults(), "unknown-element"));
    CHECK(messages(pentagon.faults()).find("has 5 nodes; expected 3, 4, 6, 8 or 9") != std::string::npos);
}

TEST_CASE("Read cells: Triangle puts the middles opposite to the corners; edges get those of their triangles") {
    const std::string nodes = "9 2 0 0\n" + placeLines("", 1), edges = "2 1\n1 1 2 5\n2 3 1 6\n";
    const auto of = [&](const std::string &elements) {
        const SourceText ofNodes = sourceOf(nodes), ofElements = sourceOf(elements), ofEdges = sourceOf(edges);
        return readTriangleParts(ofNodes, ofElements, &ofEdges);
    };
    const auto mesh = of("1 6 0\n1 1 2 3 6 9 5\n");
    CHECK(onlyElement(mesh, CellKind::Triangle6) == ids({0, 1, 2, 4, 5, 8}));
    REQUIRE(mesh->edges.size() == 2);
    CHECK(mesh->edges[0].middle == NodeId{4});
    CHECK(mesh->edges[1].middle == NodeId{8});
    const auto four = of("1 4 0\n1 1 2 3 4\n");
    CHECK(hasCode(four.faults(), "unknown-element"));
    CHECK(messages(four.faults()).find("the triangles have 4 nodes; expected 3 or 6") != std::string::npos);
}

TEST_CASE("Read cells: OBJ faces of 3 and 4 nodes, SU2 elements of first order") {
    const std::string vertices = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 3 0\n";
    const auto faces = readObj(sourceOf(vertices + "f 4/1 3/1 5/2\nf -5 -4//1 -3 -2\n"));
    REQUIRE_MESSAGE(faces.ok(), messages(faces.faults()));
    REQUIRE(faces->blocks.size() == 2);
    const auto face = faces->blocks[1].nodesOf(0);
    CHECK(std::vector<NodeId>(face.begin(), face.end()) == ids({0, 1, 2, 3}));
    checkRefusedCell(readObj, vertices + "f 1 2 3 5 4\n", "only faces with 3 or 4 nodes");
    CHECK(hasCode(readObj(sourceOf(vertices + "f 1 2 3 1\n")).faults(), "degenerate-element"));

    const auto su2Of = [](const std::string &elements, int count, const std::string &marker) {
        return "NDIME= 2\nNELEM= " + std::to_string(count) + '\n' + elements + "NPOIN= 9\n" + placeLines("") +
               "NMARK= 1\nMARKER_TAG= a\nMARKER_ELEMS= 1\n" + marker;
    };
    ImportNotes notes;
    const std::string text = su2Of("9 0 8 6 3 0\n5 0 1 8 1\n9 8 1 2 6 2\n", 3, "3 0 1\n");
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto mesh = readSu2(source);
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    CHECK(mesh->blocks.at(0).kind() == CellKind::Quadrilateral4);
    CHECK(mesh->blocks.at(0).size() == 2);
    CHECK(notes.numbers().elements.of(1) == 2);
    CHECK(notes.numbers().elements.of(2) == 1);
    checkRefusedCell(readSu2, su2Of("22 0 1 2 4 5 8 0\n", 1, "3 0 1\n"), "an element of type 22");
    checkRefusedCell(readSu2, su2Of("9 0 1 2 3 0\n", 1, "9 0 1 2 3\n"), "an element of type 9");
}

TEST_CASE("Read cells: the groups of curves of a file with lines of 3 nodes, as check --domain reads them") {
    const std::string names = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 5 \"wall\"\n"
                              "$EndPhysicalNames\n";
    const std::string rest = msh2Of("1 8 2 5 5 1 2 5\n2 16 2 3 3 1 2 3 4 5 6 7 8\n3 15 2 9 9 1\n4 8 2 6 6 2 3 9\n", 4);
    const auto groups = mshCurveGroups(names + rest.substr(rest.find("$Nodes")));
    REQUIRE(groups);
    REQUIRE(groups->count(5) == 1);
    CHECK(groups->at(5).name == "wall");
    CHECK(groups->at(5).length == doctest::Approx(2.0));
    CHECK_FALSE(groups->at(5).curved);
    CHECK(groups->at(6).curved); // through the centre
}

TEST_CASE("Read cells: a mesh of any elements with nodal values is a spacing") {
    const std::string text = msh2Of("1 3 2 1 1 1 2 3 4\n", 1) +
                             "$NodeData\n1\n\"h\"\n1\n0\n3\n0\n1\n4\n1 0.5\n2 1\n3 1\n4 0.5\n$EndNodeData\n";
    const auto spec = readMshSpacing(sourceOf(text));
    REQUIRE_MESSAGE(spec.ok(), messages(spec.faults()));
    REQUIRE(spec->background);
    CHECK(spec->background->elements.size() == 2);
    CHECK(spec->background->nodes.size() == 9);
    CHECK(spec->background->values[0] == 0.5);
    CHECK(hasCode(readMshSpacing(sourceOf(msh2Of("1 1 2 1 1 1 2\n", 1))).faults(), "no-values"));
}
