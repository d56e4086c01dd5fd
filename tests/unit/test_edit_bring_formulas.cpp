#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/bring_formulas.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/clipboard/clipboard.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/plate_sample.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

TEST_CASE("insertCopied: formulas come along with the parameters that they use") {
    const Document other = plate();
    Selection all = selectAll(other);
    const Result<Document> copied = readClipboard(clipboardText(other, all));
    REQUIRE(copied.ok());
    CHECK(copied->formulas == other.formulas);
    const Document pasted = *insertCopied({}, *copied, {1, -1}, nullptr);
    CHECK(pasted.parameters == other.parameters);
    CHECK(pasted.formulas == other.formulas);

    SUBCASE("they share a parameter with the same meaning") {
        const Document twice = *insertCopied(pasted, *copied, {1, -1}, nullptr);
        CHECK(twice.parameters == other.parameters);
        CHECK(twice.formulas.at("shape/4/radius"_number) == "r");
        CHECK(twice.formulas.at("source/1/size"_number) == "r/2");
    }
    SUBCASE("one with another meaning gets a free name, and so does what depends on it") {
        const Document here = *setParameters(pasted, {{"gap", "2*r"}, {"r", "3"}, {"r_2", "1"}});
        const Document both = *insertCopied(here, *copied, {1, -1}, nullptr);
        CHECK(both.formulas.at("shape/2/radius"_number) == "r");
        CHECK(both.formulas.at("shape/4/radius"_number) == "r_3");
        CHECK(both.formulas.at("shape/3/width"_number) == "2*gap_2");
        CHECK(both.parameters.back() == Parameter{"r_3", "0.5"});
        CHECK(both.parameters[3] == Parameter{"gap_2", "2*r_3"});
        const Result<Document> changed = overrideParameters(both, {{"r_3", "0.75"}});
        REQUIRE(changed.ok());
        CHECK(circleRadius(*changed->shapes[3]) == doctest::Approx(0.75));
        CHECK(circleRadius(*changed->shapes[1]) == doctest::Approx(3.0));
    }
    SUBCASE("places beside the copied ones have the shift in their formulas") {
        Document moved = other;
        moved.formulas["shape/2/x/0"_number] = "2*r";
        const Document beside = *insertCopied(moved, moved, {1, -1}, nullptr);
        CHECK(beside.formulas.at("shape/2/x/0"_number) == "2*r");
        CHECK(beside.formulas.at("shape/4/x/0"_number) == "2*r + 1");
        CHECK(beside.formulas.contains("shape/4/radius"_number));
    }
    SUBCASE("scaled drawings have scaled formulas") {
        const Document scaled = insertDrawing({}, other, 10.0, nullptr);
        CHECK(scaled.formulas.at("shape/2/radius"_number) == "10*(r)");
        CHECK(circleRadius(*overrideParameters(scaled, {{"r", "1"}})->shapes[1]) == doctest::Approx(10.0));
    }
}

TEST_CASE("bringParameters: refuses more parameters than a document can have") {
    std::vector<Parameter> many;
    for (std::size_t k = 0; k < kMaxParameters; ++k) {
        many.push_back({"p" + std::to_string(k), "1"});
    }
    Document document = *setParameters({}, many);
    NameChanges changes;
    CHECK(bringParameters(document, {{"p0", "1"}}, {"p0"}, changes));
    CHECK_FALSE(bringParameters(document, {{"q", "1"}}, {"q"}, changes));
    CHECK(document.parameters == many);
}

TEST_CASE("setSpacing: parameters of the expression come along with their values") {
    const Document here = *setParameters({}, {{"r", "0.5"}, {"gap", "0.125"}});
    SpacingSpec spacing;
    spacing.expression = "gap + r*x + s";
    spacing.names = {{"gap", 0.125}, {"r", 2.0}, {"s", 0.1}, {"unused", 1.0}};
    const Result<Document> next = setSpacing(here, spacing);
    REQUIRE(next.ok());
    CHECK(*next->spacing.expression == "gap + r_2*x + s");
    CHECK(next->parameters == std::vector<Parameter>{{"r", "0.5"}, {"gap", "0.125"}, {"r_2", "2"}, {"s", "0.1"}});
    CHECK(next->spacing.names.at("r_2") == 2.0);
    const auto field = SpacingField::build(next->spacing, toDomain(*addShape(*next, square({0, 0}, 1))));
    REQUIRE(field.ok());
}

