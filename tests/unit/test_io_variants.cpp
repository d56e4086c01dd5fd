#include "core/files/abaqus/abaqus.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/netgen/netgen.hpp"
#include "core/files/su2/su2.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/vtk/vtk.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using namespace forefront::testing;

TEST_CASE("Abaqus: nodes may follow the elements, and be in several sections") {
    const std::string elements = "*ELEMENT, TYPE=CPS3, ELSET=plate\n1, 1, 2, 3\n2, 2, 4, 3\n";
    const std::string some = "*NODE\n1, 0, 0\n2, 1, 0\n", others = "*NODE\n3, 0, 1\n4, 1, 1\n";
    const auto usual = triangles(readAbaqus(sourceOf("*HEADING\nplate\n" + some + others + elements)));
    REQUIRE(usual.ok());
    for (const std::string &text : {elements + some + others, some + elements + others}) {
        const auto read = triangles(readAbaqus(sourceOf(text)));
        REQUIRE(read.ok());
        CHECK(read->nodes == usual->nodes);
        CHECK(read->elements == usual->elements);
        CHECK(read->regionNames == usual->regionNames);
    }
    ImportNotes notes;
    const std::string text = "*MATERIAL\nsteel\n" + elements + some + others;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    REQUIRE(triangles(readAbaqus(source)).ok());
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].count == 1); // although the file is read twice
    const auto missing = triangles(readAbaqus(sourceOf(elements + some)));
    REQUIRE_FALSE(missing.ok());
    CHECK(missing.faults()[0].line == 2);
    CHECK_FALSE(triangles(readAbaqus(sourceOf(some + others))).ok());
    const auto parts =
        triangles(readAbaqus(sourceOf("*PART, NAME=a\n" + some + others + elements + "*PART, NAME=b\n" + elements)));
    REQUIRE_FALSE(parts.ok());
    CHECK(parts.faults()[0].code == "several-parts");
    const auto commented =
        triangles(readAbaqus(sourceOf("*ELEMENT, TYPE=CPS3, ELSET=p\n1, 1, 2, 3\n" + some + others + "** tag 5\n")));
    REQUIRE(commented.ok());
    CHECK(commented->region(0) == 1); // the comment at the end says nothing about the beginning
    CHECK_FALSE(triangles(readAbaqus(sourceOf(elements))).ok());
}

TEST_CASE("MEDIT: version 0, as bamg writes it, is read") {
    const std::string text = "Dimension 2\nVertices 3\n0 0 1\n1 0 1\n0 1 1\nTriangles 1\n1 2 3 1\nEnd\n";
    CHECK(triangles(readMedit(sourceOf("MeshVersionFormatted 0\n" + text))).ok());
    CHECK_FALSE(triangles(readMedit(sourceOf("MeshVersionFormatted 5\n" + text))).ok());
}

TEST_CASE("MEDIT: sections of other programs are skipped and noted, empty ones of other elements are nothing") {
    const std::string head = "MeshVersionFormatted 0\nDimension\n2\nIdentifier\n\"G=d.mesh;1, Date: 21/04/02\"\n"
                             "Geometry\n\"d.mesh\"\nVertices\n3\n0 0 4\n1 0 0\n0 1 0\nEdges 1\n1 2 4\n";
    const std::string elements = "Quadrilaterals\n0\nTetrahedra 0\nTriangles 1\n1 2 3 5\n";
    const std::string rest = "SubDomainFromMesh\n1\n3 1 1 1\nVertexOnGeometricEdge\n1\n1 1 0.5\nCorners 0\n";
    for (const std::string &text : {head + elements + rest + "End\n", head + rest + elements}) {
        ImportNotes notes;
        SourceText source = sourceOf(text);
        source.notes = &notes;
        const auto mesh = triangles(readMedit(source));
        REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
        CHECK(mesh->elements.size() == 1);
        CHECK(mesh->region(0) == 5);
        std::string sections;
        for (const ImportNote &note : notes.entries()) {
            sections += note.message + '\n';
        }
        CHECK(sections == "section Identifier is ignored\nsection Geometry is ignored\nsection SubDomainFromMesh is "
                          "ignored\nsection VertexOnGeometricEdge is ignored\n");
    }
    // What cannot be left out is refused.
    for (const std::string other : {"Quadrilaterals 1\n1 2 3 1 1\n", "Tetrahedra\n1\n1 2 3 1 1\n",
                                    "EdgesP2 1\n1 2 2 1\n", "TrianglesP2\n1\n", "7 8\n", "Vertices 1\n0 0 0\n"}) {
        CAPTURE(other);
        const auto mesh = triangles(readMedit(sourceOf(head + elements + other)));
        REQUIRE_FALSE(mesh.ok());
        CHECK(allLocated(mesh.faults()));
    }
}

