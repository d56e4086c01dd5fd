#include "core/drawing/commands/combine_shapes.hpp"
#include "core/drawing/commands/join_segments.hpp"
#include "core/drawing/commands/repair_drawing.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/chain_shape.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/picking/pick_index.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"
#include "core/files/text/atomic_file.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <utility>

using namespace forefront;
using namespace forefront::edit_test;
using namespace forefront::testing;

namespace {

using std::numbers::pi;

const Curve kWave = Curve::cubic({0, 0}, {1, -2}, {3, 2}, {4, 0});

/// A closed path: a wave at the bottom, a half circle on the right, a straight line back.
Shape sail() {
    Shape shape = makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 4}}, ShapeUse::Boundary, 3);
    shape.path().curves = {kWave, Curve::arc({4, 2}, {0, -2}, {2, 0}, 0.0, pi), {}};
    shape.segmentTags = {3, 4, 5};
    return shape;
}

Shape roundedBox(double radius) {
    Shape shape = makeShape(ShapeKind::Rectangle, {{0, 0}, {6, 4}});
    shape.as<RectangleForm>().radius = radius;
    return shape;
}

} // namespace

TEST_CASE("toDomain: curved segments become chords that follow their curves, with the tags of the segments") {
    const Document document = documentOf({sail()});
    const Domain domain = toDomain(document);
    REQUIRE(domain.curves.size() == 2);
    CHECK(domain.curves[0] == kWave);
    CHECK(validate(domain).empty());
    for (const DomainSegment &segment : domain.segments) {
        if (segment.stretch.follows()) {
            const Curve &curve = domain.curves[segment.stretch.curve];
            CHECK(distance(curve.point(segment.stretch.t0), domain.nodes[segment.a]) <= 1e-12);
            CHECK(distance(curve.point(segment.stretch.t1), domain.nodes[segment.b]) <= 1e-12);
            CHECK(segment.tag == static_cast<std::int32_t>(3 + segment.stretch.curve));
        } else {
            CHECK(segment.tag == 5);
        }
    }
    const CurveChains chains = curveChains(domain);
    CHECK(chains.list.size() == 2);
    CHECK(fromDomain(domain).shapes[0]->path().curves == sail().path().curves);
}

TEST_CASE("Shapes with curves: bounds, area and length are those of the curves") {
    const Shape shape = sail();
    CHECK(boundsOf(shape).max == Vec2{6, 4});
    CHECK(boundsOf(shape).min.y == doctest::Approx(kWave.bounds().min.y));
    CHECK(areaOf(shape) == doctest::Approx(8.0 + 2.0 * pi)); // the wave is symmetric
    CHECK(lengthOf(shape) == doctest::Approx(kWave.length() + 2.0 * pi + std::sqrt(32.0)));
    CHECK(contains(shape, {5.5, 2}));
    CHECK_FALSE(contains(shape, {5.9, 0.2}));
    Shape ellipse = makeShape(ShapeKind::Ellipse, {{1, 1}, {4, 1}, {1, 3}});
    CHECK(areaOf(ellipse) == doctest::Approx(6.0 * pi));
    CHECK(boundsOf(ellipse).min.x == doctest::Approx(-2.0));
    CHECK(boundsOf(ellipse).max.y == doctest::Approx(3.0));
    CHECK(areaOf(roundedBox(1.0)) == doctest::Approx(24.0 - 4.0 + pi));
    CHECK(lengthOf(roundedBox(1.0)) == doctest::Approx(12.0 + 2.0 * pi));
}

