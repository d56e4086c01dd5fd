#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/commands/trim_commands.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

Shape line(std::vector<Vec2> nodes) {
    Shape shape = makeShape(ShapeKind::Polyline, std::move(nodes));
    shape.use = ShapeUse::Constraint;
    return shape;
}

double lengthOfAll(const std::vector<Curve> &curves) {
    double sum = 0.0;
    for (const Curve &curve : curves) {
        sum += curve.length();
    }
    return sum;
}

template <class T>
std::string codeOf(const Result<T> &result) {
    return result ? "" : result.faults().front().code;
}

Result<std::vector<Curve>> partAt(const Document &document, std::uint32_t shape, Vec2 at) {
    return partToTrim(document, shape, at, *crossingsAlong(document, shape));
}

} // namespace

TEST_CASE("trimAt: removes the middle, the beginning or the end of a line, and joins what is left to the others") {
    const Document document =
        *addShapes({}, {line({{0, 0}, {10, 0}}), line({{3, -2}, {3, 2}}), line({{7, -2}, {7, 2}})});
    CHECK(lengthOfAll(*partAt(document, 1, {5, 0})) == doctest::Approx(4));
    const Result<Document> middle = trimAt(document, 1, {5, 0.1});
    REQUIRE(middle.ok());
    REQUIRE(middle->shapes.size() == 4);
    CHECK(findShape(*middle, 1)->nodes == std::vector<Vec2>{{0, 0}, {3, 0}});
    CHECK(findShape(*middle, 4)->nodes == std::vector<Vec2>{{7, 0}, {10, 0}});
    CHECK(findShape(*middle, 4)->use == ShapeUse::Constraint);
    CHECK(findShape(*middle, 2)->nodes.size() == 3); // the lines share nodes
    CHECK(findShape(*middle, 3)->nodes[1] == Vec2{7, 0});
    CHECK(findShape(*trimAt(document, 1, {1, 0}), 1)->nodes == std::vector<Vec2>{{3, 0}, {10, 0}});
    CHECK(findShape(*trimAt(document, 1, {9, 0}), 1)->nodes == std::vector<Vec2>{{0, 0}, {7, 0}});
    CHECK(codeOf(trimAt(*trimAt(document, 1, {1, 0}), 3, {7, -1})).empty());
    CHECK(codeOf(trimAt(*addShape({}, line({{0, 0}, {1, 0}})), 1, {0.5, 0})) == "not-possible");
    CHECK(codeOf(trimAt(document, 9, {0.5, 0})) == "no-such-shape");
}

TEST_CASE("trimAt: lines that end on another one but for rounding, and touches at a node, are one place") {
    const Document joint = *addShapes({}, {line({{0, 0}, {10, 0}}), line({{5, 1e-16}, {5, 5}})});
    CHECK(lengthOfAll(*partAt(joint, 1, {7, 0})) == doctest::Approx(5));
    // A tip that touches a closed path at one of its nodes: not enough to trim between.
    const Document touched = *addShapes(
        {}, {makeShape(ShapeKind::Polygon, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}), line({{1 + 5e-11, 1 + 5e-11}, {2, 2}})});
    CHECK(codeOf(partAt(touched, 1, {0.5, 0})) == "not-possible");
}

TEST_CASE("trimAt: closed outlines open; circles stay arcs, tags stay with their segments, and parts run over nodes") {
    Document document = *addShapes({}, {makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}}), line({{1, -3}, {1, 3}})});
    const Result<Document> cap = trimAt(document, 1, {2, 0.1});
    REQUIRE(cap.ok());
    const Shape &rest = *findShape(*cap, 1);
    CHECK(rest.kind() == ShapeKind::Polyline);
    CHECK(lengthOf(rest) == doctest::Approx(2.0 * (2.0 * std::numbers::pi - 2.0 * std::acos(0.5))));
    for (const Curve &curve : rest.path().curves) {
        CHECK(curve.kind() == CurveKind::Arc);
    }
    CHECK(distance(rest.nodes.front(), {1, std::sqrt(3.0)}) < 1e-9);
    CHECK(findShape(*cap, 2)->nodes.size() == 4);

    Shape box = makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 4}});
    box.segmentTags = {5, 6, 7, 8};
    document = *addShapes({}, {box, line({{2, -1}, {2, 5}})});
    const Result<Document> left = trimAt(document, 1, {4, 2}); // the right half: over two corners
    REQUIRE(left.ok());
    CHECK(findShape(*left, 1)->nodes == std::vector<Vec2>{{2, 4}, {0, 4}, {0, 0}, {2, 0}});
    CHECK(findShape(*left, 1)->segmentTags == std::vector<std::int32_t>{7, 8, 5});
    const Document touched = *addShapes({}, {box, line({{2, -1}, {2, 2}})});
    CHECK(codeOf(trimAt(touched, 1, {4, 2})) == "not-possible");
    const Document hiding = *setHidden(document, {2}, true);
    CHECK(codeOf(trimAt(hiding, 1, {4, 2})) == "not-possible");
}

