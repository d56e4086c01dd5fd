#include "core/drawing/commands/corner_commands.hpp"
#include "core/drawing/commands/junction_constraints.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace forefront::junction_test {
namespace {

Document constrainedSquare() {
    const Document square = edit_test::documentOf({edit_test::square({0, 0}, 4)});
    Document document = addConstraint(square, ConstraintKind::Horizontal, {{1, SketchPartKind::Segment, 0}}).value();
    return addConstraint(document, ConstraintKind::Vertical, {{1, SketchPartKind::Segment, 1}}).value();
}

Document rounded(const Document &document, std::uint32_t node) {
    Selection selection;
    selection.nodes = {{1, node}};
    return settleCommand(document, filletCorners(document, selection, 1.0).value()).value();
}

std::size_t tangents(const Document &document) {
    return static_cast<std::size_t>(std::count_if(document.constraints.begin(), document.constraints.end(),
                                                  [](const auto &c) { return c->kind == ConstraintKind::Tangent; }));
}

} // namespace

TEST_CASE("constrainJunctions: a fillet between constrained sides stays tangent to them") {
    const Document before = constrainedSquare();
    const Document round = rounded(before, 1);
    CHECK(tangents(round) == 0);
    const Document tied = constrainJunctions(before, round);
    CHECK(tied.shapes == round.shapes);
    CHECK(tangents(tied) == 2);
    CHECK(tangents(constrainJunctions(round, tied)) == 2); // the junctions are no longer new
    // The side moves to the right, and the arc stays tangent to both sides.
    Document wider = tied;
    Shape moved = *wider.shapes[0];
    for (Vec2 &node : moved.nodes) {
        node.x += node.x > 3.5 ? 1.0 : 0.0;
    }
    wider.shapes[0] = std::make_shared<const Shape>(moved);
    const Result<Document> settled = settleCommand(tied, wider);
    REQUIRE(settled.ok());
    const Outline outline = outlineOf(*settled->shapes[0]);
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        if (outline.isCurved(k)) {
            const Vec2 in = outline.curve(k - 1).tangent(1.0), start = outline.curve(k).tangent(0.0);
            CHECK(std::fabs(cross(in, start)) < 1e-6);
        }
    }
}

TEST_CASE("constrainJunctions: without constraints beside it a fillet gets none") {
    const Document plain = edit_test::documentOf({edit_test::square({0, 0}, 4)});
    CHECK(constrainJunctions(plain, rounded(plain, 1)).constraints.empty());
    const Document before = constrainedSquare();
    CHECK(tangents(constrainJunctions(before, rounded(before, 3))) == 0); // far from both constrained sides
}

TEST_CASE("constrainJunctions: a node made smooth stays smooth where a node beside it is constrained") {
    const Document square = edit_test::documentOf({edit_test::square({0, 0}, 4)});
    const Document before =
        addConstraint(square, ConstraintKind::Vertical, {{1, SketchPartKind::Node, 0}, {1, SketchPartKind::Node, 3}})
            .value();
    const Document smooth = settleCommand(before, setNodeKind(before, {{1, 2}}, NodeKind::Smooth).value()).value();
    const Document tied = constrainJunctions(before, smooth);
    CHECK(tangents(tied) == 1);
    CHECK(tied.shapes == smooth.shapes);
}

} // namespace forefront::junction_test