TEST_CASE("A rectangle with rounded corners: sides without length vanish, tags are those of the sides") {
    for (const double radius : {0.5, 2.0, 9.0}) { // half the shorter side is 2
        CAPTURE(radius);
        Shape box = roundedBox(radius);
        box.segmentTags = {1, 2, 3, 4};
        const Outline outline = outlineOf(box);
        CHECK(outline.segmentCount() == (radius < 2.0 ? 8 : 6));
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            CHECK(joins(outline.curve(k), outline.from(k), outline.to(k)));
        }
        const Document document = documentOf({box});
        const Domain domain = toDomain(document);
        CHECK(validate(domain).empty());
        std::set<std::int32_t> tags;
        for (const DomainSegment &segment : domain.segments) {
            tags.insert(segment.tag);
        }
        CHECK(tags == std::set<std::int32_t>{1, 2, 3, 4});
        const Result<Document> path = convertToPath(document, 1);
        REQUIRE_MESSAGE(path.ok(), messages(path.faults()));
        CHECK(sameDomain(toDomain(*path), domain));
    }
}

TEST_CASE("convertToPath: a circle becomes a path of four arcs") {
    const Document document = documentOf({makeShape(ShapeKind::Circle, {{1, 2}, {4, 6}}, ShapeUse::Boundary, 7)});
    const Result<Document> path = convertToPath(document, 1);
    REQUIRE(path.ok());
    const Shape &shape = *path->shapes[0];
    CHECK(shape.kind() == ShapeKind::Polygon);
    CHECK(shape.nodes.size() == 4);
    CHECK(curvedSegments(*path) == 4);
    CHECK(areaOf(shape) == doctest::Approx(25.0 * pi));
    CHECK(shape.tag == 7);
    CHECK(convertToPath(*path, 1).faults().front().code == "not-possible");
}

TEST_CASE("insertNode and deleteSelection: a divided curve keeps its shape, and deleting the node restores it") {
    const Document document = documentOf({sail()});
    const Vec2 on = kWave.point(0.375);
    const Result<Document> divided = insertNode(document, {1, 0}, on);
    REQUIRE_MESSAGE(divided.ok(), messages(divided.faults()));
    const Shape &shape = *divided->shapes[0];
    REQUIRE(shape.path().curves.size() == 4);
    CHECK(shape.nodes[1] == on);
    CHECK(shape.segmentTags == std::vector<std::int32_t>{3, 3, 4, 5});
    for (double t = 0.0; t <= 1.0; t += 0.125) {
        const Curve &half = shape.path().curves[t < 0.375 ? 0 : 1];
        const double own = t < 0.375 ? t / 0.375 : (t - 0.375) / 0.625;
        CHECK(distance(half.point(own), kWave.point(t)) <= 1e-12);
    }
    Selection node;
    node.nodes = {{1, 1}};
    const Document merged = deleteSelection(*divided, node);
    REQUIRE(merged.shapes[0]->path().curves.size() == 3);
    double worst = 0.0;
    for (double t = 0.0; t <= 1.0; t += 0.0625) {
        const Curve &back = merged.shapes[0]->path().curves[0];
        worst = std::max(worst, distance(back.point(back.nearest(kWave.point(t))), kWave.point(t)));
    }
    CHECK(worst <= 0.02);
    const Result<Document> arc = insertNode(document, {1, 1}, {6, 2});
    REQUIRE(arc.ok());
    node.nodes = {{1, 2}};
    const Curve whole = deleteSelection(*arc, node).shapes[0]->path().curves[1]; // arcs of one circle join exactly
    REQUIRE(whole.kind() == CurveKind::Arc);
    CHECK(whole.numbers()[7] == doctest::Approx(pi));
}

TEST_CASE("moveSelection: curves move with their shapes, and bend with their nodes") {
    const Document document = documentOf({sail()});
    Selection whole, node, both;
    whole.shapes = {1};
    const Shape moved = *moveSelection(document, whole, {1.0 / 3.0, 100})->shapes[0];
    CHECK(moved.path().curves[1].numbers()[4] == 2.0);
    CHECK(joins(moved.path().curves[1], moved.nodes[1], moved.nodes[2]));
    node.nodes = {{1, 1}};
    const Shape bent = *moveSelection(document, node, {0, -1})->shapes[0];
    CHECK(bent.path().curves[0] == Curve::cubic({0, 0}, {1, -2}, {3, 1}, {4, -1}));
    CHECK(joins(bent.path().curves[1], {4, -1}, {4, 4}));
    CHECK(bent.path().curves[1].turning() == doctest::Approx(pi)); // still a half circle
    both.segments = {{1, 1}};                                      // both ends by the length of the arc's chord
    const Shape shifted = *moveSelection(document, both, {0, 4})->shapes[0];
    CHECK(joins(shifted.path().curves[1], {4, 4}, {4, 8}));
    CHECK(moveSelection(document, node, {0, 4}).faults().front().code == "bad-curve"); // an arc without a chord
}

