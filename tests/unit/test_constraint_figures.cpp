#include "core/drawing/commands/transform.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_figures.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace forefront::figure_test {
namespace {

using Form = DimensionFigure::Form;

SketchPart corner(std::uint32_t k) {
    return {1, SketchPartKind::Node, k};
}
SketchPart side(std::uint32_t k) {
    return {1, SketchPartKind::Segment, k};
}

/// A triangle with a right angle at the origin, and a circle beside it.
Document triangleAndCircle() {
    Shape triangle;
    triangle.form = PathForm{};
    triangle.nodes = {{0, 0}, {4, 0}, {0, 3}};
    Shape circle;
    circle.form = CircleForm{};
    circle.nodes = {{7, 1}, {9, 1}};
    return addShape(addShape({}, triangle).value(), circle).value();
}

Document dimensioned(ConstraintKind kind, std::vector<SketchPart> parts) {
    return addConstraint(triangleAndCircle(), kind, std::move(parts)).value();
}

DimensionFigure figureOf(const Document &document) {
    return dimensionFigure(document, *document.constraints.back()).value();
}

} // namespace

TEST_CASE("Figures of dimensions: a length lies outside its shape, along what it measures") {
    const DimensionFigure figure = figureOf(dimensioned(ConstraintKind::Length, {side(1)}));
    CHECK(figure.form == Form::Linear);
    CHECK(distance(figure.from, figure.to) == doctest::Approx(5.0));
    CHECK(std::fabs(dot(figure.along, figure.to - figure.from)) == doctest::Approx(5.0));
    CHECK(figure.outward.x == doctest::Approx(0.6)); // away from the right angle
    CHECK(figure.outward.y == doctest::Approx(0.8));
}

TEST_CASE("Figures of dimensions: distances are measured along x, along y and square to a line") {
    const DimensionFigure level = figureOf(dimensioned(ConstraintKind::HorizontalDistance, {corner(1), corner(2)}));
    CHECK(std::fabs(level.along.x) == 1.0);
    CHECK(dot(level.to - level.from, level.along) == doctest::Approx(4.0));
    const DimensionFigure upright = figureOf(dimensioned(ConstraintKind::VerticalDistance, {corner(1), corner(2)}));
    CHECK(dot(upright.to - upright.from, upright.along) == doctest::Approx(3.0));
    const DimensionFigure height = figureOf(dimensioned(ConstraintKind::Distance, {corner(0), side(1)}));
    CHECK(distance(height.from, height.to) == doctest::Approx(2.4));
    CHECK(dot(height.to - height.from, Vec2{-4, 3}) == doctest::Approx(0.0));
}

TEST_CASE("Figures of dimensions: radius and diameter begin at the centre; an angle at the crossing of its lines") {
    const SketchPart circle{2, SketchPartKind::Segment, 0};
    const DimensionFigure radius = figureOf(dimensioned(ConstraintKind::Radius, {circle}));
    CHECK(radius.form == Form::Radial);
    CHECK_FALSE(radius.diameter);
    CHECK(radius.from == Vec2{7, 1});
    CHECK(distance(radius.from, radius.to) == doctest::Approx(2.0));
    CHECK(figureOf(dimensioned(ConstraintKind::Diameter, {circle})).diameter);

    const DimensionFigure angle = figureOf(dimensioned(ConstraintKind::Angle, {side(0), side(1)}));
    CHECK(angle.form == Form::Angular);
    CHECK(distance(angle.from, {4, 0}) < 1e-12);
    CHECK(std::fabs(angle.sweep) * 180.0 / std::numbers::pi ==
          doctest::Approx(std::atan2(3.0, 4.0) * 180.0 / std::numbers::pi));
    CHECK(dot(angle.outward, Vec2{-1, 0.3}) > 0.0); // between the sides, inside the triangle
}

TEST_CASE("Figures of dimensions: other constraints and parts that are gone have none") {
    const Document horizontal = dimensioned(ConstraintKind::Horizontal, {side(1)});
    CHECK_FALSE(dimensionFigure(horizontal, *horizontal.constraints.back()));
    Document document = dimensioned(ConstraintKind::Length, {side(1)});
    document.shapes.erase(document.shapes.begin());
    CHECK_FALSE(dimensionFigure(document, *document.constraints.back()));
    CHECK(glyphAnchors(document, *document.constraints.back()).empty());
}

