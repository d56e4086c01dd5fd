#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/scale_document.hpp"
#include "core/drawing/document/number_address.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/files/files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

std::string exportedText(const char *format, LengthUnit unit, std::optional<Extrusion> extrusion = {}) {
    StringSink sink;
    ExportOptions options;
    options.unit = unit;
    options.extrusion = extrusion;
    REQUIRE(writeMesh(sink, samples::square(2, 1), format, options).empty());
    return sink.text;
}

Result<Document> readText(const char *name, const std::string &text) {
    const testing::TemporaryFolder folder;
    const std::filesystem::path file = folder / name;
    std::ofstream(file) << text;
    return readDocument(file);
}

std::string dxfWith(const std::string &header) {
    return "0\nSECTION\n2\nHEADER\n" + header +
           "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n2\n0\nENDSEC\n0\nEOF\n";
}

} // namespace

TEST_CASE("LengthUnit: conversions are exact, and words are those that users type") {
    CHECK(conversion(LengthUnit::Inch, LengthUnit::Millimetre) == 25.4);
    CHECK(conversion(LengthUnit::Foot, LengthUnit::Inch) == 12.0);
    CHECK(conversion(LengthUnit::Foot, LengthUnit::Metre) == 0.3048);
    CHECK(conversion(LengthUnit::Millimetre, LengthUnit::Kilometre) == 1e-6);
    CHECK(conversion(LengthUnit::Centimetre, LengthUnit::Metre) == 0.01);
    CHECK_FALSE(conversion(LengthUnit::None, LengthUnit::Metre).has_value());
    CHECK_FALSE(conversion(LengthUnit::Metre, LengthUnit::None).has_value());
    CHECK(metresPer(LengthUnit::Kilometre) == 1000.0);
    CHECK(typedUnit("km") == LengthUnit::Kilometre);
    CHECK(typedUnit("\"") == LengthUnit::Inch);
    CHECK(typedUnit("'") == LengthUnit::Foot);
    CHECK_FALSE(typedUnit("px").has_value());
    CHECK(unitSuffix(LengthUnit::None).empty());
    CHECK(unitSuffix(LengthUnit::Inch) == " in");
}

TEST_CASE("Unit: a project keeps it, and one without a unit is written as before") {
    Document document = *addShapes({}, {square({0, 0}, 1)});
    CHECK(projectText(document).find("\"unit\"") == std::string::npos);
    document.unit = LengthUnit::Millimetre;
    const std::string text = projectText(document);
    CHECK(text.find("\"unit\": \"mm\"") != std::string::npos);
    const Result<Document> read = parseProject(text, "unit.json");
    REQUIRE(read.ok());
    CHECK(read->unit == LengthUnit::Millimetre);
    std::string wrong = text;
    wrong.replace(wrong.find("\"mm\""), 4, "\"ell\"");
    const Result<Document> refused = parseProject(wrong, "unit.json");
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().message.find("unit") != std::string::npos);
}

TEST_CASE("Unit: drawings bring the unit of their file") {
    const Result<Document> inches = readText("a.dxf", dxfWith("9\n$INSUNITS\n70\n1\n"));
    REQUIRE(inches.ok());
    CHECK(inches->unit == LengthUnit::Inch);
    CHECK(readText("b.dxf", dxfWith(""))->unit == LengthUnit::None);
    CHECK(readText("c.dxf", dxfWith("9\n$INSUNITS\n70\n10\n"))->unit == LengthUnit::None); // yards
    const char *const rect = R"(<rect x="1" y="1" width="8" height="8" fill="#ccc"/></svg>)";
    const std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 20 10\"";
    CHECK(readText("a.svg", svg + " width=\"20mm\" height=\"10mm\">" + rect)->unit == LengthUnit::Millimetre);
    CHECK(readText("b.svg", svg + " width=\"2cm\" height=\"1cm\">" + rect)->unit == LengthUnit::Centimetre);
    CHECK(readText("c.svg", svg + " width=\"2in\" height=\"1in\">" + rect)->unit == LengthUnit::Inch);
    CHECK(readText("d.svg", svg + " width=\"20px\" height=\"10px\">" + rect)->unit == LengthUnit::None);
    CHECK(readText("e.svg", svg + ">" + rect)->unit == LengthUnit::None);
}

