#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/shapes/groups.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <string>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

using Ids = std::set<std::uint32_t>;

/// Returns five squares, of which 1 and 2 are a group.
Document fiveSquares() {
    const Document document = *addShapes(
        {}, {square({0, 0}, 1), square({4, 0}, 1), square({8, 0}, 1), square({12, 0}, 1), square({16, 0}, 1)});
    return *groupShapes(document, {1, 2});
}

} // namespace

TEST_CASE("Groups: shapes of a group are selected as one, without those that are hidden or locked") {
    Document document = fiveSquares();
    CHECK(shapesGroupedWith(document, 1) == Ids{1, 2});
    CHECK(shapesGroupedWith(document, 3) == Ids{3});
    document = *groupShapes(document, {3, 4, 5});
    document = *setLocked(document, {4}, true);
    CHECK(shapesGroupedWith(document, 3) == Ids{3, 5});
    Selection selection;
    selection.shapes = {1, 3};
    completeGroups(document, selection);
    CHECK(selection.shapes == Ids{1, 2, 3, 5});
}

TEST_CASE("Groups: a group takes in whole groups, and dissolves") {
    Document document = *groupShapes(fiveSquares(), {2, 3});
    CHECK(shapesGroupedWith(document, 1) == Ids{1, 2, 3});
    document = *ungroupShapes(document, {3});
    for (const auto &shape : document.shapes) {
        CHECK(shape->group == 0);
    }
    CHECK(ungroupShapes(document, {1}).faults().front().code == "not-possible");
    CHECK(groupShapes(document, {1}).faults().front().code == "not-possible");
    CHECK(groupShapes(document, {1, 99}).faults().front().code == "not-possible");
}

TEST_CASE("Groups: copies are groups of their own") {
    const Document document = fiveSquares();
    Selection both;
    both.shapes = {1, 2};
    const std::array maps{PlaneMap::translation({0, 4}), PlaneMap::translation({0, 8})};
    const Document copied = *copySelection(document, both, maps);
    REQUIRE(copied.shapes.size() == 9);
    CHECK(shapesGroupedWith(copied, 1) == Ids{1, 2});
    CHECK(shapesGroupedWith(copied, 6) == Ids{6, 7});
    CHECK(shapesGroupedWith(copied, 8) == Ids{8, 9});
    const Document inserted = insertDrawing(document, document, 1.0, nullptr);
    CHECK(shapesGroupedWith(inserted, 1) == Ids{1, 2});
    CHECK(shapesGroupedWith(inserted, 6) == Ids{6, 7});
}

TEST_CASE("Groups: a project keeps them, and one without groups is written as before") {
    const std::string text = projectText(fiveSquares());
    CHECK(text.find("\"group\": 1") != std::string::npos);
    const Result<Document> read = parseProject(text, "unit.json");
    REQUIRE(read.ok());
    CHECK(shapesGroupedWith(*read, 2) == Ids{1, 2});
    CHECK(projectText(*ungroupShapes(*read, {1})).find("\"group\"") == std::string::npos);
}

TEST_CASE("Groups: a project with large numbers of groups can be changed and saved") {
    std::string text = projectText(fiveSquares());
    for (std::size_t at = text.find("\"group\": 1"); at != std::string::npos; at = text.find("\"group\": 1", at + 1)) {
        text.replace(at, 10, "\"group\": 4294967294");
    }
    REQUIRE(text.find("4294967294") != std::string::npos);
    const Result<Document> read = parseProject(text, "large.forefront");
    REQUIRE(read.ok());
    CHECK(shapesGroupedWith(*read, 1) == Ids{1, 2});
    const Document grouped = *groupShapes(*groupShapes(*read, {3, 4}), {1, 5});
    const Result<Document> again = parseProject(projectText(grouped), "again.forefront");
    REQUIRE(again.ok());
    CHECK(shapesGroupedWith(*again, 1) == Ids{1, 2, 5});
    CHECK(shapesGroupedWith(*again, 3) == Ids{3, 4});
}
