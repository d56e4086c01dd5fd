#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/files.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/vtk/vtk.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

const std::string kMsh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                         "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
                         "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n$EndElements\n";

std::string nodeData(const char *name, const char *values) {
    return std::string("$NodeData\n1\n\"") + name + "\"\n1\n0\n3\n0\n1\n4\n" + values + "$EndNodeData\n";
}

const std::string kVtk = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                         "POINTS 3 double\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";

const std::string kVtuHead = "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" "
                             "NumberOfCells=\"1\"><PointData>";
const std::string kVtuTail =
    "</PointData><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0</DataArray></Points>"
    "<Cells><DataArray type=\"Int32\" Name=\"connectivity\">0 1 2</DataArray><DataArray type=\"Int32\" "
    "Name=\"offsets\">3</DataArray><DataArray type=\"UInt8\" Name=\"types\">5</DataArray></Cells>"
    "</Piece></UnstructuredGrid></VTKFile>";

} // namespace

TEST_CASE("readMshField: by name, of any sign, the last of several time steps") {
    const std::string text = kMsh + nodeData("heat", "1 -1\n2 0\n3 2.5\n4 7\n") +
                             nodeData("flow", "1 1\n2 1\n3 1\n4 1\n") + nodeData("heat", "1 5\n2 6\n3 7\n4 -8\n");
    const auto field = fieldIn(readMshFields, sourceOf(text), "heat");
    REQUIRE_MESSAGE(field.ok(), messages(field.faults()));
    CHECK(field->values == std::vector<double>{5, 6, 7, -8});
    CHECK(field->mesh.elementCount() == 2);
    CHECK(fieldIn(readMshFields, sourceOf(text), "flow")->values[2] == 1.0);
    const auto missing = fieldIn(readMshFields, sourceOf(text), "cold");
    REQUIRE_FALSE(missing.ok());
    CHECK(hasCode(missing.faults(), "no-field"));
    CHECK(messages(missing.faults()).find("'heat'") != std::string::npos);
}

TEST_CASE("readMshField: nodes without a value are refused, and values with several components are skipped") {
    CHECK(hasCode(
        fieldIn(readMshFields, sourceOf(kMsh + "$NodeData\n1\n\"h\"\n1\n0\n3\n0\n1\n1\n1 3\n$EndNodeData\n"), "h")
            .faults(),
        "bad-values"));
    const std::string vectors = kMsh + "$NodeData\n1\n\"v\"\n1\n0\n3\n0\n3\n1\n1 3 4 5\n$EndNodeData\n";
    CHECK(readMsh(sourceOf(vectors)).ok());
    CHECK(hasCode(fieldIn(readMshFields, sourceOf(vectors), "v").faults(), "no-field"));
}

TEST_CASE("readMshSpacing: a value of 0 or less is still refused with its line") {
    const auto spacing = readMshSpacing(sourceOf(kMsh + nodeData("size", "1 1\n2 0\n3 2\n4 2\n")));
    REQUIRE_FALSE(spacing.ok());
    CHECK(hasCode(spacing.faults(), "bad-values"));
    CHECK(allLocated(spacing.faults()));
}

TEST_CASE("readVtkField: scalars and fields of points, not of cells") {
    const std::string text =
        kVtk + "CELL_DATA 1\nSCALARS heat double 1\nLOOKUP_TABLE default\n9\n" +
        "POINT_DATA 3\nVECTORS v double\n1 2 3 4 5 6 7 8 9\n" +
        "SCALARS heat double 1\nLOOKUP_TABLE default\n0.5 -1 2\nFIELD f 1\nflow 1 3 float\n1 2 3\n";
    const auto heat = fieldIn(readVtkFields, sourceOf(text), "heat");
    REQUIRE_MESSAGE(heat.ok(), messages(heat.faults()));
    CHECK(heat->values == std::vector<double>{0.5, -1, 2});
    CHECK(fieldIn(readVtkFields, sourceOf(text), "flow")->values == std::vector<double>{1, 2, 3});
    CHECK(hasCode(fieldIn(readVtkFields, sourceOf(text), "v").faults(), "no-field"));
    CHECK(readVtk(sourceOf(text)).ok());
}

TEST_CASE("readVtuField: point data by name, with as many values as nodes") {
    const std::string array = "<DataArray type=\"Float64\" Name=\"heat\">";
    const auto heat = fieldIn(readVtuFields, sourceOf(kVtuHead + array + "0.5 -1 2</DataArray>" + kVtuTail), "heat");
    REQUIRE_MESSAGE(heat.ok(), messages(heat.faults()));
    CHECK(heat->values == std::vector<double>{0.5, -1, 2});
    CHECK(hasCode(fieldIn(readVtuFields, sourceOf(kVtuHead + array + "0.5 -1</DataArray>" + kVtuTail), "heat").faults(),
                  "bad-values"));
    CHECK(hasCode(fieldIn(readVtuFields, sourceOf(kVtuHead + kVtuTail), "heat").faults(), "no-field"));
}