TEST_CASE("toggleClosed and deleteSelection of segments keep the curves that are left") {
    const Document document = documentOf({sail()});
    const Result<Document> open = toggleClosed(document, 1);
    REQUIRE(open.ok());
    CHECK(open->shapes[0]->kind() == ShapeKind::Polyline);
    CHECK(sameDomain(toDomain(*open), toDomain(document)));
    CHECK(sameContent(*toggleClosed(*open, 1), document));
    Selection side;
    side.segments = {{1, 2}};
    const Shape rest = *deleteSelection(document, side).shapes[0];
    CHECK(rest.path().curves == std::vector<Curve>{sail().path().curves[0], sail().path().curves[1]});
    CHECK(rest.segmentTags == std::vector<std::int32_t>{3, 4});
}

TEST_CASE("PickIndex: the nearest point of a curved segment is on its curve") {
    const auto document = std::make_shared<const Document>(documentOf({sail()}));
    const PickIndex index(document);
    const auto hit = index.segment({6.1, 2}, 0.2);
    REQUIRE(hit);
    CHECK(hit->ref == SegmentRef{1, 1});
    CHECK(distance(hit->at, {6, 2}) <= 1e-9);
    CHECK(hit->t == doctest::Approx(0.5));
    CHECK_FALSE(index.segment({4, 2}, 0.2)); // the chord of the arc
    Random random(3);
    for (int k = 0; k < 200; ++k) {
        const Vec2 p = random.place(7);
        const Outline outline = outlineOf(*document->shapes[0]);
        double nearest = 1e9;
        for (std::size_t s = 0; s < outline.segmentCount(); ++s) {
            for (int i = 0; i <= 2000; ++i) {
                nearest = std::min(nearest, distance(outline.curve(s).point(i / 2000.0), p));
            }
        }
        const auto found = index.segment(p, 20);
        REQUIRE(found);
        CHECK(found->distance <= nearest + 1e-12);
        CHECK(found->distance >= nearest - 5e-3);
    }
}

TEST_CASE("joinToSegments: a line that ends on a curve divides it there") {
    const Vec2 on = sail().path().curves[1].point(0.25);
    Document document = documentOf({sail()});
    document = *addShape(document, makeShape(ShapeKind::Polyline, {{4, 2}, on}, ShapeUse::Constraint));
    const Document joined = joinToSegments(document, 2);
    REQUIRE(joined.shapes[0]->nodes.size() == 4);
    CHECK(joined.shapes[0]->nodes[2] == on);
    CHECK(validate(toDomain(joined)).empty());
    CHECK(areaOf(*joined.shapes[0]) == doctest::Approx(areaOf(sail())));
}

