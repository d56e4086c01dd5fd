#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/picking/dragged_parts.hpp"
#include "core/drawing/picking/pick_index.hpp"
#include "core/drawing/picking/pointer_snap.hpp"
#include "core/drawing/shapes/curve_crossings.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

std::shared_ptr<const Document> snapDocument(std::vector<Shape> shapes) {
    return std::make_shared<const Document>(documentOf(std::move(shapes)));
}

} // namespace

TEST_CASE("snap: nodes take precedence over segments, and segments over the grid; with Ctrl nothing snaps") {
    const PickIndex index(snapDocument({square({0, 0}, 4)}));
    SnapQuery query;
    query.tolerance = 0.2;
    query.gridPitch = 1.0;
    query.at = {4.1, 0.1};
    CHECK(snap(index, query).kind == SnapKind::Node);
    CHECK(snap(index, query).at == Vec2{4, 0});
    query.at = {2.55, 0.1};
    CHECK(snap(index, query).kind == SnapKind::Segment);
    CHECK(snap(index, query).at == Vec2{3, 0}); // on the segment and on the grid
    query.at = {2.1, 2.9};
    CHECK(snap(index, query).kind == SnapKind::Grid);
    CHECK(snap(index, query).at == Vec2{2, 3});
    query.at = {2.6, 2.4};
    CHECK(snap(index, query).kind == SnapKind::Grid); // anywhere, not only near its points
    CHECK(snap(index, query).at == Vec2{3, 2});
    query.gridPitch = 0.0;
    CHECK(snap(index, query).kind == SnapKind::None);
    query.gridPitch = 1.0;
    query.at = {4.1, 0.1};
    query.off = true;
    CHECK(snap(index, query).at == query.at);
    query.off = false;
    query.filter = [](const Shape &) { return false; };
    CHECK(snap(index, query).kind == SnapKind::Grid);
}

TEST_CASE("snap: the grid has no negative zero") {
    const PickIndex index(snapDocument({}));
    SnapQuery query;
    query.tolerance = 0.2;
    for (const double pitch : {0.1, 1.0, 3.0}) {
        query.gridPitch = pitch;
        query.at = {-0.01, -0.02};
        CHECK(snap(index, query).at == Vec2{});
        CHECK_FALSE(std::signbit(snap(index, query).at.x));
        CHECK_FALSE(std::signbit(snap(index, query).at.y));
    }
}

TEST_CASE("snap: what slides along a segment or a guide takes its other coordinate from the grid") {
    Document document = documentOf({makeShape(ShapeKind::Polyline, {{0.3, 0.25}, {3.8, 0.25}}),
                                    makeShape(ShapeKind::Polyline, {{6, 1}, {9, 3.1}})});
    document.guides = {{true, 4.6}};
    const PickIndex index(std::make_shared<const Document>(document));
    SnapQuery query;
    query.tolerance = 0.2;
    query.gridPitch = 1.0;
    query.at = {1.4, 0.3};
    CHECK(snap(index, query).at == Vec2{1, 0.25});
    query.at = {3.55, 0.3}; // the line of the grid is beyond the end
    CHECK(snap(index, query).at == Vec2{3.55, 0.25});
    query.at = {7.1, 1.8}; // slanted: the nearest point
    const Snapped slanted = snap(index, query);
    CHECK(slanted.kind == SnapKind::Segment);
    CHECK(slanted.at == slanted.segment->at);
    query.gridPitch = 0.1;
    query.at = {-20.72, 30.31};
    CHECK(snap(index, query).at == Vec2{-20.7, 30.3}); // with the digits that a user would type
    query.gridPitch = 1.0;
    query.at = {4.5, 5.4};
    CHECK(snap(index, query).kind == SnapKind::Guide);
    CHECK(snap(index, query).at == Vec2{4.6, 5});
}

TEST_CASE("snap: the grid leaves a direction with a typed length alone, and a typed coordinate its other one") {
    const PickIndex index(snapDocument({square({20, 20}, 4)}));
    SnapQuery query;
    query.tolerance = 0.2;
    query.gridPitch = 1.0;
    query.anchor = Vec2{0, 0};
    query.at = {3.4, 2.55};
    query.locks.distance = 10.0;
    CHECK(distance(snap(index, query).at, (10.0 / length(query.at)) * query.at) < 1e-12);
    CHECK(wordsOf(snap(index, query)) == "length locked");
    query.locks.isRadius = true;
    CHECK(wordsOf(snap(index, query)) == "radius locked");
    query.locks = {};
    query.locks.x = 3.3;
    CHECK(snap(index, query).at == Vec2{3.3, 3});
}

