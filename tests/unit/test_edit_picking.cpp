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

using namespace forefront;
using namespace forefront::edit_test;

namespace {

std::shared_ptr<const Document> sharedDocumentOf(std::vector<Shape> shapes) {
    return std::make_shared<const Document>(documentOf(std::move(shapes)));
}

std::shared_ptr<const Document> randomDocument(std::uint64_t seed, int count) {
    Random random(seed);
    std::vector<Shape> shapes;
    for (int k = 0; k < count; ++k) {
        const Vec2 at = random.place(10);
        switch (random.below(5)) {
        case 0:
            shapes.push_back(square(at, random.real(0.1, 4)));
            break;
        case 1:
            shapes.push_back(makeShape(ShapeKind::Circle, {at, at + random.place(3)}));
            break;
        case 2:
            shapes.push_back(makeShape(ShapeKind::Rectangle, {at, at + random.place(3)}));
            break;
        case 3:
            shapes.push_back(makeShape(ShapeKind::Polyline, {at, random.place(10), random.place(10)}));
            break;
        default:
            shapes.push_back(makeShape(ShapeKind::Point, {at}, ShapeUse::Constraint));
        }
    }
    return sharedDocumentOf(std::move(shapes));
}

} // namespace

TEST_CASE("BoxTree: query and nearest agree with an exhaustive search") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        std::vector<Box2> boxes(random.below(400));
        for (Box2 &box : boxes) {
            const Vec2 at = random.place(10);
            box = boxOf(at, at + random.place(random.below(3)));
        }
        const BoxTree tree(boxes);
        for (int k = 0; k < 30; ++k) {
            const Box2 window = boxAround(random.place(12), random.real(0, 3));
            std::set<std::uint32_t> found, expected;
            tree.query(window, [&](std::uint32_t item) { CHECK(found.insert(item).second); });
            double limit = 5.0, minimum = 5.0;
            const Vec2 p = random.place(12);
            const auto toCorner = [&](std::uint32_t item) { return distance(p, boxes[item].min); };
            const std::uint32_t nearest = tree.nearest(p, limit, toCorner);
            std::uint32_t oracle = kNoIndex;
            for (std::uint32_t item = 0; item < boxes.size(); ++item) {
                if (boxes[item].overlaps(window)) {
                    expected.insert(item);
                }
                if (toCorner(item) < minimum) {
                    minimum = toCorner(item);
                    oracle = item;
                }
            }
            REQUIRE(found == expected);
            REQUIRE(nearest == oracle);
            REQUIRE(limit == minimum);
        }
    }
}

TEST_CASE("PickIndex: finds the same nodes and segments as an exhaustive search") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto document = randomDocument(seed, 60);
        const PickIndex index(document);
        Random random(seed + 1000);
        for (int k = 0; k < 60; ++k) {
            const Vec2 p = random.place(11);
            const double tolerance = random.real(0, 2);
            double node = 1e9, segment = 1e9;
            for (const auto &shape : document->shapes) {
                for (const Vec2 handle : handlesOf(*shape)) {
                    node = std::min(node, distance(p, handle));
                }
                if (shape->kind() == ShapeKind::Circle) {
                    segment = std::min(segment, std::abs(distance(p, shape->nodes[0]) - circleRadius(*shape)));
                    continue;
                }
                const Outline outline = outlineOf(*shape);
                for (std::size_t s = 0; s < outline.segmentCount(); ++s) {
                    segment = std::min(segment, distanceToSegment(outline.from(s), outline.to(s), p));
                }
            }
            const auto nodeHit = index.node(p, tolerance);
            const auto segmentHit = index.segment(p, tolerance);
            REQUIRE(nodeHit.has_value() == (node <= tolerance));
            REQUIRE(segmentHit.has_value() == (segment <= tolerance));
            if (nodeHit) {
                REQUIRE(nodeHit->distance == node);
                const Shape *shape = findShape(*document, nodeHit->ref.shape);
                REQUIRE(handlesOf(*shape)[nodeHit->ref.node] == nodeHit->at);
            }
            if (segmentHit) {
                REQUIRE(segmentHit->distance == doctest::Approx(segment));
                REQUIRE(distance(segmentHit->at, p) == doctest::Approx(segment).epsilon(1e-9));
            }
        }
    }
}