TEST_CASE("Counts that a file announces must be those of what it holds") {
    const auto refused = [](const Result<TriMesh> &mesh, const std::string &first, const std::string &second) {
        REQUIRE_FALSE(mesh.ok());
        CHECK(allLocated(mesh.faults()));
        CHECK(mesh.faults()[0].code == "bad-count");
        CHECK(mesh.faults()[0].message.find(first) != std::string::npos);
        CHECK(mesh.faults()[0].message.find(second) != std::string::npos);
    };
    const auto vtu = [](const std::string &attributes, const std::string &connectivity) {
        return triangles(readVtu(
            sourceOf("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece " + attributes +
                     "><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0</DataArray>"
                     "</Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\">" +
                     connectivity +
                     "</DataArray><DataArray type=\"Int32\" Name=\"offsets\">3</DataArray>"
                     "<DataArray type=\"UInt8\" Name=\"types\">5</DataArray></Cells></Piece>"
                     "</UnstructuredGrid></VTKFile>")));
    };
    CHECK(vtu("NumberOfPoints=\"3\" NumberOfCells=\"1\"", "0 1 2").ok());
    refused(vtu("NumberOfPoints=\"5\" NumberOfCells=\"1\"", "0 1 2"), "NumberOfPoints is '5'", "holds 3 points");
    refused(vtu("NumberOfPoints=\"3\" NumberOfCells=\"2\"", "0 1 2"), "NumberOfCells is '2'", "holds 1 cells");
    refused(vtu("NumberOfPoints=\"3\" NumberOfCells=\"1\"", "0 1 2 0"), "have 3 nodes", "4 are listed");
    const std::string format = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n",
                      one = "1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n";
    const std::string triangle = "2 1 2 1\n1 1 2 3\n$EndElements\n";
    CHECK(triangles(readMsh(sourceOf(format + "$Nodes\n1 3 1 3\n2 1 0 3\n" + one + "$Elements\n1 1 1 1\n" + triangle)))
              .ok());
    refused(triangles(readMsh(sourceOf(format + "$Nodes\n1 4 1 3\n2 1 0 3\n" + one))), "declares 4 nodes", "hold 3");
    refused(triangles(readMsh(sourceOf(format + "$Nodes\n1 2 1 3\n2 1 0 3\n" + one))), "more nodes", "2");
    refused(
        triangles(readMsh(sourceOf(format + "$Nodes\n1 3 1 3\n2 1 0 3\n" + one + "$Elements\n1 2 1 1\n" + triangle))),
        "declares 2 elements", "hold 1");
    const std::string nodes = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n", elements = "1 3 0\n1 1 2 3\n";
    const auto triangleMesh = [&](const std::string &n, const std::string &e) {
        const SourceText ofNodes = sourceOf(n), ofElements = sourceOf(e);
        return triangles(readTriangleParts(ofNodes, ofElements, nullptr));
    };
    CHECK(triangleMesh(nodes + "# made by hand\n\n", elements).ok());
    refused(triangleMesh(nodes + "4 1 1\n", elements), "announces 3 nodes", "4 lines");
    refused(triangleMesh(nodes, elements + "2 1 2 3\n3 1 2 3\n"), "announces 1 triangle", "3 lines");
    const std::string su2 = "NDIME= 2\nNELEM= 1\n5 0 1 2 0\nNPOIN= 3\n0 0 0\n1 0 1\n0 1 2\nNMARK= 2\nMARKER_TAG= a\n"
                            "MARKER_ELEMS= 1\n3 0 1\n";
    refused(triangles(readSu2(sourceOf(su2))), "NMARK is 2", "holds 1 marker");
    CHECK(triangles(readSu2(sourceOf(su2 + "MARKER_TAG= b\nMARKER_ELEMS= 0\n"))).ok());
    refused(triangles(readNetgen(
                sourceOf("mesh3d\nsurfaceelements\n2\n1 1 0 0 3 1 2 3\npoints\n3\n0 0 0\n1 0 0\n0 1 0\nendmesh\n"))),
            "has 1 lines", "instead of 2");
}

