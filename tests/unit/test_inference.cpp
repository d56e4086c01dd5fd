#include "core/drawing/commands/inferred_constraints.hpp"
#include "core/drawing/picking/inference.hpp"
#include "core/drawing/picking/pointer_snap.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace forefront::inference_test {
namespace {

using edit_test::documentOf;
using edit_test::makeShape;

/// A drawing with one slanted line from (0, 0) to (4, 2), and a point at (9, 7).
PickIndex slantedIndex() {
    return PickIndex(std::make_shared<const Document>(
        documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {4, 2}}, ShapeUse::Constraint),
                    makeShape(ShapeKind::Point, {{9, 7}}, ShapeUse::Constraint)})));
}

SnapQuery drawingFrom(std::vector<Vec2> path, Vec2 at) {
    SnapQuery query;
    query.at = at;
    query.tolerance = 0.15;
    query.anchor = path.back();
    query.infer = InferenceQuery{.starts = {path.back()}, .path = std::move(path), .reach = 20.0};
    return query;
}

std::vector<ConstraintKind> kindsOf(const Snapped &snapped) {
    std::vector<ConstraintKind> kinds;
    for (const Inference &relation : snapped.inferred) {
        kinds.push_back(relation.kind);
    }
    return kinds;
}

using Kinds = std::vector<ConstraintKind>;

} // namespace

TEST_CASE("Inference: a line near horizontal or vertical becomes so exactly, others stay") {
    const PickIndex index = slantedIndex();
    const Snapped level = snap(index, drawingFrom({{20, 20}}, {23, 20.05}));
    CHECK(level.kind == SnapKind::Inferred);
    CHECK(level.at == Vec2{23, 20});
    CHECK(kindsOf(level) == Kinds{ConstraintKind::Horizontal});
    CHECK(wordsOf(level) == "horizontal");
    const Snapped upright = snap(index, drawingFrom({{20, 20}}, {19.95, 24}));
    CHECK(upright.at == Vec2{20, 24});
    CHECK(kindsOf(upright) == Kinds{ConstraintKind::Vertical});
    CHECK(snap(index, drawingFrom({{20, 20}}, {23, 21})).kind == SnapKind::None);
    CHECK(snap(index, drawingFrom({{20, 20}}, {21, 20.09})).kind == SnapKind::None); // more than 3 degrees
}

TEST_CASE("Inference: parallel and perpendicular to a line of the drawing, and its length") {
    const PickIndex index = slantedIndex();
    const Snapped parallel = snap(index, drawingFrom({{2, 4}}, {5.03, 5.45}));
    REQUIRE(kindsOf(parallel) == Kinds{ConstraintKind::Parallel});
    CHECK(cross(parallel.at - Vec2{2, 4}, Vec2{4, 2}) == doctest::Approx(0.0));
    CHECK((parallel.inferred[0].with == SketchPart{1, SketchPartKind::Segment, 0}));
    const Snapped square = snap(index, drawingFrom({{2, 4}}, {0.99, 6.05}));
    REQUIRE(kindsOf(square) == Kinds{ConstraintKind::Perpendicular});
    CHECK(dot(square.at - Vec2{2, 4}, Vec2{4, 2}) == doctest::Approx(0.0));
    // As long as the line and parallel to it: both at once.
    const Snapped both = snap(index, drawingFrom({{2, 4}}, {6.03, 5.97}));
    CHECK(kindsOf(both) == Kinds{ConstraintKind::Parallel, ConstraintKind::Equal});
    CHECK(distance(both.at, {6, 6}) < 1e-9);
}

TEST_CASE("Inference: a circle gets the radius of a circle or an arc near by, and the constraint with it") {
    Shape arc = makeShape(ShapeKind::Polyline, {{10, 0}, {13, 3}}, ShapeUse::Constraint);
    arc.path().curves = {Curve::arc({10, 3}, {3, 0}, {0, 3}, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi)};
    const Document document = documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}}), arc});
    const PickIndex index(std::make_shared<const Document>(document));
    const auto rim = [&](Vec2 at) {
        SnapQuery query;
        query.at = at;
        query.tolerance = 0.15;
        query.infer = InferenceQuery{.starts = {}, .round = Vec2{5, 5}, .reach = 20.0};
        return snap(index, query);
    };
    const Snapped equal = rim({6.25, 6.57});
    REQUIRE(kindsOf(equal) == Kinds{ConstraintKind::Equal});
    CHECK(wordsOf(equal) == "equal radius");
    CHECK(distance(equal.at, {5, 5}) == doctest::Approx(2.0));
    CHECK((equal.inferred[0].with == SketchPart{1, SketchPartKind::Segment, 0}));
    CHECK((rim({5, 7.96}).inferred.at(0).with == SketchPart{2, SketchPartKind::Segment, 0}));
    CHECK(rim({7.5, 5}).kind == SnapKind::None);
    CHECK(rim({9, 5.01}).kind == SnapKind::None); // level with nothing

    const Document drawn = *addShapes(document, {makeShape(ShapeKind::Circle, {{5, 5}, equal.at})});
    const InferredNode node{equal.at, equal.inferred, {}};
    const InferredConstraints constrained = addInferred(drawn, 3, std::span(&node, 1), document);
    REQUIRE(constrained.added == 1);
    CHECK(constrained.document.constraints[0]->kind == ConstraintKind::Equal);
    CHECK(constrained.document.constraints[0]->parts ==
          std::vector<SketchPart>{{1, SketchPartKind::Segment, 0}, {3, SketchPartKind::Segment, 0}});
}

