#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/common/tagged_sides.hpp"
#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"
#include "tests/unit/block_samples.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// The kinds of elements that each format holds.
const std::map<std::string, std::set<CellKind>> kHeldCells = {
    {"svg",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"dxf", {CellKind::Triangle3, CellKind::Quadrilateral4}},
    {"dxf-outline",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"msh2",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"msh41",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"msh41-binary",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"vtu",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"vtk",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"xdmf",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"medit", {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral9}},
    {"inp", {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8}},
    {"su2", {CellKind::Triangle3, CellKind::Quadrilateral4}},
    {"unv", {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8}},
    {"nastran", {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8}},
    {"2dm",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"openfoam", {CellKind::Triangle3, CellKind::Quadrilateral4}},
    {"adcirc", {CellKind::Triangle3}},
    {"selafin", {CellKind::Triangle3}},
    {"ugrid", {CellKind::Triangle3, CellKind::Quadrilateral4}},
    {"mike", {CellKind::Triangle3, CellKind::Quadrilateral4}},
    {"anuga", {CellKind::Triangle3}},
    {"gr3", {CellKind::Triangle3, CellKind::Quadrilateral4}},
    {"triangle", {CellKind::Triangle3, CellKind::Triangle6}},
    {"mfem",
     {CellKind::Triangle3, CellKind::Triangle6, CellKind::Quadrilateral4, CellKind::Quadrilateral8,
      CellKind::Quadrilateral9}},
    {"ply", {CellKind::Triangle3, CellKind::Quadrilateral4}},
    {"stl", {CellKind::Triangle3}},
    {"off", {CellKind::Triangle3, CellKind::Quadrilateral4}},
    {"obj", {CellKind::Triangle3, CellKind::Quadrilateral4}}};

std::string cellText(const MeshView &mesh, std::string_view format) {
    StringSink sink;
    const Status status = writeMesh(sink, mesh, format);
    REQUIRE_MESSAGE(status.empty(), messages(status));
    return sink.text;
}

