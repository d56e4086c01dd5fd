#include "core/drawing/commands/inferred_constraints.hpp"
#include "core/drawing/commands/mesh_constraints.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <span>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

Document outlineDocument() {
    Shape outline;
    outline.form = PathForm{};
    outline.nodes = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    return addShape({}, outline).value();
}

} // namespace

TEST_CASE("pinNode: a place inside becomes a constraint point") {
    const Document next = pinNode(outlineDocument(), {1, 2}, 5).value();
    REQUIRE(next.shapes.size() == 2);
    CHECK(next.shapes[1]->kind() == ShapeKind::Point);
    CHECK(next.shapes[1]->use == ShapeUse::Constraint);
    CHECK(next.shapes[1]->tag == 5);
    CHECK(next.shapes[1]->nodes == std::vector<Vec2>{{1, 2}});
}

TEST_CASE("pinNode: a place on a segment becomes one of its nodes, and one on a node is refused") {
    const Document next = pinNode(outlineDocument(), {1, 1e-12}, 5).value();
    REQUIRE(next.shapes.size() == 1);
    REQUIRE(next.shapes[0]->nodes.size() == 5);
    CHECK(next.shapes[0]->nodes[1] == Vec2{1, 1e-12});
    const auto again = pinNode(next, {4, 3}, 5);
    REQUIRE_FALSE(again.ok());
    CHECK(again.faults().front().code == "not-possible");
    CHECK_FALSE(pinNode(outlineDocument(), {std::nan(""), 1}, 5).ok());
}

TEST_CASE("keepEdge: an edge becomes a constraint segment that shares its ends with the segments there") {
    const Document inside = keepEdge(outlineDocument(), {1, 1}, {2, 1}, 7).value();
    REQUIRE(inside.shapes.size() == 2);
    CHECK(inside.shapes[1]->kind() == ShapeKind::Polyline);
    CHECK(inside.shapes[1]->tag == 7);
    CHECK(inside.shapes[0]->nodes.size() == 4);
    const Document touching = keepEdge(outlineDocument(), {2, 1}, {2, 0}, 7).value();
    CHECK(touching.shapes[0]->nodes.size() == 5);
    CHECK(toDomain(touching).nodes.size() == 6); // 4 corners, the shared end, the other end
}

TEST_CASE("Inferred constraints: a relation follows its line where that has got another number since") {
    Document found = documentOf({square({0, 0}, 4)});
    const std::uint32_t drawn = found.nextId;
    Result<Document> next = addShape(found, makeShape(ShapeKind::Polyline, {{6, 1}, {6, 3}}));
    REQUIRE(next);
    next = insertNode(*next, {1, 0}, {2, 0}); // the right side was segment 1, and is segment 2 now
    REQUIRE(next);
    Inference parallel;
    parallel.kind = ConstraintKind::Parallel;
    parallel.start = {6, 1};
    parallel.with = SketchPart{1, SketchPartKind::Segment, 1};
    const InferredNode node{{6, 3}, {parallel}, {{6, 1}}};
    const InferredConstraints made = addInferred(*next, drawn, std::span(&node, 1), found);
    REQUIRE(made.added == 1);
    const std::vector<SketchPart> &parts = made.document.constraints.back()->parts;
    CHECK(std::ranges::count(parts, SketchPart{1, SketchPartKind::Segment, 2}) == 1);
    CHECK(std::ranges::count(parts, SketchPart{drawn, SketchPartKind::Segment, 0}) == 1);
}