TEST_CASE("Inference: level with one node and above another gives their crossing") {
    const PickIndex index = slantedIndex();
    const Snapped corner = snap(index, drawingFrom({{1, 10}}, {4.05, 6.93}));
    REQUIRE(corner.inferred.size() == 2);
    CHECK(distance(corner.at, {4, 7}) < 1e-12);
    CHECK_FALSE(corner.inferred[0].ofLine);
    CHECK(corner.inferred[0].kind == ConstraintKind::Horizontal);
    CHECK((corner.inferred[0].with == SketchPart{2, SketchPartKind::Node, 0}));
    CHECK((corner.inferred[1].with == SketchPart{1, SketchPartKind::Node, 1}));
    CHECK(wordsOf(corner) == "level with a node, above or below a node");
}

TEST_CASE("Inference: the path being drawn counts, too, and a curve is continued tangentially") {
    const PickIndex index = slantedIndex();
    SnapQuery query = drawingFrom({{20, 20}, {23, 24}}, {27.05, 21.0});
    const Snapped own = snap(index, query);
    REQUIRE(!own.inferred.empty());
    CHECK(own.inferred[0].kind == ConstraintKind::Perpendicular);
    CHECK(own.inferred[0].withOwn == 0);
    query.at = {26, 24.4};
    query.infer->straight = {false};
    query.infer->arrival = Vec2{3, 0.45};
    const Snapped tangent = snap(index, query);
    REQUIRE(!tangent.inferred.empty());
    CHECK(tangent.inferred[0].kind == ConstraintKind::Tangent);
    CHECK(cross(tangent.at - Vec2{23, 24}, Vec2{3, 0.45}) == doctest::Approx(0.0));
}

TEST_CASE("Inference: nodes, segments, guides and the grid come first; Ctrl turns all off") {
    Document document = slantedIndex().document();
    document.guides = {{true, 23.1}, {false, 30}};
    const PickIndex index(std::make_shared<const Document>(document));
    SnapQuery query = drawingFrom({{20, 20}}, {23, 20.05});
    const Snapped guide = snap(index, query);
    CHECK(guide.kind == SnapKind::Guide);
    CHECK(guide.at == Vec2{23.1, 20.05});
    CHECK(wordsOf(guide) == "guide");
    query.guides = false;
    CHECK(snap(index, query).kind == SnapKind::Inferred);
    query.guides = true;
    query.at = {23, 30.1};
    CHECK(snap(index, query).at == Vec2{23.1, 30}); // the crossing of two guides
    query.at = {4.02, 2.03};
    CHECK(snap(index, query).kind == SnapKind::Node);
    query.at = {23, 20.05};
    query.off = true;
    CHECK(snap(index, query).at == query.at);
    CHECK(snap(index, query).inferred.empty());
    query.off = false;
    query.guides = false;
    query.gridPitch = 1.0;
    const Snapped grid = snap(index, query);
    CHECK(grid.kind == SnapKind::Grid);
    CHECK(kindsOf(grid) == Kinds{ConstraintKind::Horizontal}); // it holds there, without being sought
    CHECK(wordsOf(grid) == "grid");
    query.at = {22.6, 20.05}; // along the level line to the grid
    CHECK(snap(index, query).at == Vec2{23, 20});
    query.infer->starts = {{20, 20.2}};
    query.at = {22.9, 20.25}; // the relation is nearer than the grid
    CHECK(snap(index, query).kind == SnapKind::Inferred);
    CHECK(snap(index, query).at == Vec2{23, 20.2});
    query.at = {22.9, 20.07}; // the grid is nearer
    CHECK(snap(index, query).kind == SnapKind::Grid);
    CHECK(snap(index, query).at == Vec2{23, 20});
}

} // namespace forefront::inference_test
