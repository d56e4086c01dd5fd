#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

using std::numbers::pi;

/// Returns the control points of the segments at a node.
std::vector<Control> controlsAt(const Document &document, std::uint32_t node) {
    Selection selection;
    selection.nodes = {{1, node}};
    return controlsOf(document, selection);
}

} // namespace

TEST_CASE("setNodeKind: smooth and symmetric nodes bend the segments beside them, corners straighten them") {
    const Document document = documentOf({square({0, 0}, 6)});
    const Result<Document> smooth = setNodeKind(document, {{1, 1}}, NodeKind::Smooth);
    REQUIRE(smooth.ok());
    const Shape &shape = *smooth->shapes[0];
    CHECK(nodeKind(shape, 1) != NodeKind::Corner);
    CHECK(nodeKind(shape, 0) == NodeKind::Corner);
    REQUIRE(shape.path().curves.size() == 4);
    CHECK(shape.path().curves[0].tangent(1.0) == shape.path().curves[1].tangent(0.0));
    CHECK(cross(shape.path().curves[0].tangent(1.0), Vec2{1, 1}) == doctest::Approx(0.0)); // parallel to (0, 0)-(6, 6)
    CHECK(shape.path().curves[2].kind() == CurveKind::Line);
    CHECK(validate(toDomain(*smooth)).empty());
    const Result<Document> far = setHandle(document, {1, 1}, {9, 0});
    const Result<Document> symmetric = setNodeKind(*far, {{1, 1}}, NodeKind::Symmetric);
    REQUIRE(symmetric.ok());
    CHECK(nodeKind(*symmetric->shapes[0], 1) == NodeKind::Symmetric);
    const Result<Document> corner = setNodeKind(*symmetric, {{1, 1}}, NodeKind::Corner);
    REQUIRE(corner.ok());
    CHECK(nodeKind(*corner->shapes[0], 1) == NodeKind::Corner);
    CHECK(controlsAt(*corner, 1).size() == 4);
    CHECK(codeOf(setNodeKind(document, {{1, 4}}, NodeKind::Smooth)) == "no-such-node");
    const Document circle = documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}})});
    CHECK(codeOf(setNodeKind(circle, {{1, 0}}, NodeKind::Smooth)) == "not-possible");
}

TEST_CASE("moveControl: at a smooth node the opposite control point turns with it") {
    Document document = *setHandle(documentOf({square({0, 0}, 6)}), {1, 1}, {9, 0});
    for (const NodeKind kind : {NodeKind::Smooth, NodeKind::Symmetric}) {
        const Document bent = *setNodeKind(document, {{1, 1}}, kind);
        const double before = distance(bent.shapes[0]->path().curves[1].point(0.0), controlsAt(bent, 1)[2].at);
        const Result<Document> moved = moveControl(bent, {1, 0, true}, {9, -2});
        REQUIRE(moved.ok());
        CHECK(nodeKind(*moved->shapes[0], 1) == kind);
        for (const Control &control : controlsAt(*moved, 1)) {
            if (control.ref == ControlRef{1, 0, true}) {
                CHECK(control.at == Vec2{9, -2});
            }
            if (control.ref == ControlRef{1, 1, false}) {
                CHECK(control.at.x == doctest::Approx(9.0));
                CHECK(control.at.y == doctest::Approx(kind == NodeKind::Symmetric ? 2.0 : before));
            }
        }
        const Result<Document> alone = moveControl(bent, {1, 0, true}, {8, -2}, true);
        REQUIRE(alone.ok());
        CHECK(nodeKind(*alone->shapes[0], 1) == NodeKind::Corner);
        CHECK(alone->shapes[0]->path().curves[1] == bent.shapes[0]->path().curves[1]);
    }
    CHECK(codeOf(moveControl(document, {1, 0, true}, {8, -2})) == "no-such-control point");
    CHECK(codeOf(moveControl(document, {7, 0, true}, {8, -2})) == "no-such-shape");
}