TEST_CASE("MSH 2: nodes with parameters are read like others") {
    const auto mesh = triangles(
        readMsh(sourceOf("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n3\n1 0 0 0 0 1\n2 1 0 0 1 4 0.5\n"
                         "3 0 1 0 2 1 0.25 -3\n$EndParametricNodes\n$Elements\n1\n5 2 2 7 1 1 2 3\n$EndElements\n")));
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    CHECK(mesh->nodes == std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}});
    CHECK(mesh->region(0) == 7);
}

TEST_CASE("VTK: keywords count in any case") {
    const std::string head = "# vtk DataFile Version 2.0\ntitle\n";
    const std::string text = "ASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0\n1 0 0\n0 1 0\n"
                             "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\nCELL_DATA 1\nSCALARS region int 1\n"
                             "LOOKUP_TABLE default\n7\n";
    std::string small = text;
    for (const std::string word : {"ASCII", "DATASET", "UNSTRUCTURED_GRID", "POINTS", "CELLS", "CELL_TYPES",
                                   "CELL_DATA", "SCALARS", "LOOKUP_TABLE"}) {
        std::string lower = word;
        for (char &c : lower) {
            c = c == '_' ? c : static_cast<char>(c + ('a' - 'A'));
        }
        small.replace(small.find(word), word.size(), lower);
    }
    REQUIRE(small != text);
    for (const std::string &variant : {text, small}) {
        const auto read = triangles(readVtk(sourceOf(head + variant)));
        REQUIRE(read.ok());
        CHECK(read->elements.size() == 1);
        CHECK(read->region(0) == 7);
    }
    const auto other = triangles(readVtk(sourceOf(head + "ascii\ndataset polydata\n")));
    REQUIRE_FALSE(other.ok());
    CHECK(other.faults()[0].line == 4);
    CHECK(other.faults()[0].message.find("'polydata'") != std::string::npos);
}

TEST_CASE("MSH: names of version 2.0 have no dimension; version 1 is named") {
    const std::string text = "$MeshFormat\n2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 \"wall\"\n5 \"plate\"\n"
                             "$EndPhysicalNames\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
                             "$Elements\n2\n1 1 2 3 1 1 2\n2 2 2 5 1 1 2 3\n$EndElements\n";
    const auto read = triangles(readMsh(sourceOf(text)));
    REQUIRE(read.ok());
    CHECK(read->boundaryNames == std::map<std::int32_t, std::string>{{3, "wall"}});
    CHECK(read->regionNames == std::map<std::int32_t, std::string>{{5, "plate"}});
    const auto old = triangles(readMsh(sourceOf("$NOD\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$ENDNOD\n")));
    REQUIRE_FALSE(old.ok());
    CHECK(old.faults()[0].code == "unknown-version");
    CHECK(looksLikeMsh("$NOD\n3\n"));
}

TEST_CASE("SU2: a mesh of three dimensions is refused for that reason") {
    const auto read = triangles(readSu2(sourceOf("NDIME= 3\nNELEM= 1\n10 0 1 2 3 0\n")));
    REQUIRE_FALSE(read.ok());
    CHECK(read.faults()[0].code == "not-planar");
    CHECK(read.faults()[0].line == 1);
    CHECK(read.faults()[0].column == 8);
}