TEST_CASE("snap: midpoints, centres and crossings of all kinds of segments") {
    Shape arc = makeShape(ShapeKind::Polyline, {{10, 0}, {12, 0}});
    arc.path().curves = {arcThrough({10, 0}, {11, 1}, {12, 0})};
    const PickIndex index(snapDocument(
        {makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 2}}), arc, makeShape(ShapeKind::Circle, {{20, 0}, {21, 0}}),
         makeShape(ShapeKind::Polyline, {{10, -1}, {14, 3}}), makeShape(ShapeKind::Polyline, {{19, 0.6}, {22, 0.6}})}));
    const auto snapped = [&](Vec2 at) {
        SnapQuery query;
        query.tolerance = 0.1;
        query.at = at;
        return snap(index, query);
    };
    CHECK(snapped({2.05, 0.05}).kind == SnapKind::Midpoint);
    CHECK(snapped({2.05, 0.05}).at == Vec2{2, 0});
    CHECK(snapped({11.02, 1.05}).kind == SnapKind::Midpoint);
    CHECK(distance(snapped({11.02, 1.05}).at, {11, 1}) < 1e-12);
    CHECK(snapped({1.95, 1.05}).kind == SnapKind::Centre); // of the rectangle
    CHECK(snapped({1.95, 1.05}).at == Vec2{2, 1});
    CHECK(snapped({20.05, 0}).kind == SnapKind::Centre);
    CHECK(distance(snapped({11.05, 0.05}).at, {11, 0}) < 1e-12); // of the arc; the line passes there, too
    const Snapped onCircle = snapped({20.75, 0.65});
    CHECK(onCircle.kind == SnapKind::Intersection);
    CHECK(distance(onCircle.at, {20.8, 0.6}) < 1e-12);
    const Snapped onArc = snapped({11.74, 0.68});
    CHECK(onArc.kind == SnapKind::Intersection);
    CHECK(distance(onArc.at, {11 + std::sqrt(0.5), std::sqrt(0.5)}) < 1e-9);
    CHECK(snapped({13.1, 2.1}).kind == SnapKind::Segment);
    CHECK(wordsOf(onArc) == "intersection");
    CHECK(wordsOf({{}, SnapKind::Grid}) == "grid");
    CHECK(wordsOf(Snapped{}).empty());
}

TEST_CASE("snap: perpendiculars and tangents from the anchor, while a line is drawn") {
    Shape wave = makeShape(ShapeKind::Polyline, {{0, 10}, {4, 10}});
    wave.path().curves = {Curve::cubic({0, 10}, {1, 12}, {3, 8}, {4, 10})};
    const PickIndex index(snapDocument(
        {makeShape(ShapeKind::Polyline, {{0, 0}, {8, 4}}), makeShape(ShapeKind::Circle, {{20, 0}, {21, 0}}), wave}));
    SnapQuery query;
    query.tolerance = 0.1;
    query.lines = {Vec2{3, 6}};
    query.at = {4.85, 2.38};
    CHECK(snap(index, query).kind == SnapKind::Perpendicular);
    CHECK(distance(snap(index, query).at, {4.8, 2.4}) < 1e-12);
    query.lines.clear(); // as when a shape is moved
    CHECK(snap(index, query).kind == SnapKind::Segment);
    query.lines = {Vec2{20, -9}, Vec2{18, 0}};
    query.at = {19.52, 0.9};
    CHECK(snap(index, query).kind == SnapKind::Tangent);
    CHECK(distance(snap(index, query).at, {19.5, std::sqrt(0.75)}) < 1e-12);
    query.at = {20.98, -0.05};
    CHECK(snap(index, query).kind == SnapKind::Node); // the point of the circle
    query.lines = {Vec2{20, 3}};
    query.at = {20.03, -1.02};
    CHECK(snap(index, query).kind == SnapKind::Perpendicular); // on the far side
    CHECK(distance(snap(index, query).at, {20, -1}) < 1e-12);
    query.lines = {Vec2{1, 14}};
    query.at = wave.path().curves[0].point(0.2);
    const Snapped onWave = snap(index, query);
    CHECK(onWave.kind == SnapKind::Perpendicular);
    CHECK(std::abs(dot(onWave.at - *onWave.from,
                       wave.path().curves[0].tangent(wave.path().curves[0].nearest(onWave.at)))) < 1e-6);
    query.at = wave.path().curves[0].point(0.4);
    CHECK(snap(index, query).kind == SnapKind::Segment);
}

