#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/commands/typed_size.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using namespace constraint_test;
using namespace edit_test;
using Kind = ConstraintKind;

TypedSize lengthOf(SketchPart segment, double value) {
    return {Kind::Length, {segment}, value, "length"};
}

/// Types a size after the command that sets it.
Result<Document> typed(const Document &before, const Result<Document> &next, const TypedSize &size) {
    REQUIRE_MESSAGE(next.ok(), messageOf(next));
    return withTypedSizes(before, *next, std::vector<TypedSize>{size});
}

std::set<std::uint32_t> idsOf(const Result<Document> &refused) {
    REQUIRE_FALSE(refused.ok());
    const std::vector<std::uint32_t> &ids = refused.faults().front().ids;
    return {ids.begin(), ids.end()};
}

double sideOf(const Document &document, std::uint32_t k) {
    const std::vector<Vec2> &nodes = document.shapes[0]->nodes;
    return distance(nodes[k], nodes[(k + 1) % nodes.size()]);
}

} // namespace

TEST_CASE("Typed sizes: a length that a dimension holds is refused with its name, and the dimension can be changed") {
    const Document plate = drivenPlate();
    const TypedSize size = lengthOf(segment(1, 0), 50.0);
    const Result<Document> refused = typed(plate, setSegmentLength(plate, {1, 0}, 50.0), size);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.faults().front().code == "constraint-conflict");
    CHECK(messageOf(refused) == "length = 50 cannot hold together with Length 1");
    CHECK(idsOf(refused) == std::set{kWidth});
    const std::optional<DimensionChange> change = dimensionThatSets(plate, size, idsOf(refused));
    REQUIRE(change);
    CHECK(change->constraint == kWidth);
    CHECK(change->value == 50.0);
    const Result<Document> changed = changeDimension(plate, *change);
    REQUIRE(changed.ok());
    CHECK(sideOf(*changed, 0) == doctest::Approx(50.0));
    checkAllHold(*changed);
}

TEST_CASE("Typed sizes: the dimension of another side that sets the size is found") {
    const Document plate = drivenPlate();
    const TypedSize size = lengthOf(segment(1, 2), 50.0); // opposite to the one that is driven
    const Result<Document> refused = typed(plate, setSegmentLength(plate, {1, 2}, 50.0), size);
    REQUIRE_FALSE(refused.ok());
    CHECK(idsOf(refused).contains(kWidth));
    const std::optional<DimensionChange> change = dimensionThatSets(plate, size, idsOf(refused));
    REQUIRE(change);
    CHECK(change->constraint == kWidth);
    CHECK(sideOf(*changeDimension(plate, *change), 2) == doctest::Approx(50.0));
}

TEST_CASE("Typed sizes: no dimension is offered for a size that other constraints hold") {
    Document document = documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {10, 0}, {10, 8}})});
    constrain(document, Kind::Fixed, {node(1, 0)});
    constrain(document, Kind::Fixed, {node(1, 1)});
    constrain(document, Kind::Length, {segment(1, 1)});
    const TypedSize size = lengthOf(segment(1, 0), 6.0);
    const Result<Document> refused = typed(document, setSegmentLength(document, {1, 0}, 6.0), size);
    CHECK(messageOf(refused) == "length = 6 cannot hold together with Fixed 1 and Fixed 2");
    CHECK_FALSE(dimensionThatSets(document, size, idsOf(refused)));
    CHECK_FALSE(dimensionThatSets(document, size, {3, 4})); // the other length
}

