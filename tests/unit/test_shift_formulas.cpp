#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <array>
#include <map>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

using Formulas = std::map<NumberAddress, std::string>;

/// A polygon, a rectangle, a slot, a source and a marker with formulas of a parameter w = 2.
Document sample() {
    Document document = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {2, 0}, {2, 5}}),
                                    makeShape(ShapeKind::Rectangle, {{2, 0}, {4, 3}}), slotAround({2, 1}, {5, 1}, 1)});
    SizeSource source;
    source.shape = SourceShape::Line;
    source.a = {2, 2};
    source.b = {4, 4};
    document = *addSource(document, source);
    document = *addRegionMarker(document, {{2, 1}, 3});
    document.formulas = {{"shape/1/x/1"_number, "w"},   {"shape/1/x/2"_number, "w"},   {"shape/2/left"_number, "w"},
                         {"shape/2/width"_number, "w"}, {"shape/3/x/0"_number, "w"},   {"shape/3/width"_number, "w"},
                         {"source/0/x"_number, "w"},    {"source/0/y2"_number, "2*w"}, {"region/0/x"_number, "w"},
                         {"shape/1/y/2"_number, "w+3"}};
    return *setParameters(document, {{"w", "2"}});
}

Selection everything() {
    Selection all = selected({1, 2, 3});
    all.sources = {0};
    all.markers = {0};
    return all;
}

/// Returns the formula of x of a point at x = 2 after some moves along x, each carried over as by the editor.
std::string movedText(const std::string &text, const std::vector<double> &moves) {
    Document document = documentOf({makeShape(ShapeKind::Point, {{2, 0}})});
    document.formulas = {{"shape/1/x/0"_number, text}};
    document = *setParameters(document, {{"w", "2"}});
    for (const double by : moves) {
        Document next = *transformSelection(document, selected({1}), PlaneMap::translation({by, 0}));
        carryFormulas(document, next);
        document = std::move(next);
    }
    const auto found = document.formulas.find("shape/1/x/0"_number);
    return found != document.formulas.end() ? found->second : std::string();
}

} // namespace

TEST_CASE("transformSelection: formulas of places move with whole shapes, sources and markers") {
    const Document before = sample();
    Document moved = *transformSelection(before, everything(), PlaneMap::translation({3, -1}));
    carryFormulas(before, moved);
    CHECK(moved.formulas == Formulas{{"shape/1/x/1"_number, "w + 3"},
                                     {"shape/1/x/2"_number, "w + 3"},
                                     {"shape/1/y/2"_number, "w+3 - 1"},
                                     {"shape/2/left"_number, "w + 3"},
                                     {"shape/2/width"_number, "w"},
                                     {"shape/3/x/0"_number, "w + 3"},
                                     {"shape/3/width"_number, "w"},
                                     {"source/0/x"_number, "w + 3"},
                                     {"source/0/y2"_number, "2*w - 1"},
                                     {"region/0/x"_number, "w + 3"}});
    const Result<Document> wider = overrideParameters(moved, {{"w", "4"}});
    REQUIRE(wider.ok());
    CHECK(wider->shapes[0]->nodes == std::vector<Vec2>{{3, -1}, {7, -1}, {7, 6}});
    CHECK(boundsOf(*wider->shapes[1]) == Box2{{7, -1}, {11, 2}});
    CHECK(wider->regionMarkers[0].at == Vec2{7, 0});
    // Nodes that are moved alone are placed anew.
    Selection node;
    node.nodes = {{1, 1}};
    Document placed = *transformSelection(before, node, PlaneMap::translation({3, 0}));
    carryFormulas(before, placed);
    CHECK_FALSE(placed.formulas.contains("shape/1/x/1"_number));
    CHECK(placed.formulas.at("shape/1/x/2"_number) == "w");
}

TEST_CASE("transformSelection: formulas stay short when they move again and again") {
    CHECK(movedText("w", {3, -1}) == "w + 2");
    CHECK(movedText("w", {3, -3}) == "w");
    CHECK(movedText("w", {0.1, 0.2, 0.3}) == "w + 0.6");
    CHECK(movedText("w - 0", {-1.5}) == "w - 1.5");
    CHECK(movedText("4 - w", {1}) == "4 - w + 1");
    CHECK(movedText("w > 1 ? 2 : w + 3", {1}) == "(w > 1 ? 2 : w + 3) + 1");
    CHECK(movedText("w * - 3 + 8", {1}) == "w * - 3 + 9");
    CHECK(movedText("8 + w * - 3", {1}) == "8 + w * - 3 + 1");
    CHECK(movedText("(w - 0)", {1}) == "(w - 0) + 1");
    CHECK(movedText("w", {0}) == "w");
    CHECK(movedText("w + 1e6 - 1000000", {1e-7}).starts_with("w + 1e6 - 999999.9999999"));
}

TEST_CASE("Copies, aligned shapes and pasted ones keep the formulas of their places") {
    const Document before = sample();
    Selection copies;
    const Document copied = *linearArray(before, everything(), 2.0, {10, 0}, &copies);
    CHECK(copied.formulas.at("shape/4/x/1"_number) == "w + 10");
    CHECK(copied.formulas.at("source/1/x"_number) == "w + 10");
    CHECK(copied.formulas.at("region/1/x"_number) == "w + 10");
    CHECK(copied.formulas.at("shape/1/x/1"_number) == "w");
    Document aligned = *alignSelection(before, selected({1, 2}), Alignment::Left);
    carryFormulas(before, aligned);
    CHECK(aligned.formulas.at("shape/2/left"_number) == "w - 2");
    CHECK(aligned.formulas.at("shape/1/x/1"_number) == "w");
    const Document pasted = *insertCopied(before, before, {1, -1}, nullptr);
    CHECK(pasted.formulas.at("shape/4/x/1"_number) == "w + 1");
    CHECK(pasted.formulas.at("source/1/y2"_number) == "2*w - 1");
    // A turn changes other coordinates, too.
    const Document turned = *copySelection(before, everything(), std::array{PlaneMap::rotation(90, {0, 0})});
    CHECK_FALSE(turned.formulas.contains("shape/4/x/1"_number));
    CHECK(turned.formulas.at("shape/6/width"_number) == "w");
}