TEST_CASE("PickIndex: picks the last drawn of coinciding nodes, unless it is filtered out") {
    const auto document = sharedDocumentOf({square({0, 0}, 1), square({1, 0}, 1)});
    const PickIndex index(document);
    CHECK(index.node({1.01, 0}, 0.1)->ref == NodeRef{2, 0});
    CHECK(index.node({1.01, 0}, 0.1, [](const Shape &shape) { return shape.id != 2; })->ref == NodeRef{1, 1});
    CHECK_FALSE(index.node({1.01, 0}, 0.001).has_value());
}

TEST_CASE("PickIndex: a line is picked before the inside of a shape, and the smallest shape wins") {
    const auto document =
        sharedDocumentOf({square({0, 0}, 10), square({2, 2}, 4), makeShape(ShapeKind::Circle, {{4, 4}, {5, 4}})});
    const PickIndex index(document);
    CHECK(index.shape({1, 1}, 0.1) == 1);
    CHECK(index.shape({2.5, 2.5}, 0.1) == 2);
    CHECK(index.shape({4, 4.5}, 0.1) == 3);
    CHECK(index.shape({0.05, 5}, 0.1) == 1);
    CHECK(index.shape({5.05, 4}, 0.1) == 3);
    CHECK(index.shape({11, 11}, 0.1) == kNoIndex);
}

TEST_CASE("PickIndex: finds the parts of sources, markers, and everything in a box") {
    Document drawn = *sharedDocumentOf({square({0, 0}, 1), makeShape(ShapeKind::Circle, {{5, 5}, {6, 5}})});
    drawn = *addSource(drawn, {SourceShape::Line, {0, 8}, {4, 8}, 0.0, 0.1, 0.2, ""});
    drawn = *addSource(drawn, {SourceShape::Circle, {8, 8}, {}, 1.0, 0.1, 0.2, ""});
    drawn = *addRegionMarker(drawn, {{0.5, 0.5}, 1});
    const PickIndex index(std::make_shared<const Document>(drawn));
    using Part = PickIndex::SourceHit::Part;
    CHECK(index.source({0.02, 8}, 0.1)->part == Part::A);
    CHECK(index.source({4, 8.02}, 0.1)->part == Part::B);
    CHECK(index.source({2, 8.05}, 0.1)->part == Part::Whole);
    CHECK(index.source({9.05, 8}, 0.1)->source == 1);
    CHECK(index.source({9.05, 8}, 0.1)->part == Part::Rim);
    CHECK_FALSE(index.source({6, 8}, 0.1).has_value());
    CHECK(index.marker({0.55, 0.5}, 0.1) == 0);
    CHECK_FALSE(index.marker({0.65, 0.5}, 0.1).has_value());

    const Selection shapes = index.inBox({{-1, -1}, {5, 9}}, false);
    CHECK(shapes.shapes == std::set<std::uint32_t>{1});
    CHECK(shapes.sources == std::set<std::uint32_t>{0});
    CHECK(shapes.markers.size() == 1);
    CHECK(index.inBox({{0.5, -1}, {5.5, 5.5}}, true).nodes == std::set<NodeRef>{{1, 1}, {1, 2}, {2, 0}});

    // The same box as a loop selects the same; without its corner at (5, 9), half of it.
    const std::vector<Vec2> whole = {{-1, -1}, {5, -1}, {5, 9}, {-1, 9}}, cut = {{-1, -1}, {5, -1}, {-1, 9}};
    CHECK(index.inLoop(whole, false).shapes == shapes.shapes);
    CHECK(index.inLoop(whole, false).sources == shapes.sources);
    CHECK(index.inLoop(whole, false).markers == shapes.markers);
    CHECK(index.inLoop(cut, false).sources.empty());
    CHECK(index.inLoop(cut, false).markers.size() == 1);
    const std::vector<Vec2> hand = {{0.5, -1}, {5.5, -1}, {5.5, 5.5}, {4.5, 5.5}, {4.5, 0.5}, {0.5, 0.5}};
    for (const NodeRef node : index.inLoop(hand, true).nodes) {
        CHECK(node != NodeRef{1, 2}); // inside the box of the loop, but not inside the loop
    }
    CHECK(index.inLoop(hand, true).nodes.size() < 3);
}

