#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/geojson/geojson.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/files.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/obj/obj.hpp"
#include "core/files/su2/su2.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/vtk/vtk.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/svg_samples.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::string codesOf(const ImportNotes &notes) {
    std::string codes;
    for (const ImportNote &note : notes.entries()) {
        codes += note.code + ' ' + std::to_string(note.count) + ' ';
    }
    return codes;
}

/// The fault for an element that refers to a node twice.
Diagnostic refusalOf(const Result<Mesh> &mesh) {
    REQUIRE_FALSE(mesh.ok());
    CHECK(allLocated(mesh.faults()));
    return mesh.faults()[0];
}

} // namespace

TEST_CASE("Import notes: drawings and maps tell what options change, whether or not the options are set") {
    const auto contentsOf = [](const std::string &text, Result<Domain> (*read)(const SourceText &), bool drops) {
        ImportNotes notes;
        SourceText source = sourceOf(text, "drawing");
        source.notes = &notes;
        source.options.dropLines = drops;
        REQUIRE(read(source).ok());
        return notes.contents();
    };
    const std::string area = R"({"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,3],[0,0]]]})";
    const std::string line = R"({"type": "LineString", "coordinates": [[2,1],[3,1]]})";
    const auto map = [](const std::string &parts) {
        return R"({"type": "GeometryCollection", "geometries": [)" + parts + "]}";
    };
    const std::string shapes = R"(<rect width="5" height="5"/><path d="M6 6h2v2zM1 1h1v1z"/>)";
    for (const bool drops : {false, true}) {
        CHECK(contentsOf(map(area + ',' + line), readGeoJson, drops).lines);
        CHECK_FALSE(contentsOf(map(area), readGeoJson, drops).lines);
        const DrawingContents filled = contentsOf(svgDrawing(shapes), readSvg, drops);
        CHECK_FALSE(filled.lines);
        CHECK(filled.filledShapes == 2);
        const DrawingContents inked =
            contentsOf(svgDrawing(shapes + R"(<path fill="none" stroke="black" d="M1 3h2"/>)"), readSvg, drops);
        CHECK(inked.lines);
        CHECK(inked.filledShapes == 2);
    }
    const DrawingContents outlines =
        contentsOf(svgDrawing(R"(<path fill="none" stroke="black" d="M1 1h5v5z"/>)"), readSvg, false);
    CHECK_FALSE(outlines.lines); // nothing is filled: they bound the domain
    CHECK(outlines.filledShapes == 0);
}

TEST_CASE("Import notes: GeoJSON reports reference system, heights, properties and unknown members") {
    const std::string text = R"({"type": "FeatureCollection", "title": "lake",
 "crs": {"type": "name", "properties": {"name": "EPSG:32632"}},
 "features": [
  {"type": "Feature", "id": 7, "properties": {"name": "lake", "depth": 3, "tag": "x"}, "geometry":
   {"type": "Polygon", "coordinates": [[[0,0,1],[4,0,1],[4,3,1],[0,0,1]]]}},
  {"type": "Feature", "properties": {"depth": 4}, "geometry": null}]})";
    ImportNotes notes;
    SourceText source = sourceOf(text, "lake.geojson");
    source.notes = &notes;
    REQUIRE(readGeoJson(source).ok());
    CHECK(codesOf(notes) == "crs 1 bad-tag 1 no-geometry 1 height 4 properties 1 members 2 ");
    const Diagnostics list = notes.diagnostics();
    CHECK(toString(list[0]) == "lake.geojson:2:9: note: coordinates in the reference system 'EPSG:32632' are used as "
                               "they are [crs]");
    CHECK(list[4].message == "properties other than \"name\" and \"tag\" are ignored: 'depth'");
    CHECK(list[5].message == "members that have no meaning here are ignored: 'id', 'title' (2 times)");
}