bool hasPart(const std::string &text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// One element of region 3, whose nodes are numbered as it lists them, and its first edge with tag 2.
Mesh meshOfOneCell(CellKind kind) {
    const bool isTriangle = traitsOf(kind).corners == 3;
    samples::BlockMaker maker(isTriangle ? std::vector<Vec2>{{0, 0}, {4, 0}, {0, 4}}
                                         : std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    std::vector<NodeId> corners;
    for (std::size_t k = 0; k < traitsOf(kind).corners; ++k) {
        corners.push_back(samples::node(k));
    }
    maker.add(kind, corners, 3);
    maker.tag(samples::node(0), samples::node(1), 2);
    return std::move(maker.mesh);
}

/// Returns values of a type that lie in a text as bytes.
template <class T>
std::vector<T> cellValues(const std::string &bytes, std::size_t at, std::size_t count) {
    std::vector<T> values(count);
    REQUIRE(at + count * sizeof(T) <= bytes.size());
    std::memcpy(values.data(), bytes.data() + at, count * sizeof(T));
    return values;
}

/// The nodes of an element and of its edge, as numbers from `first` on.
std::string cellRow(std::size_t nodes, std::size_t first, const char *between = " ") {
    std::string row;
    for (std::size_t k = 0; k < nodes; ++k) {
        row += (k == 0 ? "" : between) + std::to_string(first + k);
    }
    return row;
}
std::string cellEdgeRow(const CellTraits &traits, std::size_t first) {
    return std::to_string(first) + ' ' + std::to_string(first + 1) +
           (traits.order == 2 ? ' ' + std::to_string(first + traits.corners) : "");
}

} // namespace

TEST_CASE("Cells of files: each kind is written or refused by name, and a refusal leaves no file and changes none") {
    std::size_t formats = 0;
    for (const FileFormat &format : allFormats().list()) {
        if (!format.writesMesh) {
            continue;
        }
        ++formats;
        CAPTURE(format.id);
        for (const CellKind kind : kElementKinds) {
            CAPTURE(traitsOf(kind).name);
            const TemporaryFolder folder;
            const Mesh mesh = samples::sampleMesh(kind);
            const auto path = folder / (std::string("mesh") + format.extension);
            const Status status = writeMesh(path, mesh, format.id);
            CHECK((checkElements(format, mesh).empty()) == (kHeldCells.at(format.id).count(kind) == 1));
            if (kHeldCells.at(format.id).count(kind) == 1) {
                CHECK_MESSAGE(status.empty(), messages(status));
                CHECK(folder.fileCount() == filesOfMesh(path, format.id).size());
                continue;
            }
            REQUIRE(hasCode(status, "unsupported-elements"));
            CHECK(status.front().file == path.string());
            CHECK(hasPart(status.front().message, std::string(format.name) + " files hold no "));
            CHECK(hasPart(status.front().message, std::string(traitsOf(kind).plural) + " (" +
                                                      std::to_string(mesh.elementCount()) + " of them)"));
            CHECK(folder.fileCount() == 0);
            REQUIRE(writeMesh(path, twoRegionMesh(), format.id).empty());
            const auto file = filesOfMesh(path, format.id).front();
            const auto before = readFileBytes(file, 1U << 20U);
            CHECK(hasCode(writeMesh(path, mesh, format.id), "unsupported-elements"));
            CHECK(*readFileBytes(file, 1U << 20U) == *before);
            if (format.files.empty() && format.folder.empty()) {
                StringSink sink;
                CHECK(hasCode(writeMesh(sink, mesh, format.id), "unsupported-elements"));
                CHECK(sink.text.empty());
            }
        }
    }
    CHECK(formats == kHeldCells.size());
}

TEST_CASE("Cells of files: the fault names all that is lacking, and formats that hold it from the table") {
    const TemporaryFolder folder;
    Diagnostics fault = writeMesh(folder / "a.su2", samples::sampleMesh(CellKind::Quadrilateral8));
    REQUIRE(fault.size() == 1);
    CHECK(fault.front().message ==
          "SU2 files hold no edges of 3 nodes (17 of them) and no quadrilaterals of 8 nodes (12 of them)");
    CHECK(fault.front().advice == "write .msh, .vtu, .vtk, .xdmf, .inp, .unv, .bdf or .2dm instead");
    fault = writeMesh(folder / "a.inp", samples::sampleMesh(CellKind::Quadrilateral9));
    REQUIRE(fault.size() == 1);
    CHECK(fault.front().message == "Abaqus and CalculiX files hold no quadrilaterals of 9 nodes (12 of them)");
    CHECK(fault.front().advice == "write .msh, .vtu, .vtk, .xdmf, .mesh or .2dm instead");
    fault = writeMesh(folder / "a.obj", samples::allKindsSample());
    REQUIRE(fault.size() == 1);
    CHECK(hasPart(fault.front().message, " of them), no triangles of 6 nodes ("));
    CHECK(hasPart(fault.front().message, " of them) and no quadrilaterals of 9 nodes ("));
    CHECK(fault.front().advice == "write .msh, .vtu, .vtk, .xdmf or .2dm instead");
    fault = writeMesh(folder / "a.node", samples::mixedSample(), "triangle");
    REQUIRE(fault.size() == 1);
    CHECK(hasPart(fault.front().message, "files hold no quadrilaterals ("));
    CHECK(fault.front().advice ==
          "write .msh, .vtu, .vtk, .xdmf, .mesh, .inp, .su2, .unv, .bdf, .2dm, .gr3 or .obj instead");
    CHECK(folder.fileCount() == 0);
}

TEST_CASE("Cells of files: Triangle's files hold triangles of 3 or of 6 nodes, but not both") {
    const TemporaryFolder folder;
    const Mesh both = samples::joined({meshOfOneCell(CellKind::Triangle3), meshOfOneCell(CellKind::Triangle6)});
    const Status fault = writeMesh(folder / "a.node", both, "triangle");
    REQUIRE(hasCode(fault, "unsupported-elements"));
    CHECK(fault.front().message == "Triangle .node/.ele/.edge files hold elements of one kind, but the mesh has "
                                   "triangles (1 of them) and triangles of 6 nodes (1 of them)");
    CHECK(fault.front().advice == "write .msh, .vtu, .vtk, .xdmf, .mesh, .inp, .unv, .bdf or .2dm instead");
    CHECK(folder.fileCount() == 0);
}

TEST_CASE("Cells of files: a mesh of triangles is written the same as TriMesh and as Mesh") {
    const TemporaryFolder folder;
    const TriMesh triangles = twoRegionMesh();
    const Mesh blocks = triangles;
    for (const FileFormat &format : allFormats().list()) {
        if (!format.writesMesh) {
            continue;
        }
        CAPTURE(format.id);
        const auto path = folder / (std::string("mesh") + format.extension);
        std::vector<std::string> contents;
        for (const MeshView &mesh : {MeshView(triangles), MeshView(blocks)}) {
            REQUIRE(writeMesh(path, mesh, format.id).empty());
            for (const auto &file : filesOfMesh(path, format.id)) {
                contents.push_back(*readFileBytes(file, 1U << 20U));
            }
        }
        const std::size_t half = contents.size() / 2;
        CHECK(std::equal(contents.begin(), contents.begin() + static_cast<std::ptrdiff_t>(half),
                         contents.begin() + static_cast<std::ptrdiff_t>(half), contents.end()));
        CHECK(exportNotes(path, triangles, format.id).size() == exportNotes(path, blocks, format.id).size());
    }
}

TEST_CASE("Cells of files: text formats list corners, then the middles of edges, then the centre") {
    for (const CellKind kind : kElementKinds) {
        const CellTraits &traits = traitsOf(kind);
        CAPTURE(traits.name);
        const Mesh mesh = meshOfOneCell(kind);
        const std::string fromOne = cellRow(traits.nodes, 1), fromZero = cellRow(traits.nodes, 0);
        const std::string line = std::to_string(traits.order == 2 ? 8 : 1);
        const std::string gmsh = std::to_string(traits.gmsh);
        CHECK(hasPart(cellText(mesh, "msh2"), "$Elements\n2\n1 " + line + " 2 2 2 " + cellEdgeRow(traits, 1) + "\n2 " +
                                                  gmsh + " 2 3 3 " + fromOne + "\n$EndElements\n"));
        CHECK(hasPart(cellText(mesh, "msh41"), "$Elements\n2 2 1 2\n1 2 " + line + " 1\n1 " + cellEdgeRow(traits, 1) +
                                                   "\n2 3 " + gmsh + " 1\n2 " + fromOne + "\n$EndElements\n"));
        const std::size_t edgeNodes = traits.order == 2 ? 3 : 2;
        CHECK(hasPart(cellText(mesh, "vtk"),
                      "CELLS 2 " + std::to_string(2 + traits.nodes + edgeNodes) + '\n' + std::to_string(traits.nodes) +
                          ' ' + fromZero + '\n' + std::to_string(edgeNodes) + ' ' + cellEdgeRow(traits, 0) +
                          "\nCELL_TYPES 2\n" + std::to_string(traits.vtk) + '\n' + (traits.order == 2 ? "21" : "3") +
                          "\nCELL_DATA 2\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n3\n2\n"));
        if (kind != CellKind::Quadrilateral8) {
            CHECK(hasPart(cellText(mesh, "medit"), (traits.order == 2 ? "\nEdgesP2\n1\n" : "\nEdges\n1\n") +
                                                       cellEdgeRow(traits, 1) + " 2\n\n" + traits.medit + "\n1\n" +
                                                       fromOne + " 3\n\nEnd\n"));
        }
        if (kind != CellKind::Quadrilateral9) {
            const std::string text = cellText(mesh, "inp");
            CHECK(hasPart(text, std::string("** tag 3\n*ELEMENT, TYPE=") + traits.abaqus + ", ELSET=region_3\n1, " +
                                    cellRow(traits.nodes, 1, ", ") + "\n*ELSET, ELSET=EALL, GENERATE\n1, 1, 1\n"));
            CHECK(hasPart(text, "\n** support: *BOUNDARY / boundary_2, 1, 2; load: *DSLOAD / S_boundary_2, P, 1.\n"));
            CHECK(hasPart(text, "*NSET, NSET=boundary_2\n1, 2" +
                                    (traits.order == 2 ? ", " + std::to_string(traits.corners + 1) : "") + '\n'));
            CHECK(hasPart(text, "TYPE=ELEMENT\n1, S1\n"));
        }
        if (traits.order == 1) {
            CHECK(hasPart(cellText(mesh, "su2"),
                          "NELEM= 1\n" + std::to_string(traits.vtk) + ' ' + fromZero + " 0\nNPOIN= "));
            CHECK(hasPart(cellText(mesh, "su2"), "MARKER_ELEMS= 1\n3 0 1\n"));
            CHECK(hasPart(cellText(mesh, "obj"), "# tag 3\nf " + fromOne + "\ng "));
        }
    }
}

TEST_CASE("Cells of files: Triangle puts the middle of the edge opposite to corner k at 3 + k") {
    const TemporaryFolder folder;
    REQUIRE(writeMesh(folder / "a.node", meshOfOneCell(CellKind::Triangle6), "triangle").empty());
    CHECK(hasPart(*readFileBytes(folder / "a.ele", 4096), "1 6 1\n1 1 2 3 5 6 4 3\n"));
    CHECK(hasPart(*readFileBytes(folder / "a.edge", 4096), "1 1\n1 1 2 2\n"));
    CHECK(hasPart(*readFileBytes(folder / "a.node", 4096), "6 2 0 1\n1 0 0 2\n2 4 0 2\n3 0 4 0\n4 2 0 2\n"));
}

TEST_CASE("Cells of files: VTU and binary MSH hold the same numbers as their texts") {
    for (const CellKind kind : kElementKinds) {
        const CellTraits &traits = traitsOf(kind);
        CAPTURE(traits.name);
        const Mesh mesh = meshOfOneCell(kind);
        const std::size_t edgeNodes = traits.order == 2 ? 3 : 2;
        const std::string vtu = cellText(mesh, "vtu");
        std::size_t at = vtu.find("<AppendedData encoding=\"raw\">\n_");
        REQUIRE(at != std::string::npos);
        at = vtu.find('_', at) + 1 + 8 + 24 * mesh.nodes.size() + 8;
        std::vector<std::int32_t> nodes;
        for (std::int32_t n = 0; n < traits.nodes; ++n) {
            nodes.push_back(n);
        }
        nodes.insert(nodes.end(), {0, 1});
        if (traits.order == 2) {
            nodes.push_back(traits.corners);
        }
        CHECK(cellValues<std::int32_t>(vtu, at, nodes.size()) == nodes);
        at += 4 * nodes.size() + 8;
        const std::int32_t all = static_cast<std::int32_t>(nodes.size());
        CHECK(cellValues<std::int32_t>(vtu, at, 2) == std::vector<std::int32_t>{traits.nodes, all});
        CHECK(cellValues<std::uint8_t>(vtu, at + 16, 2) ==
              std::vector<std::uint8_t>{static_cast<std::uint8_t>(traits.vtk),
                                        traits.order == 2 ? std::uint8_t{21} : std::uint8_t{3}});

        const std::string msh = cellText(mesh, "msh41-binary");
        at = msh.find("$Elements\n");
        REQUIRE(at != std::string::npos);
        at += 10;
        CHECK(cellValues<std::uint64_t>(msh, at, 4) == std::vector<std::uint64_t>{2, 2, 1, 2});
        at += 32;
        CHECK(cellValues<std::int32_t>(msh, at, 3) == std::vector<std::int32_t>{1, 2, traits.order == 2 ? 8 : 1});
        at += 12 + 8 + 8 + 8 * edgeNodes;
        CHECK(cellValues<std::int32_t>(msh, at, 3) == std::vector<std::int32_t>{2, 3, traits.gmsh});
        at += 12 + 8 + 8;
        std::vector<std::uint64_t> fromOne;
        for (std::uint64_t n = 1; n <= traits.nodes; ++n) {
            fromOne.push_back(n);
        }
        CHECK(cellValues<std::uint64_t>(msh, at, traits.nodes) == fromOne);
    }
}

TEST_CASE("Cells of files: an entity of MSH 4.1 has a block for each kind, and elements keep their numbers") {
    samples::BlockMaker maker({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}});
    using samples::node;
    maker.add(CellKind::Quadrilateral4, {node(0), node(1), node(2), node(3)}, 1);
    maker.add(CellKind::Triangle3, {node(1), node(4), node(5)}, 1);
    maker.add(CellKind::Triangle3, {node(1), node(5), node(2)}, 4);
    maker.mesh.nodes.push_back({0.5, -0.25});
    maker.mesh.edges = {{node(0), node(1), 2, node(6)}, {node(1), node(4), 2}, {node(4), node(5), 2}};
    CHECK(hasPart(cellText(maker.mesh, "msh41"), "$Elements\n5 6 1 6\n"
                                                 "1 2 1 2\n2 2 5\n3 5 6\n"
                                                 "1 2 8 1\n1 1 2 7\n"
                                                 "2 1 2 1\n5 2 5 6\n2 1 3 1\n4 1 2 3 4\n"
                                                 "2 4 2 1\n6 2 6 3\n$EndElements\n"));
}