TEST_CASE("trimAt: a border that shapes share is trimmed from all of them, and what is left stays joined") {
    const Document document = *addShapes({}, {makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                                              makeShape(ShapeKind::Rectangle, {{4, 1}, {7, 3}})});
    const Result<Document> open = trimAt(document, 1, {4, 2});
    REQUIRE(open.ok());
    REQUIRE(open->shapes.size() == 2);
    CHECK(open->shapes[0]->nodes == std::vector<Vec2>{{4, 3}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 1}});
    CHECK(open->shapes[0]->isPolyline());
    REQUIRE(open->shapes[1]->isPolyline());
    CHECK(open->shapes[1]->nodes == std::vector<Vec2>{{4, 1}, {7, 1}, {7, 3}, {4, 3}});
    CHECK(open->shapes[1]->nodes == trimAt(document, 2, {4, 2})->shapes[1]->nodes);

    // A stretch beside that the neighbour does not run along, and a locked neighbour, change nothing of it.
    CHECK(*trimAt(document, 1, {4, 0.5})->shapes[1] == *document.shapes[1]);
    const Document locked = *setLocked(document, {2}, true);
    CHECK(*trimAt(locked, 1, {4, 2})->shapes[1] == *locked.shapes[1]);

    // A line that is the border alone goes; a curved border goes from both sides.
    const Document lines = *addShapes(document, {line({{4, 3}, {4, 1}})});
    CHECK(trimAt(lines, 1, {4, 2})->shapes.size() == 2);
    Document round = *addShapes({}, {makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}}), line({{-3, 0}, {3, 0}})});
    round = *trimAt(round, 1, {0, -2});
    const Shape half = *round.shapes[0];
    round = *addShapes(round, {half});
    const Result<Document> gone = trimAt(*addShapes(round, {line({{0, -1}, {0, 3}})}), 1, {1.4, 1.4});
    REQUIRE(gone.ok());
    CHECK(lengthOf(*gone->shapes[0]) == doctest::Approx(std::numbers::pi));
    CHECK(lengthOf(*gone->shapes[2]) == doctest::Approx(std::numbers::pi));
}

TEST_CASE("trimAt: a path that crosses itself loses its loop; cubics are cut exactly") {
    Shape loop = line({{0, 0}, {4, 0}, {4, 2}, {2, -2}});
    const Document document = *addShapes({}, {loop});
    const Result<Document> cut = trimAt(document, 1, {4, 1});
    REQUIRE(cut.ok());
    CHECK(cut->shapes.size() == 2);
    CHECK(findShape(*cut, 1)->nodes == std::vector<Vec2>{{0, 0}, {3, 0}});
    Shape wave = line({{0, 10}, {4, 10}});
    wave.path().curves = {Curve::cubic({0, 10}, {1, 14}, {3, 6}, {4, 10})};
    const Document waves = *addShapes({}, {wave, line({{1, 5}, {1, 15}}), line({{3, 5}, {3, 15}})});
    const Result<Document> pieces = trimAt(waves, 1, {2, 10});
    REQUIRE(pieces.ok());
    CHECK(findShape(*pieces, 1)->nodes.back().x == doctest::Approx(1));
    CHECK(findShape(*pieces, 4)->path().curves[0].kind() == CurveKind::Cubic);
    CHECK(checkShape(*findShape(*pieces, 4)).empty());
}

TEST_CASE("extendEnd: lines go straight on, arcs along their circle, cubics along their tangent, to the next line") {
    Shape arc = line({{0, -2}, {2, 0}});
    arc.path().curves = {Curve::arc({0, 0}, {2, 0}, {0, 2}, -std::numbers::pi / 2, std::numbers::pi / 2)};
    Shape cubic = line({{20, 0}, {22, 1}});
    cubic.path().curves = {Curve::cubic({20, 0}, {20.5, 1}, {21, 1}, {22, 1})};
    const Document document =
        *addShapes({}, {arc, line({{-3, 1}, {3, 1}}), line({{10, 0}, {11, 0}}), line({{13, -1}, {13, 1}}),
                        line({{15, -1}, {15, 1}}), cubic, line({{25, 0}, {25, 2}})});
    const Result<Document> straight = extendEnd(document, {3, 1});
    REQUIRE(straight.ok());
    CHECK(findShape(*straight, 3)->nodes == std::vector<Vec2>{{10, 0}, {13, 0}});
    CHECK(findShape(*straight, 4)->nodes.size() == 3);
    CHECK(findShape(*extendEnd(*straight, {3, 1}), 3)->nodes.back() == Vec2{15, 0}); // on, from line to line
    const Result<Document> round = extendEnd(document, {1, 1});
    REQUIRE(round.ok());
    CHECK(distance(findShape(*round, 1)->nodes[1], {std::sqrt(3.0), 1}) < 1e-9);
    CHECK(lengthOf(*findShape(*round, 1)) == doctest::Approx(2.0 * (std::numbers::pi / 2 + std::asin(0.5))));
    const Result<Document> back = extendEnd(document, {1, 0}); // the other way round, to the far side of the line
    REQUIRE(back.ok());
    CHECK(distance(findShape(*back, 1)->nodes[0], {-std::sqrt(3.0), 1}) < 1e-9);
    const Result<Document> tangent = extendEnd(document, {6, 1});
    REQUIRE(tangent.ok());
    CHECK(findShape(*tangent, 6)->nodes.back() == Vec2{25, 1});
    CHECK(findShape(*tangent, 6)->nodes.size() == 3);
    CHECK(codeOf(extendEnd(document, {4, 1})) == "not-possible");
    CHECK(codeOf(extendEnd(document, {4, 7})) == "no-such-node");
    const Document closed = *addShape(document, square({50, 50}, 1));
    CHECK(codeOf(extendEnd(closed, {8, 0})) == "not-possible");
}

