#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/constraint_drag.hpp"
#include "core/drawing/constraints/held_numbers.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/sketch/sketch_drag.hpp"
#include "tests/support/random_sketch.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace forefront {
namespace {

using namespace constraint_test;
using namespace edit_test;
using namespace tests;
using Kind = ConstraintKind;

/// A quadrilateral with a horizontal, a vertical, two equal sides and one of length 6: 4 degrees of freedom.
Document freeQuadrilateral() {
    Document document = documentOf({makeShape(ShapeKind::Polygon, {{-0.5, 0.9}, {5.5, 0.9}, {5.5, 5.7}, {0.7, 5.3}})});
    constrain(document, Kind::Horizontal, {segment(1, 0)});
    constrain(document, Kind::Vertical, {segment(1, 1)});
    constrain(document, Kind::Equal, {segment(1, 1), segment(1, 2)});
    constrain(document, Kind::Length, {segment(1, 0)});
    return document;
}

Document typed(const Document &document, NodeRef node, Vec2 at) {
    const Result<Document> moved = setHandle(document, node, at);
    REQUIRE(moved.ok());
    const Result<Document> settled = completeCommand(document, *moved);
    REQUIRE_MESSAGE(settled.ok(), messageOf(settled));
    return *settled;
}

} // namespace

TEST_CASE("Exact places: a dragged node that can reach its place gets it bit for bit, all along the way") {
    const Document document = freeQuadrilateral();
    const auto start = std::make_shared<const Document>(document);
    const Vec2 from = document.shapes[0]->nodes[2], to{6.8, 4.8};
    ConstraintDrag drag(start);
    for (int step = 1; step <= 12; ++step) {
        const Vec2 at = step == 12 ? to : from + (step / 12.0) * (to - from);
        const Document now = drag.carry(*setHandle(document, {1, 2}, at));
        CHECK(now.shapes[0]->nodes[2] == at);
        checkAllHold(now);
    }
    CHECK(drag.carry(document).shapes == document.shapes);
}

TEST_CASE("Exact places: a drag along one axis keeps the other coordinate of the node") {
    const Document document = freeQuadrilateral();
    const auto start = std::make_shared<const Document>(document);
    ConstraintDrag drag(start);
    const Vec2 at{6.25, document.shapes[0]->nodes[2].y};
    CHECK(drag.carry(*setHandle(document, {1, 2}, at)).shapes[0]->nodes[2] == at);
}

TEST_CASE("Exact places: where only one coordinate is free, it is exact, and the other stays") {
    Document document = freeQuadrilateral();
    constrain(document, Kind::Fixed, {node(1, 0)});
    const auto start = std::make_shared<const Document>(document);
    ConstraintDrag drag(start);
    const double x = document.shapes[0]->nodes[2].x;
    const Vec2 at = drag.carry(*setHandle(document, {1, 2}, {x + 0.4, 5.25})).shapes[0]->nodes[2];
    CHECK(std::fabs(at.x - x) < 1e-9);
    CHECK(at.y == 5.25);
}

TEST_CASE("Exact places: a node of a long profile takes all of it along and does not lag") {
    RandomSketch sketch = steppedProfile(60);
    std::erase_if(sketch.system.equations,
                  [](const SketchEquation &equation) { return equation.kind == EquationKind::Value; }); // of its place
    std::uint32_t x = 0;
    while (sketch.system.kinds[x] != UnknownKind::X || sketch.system.kinds[x + 1] != UnknownKind::Y) {
        ++x;
    }
    SketchDrag drag(sketch.system);
    const double size = 3.0;
    const std::vector<SketchPull> pulls{{x, sketch.system.values[x] + size}, {x + 1, sketch.system.values[x + 1] + 1}};
    REQUIRE(drag.pull(pulls));
    CHECK(drag.values()[x] == pulls[0].value);
    CHECK(drag.values()[x + 1] == pulls[1].value);
}

TEST_CASE("Exact places: both typed coordinates of a free node are kept, one after the other") {
    Document document = freeQuadrilateral();
    const double y = document.shapes[0]->nodes[2].y;
    document = typed(document, {1, 2}, {5.0, y});
    CHECK(document.shapes[0]->nodes[2] == Vec2{5.0, y});
    document = typed(document, {1, 2}, {5.0, 5.5});
    CHECK(document.shapes[0]->nodes[2] == Vec2{5.0, 5.5});
    checkAllHold(document);
}

TEST_CASE("Exact places: a typed number that constraints hold elsewhere is refused with their names") {
    const Document plate = drivenPlate();
    const Document wanted = *setHandle(plate, {1, 2}, {45.0, 30.0});
    const Document settled = typed(plate, {1, 2}, {45.0, 30.0});
    const Diagnostics faults = heldNumbersFault(plate, wanted, settled);
    REQUIRE(!faults.empty());
    CHECK(faults[0].message == "x = 45 of node 3 cannot hold together with Vertical 1, Fixed 1 and Length 1");
    CHECK(heldNumbersFault(plate, plate, plate).empty());
    const Document quadrilateral = freeQuadrilateral();
    CHECK(heldNumbersFault(quadrilateral, *setHandle(quadrilateral, {1, 2}, {5.0, 5.5}),
                           typed(quadrilateral, {1, 2}, {5.0, 5.5}))
              .empty());
}

} // namespace forefront
