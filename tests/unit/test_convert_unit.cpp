#include "core/drawing/commands/convert_unit.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/length_unit.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace forefront {
namespace {

using namespace constraint_test;
using namespace edit_test;

/// A circle in millimetres whose diameter is driven by a parameter, with a region that is limited by another.
Document drivenCircle() {
    Document document = documentOf({makeShape(ShapeKind::Circle, {{10, 20}, {18, 20}})});
    document.unit = LengthUnit::Millimetre;
    constrain(document, ConstraintKind::Diameter, {segment(1)});
    document.regionMarkers.push_back({{10, 20}, 1, 4.0});
    document = *setParameters(document, {{"d", "16"}, {"t", "d/8"}});
    document.formulas[{NumberOwner::ofConstraint(document.constraints[0]->id), Quantity::Value}] = "d";
    document.formulas[{NumberOwner::ofShape(1), Quantity::X, 0}] = "d - 6";
    document.formulas[{NumberOwner::ofRegion(0), Quantity::Area}] = "t^2";
    pruneFormulas(document);
    REQUIRE(document.formulas.size() == 3);
    return document;
}

std::vector<std::string> textsOf(const Document &document) {
    std::vector<std::string> texts;
    for (const auto &[address, text] : document.formulas) {
        texts.push_back(text);
    }
    return texts;
}

Document converted(const Document &document, LengthUnit unit) {
    Result<Document> next = convertUnit(document, unit);
    REQUIRE_MESSAGE(next.ok(), messageOf(next));
    Document kept = *next;
    pruneFormulas(kept);
    CHECK(kept.formulas == next->formulas); // each gives the value of its number
    return *std::move(next);
}

} // namespace

TEST_CASE("Unit: formulas name the unit of their parameters, and lose it in that unit") {
    const Document millimetres = drivenCircle();
    const Document inches = converted(millimetres, LengthUnit::Inch);
    CHECK(textsOf(inches) == std::vector<std::string>{"d*mm", "t^2*mm^2", "(d - 6)*mm"});
    CHECK(inches.parameters == std::vector<Parameter>{{"d", "16"}, {"t", "d/8"}, {"mm", "1/25.4"}});
    CHECK(inches.constraints[0]->value == doctest::Approx(16.0 / 25.4));
    CHECK(circleRadius(*inches.shapes[0]) == doctest::Approx(8.0 / 25.4));
    checkAllHold(inches);

    const Document metres = converted(inches, LengthUnit::Metre);
    CHECK(textsOf(metres) == textsOf(inches));
    CHECK(metres.parameters[2] == Parameter{"mm", "0.001"});
    CHECK(circleRadius(*metres.shapes[0]) == doctest::Approx(0.008));

    const Document back = converted(metres, LengthUnit::Millimetre);
    CHECK(back.formulas == millimetres.formulas);
    CHECK(back.parameters == millimetres.parameters);
    CHECK(circleRadius(*back.shapes[0]) == doctest::Approx(8.0));
}

TEST_CASE("Unit: a parameter keeps its number and its meaning, so that --set means the same in every unit") {
    for (const LengthUnit unit : {LengthUnit::Inch, LengthUnit::Metre, LengthUnit::Foot}) {
        const Document document = converted(drivenCircle(), unit);
        const Result<Document> set = overrideParameters(document, {{"d", "20"}});
        REQUIRE_MESSAGE(set.ok(), messageOf(set));
        CHECK(circleRadius(*set->shapes[0]) == doctest::Approx(10.0 * *conversion(LengthUnit::Millimetre, unit)));
        CHECK(set->formulas == document.formulas);
    }
}

TEST_CASE("Unit: formulas in several units each keep theirs") {
    Document inches = converted(drivenCircle(), LengthUnit::Inch);
    inches = *addShapes(inches, {makeShape(ShapeKind::Circle, {{9, 9}, {11, 9}})});
    inches = *setParameters(inches, {{"d", "16"}, {"t", "d/8"}, {"mm", "1/25.4"}, {"g", "2"}});
    const NumberAddress radius{NumberOwner::ofShape(inches.shapes[1]->id), Quantity::Radius, 0};
    inches.formulas[radius] = "g";
    const Document feet = converted(inches, LengthUnit::Foot);
    CHECK(feet.formulas.at(radius) == "g*in");
    CHECK(textsOf(feet)[0] == "d*mm");
    const Document back = converted(feet, LengthUnit::Inch);
    CHECK(back.formulas == inches.formulas);
    CHECK(back.parameters == inches.parameters);
}

TEST_CASE("Unit: a parameter for a unit that is used in another way keeps its value, and numbers stay right") {
    Document inches = converted(drivenCircle(), LengthUnit::Inch);
    inches.parameters.push_back({"w", "3*mm"}); // would be another length
    inches.spacing.names = parameterValues(inches.parameters);
    const Document feet = converted(inches, LengthUnit::Foot);
    CHECK(feet.parameters[2] == Parameter{"mm", "1/25.4"});
    CHECK(textsOf(feet) == std::vector<std::string>{"d*mm*in", "t^2*mm^2*in^2", "(d - 6)*mm*in"});
    CHECK(circleRadius(*feet.shapes[0]) == doctest::Approx(8.0 / 304.8));
}

TEST_CASE("Unit: a parameter that has the name of a unit is not taken for it") {
    Document document = drivenCircle();
    document.parameters.push_back({"mm", "7"});
    document.spacing.names = parameterValues(document.parameters);
    const Document inches = converted(document, LengthUnit::Inch);
    CHECK(textsOf(inches)[0] == "d*unit_mm");
    CHECK(inches.parameters[2] == Parameter{"mm", "7"});
    const Document back = converted(inches, LengthUnit::Millimetre);
    CHECK(back.formulas == document.formulas);
    CHECK(back.parameters == document.parameters);
}

TEST_CASE("Unit: without a unit before or after, nothing but the unit changes") {
    Document document = drivenCircle();
    document.unit = LengthUnit::None;
    const Document metres = converted(document, LengthUnit::Metre);
    CHECK(metres.unit == LengthUnit::Metre);
    CHECK(metres.shapes == document.shapes);
    CHECK(metres.formulas == document.formulas);
    CHECK(convertUnit(metres, LengthUnit::None)->formulas == document.formulas);
}

} // namespace forefront