TEST_CASE(
    "A rectangle with rounded corners: sides and arcs have tags of their own, which a quarter turn keeps in place") {
    Shape box = roundedBox(1.0);
    CHECK(taggedSegments(box) == 8);
    box.segmentTags = {1, 2, 3, 4};
    CHECK(segmentTagsOf(box) == std::vector<std::int32_t>{1, 2, 3, 4, 1, 2, 3, 4});
    const Document tagged = *setSegmentTag(documentOf({box}), {{1, 5}}, 9);
    CHECK(tagged.shapes[0]->segmentTags == std::vector<std::int32_t>{1, 2, 3, 4, 1, 9, 3, 4});
    const Result<Document> read = parseProject(projectText(tagged), "box.forefront");
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    CHECK(read->shapes[0]->segmentTags == tagged.shapes[0]->segmentTags);
    const auto tagsByPlace = [](const Shape &shape, const PlaneMap &map) {
        std::map<std::pair<long, long>, std::int32_t> tags;
        const Outline outline = outlineOf(shape);
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            const Vec2 middle = map(outline.curve(k).point(0.5));
            tags[{std::lround(1e6 * middle.x), std::lround(1e6 * middle.y)}] = segmentTag(shape, outline.part(k));
        }
        return tags;
    };
    const PlaneMap still = PlaneMap::translation({});
    for (const PlaneMap &map :
         {PlaneMap::rotation(90.0, {1, 2}), PlaneMap::rotation(180.0, {1, 2}), PlaneMap::rotation(270.0, {1, 2}),
          PlaneMap::reflection(90.0, {1, 2}), PlaneMap::reflection(45.0, {1, 2})}) {
        CAPTURE(map.u.x);
        CAPTURE(map.u.y);
        const Document mapped = *transformSelection(tagged, selected({1}), map);
        CHECK(mapped.shapes[0]->is<RectangleForm>());
        CHECK(tagsByPlace(*mapped.shapes[0], still) == tagsByPlace(*tagged.shapes[0], map));
    }
}

TEST_CASE("joinToSegments: a line from side to side of a rounded rectangle divides just these sides") {
    const Shape box = roundedBox(1.0);
    const Box2 bounds = boundsOf(box);
    const double middle = bounds.centre().y;
    const std::pair<Vec2, Vec2> lines[] = {
        {{bounds.min.x, middle}, {bounds.centre().x, bounds.max.y}}, // left to top
        {{bounds.min.x, middle}, {bounds.max.x, middle}},            // left to right
        {{bounds.max.x, middle}, {bounds.centre().x, bounds.min.y}}, // right to bottom
    };
    for (const auto &[from, to] : lines) {
        Document document = documentOf({box});
        document = *addShape(document, makeShape(ShapeKind::Polyline, {from, to}, ShapeUse::Constraint));
        const Document joined = joinToSegments(document, 2);
        const std::vector<Vec2> &nodes = joined.shapes[0]->nodes;
        REQUIRE(nodes.size() == 10);
        CHECK(std::count(nodes.begin(), nodes.end(), from) == 1);
        CHECK(std::count(nodes.begin(), nodes.end(), to) == 1);
        CHECK(areaOf(*joined.shapes[0]) == doctest::Approx(areaOf(box)).epsilon(1e-12));
        CHECK(validate(toDomain(joined)).empty());
    }
}

TEST_CASE("joinToSegments: a line that begins on a circle or an ellipse divides it there") {
    const Shape circle = makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}});
    const Shape ellipse = makeShape(ShapeKind::Ellipse, {{0, 0}, {2, 0}, {0, 1}});
    for (const Shape &round : {circle, ellipse}) {
        for (const double angle : {0.06, 1.0, 3.0}) {
            const double width = round.kind() == ShapeKind::Circle ? 1.0 : 2.0;
            const Vec2 on{width * std::cos(angle), std::sin(angle)};
            Document document = documentOf({round});
            document = *addShape(document, makeShape(ShapeKind::Polyline, {on, {0.1, 0.2}}, ShapeUse::Constraint));
            const Document joined = joinToSegments(document, 2);
            const std::vector<Vec2> &nodes = joined.shapes[0]->nodes;
            CHECK(std::count(nodes.begin(), nodes.end(), on) == 1);
            CHECK(areaOf(*joined.shapes[0]) == doctest::Approx(areaOf(round)));
            CHECK(validate(toDomain(joined)).empty());
        }
    }
}