TEST_CASE("PickIndex: a hundred thousand searches among a hundred thousand nodes visit few nodes each") {
    std::vector<Shape> shapes;
    for (int k = 0; k < 100; ++k) {
        std::vector<Vec2> ring;
        for (int i = 0; i < 1000; ++i) {
            const double angle = 0.00628318 * i;
            ring.push_back({k * 3.0 + std::cos(angle), std::sin(angle)});
        }
        shapes.push_back(makeShape(ShapeKind::Polygon, ring));
    }
    const PickIndex index(sharedDocumentOf(std::move(shapes)));
    Random random(3);
    int found = 0;
    for (int k = 0; k < 100000; ++k) {
        // The filter is asked once for every node within the reach: a count of work that does not depend on the
        // machine.
        index.node({random.real(0, 300), random.real(-1, 1)}, 0.01, [&](const Shape &) { return ++found > 0; });
    }
    CHECK(found > 1000);
    CHECK(found < 400000);
}

TEST_CASE("targetsOfDrag: other nodes and segments of the own path, not those that follow the dragged node") {
    const std::shared_ptr<const Document> document =
        sharedDocumentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 4}, {2, 6}, {0, 4}}),
                          makeShape(ShapeKind::Rectangle, {{10, 0}, {14, 4}})});
    const std::uint32_t path = document->shapes[0]->id, rectangle = document->shapes[1]->id;
    const PickIndex index(document);
    Selection dragged;
    dragged.nodes = {{path, 0}};
    SnapQuery query;
    query.tolerance = 0.1;
    query.filter = targetsOfDrag(*document, dragged);
    const auto snapped = [&](Vec2 at) {
        query.at = at;
        return snap(index, query).kind;
    };
    CHECK(snapped({4.02, 4.02}) == SnapKind::Node);
    CHECK(snapped({2.02, 6.02}) == SnapKind::Node);
    CHECK(snapped({4.05, 2.01}) == SnapKind::Midpoint);
    CHECK(snapped({4.05, 1.2}) == SnapKind::Segment);
    CHECK(snapped({0.02, 0.02}) == SnapKind::None);   // itself
    CHECK(snapped({4.02, 0.5}) == SnapKind::Segment); // from its neighbour on
    CHECK(snapped({0.02, 4.02}) != SnapKind::Node);   // its neighbour
    CHECK(snapped({2.02, 0.02}) == SnapKind::None);   // a segment that follows
    CHECK(snapped({10.02, 0.02}) == SnapKind::Node);  // another shape
    CHECK(linesToNode(*document, dragged, {path, 0}) == std::vector<Vec2>{{4, 0}, {0, 4}});
    query.lines = linesToNode(*document, dragged, {path, 0});
    CHECK(snapped({10.03, 0.02}) == SnapKind::Node);
    CHECK(snapped({2.97, 5.04}) == SnapKind::Midpoint);
    dragged.nodes = {{path, 0}, {path, 1}};
    CHECK(linesToNode(*document, dragged, {path, 0}) == std::vector<Vec2>{{0, 4}});
    // The handles of a rectangle depend on each other, and a whole shape has nothing to snap to of its own.
    dragged.nodes = {{rectangle, 0}};
    query.filter = targetsOfDrag(*document, dragged);
    CHECK(snapped({14.02, 4.02}) == SnapKind::None);
    dragged = {};
    dragged.shapes = {path};
    query.filter = targetsOfDrag(*document, dragged);
    CHECK(snapped({4.02, 4.02}) == SnapKind::None);
    CHECK(linesToNode(*document, dragged, {path, 0}).empty());
}

TEST_CASE("targetsOfDrag: the centre of an arc that does not change") {
    Shape path = makeShape(ShapeKind::Polyline, {{0, 0}, {4, 0}, {8, 0}, {12, 0}});
    path.path().curves = {Curve::line({0, 0}, {4, 0}), Curve::arc({6, 0}, {-2, 0}, {0, 2}, 0, -std::numbers::pi),
                          Curve::line({8, 0}, {12, 0})};
    const std::shared_ptr<const Document> document = sharedDocumentOf({path});
    const PickIndex index(document);
    const std::uint32_t id = document->shapes[0]->id;
    SnapQuery query;
    query.tolerance = 0.1;
    query.at = {6.02, 0.02};
    Selection dragged;
    dragged.nodes = {{id, 0}};
    query.filter = targetsOfDrag(*document, dragged);
    CHECK(snap(index, query).kind == SnapKind::Centre);
    dragged.nodes = {{id, 1}};
    query.filter = targetsOfDrag(*document, dragged);
    CHECK(snap(index, query).kind == SnapKind::None);
}

