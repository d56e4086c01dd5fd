#include "core/drawing/commands/corner_commands.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/constraints/carry_constraints.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using namespace constraint_test;
using namespace edit_test;
using Kind = ConstraintKind;

SketchPart circle(std::uint32_t shape) {
    return {shape, SketchPartKind::Segment, 0};
}

/// A plate 40 long with sides of 18 and 30, a corner at the origin and a hole placed by distances from two sides.
Document plateWithHole() {
    Document document = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {40, 0}, {40, 18}, {0, 30}}),
                                    makeShape(ShapeKind::Circle, {{8, 6}, {11, 6}})});
    constrain(document, Kind::Coincident, {node(1, 0), {0, SketchPartKind::Origin, 0}});
    constrain(document, Kind::Horizontal, {segment(1, 0)});
    constrain(document, Kind::Vertical, {segment(1, 1)});
    constrain(document, Kind::Vertical, {segment(1, 3)});
    constrain(document, Kind::Length, {segment(1, 0)});
    constrain(document, Kind::Length, {segment(1, 1)});
    constrain(document, Kind::Length, {segment(1, 3)});
    constrain(document, Kind::Distance, {node(2, 0), segment(1, 0)});
    constrain(document, Kind::Distance, {node(2, 0), segment(1, 3)});
    constrain(document, Kind::Radius, {circle(2)});
    return document;
}

/// A rectangle with horizontal and vertical sides and a free small circle to its left.
Document plateBesideCircle(Vec2 centre) {
    Document document = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {4.5, 0}, {4.5, 4.5}, {0, 4.5}}),
                                    makeShape(ShapeKind::Circle, {centre, centre + Vec2{0.5, 0}})});
    constrain(document, Kind::Horizontal, {segment(1, 0)});
    constrain(document, Kind::Vertical, {segment(1, 1)});
    constrain(document, Kind::Equal, {segment(1, 0), segment(1, 1)});
    return document;
}

} // namespace

TEST_CASE("Sketch commands: an outline mirrored alone keeps its anchor, and its hole stays inside") {
    const Document plate = plateWithHole();
    for (const PlaneMap &map : {PlaneMap::reflection(90.0, {20, 15}), PlaneMap::reflection(0.0, {20, 15})}) {
        const Result<Document> mapped = transformSelection(plate, selected({1}), map);
        REQUIRE_MESSAGE(mapped.ok(), messageOf(mapped));
        const Result<Document> settled = completeCommand(plate, *mapped);
        REQUIRE_MESSAGE(settled.ok(), messageOf(settled));
        checkAllHold(*settled);
        CHECK(settled->constraints.size() == plate.constraints.size());
        const std::vector<Vec2> &nodes = settled->shapes[0]->nodes;
        CHECK(length(nodes[0]) < 1e-9);
        const Vec2 centre = settled->shapes[1]->nodes[0];
        const Box2 box = boundsOf(*settled->shapes[0]);
        CHECK((centre.x > box.min.x && centre.x < box.max.x && centre.y > box.min.y && centre.y < box.max.y));
        const double across = map.u.x < 0.0 ? -1.0 : 1.0, up = map.u.x < 0.0 ? 1.0 : -1.0;
        CHECK(distance(nodes[2], {40 * across, 18 * up}) < 1e-9);
        CHECK(distance(centre, {8 * across, 6 * up}) < 1e-9);
    }
}

TEST_CASE("Sketch commands: a turn that constraints with other shapes do not allow is refused with their names") {
    Document document = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {40, 0}, {40, 30}, {0, 30}}),
                                    makeShape(ShapeKind::Polyline, {{0, -20}, {40, -20}}, ShapeUse::Constraint)});
    constrain(document, Kind::Parallel, {segment(1, 0), segment(2, 0)});
    constrain(document, Kind::Fixed, {node(2, 0)});
    constrain(document, Kind::Fixed, {node(2, 1)});
    const Result<Document> turned = transformSelection(document, selected({1}), PlaneMap::rotation(30.0, {20, 15}));
    CHECK(codeOf(turned) == "constraint-conflict");
    CHECK(messageOf(turned).find("Parallel 1") != std::string::npos);
    const Document loose = removeConstraints(document, {4, 5});
    const Result<Document> followed = transformSelection(loose, selected({1}), PlaneMap::rotation(30.0, {20, 15}));
    REQUIRE_MESSAGE(followed.ok(), messageOf(followed));
    const Result<Document> settled = completeCommand(loose, *followed);
    REQUIRE(settled.ok());
    CHECK(settled->shapes[0] == followed->shapes[0]); // the line turns with it
    checkAllHold(*settled);
}

TEST_CASE("Sketch commands: a new tangent moves the hole alone and keeps its radius, in either order of selection") {
    const Document document = plateBesideCircle({1.5, 2.0});
    Document first = document, second = document;
    constrain(first, Kind::Tangent, {circle(2), segment(1, 1)});
    constrain(second, Kind::Tangent, {segment(1, 1), circle(2)});
    for (const Document &tangent : {first, second}) {
        CHECK(tangent.shapes[0]->nodes == document.shapes[0]->nodes);
        CHECK(distance(tangent.shapes[1]->nodes[0], {4.0, 2.0}) < 1e-9);
        CHECK(std::fabs(distance(tangent.shapes[1]->nodes[0], tangent.shapes[1]->nodes[1]) - 0.5) < 1e-12);
        checkAllHold(tangent);
    }
}

TEST_CASE("Sketch commands: what cannot move alone takes the other shape along") {
    Document document = plateBesideCircle({1.5, 2.0});
    constrain(document, Kind::Fixed, {node(2, 0)});
    constrain(document, Kind::Radius, {circle(2)});
    constrain(document, Kind::Tangent, {circle(2), segment(1, 1)});
    CHECK(distance(document.shapes[1]->nodes[0], {1.5, 2.0}) < 1e-9);
    checkAllHold(document);
}

TEST_CASE("Sketch commands: a fillet keeps the dimension to the corner, measured to the side across it") {
    Document plate = drivenPlate();
    plate = setFormula(plate, {NumberOwner::ofConstraint(kHeight), Quantity::Value}, "5*6");
    Selection corner;
    corner.nodes = {{1, 2}};
    for (const bool rounds : {true, false}) {
        const Result<Document> cut = rounds ? filletCorners(plate, corner, 4.0) : chamferCorners(plate, corner, 4.0);
        REQUIRE(cut.ok());
        const Result<Document> settled = completeCommand(plate, *cut);
        REQUIRE_MESSAGE(settled.ok(), messageOf(settled));
        CHECK(lostConstraints(plate, *settled).empty());
        CHECK(settled->formulas == plate.formulas);
        const SketchConstraint *const height = findConstraint(*settled, kHeight);
        REQUIRE(height != nullptr);
        CHECK(height->kind == Kind::Distance);
        checkAllHold(*settled);
        Document free = *settled;
        free.formulas.clear();
        const Result<Document> higher = setDimension(free, kHeight, 36.0);
        REQUIRE_MESSAGE(higher.ok(), messageOf(higher));
        CHECK(std::fabs(boundsOf(*higher->shapes[0]).size().y - 36.0) < 1e-6);
    }
}

} // namespace forefront