TEST_CASE("Typed sizes: a length is as typed where the constraints allow it in another way than the command") {
    Document document = documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {10, 0}, {10, 8}})});
    constrain(document, Kind::Fixed, {node(1, 1)}); // the command moves this node
    constrain(document, Kind::Horizontal, {segment(1, 0)});
    const Result<Document> next =
        typed(document, setSegmentLength(document, {1, 0}, 6.0), lengthOf(segment(1, 0), 6.0));
    REQUIRE_MESSAGE(next.ok(), messageOf(next));
    CHECK(next->shapes[0]->nodes[0].x == doctest::Approx(4.0));
    CHECK(next->shapes[0]->nodes[1] == Vec2{10, 0});
    CHECK(next->constraints == document.constraints);
    CHECK(next->nextId == document.nextId);
    const Result<Document> kept = completeCommand(document, *next);
    REQUIRE(kept.ok());
    CHECK(kept->shapes[0]->nodes == next->shapes[0]->nodes);
}

TEST_CASE("Typed sizes: an expression that was typed is followed, also where the constraints move another node") {
    Document document = documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {10, 0}, {10, 8}})});
    constrain(document, Kind::Vertical, {segment(1, 1)});
    constrain(document, Kind::Fixed, {node(1, 2)}); // so x of node 2 is held
    constrain(document, Kind::Horizontal, {segment(1, 0)});
    document = *setParameters(document, {{"w", "6"}});
    TypedSize size = lengthOf(segment(1, 0), 6.0);
    size.follow = [](Document held) { return followLength(std::move(held), {1, 0}, "w"); };
    const Result<Document> next = typed(document, size.follow(*setSegmentLength(document, {1, 0}, 6.0)), size);
    REQUIRE_MESSAGE(next.ok(), messageOf(next));
    CHECK(sideOf(*next, 0) == doctest::Approx(6.0));
    CHECK_FALSE(next->formulas.empty());
}

TEST_CASE("Typed sizes: radius and diameter measure the same circle; a parameter behind a dimension is set") {
    Document document = documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {3, 0}})});
    constrain(document, Kind::Diameter, {segment(1)});
    const TypedSize size{Kind::Radius, {segment(1)}, 5.0, "radius"};
    const Result<Document> refused = typed(document, setRadius(document, 1, 5.0), size);
    CHECK(messageOf(refused) == "radius = 5 cannot hold together with Diameter 1");
    std::optional<DimensionChange> change = dimensionThatSets(document, size, idsOf(refused));
    REQUIRE(change);
    CHECK(change->value == 10.0);
    const std::uint32_t id = change->constraint;
    const NumberAddress value{NumberOwner::ofConstraint(id), Quantity::Value};

    Document named = setFormula(*setParameters(document, {{"d", "6"}}), value, "d");
    CHECK(parameterBehind(named, id) == std::optional<std::size_t>(0));
    const Result<Document> set = changeDimension(named, {id, 10.0});
    REQUIRE_MESSAGE(set.ok(), messageOf(set));
    CHECK(set->parameters[0].expression == "10");
    CHECK(set->formulas.at(value) == "d");
    CHECK(circleRadius(*set->shapes[0]) == doctest::Approx(5.0));

    named = setFormula(named, value, "2*d/2");
    CHECK_FALSE(parameterBehind(named, id));
    const Result<Document> freed = changeDimension(named, {id, 10.0});
    REQUIRE_MESSAGE(freed.ok(), messageOf(freed));
    CHECK(freed->parameters[0].expression == "6");
    CHECK(freed->formulas.empty());
    CHECK(circleRadius(*freed->shapes[0]) == doctest::Approx(5.0));
}

TEST_CASE("Typed sizes: without constraints on the shape, the command applies as it is") {
    Document document = drivenPlate();
    document = *addShapes(document, {makeShape(ShapeKind::Polyline, {{100, 0}, {110, 0}})});
    const std::uint32_t id = document.shapes[1]->id;
    const Document next = *setSegmentLength(document, {id, 0}, 4.0);
    const Result<Document> applied = typed(document, next, lengthOf(segment(id, 0), 4.0));
    REQUIRE_MESSAGE(applied.ok(), messageOf(applied));
    CHECK(applied->shapes == next.shapes);
}

} // namespace forefront