TEST_CASE("Import notes: mesh formats report what they skip; our own files cause no notes") {
    const TemporaryFolder folder;
    const TriMesh mesh = twoRegionMesh();
    for (const FileFormat &format : allFormats().list()) {
        if (format.writesMesh && format.readsMesh) {
            CAPTURE(format.id);
            const auto file = folder / (std::string(format.id) + format.extension);
            REQUIRE_FALSE(hasErrors(writeMesh(file, mesh, format.id)));
            ImportNotes notes;
            CHECK(allFormats().readMesh(file, {}, &notes).ok());
            CHECK(codesOf(notes).empty());
        }
    }
    ImportNotes notes;
    const std::string msh = written(writeMsh2, mesh) + "$Parametrizations\n0\n$EndParametrizations\n";
    SourceText source = sourceOf(msh);
    source.notes = &notes;
    CHECK(readMsh(source).ok());
    const std::string obj = written(writeObj, mesh) + "vn 0 0 1\nvn 0 0 1\n";
    source.text = obj;
    CHECK(readObj(source).ok());
    CHECK(codesOf(notes) == "section 1 statement 2 ");
}

TEST_CASE("Readers: refuse an element that refers to a node twice, with its place") {
    const Diagnostic obj = refusalOf(readObj(sourceOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 1\n")));
    CHECK(obj.line == 5);
    CHECK(obj.message == "face 2 refers to a node twice");
    const std::string medit =
        "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 0\n1 0 0\n0 1 0\nTriangles 1\n1 2 2 1\n";
    CHECK(refusalOf(readMedit(sourceOf(medit))).line == 8);
    const std::string nodes = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
    const std::string elements = "1 3 0\n1 3 2 3\n";
    CHECK(refusalOf(readTriangleParts(sourceOf(nodes), sourceOf(elements), nullptr)).line == 2);
    const std::string msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
                            "$Elements\n2\n1 2 2 1 1 1 2 3\n2 1 2 1 1 3 3\n$EndElements\n";
    CHECK(refusalOf(readMsh(sourceOf(msh))).line == 13);
    const std::string su2 = "NDIME= 2\nNELEM= 1\n5 0 1 0 0\nNPOIN= 3\n0 0\n1 0\n0 1\nNMARK= 0\n";
    CHECK(refusalOf(readSu2(sourceOf(su2))).line == 3);
    const std::string inp = "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n*ELEMENT, TYPE=CPS3\n1, 2, 3, 2\n";
    CHECK(refusalOf(readAbaqus(sourceOf(inp))).line == 6);
    const std::string vtk = "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n"
                            "0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 1\nCELL_TYPES 1\n5\n";
    CHECK(refusalOf(readVtk(sourceOf(vtk))).code == "degenerate-element");
    TriMesh mesh = twoRegionMesh();
    mesh.elements[3][2] = mesh.elements[3][0];
    CHECK(refusalOf(readMsh(sourceOf(written(writeMsh4Binary, mesh)))).code == "degenerate-element");
    CHECK(refusalOf(readVtu(sourceOf(written(writeVtu, mesh)))).code == "degenerate-element");
}

TEST_CASE("Project: faults of its domain carry the line and column of the nodes") {
    const TemporaryFolder folder;
    std::ofstream(folder / "bow.forefront") << R"({"format": "forefront", "version": 1, "shapes": [
  {"id": 1, "kind": "polygon", "nodes": [[0, 0],
    [4, 3], [4, 0], [0, 3]]}]})";
    const auto domain = allFormats().readDomain(folder / "bow.forefront");
    REQUIRE(domain.ok());
    const Diagnostics faults = allFormats().locateFaults(folder / "bow.forefront", validate(domain->domain));
    REQUIRE(!faults.empty());
    CHECK(faults[0].code == "crossing-segments");
    REQUIRE(faults[0].parts.size() == 2);
    CHECK(faults[0].line == 2);
    CHECK(faults[0].column == 42);
    CHECK(faults[0].parts[1].line == 3);
    CHECK(faults[0].parts[1].column == 13);
}

TEST_CASE("Files: bytes read earlier stand in for the file, with a detected or given format") {
    ImportOptions options;
    options.content =
        std::make_shared<const std::string>("{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1,0],[0,1]]]}");
    const auto domain = allFormats().readDomain("standard input", options);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    CHECK(domain->domain.segments.size() == 3);
    options.formatId = "poly";
    const auto wrong = allFormats().readDomain("standard input", options);
    REQUIRE_FALSE(wrong.ok());
    CHECK(wrong.faults()[0].file == "standard input");
    options.formatId = "step";
    const auto unknown = allFormats().readDomain("standard input", options);
    REQUIRE_FALSE(unknown.ok());
    CHECK(unknown.faults()[0].message == "unknown format 'step'");
}

