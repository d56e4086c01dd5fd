#include "core/drawing_files/clipboard/clipboard.hpp"
#include "core/engine/base/hash.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/files.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/vtk/vtk.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Returns the codes and counts of the notes on a text, or the code of the error.
template <class T>
std::string remarksOn(Result<T> (*read)(const SourceText &), const std::string &text) {
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const Result<T> got = read(source);
    std::string list = got.ok() ? "" : got.faults().front().code + '\n';
    for (const ImportNote &note : notes.entries()) {
        list += note.code + ' ' + std::to_string(note.count) + '\n';
    }
    return list;
}

/// Returns the notes on the text of the clipboard.
std::string remarksOnClipboard(const std::string &text) {
    ImportNotes notes;
    const Result<Document> drawing = readClipboard(text, &notes);
    REQUIRE(drawing.ok());
    std::string list;
    for (const ImportNote &note : notes.entries()) {
        list += note.code + ' ' + std::to_string(note.count) + '\n';
    }
    return list;
}

} // namespace

TEST_CASE("Abaqus: numbers have at most 20 characters; only longer ones are rounded, with one note") {
    TriMesh mesh = samples::square(1, 1);
    mesh.nodes = {{-1.2246467991473533e-17, 0.1 + 0.2}, {1.0, 1.0 / 3.0}, {1.0, -1.0 / 3e4}, {1e300 / 3.0, 1.0}};
    std::istringstream lines(written(writeAbaqus, mesh));
    std::vector<double> read;
    bool inNodes = false;
    for (std::string line; std::getline(lines, line);) {
        inNodes = line.starts_with('*') ? line.starts_with("*NODE") : inNodes;
        std::istringstream words(line);
        for (std::string word; inNodes && !line.starts_with('*') && std::getline(words, word, ',');) {
            word.erase(0, word.find_first_not_of(' '));
            CHECK_MESSAGE(word.size() <= 20, word);
            read.push_back(std::stod(word));
        }
    }
    REQUIRE(read.size() == 16);
    for (std::size_t n = 0; n < 4; ++n) {
        CHECK(read[4 * n + 1] == doctest::Approx(mesh.nodes[n].x).epsilon(1e-13));
        CHECK(read[4 * n + 2] == doctest::Approx(mesh.nodes[n].y).epsilon(1e-13));
    }
    CHECK(read[2] == 0.1 + 0.2); // fits, so that it reads back to the same bits
    CHECK(read[6] == 1.0 / 3.0);
    const Diagnostics notes = exportNotes("a.inp", mesh);
    REQUIRE(notes.size() == 1);
    CHECK(notes.front().code == "rounded-coordinates");
    CHECK(notes.front().message.starts_with("3 coordinates are rounded to 20 characters"));
    CHECK(exportNotes("a.inp", samples::square(2, 2)).empty());
}

TEST_CASE("Abaqus: other coordinate systems and files are refused; sets that do not exist and of nodes are noted") {
    const std::string nodes = "\n1, 0, 0\n2, 1, 0\n3, 1, 1\n", element = "*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n";
    CHECK(remarksOn(readAbaqus, "*NODE, SYSTEM=C" + nodes + element) == "coordinate-system\n");
    CHECK(remarksOn(readAbaqus, "*NODE, SYSTEM=R" + nodes + element).empty());
    CHECK(remarksOn(readAbaqus, "*SYSTEM\n0, 0, 0, 1, 1, 0\n*NODE" + nodes + element) == "coordinate-system\n");
    CHECK(remarksOn(readAbaqus, "*NODE, INPUT=nodes.txt\n" + element) == "unknown-section\n");
    CHECK(remarksOn(readAbaqus, "*NODE" + nodes + element + "*INCLUDE, INPUT=more.inp\n") == "unknown-section\n");
    CHECK(remarksOn(readAbaqus, "*NODE, NSET=fixed" + nodes + element) == "node-set 1\n");
    CHECK(remarksOn(readAbaqus, "*NODE, NSET=NALL" + nodes + element).empty());
    CHECK(remarksOn(readAbaqus, "*NODE" + nodes + element + "*ELSET, ELSET=all\nleft, right\n1\n") ==
          "element-set 1\nelement-set 1\n");
}