TEST_CASE("Glyphs: each line of a relation has one, a joint has one, and axes have none") {
    const Document document = triangleAndCircle();
    const auto anchorsOf = [&](ConstraintKind kind, std::vector<SketchPart> parts) {
        SketchConstraint constraint;
        constraint.kind = kind;
        constraint.parts = std::move(parts);
        return glyphAnchors(document, constraint);
    };
    const std::vector<GlyphAnchor> right = anchorsOf(ConstraintKind::Perpendicular, {side(0), side(2)});
    REQUIRE(right.size() == 2);
    CHECK(right[0].at == Vec2{2, 0});
    CHECK(right[1].at == Vec2{0, 1.5});
    CHECK(std::fabs(right[1].along.y) == doctest::Approx(1.0));
    CHECK(anchorsOf(ConstraintKind::Parallel, {side(0), {0, SketchPartKind::XAxis, 0}}).size() == 1);
    const std::vector<GlyphAnchor> level = anchorsOf(ConstraintKind::Horizontal, {corner(0), corner(1)});
    REQUIRE(level.size() == 1);
    CHECK(level[0].at == Vec2{2, 0});
    CHECK(anchorsOf(ConstraintKind::OnCurve, {corner(2), {2, SketchPartKind::Segment, 0}}).size() == 1);
}

TEST_CASE("placeDimension: the text keeps its place beside what it measures, also when that is moved and turned") {
    const Document document = dimensioned(ConstraintKind::Length, {side(1)});
    const std::uint32_t id = document.constraints.back()->id;
    const Document placed = placeDimension(document, id, Vec2{5, 5}).value();
    CHECK(placed.shapes == document.shapes);
    CHECK_FALSE(sameConstraints(placed, document));
    CHECK(distance(figureOf(placed).placeOf(*placed.constraints.back()->label), {5, 5}) < 1e-12);
    Selection all;
    all.shapes = {1, 2};
    const PlaneMap map = PlaneMap::rotation(90.0, {0, 0});
    const Document turned = transformSelection(placed, all, map).value();
    REQUIRE(turned.constraints.size() == 1);
    CHECK(distance(figureOf(turned).placeOf(*turned.constraints.back()->label), {-5, 5}) < 1e-9);
    const Document larger = transformSelection(placed, all, PlaneMap::scaling({2, 2}, {0, 0})).value();
    CHECK(distance(figureOf(larger).placeOf(*larger.constraints.back()->label), {10, 10}) < 1e-9);
    CHECK_FALSE(placeDimension(placed, id, std::nullopt).value().constraints.back()->label);
    CHECK_FALSE(placeDimension(placed, 99, Vec2{}).ok());
    CHECK_FALSE(placeDimension(placed, id, Vec2{std::nan(""), 0}).ok());
}

TEST_CASE("Projects keep the places of texts and the guides; invalid ones are faults with their line") {
    Document document = dimensioned(ConstraintKind::Length, {side(1)});
    document = placeDimension(document, document.constraints.back()->id, Vec2{5, 5}).value();
    document.guides = {{true, 1.5}, {false, -2}};
    const std::string text = projectText(document);
    const Document again = parseProject(text, "test.json").value();
    CHECK(sameContent(document, again));
    const auto faultOf = [&](const std::string &old, const std::string &given) {
        std::string changed = text;
        const std::size_t at = changed.find(old);
        REQUIRE(at != std::string::npos);
        changed.replace(at, old.size(), given);
        const Result<Document> read = parseProject(changed, "test.json");
        return read ? std::string("none") : read.faults().front().code;
    };
    CHECK(faultOf("{\"x\": 1.5}", "{\"x\": 1, \"y\": 2}") == "bad-guide");
    CHECK(faultOf("{\"x\": 1.5}", "{}") == "bad-guide");
    CHECK(faultOf("{\"x\": 1.5}", "{\"x\": \"left\"}") != "none");
    CHECK(faultOf("\"label\": [", "\"label\": [1, ") != "none");
}

} // namespace forefront::figure_test