TEST_CASE("Unit: files of meshes name it where the format has a place, and are as before without one") {
    CHECK(exportedText("dxf", LengthUnit::Millimetre).find("9\n$INSUNITS\n70\n4\n") != std::string::npos);
    CHECK(exportedText("dxf-outline", LengthUnit::Foot).find("9\n$INSUNITS\n70\n2\n") != std::string::npos);
    CHECK(exportedText("inp", LengthUnit::Metre).find("** Unit of the coordinates: m\n") != std::string::npos);
    for (const char *format : {"msh2", "msh41"}) {
        const std::string text = exportedText(format, LengthUnit::Centimetre);
        CHECK(text.ends_with("Unit of the coordinates: cm\n$EndComments\n"));
        const Result<Mesh> read = [&] {
            const testing::TemporaryFolder folder;
            std::ofstream(folder / "a.msh") << text;
            return readMesh(folder / "a.msh");
        }();
        REQUIRE(read.ok());
        CHECK(read->nodes.size() == samples::square(2, 1).nodes.size());
    }
    CHECK(exportedText("msh2", LengthUnit::Inch, Extrusion{}).find("coordinates: in\n") != std::string::npos);
    CHECK(exportedText("inp", LengthUnit::Inch, Extrusion{}).find("coordinates: in\n") != std::string::npos);
    CHECK(exportedText("svg", LengthUnit::None).starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox="));
    for (const char *format : {"dxf", "inp", "msh2", "msh41"}) {
        const std::string text = exportedText(format, LengthUnit::None);
        CHECK(text.find("INSUNITS") == std::string::npos);
        CHECK(text.find("Unit of") == std::string::npos);
    }
}

TEST_CASE("Unit: an SVG picture has the size of the mesh") {
    const TriMesh mesh = samples::square(2, 1);
    const Vec2 size = MeshView(mesh).bounds().size();
    const double longer = std::max(size.x, size.y);
    const auto widthOf = [](const std::string &text, const std::string &unit) {
        const std::size_t at = text.find(" width=\"");
        REQUIRE(at != std::string::npos);
        std::istringstream in(text.substr(at + 8, text.find(unit + '"', at) - at - 8));
        double width = 0.0;
        in >> width;
        return width;
    };
    constexpr double kWithMargins = 1.02; // 10 of 1000 at each side
    CHECK(widthOf(exportedText("svg", LengthUnit::Metre), "mm") == doctest::Approx(1000.0 * kWithMargins * longer));
    CHECK(widthOf(exportedText("svg", LengthUnit::Foot), "in") == doctest::Approx(12.0 * kWithMargins * longer));
}

TEST_CASE("Unit: an empty drawing takes that of an inserted one, and pasted shapes are converted") {
    Document inches = *addShapes({}, {square({0, 0}, 2)});
    inches.unit = LengthUnit::Inch;
    CHECK(insertDrawing({}, inches, 1.0, nullptr).unit == LengthUnit::Inch);
    CHECK(insertDrawing({}, inches, 25.4, nullptr).unit == LengthUnit::None);
    Document millimetres;
    millimetres.unit = LengthUnit::Millimetre;
    const Result<Document> pasted = insertCopied(millimetres, inches, {1, -1}, nullptr);
    REQUIRE(pasted.ok());
    CHECK(pasted->unit == LengthUnit::Millimetre);
    CHECK(boundsOf(*pasted).size().x == doctest::Approx(2 * 25.4));
}

TEST_CASE(
    "Unit: what is pasted or inserted with another unit keeps its formulas, and its boundary layers their height") {
    Document inches = *addShapes({}, {makeShape(ShapeKind::Circle, {{0, 0}, {0.5, 0}})});
    inches.unit = LengthUnit::Inch;
    inches.formulas[*parseAddress("shape/1/radius")] = "r";
    inches = *setParameters(inches, {{"r", "0.5"}});
    LayerSpec layer;
    layer.tag = inches.shapes[0]->tag;
    layer.first = 0.01;
    layer.thickness = 0.1;
    inches.layers = {layer};
    Document millimetres;
    millimetres.unit = LengthUnit::Millimetre;
    const Result<Document> pasted = insertCopied(millimetres, inches, {1, -1}, nullptr);
    REQUIRE(pasted.ok());
    REQUIRE(pasted->shapes.size() == 1);
    const NumberAddress radius{NumberOwner::ofShape(pasted->shapes[0]->id), Quantity::Radius, 0};
    REQUIRE(pasted->formulas.contains(radius));
    CHECK(pasted->formulas.at(radius) == "r*in");
    CHECK(pasted->parameters == std::vector<Parameter>{{"r", "0.5"}, {"in", "25.4"}});
    const Document inserted = insertDrawing(millimetres, inches, 25.4, nullptr);
    for (const Document &next : {*pasted, inserted}) {
        REQUIRE(next.layers.size() == 1);
        CHECK(next.layers[0].first == doctest::Approx(0.254));
        CHECK(*next.layers[0].thickness == doctest::Approx(2.54));
    }
}

TEST_CASE("scaleDocument: the heights of boundary layers are scaled") {
    Document document = *addShapes({}, {square({0, 0}, 1)});
    LayerSpec layer;
    layer.first = 0.01;
    layer.thickness = 0.1;
    document.layers = {layer};
    const Result<Document> scaled = scaleDocument(document, {}, 1000.0);
    REQUIRE(scaled.ok());
    CHECK(scaled->layers[0].first == doctest::Approx(10.0));
    CHECK(*scaled->layers[0].thickness == doctest::Approx(100.0));
}
