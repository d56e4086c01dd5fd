#include "core/drawing/commands/scale_document.hpp"
#include "core/drawing/commands/scale_sizes.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/lost_formulas.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/support/number_literal.hpp"

#include <doctest/doctest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

using namespace forefront;

TEST_CASE("scaleDocument: shapes, sizes, paint and the picture scale together; growth and numbers of elements do not") {
    Shape circle;
    circle.form = CircleForm{};
    circle.nodes = {{10, 10}, {14, 10}};
    circle.nodeSizes[1] = {2.0, 0.3};
    Document document = *addShape({}, circle);
    SizeSource source;
    source.a = {20, 10};
    source.radius = 2.0;
    source.growth = 0.1;
    source.endSize = 3.0;
    document.spacing.sources = {source};
    document.spacing.size = 5.0;
    document.spacing.maximum = 8.0;
    document.spacing.partSizes[3] = {4.0, 0.2};
    document.spacing.paint.origin = {10, 10};
    auto tile = std::make_shared<PaintedSpacing::Tile>();
    tile->fill(6.0F);
    document.spacing.paint.tiles[{0, 0}] = tile;
    document.regionMarkers = {{{12, 10}, 1, 9.0, 0.5, 0.3}};
    document.elementCounts[1] = {7, 0.2};
    document.picture = BackgroundPicture{.file = "/lake.png", .corner = {0, 0}, .size = {40, 20}};
    const Result<Document> scaled = scaleDocument(document, {10, 10}, 0.5);
    REQUIRE(scaled.ok());
    CHECK(scaled->shapes[0]->nodes == std::vector<Vec2>{{10, 10}, {12, 10}});
    CHECK(scaled->shapes[0]->nodeSizes.at(1) == PartSize{1.0, 0.3});
    const SpacingSpec &spacing = scaled->spacing;
    CHECK(spacing.sources[0].a == Vec2{15, 10});
    CHECK(spacing.sources[0].radius == 1.0);
    CHECK(spacing.sources[0].size == 0.5);
    CHECK(spacing.sources[0].endSize == 1.5);
    CHECK(spacing.sources[0].growth == 0.1);
    CHECK(spacing.size == 2.5);
    CHECK(spacing.maximum == 4.0);
    CHECK_FALSE(spacing.minimum.has_value());
    CHECK(spacing.partSizes.at(3) == PartSize{2.0, 0.2});
    CHECK(spacing.paint.pitch == 0.5);
    CHECK(spacing.paint.origin == Vec2{10, 10});
    CHECK((*spacing.paint.tiles.at({0, 0}))[5] == 3.0F);
    CHECK(scaled->regionMarkers[0].at == Vec2{11, 10});
    CHECK(scaled->regionMarkers[0].maxArea == 2.25);
    CHECK(scaled->regionMarkers[0].size == 0.25);
    CHECK(scaled->regionMarkers[0].growth == 0.3);
    CHECK(scaled->elementCounts == document.elementCounts);
    CHECK(scaled->picture->corner == Vec2{5, 5});
    CHECK(scaled->picture->size == Vec2{20, 10});
    CHECK_FALSE(scaleDocument(document, {}, 0.0).ok());
}

TEST_CASE("scaleDocument: formulas of lengths, areas and places are scaled") {
    Shape circle;
    circle.form = CircleForm{};
    circle.nodes = {{10, 10}, {14, 10}};
    Document document = *addShape({}, circle);
    document = *addRegionMarker(document, {{10, 10}, 1, 4.0});
    document.spacing.gradation = 0.4;
    document.formulas = {{"shape/1/radius"_number, "r"},
                         {"shape/1/x/0"_number, "2*r + 2"},
                         {"region/0/area"_number, "r"},
                         {"spacing/gradation"_number, "r/10"}};
    document = *setParameters(document, {{"r", "4"}});
    const Result<Document> scaled = scaleDocument(document, {10, 6}, 0.5);
    REQUIRE(scaled.ok());
    CHECK(scaled->formulas == std::map<NumberAddress, std::string>{{"shape/1/radius"_number, "0.5*(r)"},
                                                                   {"shape/1/x/0"_number, "5 + 0.5*(2*r + 2)"},
                                                                   {"region/0/area"_number, "0.25*(r)"},
                                                                   {"spacing/gradation"_number, "r/10"}});
    CHECK(lostFormulas(document, *scaled).empty());
    const Result<Document> wider = overrideParameters(*scaled, {{"r", "5"}});
    REQUIRE(wider.ok());
    CHECK(wider->shapes[0]->nodes == std::vector<Vec2>{{11, 8}, {13.5, 8}});
    const Result<Document> back = scaleDocument(*scaled, {10, 6}, 2.0);
    REQUIRE(back.ok());
    CHECK(back->formulas.at("shape/1/radius"_number) == "r");
}

TEST_CASE("lostFormulas: numbers that have become plain have names") {
    Shape circle;
    circle.form = CircleForm{};
    circle.nodes = {{10, 10}, {14, 10}};
    Document document = *addShape({}, circle);
    document = *addRegionMarker(document, {{10, 10}, 1, 4.0});
    document.formulas = {
        {"shape/1/radius"_number, "r"}, {"shape/1/x/0"_number, "2*r + 2"}, {"region/0/area"_number, "r"}};
    document = *setParameters(document, {{"r", "4"}});
    Document plain = document;
    plain.formulas = {{"shape/1/x/0"_number, "2*r + 2"}};
    const std::vector<NumberAddress> lost = lostFormulas(document, plain);
    REQUIRE(lost == std::vector{"region/0/area"_number, "shape/1/radius"_number});
    CHECK(numberName(document, lost[0]) == "maximum area of region marker 1");
    CHECK(numberName(document, lost[1]) == "radius of circle 1");
    Document others = plain; // as many as before
    others.spacing.size = 4.0;
    others.formulas["spacing/size"_number] = "r";
    others.formulas["shape/1/y/0"_number] = "r + 6";
    CHECK(lostFormulas(document, others) == lost);
}

TEST_CASE("scaleSizes: sizes and their formulas take the factor; limits and numbers of elements stay") {
    Shape circle;
    circle.form = CircleForm{};
    circle.nodes = {{10, 10}, {14, 10}};
    circle.nodeSizes[1] = {2.0, 0.3};
    Document document = *addShape({}, circle);
    document = *setParameters(document, {{"d", "4"}});
    document.spacing.size = 2.0;
    document.spacing.minimum = 0.1;
    document.spacing.maximum = 8.0;
    document.regionMarkers = {{{12, 10}, 1, 8.0, 0.5, 0.3}};
    document.elementCounts[1] = {7, 0.2};
    document = setFormula(document, {NumberOwner::ofSpacing(), Quantity::Size, 0}, "d/2");
    const Document scaled = scaleSizes(document, 0.5);
    CHECK(scaled.spacing.size == 1.0);
    CHECK(scaled.formulas.at({NumberOwner::ofSpacing(), Quantity::Size, 0}) == "0.5*(d/2)");
    CHECK(scaled.spacing.minimum == 0.1);
    CHECK(scaled.spacing.maximum == 8.0);
    CHECK(scaled.shapes.front()->nodeSizes.at(1).size == 1.0);
    CHECK(scaled.regionMarkers.front().size == 0.25);
    CHECK(scaled.regionMarkers.front().maxArea == 2.0);
    CHECK(scaled.elementCounts == document.elementCounts);
}