TEST_CASE("Cells of files: Abaqus lists the elements of a region once for each kind, in one set") {
    const Mesh mesh = samples::mixedSample();
    const std::string text = cellText(mesh, "inp");
    CHECK(hasPart(text, "*HEADING\nPlane mesh\n"));
    for (const char *type : {"CPS3", "CPS4"}) {
        for (const char *region : {"left_half", "right_half"}) {
            const std::string card = std::string("*ELEMENT, TYPE=") + type + ", ELSET=" + region + '\n';
            CHECK(hasPart(text, card));
            CHECK(text.find(card) == text.rfind(card));
        }
    }
}

TEST_CASE("Cells of files: an SVG picture draws edges of 3 nodes as the Bezier curves that they are") {
    Mesh mesh = meshOfOneCell(CellKind::Triangle6);
    mesh.nodes[3] = {2.0, -1.0}; // control point: 2 * (2, -1) - ((0, 0) + (4, 0)) / 2 = (2, -2), 1 below at its lowest
    const std::string text = cellText(mesh, "svg");
    CHECK(hasPart(text, "viewBox=\"-10 -10 820 1020\"")); // 4 wide and 5 high
    CHECK(hasPart(text, "d=\"M0 800Q400 1200 800 800Q400 400 0 0Q0 400 0 800Z\n\""));
    CHECK(hasPart(text, "d=\"M0 800Q400 1200 800 800\n\""));
    CHECK(hasPart(cellText(meshOfOneCell(CellKind::Quadrilateral4), "svg"), "d=\"M0 1000L1000 1000L1000 0L0 0Z\n\""));
}