TEST_CASE(
    "setCurved: a line becomes a cubic along it, an arc becomes a cubic near it, and both can become lines again") {
    const Document document = documentOf({square({0, 0}, 6)});
    const Result<Document> curved = setCurved(document, {{1, 0}, {1, 2}}, true);
    REQUIRE(curved.ok());
    CHECK(curved->shapes[0]->path().curves[0] == Curve::cubic({0, 0}, {2, 0}, {4, 0}, {6, 0}));
    CHECK(areaOf(*curved->shapes[0]) == doctest::Approx(36.0));
    CHECK(sameContent(*setCurved(*curved, {{1, 0}, {1, 2}}, false), document));
    const Document circle = *convertToPath(documentOf({makeShape(ShapeKind::Circle, {{1, 1}, {3, 1}})}), 1);
    const Result<Document> cubics = setCurved(circle, {{1, 0}, {1, 1}, {1, 2}, {1, 3}}, true);
    REQUIRE(cubics.ok());
    const Curve &quarter = cubics->shapes[0]->path().curves[0];
    REQUIRE(quarter.kind() == CurveKind::Cubic);
    for (double t = 0.0; t <= 1.0; t += 0.1) {
        CHECK(distance(quarter.point(t), {1, 1}) == doctest::Approx(2.0).epsilon(3e-4));
    }
    CHECK(codeOf(setCurved(document, {{1, 4}}, true)) == "no-such-segment");
}

TEST_CASE("setCurved: an arc of more than a quarter turn is divided, and the cubics stay near it") {
    constexpr double kSweep = 1.75 * pi; // a single cubic would be far off
    const Curve arc = Curve::arc({0, 0}, {2, 0}, {0, 2}, 0.0, kSweep);
    Shape path = makeShape(ShapeKind::Polygon, {arc.point(0.0), arc.point(1.0), {0, 0}});
    path.path().curves = {arc, Curve(), Curve()};
    path.segmentTags = {5, 6, 7};
    const Document document = documentOf({path});
    const Result<Document> cubics = setCurved(document, {{1, 0}, {1, 2}}, true);
    REQUIRE(cubics.ok());
    const Shape &shape = *cubics->shapes[0];
    REQUIRE(shape.nodes.size() == 6);
    CHECK(shape.segmentTags == std::vector<std::int32_t>{5, 5, 5, 5, 6, 7});
    for (std::size_t k = 0; k < 4; ++k) {
        REQUIRE(shape.path().curves[k].kind() == CurveKind::Cubic);
        for (double t = 0.0; t <= 1.0; t += 0.125) {
            CHECK(distance(shape.path().curves[k].point(t), {0, 0}) == doctest::Approx(2.0).epsilon(3e-4));
        }
    }
    CHECK(shape.path().curves[4].kind() == CurveKind::Line);
    CHECK(shape.path().curves[5].kind() == CurveKind::Cubic);
    CHECK(areaOf(shape) == doctest::Approx(areaOf(path)).epsilon(1e-3));
}

TEST_CASE("setNodeKind: a smooth node beside a long arc has control points near the arc") {
    const Curve arc = Curve::arc({0, 0}, {2, 0}, {0, 2}, 0.0, 1.9 * pi);
    Shape path = makeShape(ShapeKind::Polygon, {arc.point(0.0), arc.point(1.0), {1, -0.2}});
    path.path().curves = {arc, Curve(), Curve()};
    const Result<Document> smooth = setNodeKind(documentOf({path}), {{1, 0}}, NodeKind::Smooth);
    REQUIRE(smooth.ok());
    const Box2 box = smooth->shapes[0]->path().curves[0].bounds();
    CHECK(box.diagonal() < 20.0);
}

TEST_CASE("convertToPaths: converts what it can, and fails if there is nothing to convert") {
    const Document document = documentOf({makeShape(ShapeKind::Circle, {{1, 1}, {3, 1}}), square({5, 5}, 1),
                                          makeShape(ShapeKind::Rectangle, {{0, 0}, {1, 2}})});
    const Result<Document> paths = convertToPaths(document, {1, 2, 3});
    REQUIRE(paths.ok());
    CHECK(isPath(*paths->shapes[0]));
    CHECK(isPath(*paths->shapes[2]));
    CHECK(codeOf(convertToPaths(document, {2})) == "not-possible");
}

