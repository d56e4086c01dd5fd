#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <string>

using namespace forefront;
using namespace forefront::edit_test;

TEST_CASE("nameBoundaryPart: a new name for one segment makes a new tag and leaves the other shapes alone") {
    const Document document = *addShapes({}, {square({0, 0}, 10), square({2, 2}, 6)});
    const Document named = *nameBoundaryPart(document, {.shapes = {}, .segments = {{1, 2}}}, "inlet");
    CHECK(segmentTag(*named.shapes[0], 2) == 2);
    CHECK(named.boundaryNames == std::map<std::int32_t, std::string>{{2, "inlet"}});
    for (const std::size_t k : {0U, 1U, 3U}) {
        CHECK(segmentTag(*named.shapes[0], k) == 1);
        CHECK(segmentTag(*named.shapes[1], k) == 1);
    }
    // The only part with its tag keeps the tag when renamed; a name that is already known gives it that name's tag.
    const Document renamed = *nameBoundaryPart(named, {.shapes = {}, .segments = {{1, 2}}}, "outlet");
    CHECK(renamed.boundaryNames == std::map<std::int32_t, std::string>{{2, "outlet"}});
    const Document joined = *nameBoundaryPart(renamed, {.shapes = {2}, .segments = {}}, "outlet");
    CHECK(joined.shapes[1]->tag == 2);
    CHECK(joined.boundaryNames.size() == 1);
}

TEST_CASE("nameBoundaryPart: an empty name separates a part from a shared name; refuses an empty selection") {
    Document document = *addShapes({}, {square({0, 0}, 10), square({2, 2}, 6)});
    document = *setBoundaryName(document, 1, "wall");
    const Document freed = *nameBoundaryPart(document, {.shapes = {2}, .segments = {}}, "");
    CHECK(freed.shapes[0]->tag == 1);
    CHECK(freed.shapes[1]->tag == 2);
    CHECK(freed.boundaryNames == std::map<std::int32_t, std::string>{{1, "wall"}});
    CHECK(nameBoundaryPart(document, {}, "x").faults().front().code == "not-possible");
}

TEST_CASE("nameRegionOf: a new name makes a new region; the other markers keep theirs") {
    Document document = *addShapes({}, {square({0, 0}, 10), square({20, 0}, 6)});
    document = *addRegionMarker(*addRegionMarker(document, {{1, 1}, 2}), {{21, 1}, 2});
    document = *setRegionName(document, 2, "sand");
    const Document named = *nameRegionOf(document, 1, "clay");
    CHECK(named.regionMarkers[0].tag == 2);
    CHECK(named.regionMarkers[1].tag == 3);
    CHECK(named.regionNames == std::map<std::int32_t, std::string>{{2, "sand"}, {3, "clay"}});
    CHECK(nameRegionOf(named, 1, "sand")->regionMarkers[1].tag == 2);
    CHECK(nameRegionOf(document, 2, "x").faults().front().code == "no-such-marker");
}

TEST_CASE("renameBoundaryTag: nothing is left of a tag that is renamed to another one's name") {
    Document document = documentOf({square({0, 0}, 1), square({3, 0}, 1)});
    document = *setShapeTag(document, {2}, 5);
    document.boundaryNames = {{1, "wall"}, {5, "inlet"}, {7, "nobody's"}};
    document = *setPartSize(document, 5, PartSize{0.1, 0.2});
    Document merged = *renameBoundaryTag(document, 5, "wall");
    CHECK(merged.shapes[1]->tag == 1);
    CHECK(merged.boundaryNames == std::map<std::int32_t, std::string>{{1, "wall"}, {7, "nobody's"}});
    CHECK(merged.spacing.partSizes.empty());
    const Result<Document> unused = renameBoundaryTag(merged, 7, "wall"); // that no shape has
    REQUIRE(unused.ok());
    CHECK(unused->boundaryNames.size() == 1);
    CHECK(renameBoundaryTag(document, 5, "outlet")->boundaryNames.at(5) == "outlet");
}

TEST_CASE("freeBoundaryTag: a new tag has no size that a deleted part has left") {
    Document document = documentOf({square({0, 0}, 1)});
    CHECK(freeBoundaryTag(document) == 2);
    document.spacing.partSizes[4] = {0.1, 0.2};
    CHECK(freeBoundaryTag(document) == 5);
    document.elementCounts[8] = {10, 0.2};
    CHECK(freeBoundaryTag(document) == 9);
}