TEST_CASE("SU2: what solvers alone use is skipped with its data, several zones are refused") {
    const std::string mesh = "NELEM= 1\n5 0 1 2 0\nNPOIN= 3\n0 0\n1 0\n0 1\n";
    const std::string solver = "FFD_NBOX= 1\nFFD_CORNER_POINTS= 2\n0 0\n1.5 -2\nFFD_TAG= BOX\n"
                               "NPERIODIC= 1\nPERIODIC_INDEX= 0\n0 0 0\n";
    ImportNotes notes;
    const std::string text =
        "NDIME= 2\nAOA_OFFSET= 0\n" + mesh + solver + "NMARK= 1\nMARKER_TAG= a\nMARKER_ELEMS= 1\n3 0 1\n";
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto read = triangles(readSu2(source));
    REQUIRE(read.ok());
    CHECK(read->elements.size() == 1);
    CHECK(read->edges.size() == 1);
    CHECK(notes.entries().size() == 4); // FFD boxes once
    CHECK(refusalOf(readSu2(sourceOf("NDIME= 2\n" + mesh + "7 8 9\n"))).line == 8);
    CHECK(refusalOf(readSu2(sourceOf("NZONE= 2\nNDIME= 2\n" + mesh))).code == "several-zones");
    CHECK(readSu2(sourceOf("NZONE= 1\nIZONE= 1\nNDIME= 2\n" + mesh)).ok());
}

TEST_CASE("MSH: points without a group that no element uses are left out") {
    const auto pointsOf = [](const std::string &points, ImportNotes &notes) {
        const std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 9 9 0\n"
                                 "$EndNodes\n$Elements\n2\n1 2 2 1 1 1 2 3\n" +
                                 points + "$EndElements\n";
        SourceText source = sourceOf(text);
        source.notes = &notes;
        const auto read = readMsh(source);
        REQUIRE(read.ok());
        return read->points.size();
    };
    ImportNotes centre, corner;
    CHECK(pointsOf("2 15 2 0 4 4\n", centre) == 0);
    REQUIRE_FALSE(centre.entries().empty());
    CHECK(centre.entries()[0].code == "lone-point");
    CHECK(pointsOf("2 15 2 0 1 1\n", corner) == 1);
    CHECK(corner.empty());
}

TEST_CASE("Import notes: many messages that differ only in what they quote are one") {
    ImportNotes notes;
    const std::string text = "a\nb\nc\n";
    const auto add = [&](const std::string &ids, std::size_t offset) {
        for (const char id : ids) {
            notes.add("svg-mask", "mask '" + std::string(1, id) + "' is missing", "drawing.svg", text, offset);
        }
    };
    add("aba", 0);
    add("cde", 2);
    notes.add("svg-mask", "masks are read as clips", "drawing.svg", text, 4);
    REQUIRE(notes.diagnostics().size() == 6); // few, so each keeps its place
    CHECK(notes.diagnostics()[0].message == "mask 'a' is missing (2 times)");
    CHECK(notes.diagnostics()[4].line == 2);
    add("f", 4);
    REQUIRE(notes.diagnostics().size() == 2);
    CHECK(notes.diagnostics()[0].message == "mask 'a' is missing (7 times; also 'b', 'c', 'd', 'e', 'f')");
    CHECK(notes.diagnostics()[0].line == 1);
    CHECK(notes.diagnostics()[1].message == "masks are read as clips");
    add("ghijk", 4);
    CHECK(notes.diagnostics()[0].message ==
          "mask 'a' is missing (12 times; also 'b', 'c', 'd', 'e', 'f', 'g', 'h' and others)");
    for (const char *word : {"marks", "parts", "names", "lines", "paths", "areas"}) { // an apostrophe quotes nothing
        notes.add("svg-mask", "the " + std::string(word) + "' ends and the " + word + "' sides", "drawing.svg", text,
                  0);
    }
    CHECK(notes.diagnostics().size() == 8);
    for (const char *word : {"Bob's", "a", "b", "c", "d", "e"}) {
        notes.add("layer", "layer '" + std::string(word) + "' of 'map' is empty", "map.json", text, 0);
    }
    REQUIRE(notes.diagnostics().size() == 9);
    CHECK(notes.diagnostics()[8].message ==
          "layer 'Bob's' of 'map' is empty (6 times; also 'a', 'map'; 'b', 'map'; 'c', 'map'; 'd', 'map'; 'e', 'map')");
}