TEST_CASE("Cells of files: SU2 notes regions of elements of several kinds in turn") {
    const std::string text = cellText(samples::mixedSample(), "su2");
    std::size_t noted = 0;
    for (std::size_t at = text.find("% elements "); at != std::string::npos; at = text.find("% elements ", at + 1)) {
        noted += std::stoul(text.substr(at + 11));
    }
    CHECK(noted == samples::mixedSample().elementCount());
}

TEST_CASE("TaggedSides: the sides of elements along tagged edges, with their direction") {
    for (const Mesh &mesh : {samples::mixedSample(), samples::allKindsSample(), Mesh(twoRegionMesh())}) {
        const MeshView view(mesh);
        const TaggedSides sides(view);
        std::size_t both = 0;
        for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
            std::vector<std::tuple<std::size_t, std::size_t, bool>> expected, found;
            for (std::size_t k = 0; k < view.elementCount(); ++k) {
                const auto corners = view.cornersOf(k);
                for (std::size_t s = 0; s < corners.size(); ++s) {
                    const NodeId a = corners[s], b = corners[(s + 1) % corners.size()];
                    if (std::minmax(a, b) == std::minmax(mesh.edges[e].a, mesh.edges[e].b)) {
                        expected.emplace_back(k, s, a == mesh.edges[e].a);
                    }
                }
            }
            for (const ElementSide &side : sides.of(e)) {
                found.emplace_back(side.element, side.side, side.along);
            }
            CHECK(found == expected);
            CHECK_FALSE(found.empty());
            both += found.size() > 1 ? 1 : 0;
        }
        CHECK(both > 0);
        CHECK(hasInnerEdges(mesh));
        CHECK(withoutInnerEdges(mesh).edges.size() == mesh.edges.size() - both);
        CHECK_FALSE(hasInnerEdges(withoutInnerEdges(mesh)));
    }
}
