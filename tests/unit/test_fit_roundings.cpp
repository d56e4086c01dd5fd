// The radius of rounded corners of rectangles that change.
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/files/source/import_notes.hpp"
#include "core/files/source/source.hpp"
#include "tests/unit/edit_support.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

constexpr NumberAddress kRadius{NumberOwner::ofShape(1), Quantity::Radius};

constexpr SketchPart kArc{1, SketchPartKind::Segment, 4};

/// Returns a rectangle of 8 x 4 with corners of radius 1.5.
Document roundedPlate() {
    Shape plate = makeShape(ShapeKind::Rectangle, {{0, 0}, {8, 4}});
    std::get<RectangleForm>(plate.form).radius = 1.5;
    return documentOf({plate});
}

double radiusOf(const Document &document) {
    return document.shapes.front()->as<RectangleForm>().radius;
}

/// Returns the document after a radius was typed.
Result<Document> typed(Document document, double radius) {
    const Document before = document;
    const Status status = setNumber(document, kRadius, radius);
    return status.empty() ? completeCommand(before, document) : Result<Document>(status);
}

Result<Document> completed(const Document &before, const Result<Document> &command) {
    return command ? completeCommand(before, *command) : command;
}

} // namespace

TEST_CASE(
    "fitRoundings: a radius that does not fit is refused where it is typed, or set by a dimension or a parameter") {
    const Document plate = roundedPlate();
    CHECK(radiusOf(*typed(plate, 2.0)) == 2.0);
    const Result<Document> large = typed(plate, 2.5);
    REQUIRE(!large);
    CHECK(large.faults().front().message ==
          "the corners of rectangle 1 cannot have the radius 2.5: half of its shorter side is 2");

    const Result<Document> dimension = addConstraint(plate, ConstraintKind::Radius, {kArc});
    REQUIRE(dimension);
    const std::uint32_t id = dimension->constraints.front()->id;
    CHECK(radiusOf(*completed(*dimension, setDimension(*dimension, id, 1.0))) == 1.0);
    CHECK(codeOf(completed(*dimension, setDimension(*dimension, id, 3.0))) == "bad-radius");

    Document formula = *setParameters(plate, {{"r", "1.5"}});
    formula.formulas[kRadius] = "r";
    CHECK(radiusOf(*setParameters(formula, {{"r", "1.8"}})) == 1.8);
    CHECK(codeOf(setParameters(formula, {{"r", "2.2"}})) == "bad-radius");
}

TEST_CASE("fitRoundings: the radius follows a rectangle that becomes too small, unless something holds it") {
    const Document plate = roundedPlate();
    const Result<Document> flat = completed(plate, setHandle(plate, {1, 2}, {8, 2}));
    REQUIRE(flat);
    CHECK(radiusOf(*flat) == 1.0);
    CHECK(radiusOf(*completed(plate, setHandle(plate, {1, 2}, {8, 3}))) == 1.5);
    const Result<Document> held = addConstraint(plate, ConstraintKind::Radius, {kArc});
    CHECK(codeOf(completed(*held, setHandle(*held, {1, 2}, {8, 2}))) == "bad-radius");
    Document formula = *setParameters(plate, {{"r", "1.5"}});
    formula.formulas[kRadius] = "r";
    CHECK(codeOf(completed(formula, setHandle(formula, {1, 2}, {8, 2}))) == "bad-radius");
}

TEST_CASE("fitRoundings: a radius that a file has too large stays until its rectangle changes, and is warned of") {
    Document plate = roundedPlate();
    Shape round = *plate.shapes.front();
    std::get<RectangleForm>(round.form).radius = 3.0;
    plate.shapes.front() = std::make_shared<const Shape>(round);
    ImportNotes notes;
    const std::string text = projectText(plate);
    SourceText source;
    source.name = "plate.json";
    source.text = text;
    source.notes = &notes;
    const Result<Document> read = readProjectText(source);
    REQUIRE(read);
    CHECK(radiusOf(*read) == 3.0);
    CHECK(radiusOf(*completed(*read, setHandle(*read, {1, 2}, {8, 6}))) == 3.0);
    CHECK(radiusOf(*completed(*read, setHandle(*read, {1, 2}, {8, 5}))) == 2.5);
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries().front().severity == Severity::Warning);
}
