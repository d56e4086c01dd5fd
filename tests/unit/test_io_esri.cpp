#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/files/esri/esri_grid.hpp"
#include "core/files/files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Three columns and two rows of cells of width 2 over (0, 0) to (6, 4); the upper right one has no value.
const std::string kHeader = "NCOLS 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value -9\n";
const std::string kGrid = kHeader + "1 2 -9\n3 4 5\n";

std::string faultIn(const std::string &text) {
    const auto spacing = readEsriGrid(sourceOf(text));
    REQUIRE_FALSE(spacing.ok());
    CHECK(allLocated(spacing.faults()));
    const Diagnostic &fault = spacing.faults().front();
    return std::to_string(fault.line) + ':' + std::to_string(fault.column) + ' ' + fault.code + ": " + fault.message;
}

} // namespace

TEST_CASE("ESRI grid: sizes hold at the centres of the cells, linear between, constant towards the edge") {
    const auto spacing = readEsriGrid(sourceOf(kGrid));
    REQUIRE_MESSAGE(spacing.ok(), messages(spacing.faults()));
    const Document document = edit_test::documentOf({edit_test::makeShape(ShapeKind::Rectangle, {{0, 0}, {6, 4}})});
    SpacingSpec steep = *spacing;
    steep.gradation = 10.0; // these sizes change too fast for the default
    const auto field = SpacingField::build(steep, toDomain(document));
    REQUIRE_MESSAGE(field.ok(), messages(field.faults()));
    const auto at = [&](Vec2 p) { return (*field)->at(p); };
    CHECK(at({1, 3}) == doctest::Approx(1)); // the first row is the highest
    CHECK(at({1, 1}) == doctest::Approx(3));
    CHECK(at({3, 1}) == doctest::Approx(4));
    CHECK(at({2, 1}) == doctest::Approx(3.5));
    CHECK(at({1, 2}) == doctest::Approx(2));
    CHECK(at({0.25, 0.5}) == doctest::Approx(3));
    CHECK(at({0, 4}) == doctest::Approx(1));
    CHECK(spacing->background->nodes.size() == 16);
    CHECK(spacing->background->elements.size() == 17);
}

TEST_CASE("ESRI grid: corners by the centre, other widths and heights, any line breaks") {
    const std::string text = "nrows 2 ncols 2\nxllcenter 10.5 yllcenter 21\ndx 1 dy 2\n1 1 1\n2";
    const auto spacing = readEsriGrid(sourceOf(text));
    REQUIRE_MESSAGE(spacing.ok(), messages(spacing.faults()));
    Box2 box;
    for (const Vec2 node : spacing->background->nodes) {
        box.add(node);
    }
    CHECK(box == Box2{{10, 20}, {12, 24}});
    CHECK(looksLikeEsriGrid(text));
    CHECK(looksLikeEsriGrid("\n ncols"));
    CHECK_FALSE(looksLikeEsriGrid("xllcorner 0"));
    CHECK_FALSE(looksLikeEsriGrid(" "));
}

TEST_CASE("ESRI grid: faults name the value, what was expected, and the place") {
    CHECK(faultIn(kHeader + "1 2 3\n4 0 6\n") == "8:3 bad-values: expected a size above 0, got 0");
    CHECK(faultIn(kHeader + "1 2 3\n4 x 6\n").starts_with("8:3 bad-number: "));
    CHECK(faultIn(kHeader + "1 2 3\n4 5\n").starts_with("9:1 "));
    CHECK(faultIn(kHeader + "1 2 3\n4 5 6\n7\n") == "9:1 bad-count: expected the end of the file after 6 values");
    CHECK(faultIn("ncols 2\nncols 3\n") == "2:1 duplicate-field: duplicate ncols");
    CHECK(faultIn("ncols 2.5\nnrows 2\n") == "1:1 bad-count: expected a whole number above 0 for ncols, got 2.5");
    CHECK(faultIn("ncols 2\n1 2\n") == "1:1 missing-field: the grid has no nrows");
    CHECK(faultIn("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\n1") == "1:1 missing-field: the grid has no cellsize");
    CHECK(faultIn("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 0\n1") ==
          "1:1 bad-number: expected a cellsize above 0, got 0");
    CHECK(faultIn("ncols 1\nnrows 1\nxllcorner 0\ncellsize 1\n1") == "1:1 missing-field: the grid has no yllcorner");
    CHECK(faultIn(kHeader + "-9 -9 -9\n-9 -9 -9\n").starts_with("1:1 no-values: "));
    CHECK(faultIn("ncols 1000\nnrows 1000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1").find("its 1000000 values") !=
          std::string::npos);
    CHECK(faultIn(kHeader + "1 2 3\n4 nan 6\n").starts_with("8:3 non-finite: "));
    CHECK(faultIn("ncols 400\nnrows 400\nxllcorner 0\nyllcorner 0\ncellsize 1\n1").find("bad-count") !=
          std::string::npos);
}

