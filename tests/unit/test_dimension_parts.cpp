#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/constraints/sketch_state.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/source/import_notes.hpp"
#include "core/files/source/source.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace forefront::constraint_test {

using namespace edit_test;
using Kind = ConstraintKind;

TEST_CASE("Dimensions: lines that are not parallel have no distance") {
    const Document slanted = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 3}, {0, 2}})});
    const Result<SketchConstraint> made = makeConstraint(slanted, Kind::Distance, {segment(1, 0), segment(1, 2)});
    REQUIRE_FALSE(made.ok());
    CHECK(made.faults().front().code == "bad-constraint");
    CHECK(made.faults().front().message ==
          "Distance 1: segment 1 of polygon 1 and segment 3 of polygon 1 are not parallel");
    CHECK(made.faults().front().advice == "add an angle, or make them parallel first");
    CHECK(makeConstraint(slanted, Kind::Angle, {segment(1, 0), segment(1, 2)}).ok());

    // A side that is turned afterwards makes the distance one that does not hold; a project with it says so.
    Document document = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 3}, {0, 3}})});
    constrain(document, Kind::Distance, {segment(1, 0), segment(1, 2)});
    CHECK(sketchState(document).violated.empty());
    const Result<Document> turned = setHandle(document, {1, 3}, {0, 2});
    REQUIRE(turned.ok());
    CHECK(sketchState(*turned).violated == std::set<std::uint32_t>{document.constraints.back()->id});
    ImportNotes notes;
    const std::string text = projectText(*turned);
    SourceText source;
    source.text = text;
    source.notes = &notes;
    REQUIRE(readProjectText(source).ok());
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].message.starts_with("constraint 'Distance 1': its lines are not parallel"));
    CHECK(notes.entries()[0].severity == Severity::Warning);
    REQUIRE(addConstraint(*turned, *turned->constraints.back()).faults().front().code == "bad-constraint");
}

TEST_CASE("Dimensions: a value that a formula or a lock sets is refused with its name") {
    Document document =
        documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {8, 0}}), makeShape(ShapeKind::Circle, {{30, 0}, {34, 0}})});
    document.parameters = {{"d", "16"}};
    document.spacing.names = {{"d", 16.0}};
    document = setFormula(document, {NumberOwner::ofShape(1), Quantity::Radius, 0}, "d/2");
    Result<Document> refused = addConstraint(document, Kind::Diameter, {segment(1)});
    CHECK(codeOf(refused) == "constraint-redundant");
    CHECK(messageOf(refused) == "Diameter 1 is set by the formula radius of circle 1 = d/2");
    CHECK(refused.faults().front().advice == "leave it out, or enter a number in place of the formula first");
    Result<Document> locked = setLocked(document, {2}, true);
    REQUIRE(locked.ok());
    refused = addConstraint(*locked, Kind::Radius, {segment(2)});
    CHECK(messageOf(refused) == "Radius 1 always holds: circle 2 is locked");
    const Document plate = documentOf({makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 3}})});
    refused = addConstraint(plate, Kind::Horizontal, {segment(1, 0)});
    CHECK(messageOf(refused) == "Horizontal 1 always holds here: the form of the shapes implies it");
    CHECK(refused.faults().front().advice == "leave it out");
}

TEST_CASE("Dimensions: circles stand for their centres in a distance") {
    Document document = everyShape();
    const auto partsFor = [&](Kind kind, const SketchPart &a, const SketchPart &b) {
        const Result<SketchConstraint> made = makeConstraint(document, kind, {a, b});
        REQUIRE(made.ok());
        return made->parts;
    };
    CHECK(partsFor(Kind::Distance, segment(3, 1), segment(4)) == std::vector{node(4, 0), segment(3, 1)});
    CHECK(partsFor(Kind::Distance, segment(4), segment(8)) == std::vector{node(4, 0), node(8, 0)});
    CHECK(partsFor(Kind::HorizontalDistance, segment(6), segment(8)) == std::vector{node(6, 0), node(8, 0)});
    CHECK(partsFor(Kind::VerticalDistance, segment(7, 1), segment(7, 3)) == std::vector{node(7, 1), node(7, 0)});
    CHECK(partsFor(Kind::Distance, segment(1, 1), node(5, 0)) ==
          std::vector{SketchPart{1, SketchPartKind::Centre, 1}, node(5, 0)});
    constrain(document, Kind::Distance, {segment(4), segment(8)});
    const Vec2 apart = handlesOf(*findShape(document, 8))[0] - handlesOf(*findShape(document, 4))[0];
    CHECK(document.constraints.back()->value == doctest::Approx(length(apart)));
}

} // namespace forefront::constraint_test