TEST_CASE("MEDIT: elements of second order under a keyword of first order are named") {
    const auto file = [](const std::string &section) {
        std::string text = "MeshVersionFormatted 2\nDimension 2\nVertices 9\n";
        for (const char *place : {"0 0", "2 0", "2 2", "0 2", "1 0", "2 1", "1 2", "0 1", "1 1"}) {
            text += std::string(place) + " 0\n";
        }
        return text + section + "End\n";
    };
    for (const std::string &section : {std::string("Quadrilaterals\n1\n1 2 3 4 5 6 7 8 9 1\n"),
                                       std::string("Quadrilaterals\n1\n1 2 3 4 5 6 7 8 1\n"),
                                       std::string("Triangles\n2\n1 2 3 5 6 9 1\n1 3 4 9 7 8 1\n"),
                                       std::string("Edges\n2\n1 2 5 1\n2 3 6 1\nTriangles\n1\n1 2 3 1\n")}) {
        const Result<Mesh> mesh = readMedit(sourceOf(file(section)));
        REQUIRE_FALSE(mesh.ok());
        CHECK(mesh.faults().front().code == "unknown-element");
        CHECK_MESSAGE(mesh.faults().front().message.find("holds elements of second order") != std::string::npos,
                      mesh.faults().front().message);
        CHECK(mesh.faults().front().line == 15);
    }
    CHECK(remarksOn(readMedit, file("Triangles\n2\n1 2 3 1 1 3 4 1\n")).empty()); // two on a line are read
    CHECK(remarksOn(readMedit, file("Triangles\n1\n1 2 3 1 7\n")) == "unknown-section\n");
}

TEST_CASE("MEDIT: references of middle nodes count as those of their edges") {
    const std::string text =
        "MeshVersionFormatted 2\nDimension 2\nVertices 6\n0 0 4\n2 0 4\n0 2 0\n1 0 4\n1 1 0\n0 1 8\n"
        "EdgesP2\n1\n1 2 4 4\nTrianglesP2\n1\n1 2 3 4 5 6 1\nEnd\n";
    CHECK(remarksOn(readMedit, text) == "vertex-references 1\n"); // only that of node 6
}

TEST_CASE("Triangle: lines after the last section of a .poly file are noted") {
    const std::string poly = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n1\n1 0.2 0.2 1\n";
    CHECK(remarksOn(readPoly, poly).empty());
    CHECK(remarksOn(readPoly, poly + "# the end\n").empty());
    CHECK(remarksOn(readPoly, poly + "2 0.3 0.3 2\n3 0.1 0.1 2\n") == "more-lines 2\n");
}

TEST_CASE("VTK and VTU: field data that name no tags are noted") {
    const std::string head = "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    const std::string grid = "POINTS 3 double\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";
    CHECK(remarksOn(readVtk, head + grid).empty());
    CHECK(remarksOn(readVtk, head + "FIELD FieldData 1\nTIME 1 1 double\n0.5\n" + grid) == "field-data 1\n");
    const auto vtu = [](const std::string &fields) {
        return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><FieldData>" + fields +
               "</FieldData><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" "
               "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0</DataArray></Points><Cells><DataArray type=\"Int32\" "
               "Name=\"connectivity\">0 1 2</DataArray><DataArray type=\"Int32\" Name=\"offsets\">3</DataArray>"
               "<DataArray type=\"UInt8\" Name=\"types\">5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
    };
    CHECK(remarksOn(readVtu, vtu("")).empty());
    CHECK(remarksOn(readVtu, vtu("<DataArray type=\"Float64\" Name=\"TimeValue\">0.5</DataArray>"
                                 "<DataArray type=\"String\" Name=\"author\">65 0</DataArray>")) ==
          "field-data 1\nfield-data 1\n");
    CHECK(remarksOn(readVtu, written(writeVtu, twoRegionMesh())).empty());
}

TEST_CASE("Clipboard: lines and columns that are not used are noted") {
    CHECK(remarksOnClipboard("0 0\n1 0\n\n2 0\n3 1\n").empty());
    CHECK(remarksOnClipboard("(0, 0)\n(1, 0)\n").empty());
    CHECK(remarksOnClipboard("x\ty\tz\n0\t0\t5\n1\t0\t5\n1\t1\t\n") == "other-lines 1\nmore-columns 2\n");
    CHECK(remarksOnClipboard(R"({"format": "forefront", "version": 2, "mood": 1, "shapes": []})") == "members 1\n");
}