TEST_CASE("ESRI grid: NODATA_value nan marks cells without a size, as GDAL writes it") {
    for (const std::string none : {"nan", "-nan", "NaN"}) {
        const std::string header = kHeader.substr(0, kHeader.find("-9"));
        const auto usual = readEsriGrid(sourceOf(kGrid));
        const auto spacing = readEsriGrid(sourceOf(header + none + "\n1 2 " + none + "\n3 4 5\n"));
        REQUIRE_MESSAGE(spacing.ok(), messages(spacing.faults()));
        CHECK(spacing->background->values == usual->background->values);
    }
}

TEST_CASE("ESRI grid: more values than a spacing holds are averaged, and a note says so") {
    std::string text = "ncols 1001\nnrows 500\nxllcorner 0\nyllcorner 10\ncellsize 2\nNODATA_value -1\n";
    for (std::size_t row = 0; row < 500; ++row) {
        for (std::size_t column = 0; column < 1001; ++column) {
            text += column < 2 && row < 2 ? (column == 0 ? " 1"
                                             : row == 0  ? " -1"
                                                         : " 4")
                    : column >= 999       ? " -1"
                                          : " 3";
        }
    }
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto spacing = readEsriGrid(source);
    REQUIRE_MESSAGE(spacing.ok(), messages(spacing.faults()));
    Box2 box;
    for (const Vec2 node : spacing->background->nodes) {
        box.add(node);
    }
    CHECK(box.min == Vec2{0, 10});
    CHECK(box.max.y == 1010.0);
    CHECK(spacing->background->nodes.size() < 252'000);
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].message == "the grid has 1001 x 500 values; averaged to 501 x 250");
    const auto &values = spacing->background->values;
    CHECK(std::count(values.begin(), values.end(), 2.0) == 4); // the mean of 1, 1 and 4, repeated at the corner
}

TEST_CASE("ESRI grid: sizes of cells without neighbours are not used, and a note says so") {
    ImportNotes notes;
    SourceText source = sourceOf("ncols 5\nnrows 5\nxllcorner 0\nyllcorner 0\ncellsize 1\nnodata_value 0\n"
                                 "1 1 0 0 0\n1 1 0 0 0\n0 0 0 0 0\n0 0 0 2 0\n0 0 0 0 0\n");
    source.notes = &notes;
    REQUIRE(readEsriGrid(source).ok());
    REQUIRE(notes.diagnostics().size() == 1);
    CHECK(notes.diagnostics()[0].code == "isolated-sizes");
    CHECK(notes.diagnostics()[0].message.starts_with("1 cell has a size not used: "));
}

TEST_CASE("ESRI grid: read by its name or content, kept in the project") {
    const TemporaryFolder folder;
    const auto file = folder / "sizes.asc";
    std::ofstream(file) << kGrid;
    const auto spacing = allFormats().readSpacing(file);
    REQUIRE_MESSAGE(spacing.ok(), messages(spacing.faults()));
    Document document;
    document.spacing = *spacing;
    const Result<Document> read = parseProject(projectText(document), "test");
    REQUIRE(read.ok());
    CHECK(sameContent(read->spacing, document.spacing));
    const auto domain = allFormats().readDomain(file);
    REQUIRE_FALSE(domain.ok());
    CHECK(domain.faults().front().message == "ESRI ASCII grid cannot be read here");
}