TEST_CASE("combineShapes: curves stay curves") {
    const Document document = documentOf({makeShape(ShapeKind::Rectangle, {{0, -5}, {5, 5}}),
                                          makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}}, ShapeUse::Boundary, 3)});
    const Result<Document> cut = combineShapes(document, {1, 2}, ShapeOperation::Difference);
    REQUIRE(cut.ok());
    REQUIRE(cut->shapes.size() == 1);
    CHECK(areaOf(*cut->shapes[0]) == doctest::Approx(50.0 - 2.0 * pi).epsilon(1e-9));
    CHECK(curvedSegments(*cut) <= 2); // the circle begins at (2, 0)
    const Document apart = documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}}), roundedBox(1.0)});
    const Result<Document> both = combineShapes(apart, {1, 2}, ShapeOperation::Exclusion);
    REQUIRE(both.ok());
    CHECK(curvedSegments(*both) >= 4);
    CHECK(validate(toDomain(*both)).empty());
}

TEST_CASE("repairDrawing: a crossing of curves is repaired, and the parts remain curves with their names") {
    Shape disc = makeShape(ShapeKind::Circle, {{6, 2}, {7, 2}}, ShapeUse::Boundary, 9);
    disc.name = "disc";
    Shape alone = makeShape(ShapeKind::Circle, {{20, 0}, {21, 0}});
    const Document document = documentOf({sail(), disc, alone});
    const Result<RepairedDrawing> repaired = repairDrawing(document);
    REQUIRE(repaired.ok());
    CHECK(repaired->left.empty());
    CHECK(curvedSegments(repaired->document) >= 5);
    CHECK(*repaired->document.shapes[0] == *document.shapes[2]);
    bool named = false;
    for (const auto &shape : repaired->document.shapes) {
        named = named || shape->name == "disc";
    }
    CHECK(named);
}

TEST_CASE("checkShape: refuses curves that are not finite, have no radius or miss their nodes") {
    const auto codeWith = [](const Curve &curve) {
        Shape shape = sail();
        shape.path().curves[1] = curve;
        const Diagnostics faults = checkShape(shape);
        return faults.empty() ? std::string() : faults.front().code;
    };
    CHECK(codeWith(sail().path().curves[1]).empty());
    CHECK(codeWith(Curve::arc({4, 2}, {0, -2}, {0, 2}, 0.0, pi)) == "bad-curve");
    CHECK(codeWith(Curve::arc({4, 2}, {0, -2}, {2, 0}, 0.0, 0.0)) == "bad-curve");
    CHECK(codeWith(Curve::arc({4, 2.1}, {0, -2}, {2, 0}, 0.0, pi)) == "bad-curve");
    CHECK(codeWith(Curve::cubic({4, 0}, {std::nan(""), 0}, {5, 5}, {4, 4})) == "bad-curve");
    Shape lens = makeShape(ShapeKind::Polygon, {{0, 0}, {2, 0}});
    CHECK(checkShape(lens).front().code == "bad-shape");
    lens.path().curves = {Curve::arc({1, 0}, {-1, 0}, {0, -1}, 0.0, pi), {}};
    CHECK(checkShape(lens).empty());
    CHECK(validate(toDomain(documentOf({lens}))).empty());
    CHECK(checkShape(makeShape(ShapeKind::Ellipse, {{0, 0}, {1, 0}, {2, 0}})).front().code == "bad-shape");
}

TEST_CASE("setHandle: perpendicular semi-axes of an ellipse stay perpendicular") {
    const Document document = documentOf({makeShape(ShapeKind::Ellipse, {{1, 1}, {4, 1}, {1, 3}})});
    CHECK(setHandle(document, {1, 1}, {1, 7})->shapes[0]->nodes == std::vector<Vec2>{{1, 1}, {1, 7}, {-1, 1}});
    CHECK(setHandle(document, {1, 2}, {9, 2})->shapes[0]->nodes == std::vector<Vec2>{{1, 1}, {4, 1}, {1, 2}});
    CHECK(setHandle(document, {1, 0}, {2, 2})->shapes[0]->nodes == std::vector<Vec2>{{2, 2}, {5, 2}, {2, 4}});
    CHECK(setHandle(document, {1, 1}, {1, 1}).ok());
}