TEST_CASE("splitPath and joinEnds: joining the parts restores the path") {
    Shape tagged = square({0, 0}, 6);
    tagged.segmentTags = {1, 2, 3, 4};
    tagged.path().curves = {{}, Curve::arc({6, 3}, {0, -3}, {3, 0}, 0.0, pi), {}, {}};
    const Document document = documentOf({tagged});
    const Result<Document> open = splitPath(document, {1, 2});
    REQUIRE(open.ok());
    CHECK(open->shapes[0]->kind() == ShapeKind::Polyline);
    CHECK(open->shapes[0]->nodes == std::vector<Vec2>{{6, 6}, {0, 6}, {0, 0}, {6, 0}, {6, 6}});
    CHECK(open->shapes[0]->segmentTags == std::vector<std::int32_t>{3, 4, 1, 2});
    CHECK(sortedSegments(toDomain(*open)) == sortedSegments(toDomain(document)));
    const Result<Document> parts = splitPath(*open, {1, 3});
    REQUIRE(parts.ok());
    REQUIRE(parts->shapes.size() == 2);
    CHECK(parts->shapes[1]->path().curves.size() == 1);
    CHECK(parts->shapes[1]->tag == 1);
    CHECK(sortedSegments(toDomain(*parts)) == sortedSegments(toDomain(document)));
    CHECK(codeOf(splitPath(*parts, {1, 0})) == "not-possible");
    const std::uint32_t second = parts->shapes[1]->id;
    const Result<Document> joined = joinEnds(*parts, {1, 3}, {second, 0});
    REQUIRE(joined.ok());
    CHECK(sameContent(*joined, *open));
    const Result<Document> turned = joinEnds(*parts, {second, 1}, {1, 0}); // both begin where the other ends
    REQUIRE(turned.ok());
    CHECK(sortedSegments(toDomain(*turned)) == sortedSegments(toDomain(document)));
    const Result<Document> closed = joinEnds(*joined, {1, 0}, {1, 4});
    REQUIRE(closed.ok());
    CHECK(closed->shapes[0]->kind() == ShapeKind::Polygon);
    CHECK(sortedSegments(toDomain(*closed)) == sortedSegments(toDomain(document)));
    CHECK(codeOf(joinEnds(document, {1, 0}, {1, 2})) == "not-possible");
    CHECK(codeOf(joinEnds(*joined, {1, 0}, {1, 0})) == "not-possible");
    const Document apart = documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {1, 0}}),
                                       makeShape(ShapeKind::Polyline, {{3, 1}, {2, 0}}, ShapeUse::Boundary, 5)});
    const Result<Document> bridged = joinEnds(apart, {1, 1}, {2, 1});
    REQUIRE(bridged.ok());
    CHECK(bridged->shapes[0]->nodes == std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}, {3, 1}});
    CHECK(bridged->shapes[0]->segmentTags == std::vector<std::int32_t>{1, 1, 5});
}

TEST_CASE("arcThrough: the arc passes its three points in their order") {
    Random random(5);
    for (int k = 0; k < 500; ++k) {
        const Vec2 centre = random.place(5);
        const double radius = random.real(0.1, 4), from = random.real(-4, 4), sweep = random.real(-6, 6);
        const auto at = [&](double angle) { return centre + radius * Vec2{std::cos(angle), std::sin(angle)}; };
        if (std::fabs(sweep) < 0.1) {
            continue;
        }
        const Curve arc = arcThrough(at(from), at(from + 0.4 * sweep), at(from + sweep));
        REQUIRE(arc.kind() == CurveKind::Arc);
        CHECK(arc.numbers()[7] == doctest::Approx(sweep));
        CHECK(distance(arc.point(0.4), at(from + 0.4 * sweep)) <= 1e-9);
        CHECK(distance(arc.point(1.0), at(from + sweep)) <= 1e-9);
    }
    CHECK(arcThrough({0, 0}, {1, 1}, {3, 3}).kind() == CurveKind::Line);
    const Curve half = arcOfRadius({0, 0}, {4, 0}, 1.0, {2, 1});
    CHECK(half.numbers()[7] == doctest::Approx(-pi));
    CHECK(arcOfRadius({0, 0}, {4, 0}, 2.5, {2, 1}).length() < 2.5 * pi);
    CHECK(arcOfRadius({0, 0}, {4, 0}, 2.5, {2, 9}).length() > 2.5 * pi);
    const auto numbers = arcOfRadius({0, 0}, {4, 0}, 2.5, {2, -9}).numbers();
    CHECK(length({numbers[2], numbers[3]}) == doctest::Approx(2.5));
}