TEST_CASE("snap: perpendiculars far from the origin, and opposite the point of a circle there is no midpoint") {
    const Vec2 far{5e6, 5.4e6};
    const PickIndex index(snapDocument({makeShape(ShapeKind::Polyline, {far, far + Vec2{80, 40}}),
                                        makeShape(ShapeKind::Circle, {far + Vec2{200, 0}, far + Vec2{210, 0}})}));
    SnapQuery query;
    query.tolerance = 1.0;
    query.lines = {far + Vec2{30, 60}};
    query.at = far + Vec2{48.5, 23.8};
    CHECK(snap(index, query).kind == SnapKind::Perpendicular);
    CHECK(distance(snap(index, query).at, far + Vec2{48, 24}) < 1e-8);
    const PickIndex atOrigin(snapDocument({makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}})}));
    query = {};
    query.tolerance = 0.1;
    query.at = {-1.01, 0.01};
    CHECK(snap(atOrigin, query).kind == SnapKind::Segment);
}

TEST_CASE("snap: shift keeps to multiples of 15 degrees from the anchor, exactly so along the axes") {
    const PickIndex index(snapDocument({}));
    SnapQuery query;
    query.anchor = Vec2{1, 1};
    query.angle = true;
    query.at = {5, 1.3};
    CHECK(snap(index, query).at == Vec2{5, 1});
    query.at = {0.8, -7};
    CHECK(snap(index, query).at.x == 1.0);
    query.at = {4, 4.2};
    const Vec2 diagonal = snap(index, query).at - *query.anchor;
    CHECK(diagonal.x == doctest::Approx(diagonal.y));
    query.at = {3, 2};
    const Vec2 thirty = snap(index, query).at - *query.anchor;
    CHECK(std::atan2(thirty.y, thirty.x) == doctest::Approx(std::acos(-1.0) / 6));
    CHECK(wordsOf(snap(index, query)) == "angle 30\xc2\xb0");
    query.at = *query.anchor + Vec2{2, -0.01};
    CHECK(wordsOf(snap(index, query)) == "angle 0\xc2\xb0");
    query.at = {3, -5};
    CHECK(wordsOf(snap(index, query)) == "angle 285\xc2\xb0");
    query.angleStep = 22.5;
    query.at = {3, 2};
    CHECK(wordsOf(snap(index, query)) == "angle 22.5\xc2\xb0");
}

TEST_CASE("snap: locked coordinates stay fixed, the others still snap") {
    const PickIndex index(snapDocument({square({0, 0}, 4)}));
    SnapQuery query;
    query.tolerance = 0.5;
    query.at = {4.1, 0.1};
    query.locks.x = 3.25;
    CHECK(snap(index, query).at == Vec2{3.25, 0}); // y is drawn to the node (4, 0)
    CHECK(snap(index, query).kind == SnapKind::Locked);
    CHECK(wordsOf(snap(index, query)) == "x locked, node");
    query.at = {7.1, 1.4};
    CHECK(wordsOf(snap(index, query)) == "x locked");
    CHECK(wordsOf(lockedAt({1, 2})) == "x, y locked");
    query.locks = {};
    query.anchor = Vec2{1, 1};
    query.locks.distance = 2.0;
    CHECK(distance(snap(index, query).at, {1, 1}) == doctest::Approx(2));
    query.locks.angle = 90.0;
    CHECK(snap(index, query).at == Vec2{1, 3});
    query.locks.distance.reset();
    query.at = {7, 5};
    CHECK(snap(index, query).at == Vec2{1, 5});
    query.locks.y = 9.0;
    CHECK(snap(index, query).at == Vec2{1, 9});
}

TEST_CASE("gridPitch: 1, 2 or 5 times a power of ten, at least as wide as requested") {
    CHECK(gridPitch(1.0 / 24.0) == doctest::Approx(1));
    CHECK(gridPitch(0.01) == doctest::Approx(0.2));
    CHECK(gridPitch(0.06) == doctest::Approx(2));
    CHECK(gridPitch(3.0) == doctest::Approx(100));
    CHECK(gridPitch(0.0) == 0.0);
    CHECK(gridPitch(std::nan("")) == 0.0);
}
