#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/names/part_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/elevations.hpp"
#include "core/files/files.hpp"
#include "core/files/open_boundaries.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A square whose right side, of the tag 2, is open, with an elevation.
Document openSquare() {
    Document document = edit_test::documentOf({edit_test::square({0, 0}, 2)});
    const BoundaryPart right{.shapes = {}, .segments = {{document.shapes[0]->id, 1}}};
    document = *nameBoundaryPart(document, right, "sea");
    document.openBoundaries = {segmentTag(*document.shapes[0], 1)};
    document.parameters = {{"d", "4"}};
    document.elevation = "-d - 0.1*x";
    return document;
}

} // namespace

TEST_CASE("Open boundaries: only outer parts of a mesh can be open") {
    const TriMesh mesh = twoRegionMesh();
    const auto parts = boundaryPartsOf(mesh);
    CHECK(parts.size() == 4);
    for (const auto &[tag, name] : parts) {
        CHECK(name == boundaryName(mesh.boundaryNames, tag));
    }
    std::int32_t inner = 0;
    for (const TaggedEdge &edge : mesh.edges) {
        inner = parts.contains(edge.tag) ? inner : edge.tag;
    }
    REQUIRE(inner != 0);
    const std::int32_t last = parts.rbegin()->first, first = parts.begin()->first;
    CHECK(openPartsIn(mesh, std::vector{last, inner, first, 4711}) == std::vector{last, first});
    CHECK(hasCode(noteAllLand("x.14", {}, {}, "open one"), "no-open-boundary"));
    CHECK(noteAllLand("x.14", {}, {.openBoundaries = {first}}, "open one").empty());
    CHECK(noteAllLand("x.msh", {}, {}, "open one").empty());
}

TEST_CASE("Open boundaries: elevations above the sea everywhere are warned of") {
    CHECK(hasCode(warnOfDryElevations(std::vector{1.0, 0.5}), "dry-elevations"));
    CHECK(warnOfDryElevations(std::vector{1.0, -0.5}).empty());
    CHECK(warnOfDryElevations({}).empty());
}

TEST_CASE("Open boundaries: a project keeps them with the elevation, and refuses a tag twice") {
    const Document document = openSquare();
    const std::string text = projectText(document);
    CHECK(text.find("\"openBoundaries\": [2]") != std::string::npos);
    const Result<Document> back = parseProject(text, "bay.json");
    REQUIRE(back.ok());
    CHECK(back->openBoundaries == document.openBoundaries);
    CHECK(back->elevation == document.elevation);
    CHECK(projectText(Document()).find("openBoundaries") == std::string::npos);
    CHECK(projectText(Document()).find("elevation") == std::string::npos);
    const auto with = [&](const std::string &member) {
        return parseProject(R"({"format": "forefront", "version": 2, "shapes": [], )" + member + "}", "bay.json");
    };
    CHECK(with(R"("openBoundaries": [2, 3])").ok());
    for (const char *wrong :
         {R"("openBoundaries": [2, 2])", R"("openBoundaries": 2)", R"("openBoundaries": [0])", R"("elevation": 5)"}) {
        CAPTURE(wrong);
        const Result<Document> refused = with(wrong);
        REQUIRE_FALSE(refused.ok());
        CHECK(allLocated(refused.faults()));
    }
}

TEST_CASE("Open boundaries: they follow their tags, and the elevation its parameters") {
    const Document document = openSquare();
    CHECK(freeBoundaryTag(document) == 3);
    const Result<Document> renamed = renameParameter(document, 0, "deep");
    REQUIRE(renamed.ok());
    CHECK(renamed->elevation == "-deep - 0.1*x");
    const Result<Document> removed = removeParameter(document, 0);
    REQUIRE_FALSE(removed.ok());
    CHECK(removed.faults().front().message == "d is used by the elevation");

    Document unnamed = document; // a part with a tag of its own keeps what its tag had
    unnamed.boundaryNames.clear();
    unnamed = *setSegmentTag(unnamed, {{unnamed.shapes[0]->id, 3}}, 2);
    const BoundaryPart left{.shapes = {}, .segments = {{unnamed.shapes[0]->id, 3}}};
    const Result<Document> crack = setCrack(unnamed, left, false);
    REQUIRE(crack.ok());
    CHECK(crack->openBoundaries == std::vector{2, 3});

    Document other = edit_test::documentOf({edit_test::square({5, 0}, 2)});
    other.boundaryNames = {{1, "land"}};
    const Document both = *renameBoundaryTag(document, 2, "land");
    CHECK(both.openBoundaries == std::vector{2}); // a new name for all of it
    Document merged = document;
    merged.boundaryNames[1] = "land";
    CHECK(renameBoundaryTag(merged, 2, "land")->openBoundaries.empty()); // it becomes a part of the other
}
