#include "core/files/abaqus/abaqus.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/su2/su2.hpp"
#include "core/files/vtk/vtk.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using namespace forefront::testing;

TEST_CASE("Abaqus: nodes may follow the elements, and be in several sections") {
    const std::string elements = "*ELEMENT, TYPE=CPS3, ELSET=plate\n1, 1, 2, 3\n2, 2, 4, 3\n";
    const std::string some = "*NODE\n1, 0, 0\n2, 1, 0\n", others = "*NODE\n3, 0, 1\n4, 1, 1\n";
    const auto usual = readAbaqus(sourceOf("*HEADING\nplate\n" + some + others + elements));
    REQUIRE(usual.ok());
    for (const std::string &text : {elements + some + others, some + elements + others}) {
        const auto read = readAbaqus(sourceOf(text));
        REQUIRE(read.ok());
        CHECK(read->nodes == usual->nodes);
        CHECK(read->elements == usual->elements);
        CHECK(read->regionNames == usual->regionNames);
    }
    ImportNotes notes;
    const std::string text = "*MATERIAL\nsteel\n" + elements + some + others;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    REQUIRE(readAbaqus(source).ok());
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].count == 1); // although the file is read twice
    const auto missing = readAbaqus(sourceOf(elements + some));
    REQUIRE_FALSE(missing.ok());
    CHECK(missing.faults()[0].line == 2);
    CHECK_FALSE(readAbaqus(sourceOf(some + others)).ok());
    const auto parts =
        readAbaqus(sourceOf("*PART, NAME=a\n" + some + others + elements + "*PART, NAME=b\n" + elements));
    REQUIRE_FALSE(parts.ok());
    CHECK(parts.faults()[0].code == "several-parts");
    const auto commented =
        readAbaqus(sourceOf("*ELEMENT, TYPE=CPS3, ELSET=p\n1, 1, 2, 3\n" + some + others + "** tag 5\n"));
    REQUIRE(commented.ok());
    CHECK(commented->region(0) == 1); // the comment at the end says nothing about the beginning
    CHECK_FALSE(readAbaqus(sourceOf(elements)).ok());
}

TEST_CASE("MEDIT: version 0, as bamg writes it, is read") {
    const std::string text = "Dimension 2\nVertices 3\n0 0 1\n1 0 1\n0 1 1\nTriangles 1\n1 2 3 1\nEnd\n";
    CHECK(readMedit(sourceOf("MeshVersionFormatted 0\n" + text)).ok());
    CHECK_FALSE(readMedit(sourceOf("MeshVersionFormatted 5\n" + text)).ok());
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
        const auto read = readVtk(sourceOf(head + variant));
        REQUIRE(read.ok());
        CHECK(read->elements.size() == 1);
        CHECK(read->region(0) == 7);
    }
    const auto other = readVtk(sourceOf(head + "ascii\ndataset polydata\n"));
    REQUIRE_FALSE(other.ok());
    CHECK(other.faults()[0].line == 4);
    CHECK(other.faults()[0].message.find("'polydata'") != std::string::npos);
}

TEST_CASE("MSH: names of version 2.0 have no dimension; version 1 is named") {
    const std::string text = "$MeshFormat\n2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 \"wall\"\n5 \"plate\"\n"
                             "$EndPhysicalNames\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
                             "$Elements\n2\n1 1 2 3 1 1 2\n2 2 2 5 1 1 2 3\n$EndElements\n";
    const auto read = readMsh(sourceOf(text));
    REQUIRE(read.ok());
    CHECK(read->boundaryNames == std::map<std::int32_t, std::string>{{3, "wall"}});
    CHECK(read->regionNames == std::map<std::int32_t, std::string>{{5, "plate"}});
    const auto old = readMsh(sourceOf("$NOD\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$ENDNOD\n"));
    REQUIRE_FALSE(old.ok());
    CHECK(old.faults()[0].code == "unknown-version");
    CHECK(looksLikeMsh("$NOD\n3\n"));
}

TEST_CASE("SU2: a mesh of three dimensions is refused for that reason") {
    const auto read = readSu2(sourceOf("NDIME= 3\nNELEM= 1\n10 0 1 2 3 0\n"));
    REQUIRE_FALSE(read.ok());
    CHECK(read.faults()[0].code == "not-planar");
    CHECK(read.faults()[0].line == 1);
    CHECK(read.faults()[0].column == 8);
}