TEST_CASE("copySelection: copies follow the same formulas, with the shift in those of places") {
    Document document = plate();
    document.formulas["shape/2/x/0"_number] = "gap";
    pruneFormulas(document);
    REQUIRE(document.formulas.contains("shape/2/x/0"_number));
    Selection hole;
    hole.shapes = {2};
    hole.sources = {0};
    document = *addRegionMarker(document, {{1, 1}, 1, 0.5});
    document.formulas["region/0/area"_number] = "r";
    hole.markers = {0};
    const Result<Document> copied = linearArray(document, hole, 3, {2, 0});
    REQUIRE(copied.ok());
    CHECK(copied->formulas.at("region/2/area"_number) == "r");
    CHECK(copied->formulas.at("shape/3/radius"_number) == "r");
    CHECK(copied->formulas.at("shape/4/radius"_number) == "r");
    CHECK(copied->formulas.at("source/2/size"_number) == "r/2");
    CHECK(copied->formulas.at("shape/3/x/0"_number) == "gap + 2");
    const Result<Document> larger = overrideParameters(*copied, {{"r", "0.75"}});
    REQUIRE(larger.ok());
    CHECK(circleRadius(*larger->shapes[3]) == doctest::Approx(0.75));
}

TEST_CASE("bringParameters: one with the same name and value is shared, however it is written") {
    Document here = *setParameters({}, {{"w", "0.2"}, {"h", "2*w"}});
    const std::vector<Parameter> before = here.parameters;
    NameChanges changes;
    SUBCASE("a constant and an expression") {
        CHECK(bringParameters(here, {{"h", "0.4"}}, {"h"}, changes));
        CHECK(here.parameters == before);
    }
    SUBCASE("what a shared one depends on stays behind") {
        CHECK(bringParameters(here, {{"w", "0.8"}, {"h", "w/2"}}, {"h"}, changes));
        CHECK(here.parameters == before);
    }
    SUBCASE("one that depends on another value has another value itself") {
        CHECK(bringParameters(here, {{"w", "0.8"}, {"h", "w/2"}}, {"h", "w"}, changes));
        CHECK(here.parameters == std::vector<Parameter>{{"w", "0.2"}, {"h", "2*w"}, {"w_2", "0.8"}});
        CHECK(changes == NameChanges{{"w", "w_2"}});
    }
}

TEST_CASE("setSpacing: an expression of a parameter that is a formula here keeps its name") {
    const Document here = *setParameters({}, {{"w", "0.2"}, {"h", "2*w"}});
    SpacingSpec spacing;
    spacing.expression = "h + x";
    spacing.names = {{"h", here.spacing.names.at("h")}};
    const Result<Document> next = setSpacing(here, spacing);
    REQUIRE(next.ok());
    CHECK(*next->spacing.expression == "h + x");
    CHECK(next->parameters == here.parameters);
}

TEST_CASE("insertDrawing: warns of formulas that become plain numbers because there would be too many parameters") {
    std::vector<Parameter> many;
    for (std::size_t k = 0; k < kMaxParameters; ++k) {
        many.push_back({"p" + std::to_string(k), "1"});
    }
    const Document full = *setParameters({}, many);
    Insertion insertion;
    const Document next = insertDrawing(full, plate(), 1.0, &insertion);
    CHECK(next.formulas.empty());
    CHECK(next.shapes.size() == 2);
    REQUIRE(insertion.notes.size() == 1);
    CHECK(insertion.notes[0].code == "dropped-formulas");
    CHECK(insertion.notes[0].severity == Severity::Warning);
    CHECK(insertion.notes[0].message ==
          "2 formulas became plain numbers; the document would need more than 1000 parameters");
    insertDrawing({}, plate(), 1.0, &insertion);
    CHECK(insertion.notes.empty());
}

TEST_CASE("freeParameterName: counts on from the first number, within the greatest length") {
    CHECK(freeParameterName("p", 1, {}) == "p1");
    CHECK(freeParameterName("r_", 2, {"r_2", "r_3"}) == "r_4");
    const std::string longest(kMaxParameterName, 'a');
    CHECK(freeParameterName(longest, 10, {}) == longest.substr(2) + "10");
}