TEST_CASE("readFields: infinite values are absent") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "f.vtu";
    std::string head = kVtuHead;
    head.insert(std::string("<VTKFile ").size(), "byte_order=\"LittleEndian\" ");
    std::ofstream(file) << head << "<DataArray type=\"Float64\" Name=\"heat\" format=\"binary\">"
                        << "GAAAAAAAAAAAAOA/AAAAAAAA8H8AAAAAAADw/w==</DataArray>"
                        << kVtuTail; // 24 bytes: 0.5, ∞ and -∞
    const Result<MeshFields> read = allFormats().readFields(file);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    const std::vector<double> &heat = read->fields.at("heat");
    CHECK(heat[0] == 0.5);
    CHECK(std::isnan(heat[1]));
    CHECK(std::isnan(heat[2]));
}

TEST_CASE("readMshFields: values of triangles by number; those of other elements are left out") {
    const std::string mesh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                             "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
                             "$Elements\n3\n5 1 2 1 1 1 2\n7 2 2 1 1 1 2 3\n9 2 2 1 1 1 3 4\n$EndElements\n";
    const std::string head = "$ElementData\n1\n\"flux\"\n1\n0\n3\n0\n";
    const auto read = readMshFields(sourceOf(mesh + head + "1\n3\n9 2.5\n5 8\n7 -1\n$EndElementData\n"));
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    CHECK(read->fields.empty());
    REQUIRE(read->elementFields.contains("flux"));
    CHECK(read->elementFields.at("flux") == std::vector<double>{-1, 2.5});
    ImportNotes notes;
    const std::string vectors = mesh + head + "3\n1\n7 1 2 3\n$EndElementData\n";
    SourceText source = sourceOf(vectors);
    source.notes = &notes;
    const auto left = readMshFields(source);
    REQUIRE(left.ok());
    CHECK(left->elementFields.empty());
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries().front().message.find("'flux' is ignored: it has 3 components") != std::string::npos);
    CHECK(allLocated(readMshFields(sourceOf(mesh + head + "1\n2\n7 1\n$EndElementData\n")).faults()));
}

TEST_CASE("readVtkFields: values of triangles without those of lines, and no tags") {
    const std::string text = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                             "POINTS 3 double\n0 0 0 1 0 0 0 1 0\nCELLS 2 7\n2 0 1\n3 0 1 2\nCELL_TYPES 2\n3\n5\n"
                             "CELL_DATA 2\nSCALARS region int 1\nLOOKUP_TABLE default\n0\n4\n"
                             "SCALARS flux double 1\nLOOKUP_TABLE default\n7\n-0.5\nVECTORS v double\n1 2 3 4 5 6\n";
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto read = readVtkFields(source);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    CHECK(MeshView(read->mesh).region(0) == 4);
    CHECK(read->elementFields == NamedFields{{"flux", {-0.5}}});
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries().front().message.find("'v' is ignored: it has 3 components") != std::string::npos);
}

TEST_CASE("readVtkFields: an array named like tags is a field if its values are not whole numbers") {
    ImportNotes notes;
    const std::string text = kVtk + "CELL_DATA 1\nSCALARS region double 1\nLOOKUP_TABLE default\n2.5\n" +
                             "SCALARS boundary double 1\nLOOKUP_TABLE default\n0\n";
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto read = readVtkFields(source);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    CHECK(read->elementFields == NamedFields{{"region", {2.5}}});
    CHECK(MeshView(read->mesh).region(0) == 2);
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries().front().code == "real-tags");
    CHECK(notes.entries().front().message.find("'region'") != std::string::npos);
}

TEST_CASE("readVtuFields: cell data of triangles; arrays that are not read are noted") {
    const std::string head = "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" "
                             "NumberOfCells=\"1\"><CellData>"
                             "<DataArray type=\"Float64\" Name=\"flux\">0.25</DataArray>"
                             "<DataArray type=\"Float64\" Name=\"v\" NumberOfComponents=\"3\">1 2 3</DataArray>"
                             "<DataArray type=\"String\" Name=\"note\">x</DataArray>"
                             "<DataArray type=\"Float64\" Name=\"long\">1 2</DataArray></CellData><PointData>";
    ImportNotes notes;
    const std::string text = head + kVtuTail;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto read = readVtuFields(source);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    CHECK(read->elementFields == NamedFields{{"flux", {0.25}}});
    std::vector<std::string> codes;
    for (const ImportNote &note : notes.entries()) {
        codes.push_back(note.code);
    }
    CHECK(codes == std::vector<std::string>{"vector-values", "array-type", "array-length"});
}