TEST_CASE("crossingsOf: lines, circles, arcs and cubics; touching curves and ends on a curve count") {
    const auto circle = Curve::circle({0, 0}, {2, 0});
    const auto through = crossingsOf(Curve::line({-3, 0.5}, {3, 0.5}), circle, 1e-9);
    REQUIRE(through.size() == 2);
    CHECK(through[0].at.x == doctest::Approx(-std::sqrt(3.75)));
    CHECK(distance(circle.point(through[1].second), through[1].at) < 1e-9);
    CHECK(crossingsOf(Curve::line({-3, 2}, {3, 2}), circle, 1e-9).size() == 1); // a tangent
    CHECK(crossingsOf(Curve::line({-3, 2.1}, {3, 2.1}), circle, 1e-9).empty());
    CHECK(crossingsOf(circle, Curve::circle({3, 0}, {4.5, 0}), 1e-9).size() == 2);
    const auto end = crossingsOf(Curve::line({0, 0}, {4, 0}), Curve::line({1, 0}, {1, 3}), 1e-9);
    REQUIRE(end.size() == 1);
    CHECK(end[0].first == doctest::Approx(0.25));
    CHECK(end[0].second == doctest::Approx(0.0));
    const auto cubic = Curve::cubic({0, 0}, {1, 4}, {3, -4}, {4, 0});
    CHECK(crossingsOf(cubic, Curve::line({-1, 0}, {5, 0}), 1e-9).size() == 3);
    CHECK(crossingsOf(Curve::line({0, 0}, {2, 0}), Curve::line({1, 0}, {3, 0}), 1e-9).size() == 2); // along each other
    // Arcs that run along each other have the ends only, not the places where they are divided internally.
    const double right = std::numbers::pi / 2;
    const Curve half = Curve::arc({0, 0}, {2, 0}, {0, 2}, 0, 2 * right),
                later = Curve::arc({0, 0}, {2, 0}, {0, 2}, 0.7 * right, 2 * right);
    const auto shared = crossingsOf(half, later, 1e-9);
    REQUIRE(shared.size() == 2);
    CHECK(shared[0].first == doctest::Approx(0.35));
    CHECK(shared[1].first == doctest::Approx(1.0));
    CHECK(crossingsOf(half, half, 1e-9).size() == 2);
    CHECK(crossingsOf(cubic, cubic, 1e-9).size() == 2);
    // A crossing exactly where curves are divided internally is one.
    CHECK(crossingsOf(half, Curve::line({0, 0}, {0, 3}), 1e-9).size() == 1);
}

TEST_CASE("PickIndex: hidden shapes are never found, locked ones only for snapping") {
    Document drawn = documentOf({square({0, 0}, 4), square({5, 0}, 4), square({10, 0}, 4)});
    drawn = *setHidden(drawn, {1}, true);
    drawn = *setLocked(drawn, {2}, true);
    const PickIndex index(std::make_shared<const Document>(drawn));
    CHECK_FALSE(index.node({0, 0}, 0.1).has_value());
    CHECK_FALSE(index.segment({2, 0}, 0.1).has_value());
    CHECK(index.shape({2, 2}, 0.1) == kNoIndex);
    CHECK(index.node({5, 0}, 0.1).has_value());
    CHECK(index.segment({7, 0}, 0.1).has_value());
    CHECK(index.shape({7, 2}, 0.1) == kNoIndex);
    CHECK(index.shape({7, 0}, 0.1) == kNoIndex);
    CHECK(index.shape({12, 2}, 0.1) == 3);
    CHECK(index.inBox({{-1, -1}, {20, 20}}, false).shapes == std::set<std::uint32_t>{3});
    CHECK(index.inBox({{-1, -1}, {20, 20}}, true).nodes.size() == 4);
    CHECK(selectAll(drawn).shapes == std::set<std::uint32_t>{3});
    CHECK(toDomain(drawn).segments.size() == 12); // the mesh contains all of them

    Selection selection;
    selection.shapes = {1, 3};
    selection.nodes = {{1, 0}, {3, 1}};
    selection.segments = {{1, 2}, {3, 3}};
    selection.drop({1});
    CHECK(selection.shapes == std::set<std::uint32_t>{3});
    CHECK(selection.nodes == std::set<NodeRef>{{3, 1}});
    CHECK(selection.segments == std::set<SegmentRef>{{3, 3}});
}