TEST_CASE("extendEnd and trimAt: an end that meets its own path becomes a node there") {
    const Document hook = *addShape({}, line({{0, 0}, {6, 0}, {6, 4}, {3, 4}, {3, 2}}));
    const Result<Document> extended = extendEnd(hook, {1, 4});
    REQUIRE(extended.ok());
    CHECK(findShape(*extended, 1)->nodes == std::vector<Vec2>{{0, 0}, {3, 0}, {6, 0}, {6, 4}, {3, 4}, {3, 0}});

    const Document loop = *addShape({}, line({{0, 0}, {4, 0}, {4, 2}, {2, -2}}));
    const Result<Document> tail = trimAt(loop, 1, {2.2, -1.6});
    REQUIRE(tail.ok());
    CHECK(findShape(*tail, 1)->nodes == std::vector<Vec2>{{0, 0}, {3, 0}, {4, 0}, {4, 2}, {3, 0}});

    Shape curved = line({{0, 0}, {6, 0}, {6, 4}, {3, 4}, {3, 2}});
    curved.path().curves = {Curve::arc({3, 0}, {3, 0}, {0, 1}, std::numbers::pi, std::numbers::pi), Curve(), Curve(),
                            Curve()};
    curved.segmentTags = {5, 6, 7, 8};
    const Result<Document> onArc = extendEnd(*addShape({}, curved), {1, 4});
    REQUIRE(onArc.ok());
    const Shape &joined = *findShape(*onArc, 1);
    REQUIRE(joined.nodes.size() == 6);
    CHECK(joined.segmentTags == std::vector<std::int32_t>{5, 5, 6, 7, 8});
    CHECK(distance(joined.nodes[1], {3, -1}) < 1e-9);
    CHECK(joined.path().curves[0].kind() == CurveKind::Arc);
    CHECK(checkShape(joined).empty());
}

TEST_CASE("trimAt, extendEnd: a line that is equal to another gives that up and moves nothing else") {
    const Document drawn = documentOf({square({0, 0}, 6), line({{-1, 3}, {5, 3}}), line({{-1, 4}, {5, 4}})});
    const auto equal = [](const Document &document, std::uint32_t id) {
        Result<Document> next = addConstraint(document, ConstraintKind::Equal,
                                              {{id, SketchPartKind::Segment, 0}, {1, SketchPartKind::Segment, 1}});
        REQUIRE(next.ok());
        return *std::move(next);
    };
    const Document before = equal(drawn, 2);
    const Result<Document> trimmed = trimAt(before, 2, {-0.5, 3});
    REQUIRE(trimmed.ok());
    const Result<Document> settled = settleCommand(before, *trimmed);
    REQUIRE(settled.ok());
    CHECK(settled->constraints.empty());
    CHECK(findShape(*settled, 2)->nodes == std::vector<Vec2>{{0, 3}, {5, 3}});
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{6, 0}, Vec2{6, 6}, Vec2{0, 6}}) {
        const std::vector<Vec2> nodes = handlesOf(*findShape(*settled, 1));
        CHECK(std::find(nodes.begin(), nodes.end(), corner) != nodes.end());
    }
    const Result<Document> longer = extendEnd(before, {2, 1});
    REQUIRE(longer.ok());
    const Result<Document> kept = settleCommand(before, *longer);
    REQUIRE(kept.ok());
    CHECK(kept->constraints.empty());
    CHECK(findShape(*kept, 2)->nodes.back() == Vec2{6, 3});
    // What another line is equal to stays.
    const Document other = equal(before, 3);
    const Result<Document> cut = trimAt(other, 2, {-0.5, 3});
    REQUIRE(cut.ok());
    CHECK(cut->constraints.size() == 1);
}
