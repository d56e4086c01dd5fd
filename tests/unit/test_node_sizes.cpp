#include "core/drawing/commands/combine_shapes.hpp"
#include "core/drawing/commands/corner_commands.hpp"
#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/repair_drawing.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/commands/trim_commands.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/number_literal.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace forefront;

namespace {

Shape made(ShapeKind kind, std::vector<Vec2> nodes) {
    Shape shape;
    shape.form = formOf(kind);
    shape.nodes = std::move(nodes);
    return shape;
}

constexpr PartSize kFine{0.05, 0.3};
const Vec2 kPlace{4, 3}; ///< of node 2 of the square

/// A document with a square, id 1, whose node 2 has a size.
Document plainSquare() {
    const Document drawn = *addShape({}, made(ShapeKind::Polygon, {{0, 0}, {4, 0}, kPlace, {0, 3}}));
    return *setNodeSize(drawn, {{1, 2}}, kFine);
}

/// Returns the places that have a size in a document, each once; every size must be the one of plainSquare().
std::vector<Vec2> sizedPlaces(const Document &document) {
    std::vector<Vec2> places;
    for (const NodeSize &node : spacingOf(document).placed.nodes) {
        CHECK(node.size == kFine.size);
        CHECK(node.growth == kFine.growth);
        if (std::find(places.begin(), places.end(), node.at) == places.end()) {
            places.push_back(node.at);
        }
    }
    return places;
}

const std::vector<Vec2> kSame{kPlace};

Selection nodeOf(std::uint32_t shape, std::uint32_t node) {
    Selection selection;
    selection.nodes = {{shape, node}};
    return selection;
}

Selection shapeOf(std::uint32_t shape) {
    Selection selection;
    selection.shapes = {shape};
    return selection;
}

} // namespace

TEST_CASE("Node sizes: are part of the spacing, beside automatic spacing, and named by shape and node") {
    const Document document = *setShapeName(plainSquare(), 1, "quay");
    const auto field = SpacingField::build(spacingOf(document), toDomain(document));
    const auto automatic = SpacingField::build({}, toDomain(document));
    CHECK(spacingOf(*setNodeSize(document, {{1, 2}}, {})).placed == PlacedSizes());
    REQUIRE(field.ok());
    CHECK((*field)->at(kPlace) == doctest::Approx(0.05));
    CHECK((*field)->at({3.9, 3}) == doctest::Approx(0.08));
    CHECK((*field)->sample(kPlace).describe == "size at node 3 of quay");
    CHECK((*field)->at({0, 0}) == (*automatic)->at({0, 0}));
}

TEST_CASE("Node sizes: stay at their nodes when the shape is edited") {
    const Document document = plainSquare();
    REQUIRE(sizedPlaces(document) == kSame);
    CHECK(sizedPlaces(*insertNode(document, {1, 0}, {2, 0})) == kSame);
    CHECK(sizedPlaces(*insertNode(document, {1, 2}, {2, 3})) == kSame);
    CHECK(sizedPlaces(deleteSelection(document, nodeOf(1, 0))) == kSame);
    CHECK(sizedPlaces(deleteSelection(document, nodeOf(1, 2))).empty());
    CHECK(sizedPlaces(*setHandle(document, {1, 2}, {5, 5})) == std::vector<Vec2>{{5, 5}});
    CHECK(sizedPlaces(*toggleClosed(document, 1)) == kSame);
    CHECK(sizedPlaces(*toggleClosed(*toggleClosed(document, 1), 1)) == kSame);
    CHECK(sizedPlaces(*filletCorners(document, nodeOf(1, 0), 0.5)) == kSame);
    CHECK(sizedPlaces(*chamferCorners(document, nodeOf(1, 1), 0.5)) == kSame);
    CHECK(sizedPlaces(*setCurved(document, {{1, 0}}, true)) == kSame);
    Selection side;
    side.segments = {{1, 0}};
    CHECK(sizedPlaces(deleteSelection(document, side)) == kSame);
}

TEST_CASE("Node sizes: that of a corner that is cut goes to both ends of the cut") {
    const Document document = plainSquare();
    const std::vector<Vec2> ends{{4, 2.5}, {3.5, 3}};
    CHECK(sizedPlaces(*filletCorners(document, nodeOf(1, 2), 0.5)) == ends);
    CHECK(sizedPlaces(*chamferCorners(document, nodeOf(1, 2), 0.5)) == ends);
    // A cut that uses up a side: the size goes to the node at its other end, where the smaller size stays.
    Document both = *setNodeSize(document, {{1, 1}}, PartSize{0.01, 0.2});
    both = *chamferCorners(both, nodeOf(1, 2), 3.0);
    CHECK(both.shapes[0]->nodes == std::vector<Vec2>{{0, 0}, {4, 0}, {1, 3}, {0, 3}});
    CHECK(both.shapes[0]->nodeSizes == std::map<std::uint32_t, PartSize>{{1, {0.01, 0.2}}, {2, kFine}});
    const Document last = *setNodeSize(*addShape({}, made(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 3}, {0, 3}})),
                                       {{1, 3}}, kFine); // the side that is used up closes the path
    CHECK(sizedPlaces(*chamferCorners(last, nodeOf(1, 3), 3.0)) == std::vector<Vec2>{{0, 0}, {3, 3}});
    // The same nodes by number have sizes before and after, at other places.
    const Document slim = *setNodeSize(*addShape({}, made(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 1}, {0, 4}})),
                                       {{1, 1}, {1, 2}}, kFine);
    Selection two = nodeOf(1, 1);
    two.nodes.insert({1, 3});
    CHECK(sizedPlaces(*chamferCorners(slim, two, 1.0)) == std::vector<Vec2>{{3, 0}, {4, 1}});
    const Document all = *filletCorners(document, shapeOf(1), 1.5); // uses up two sides
    CHECK(sizedPlaces(all) == std::vector<Vec2>{{4, 1.5}, {2.5, 3}});
}

TEST_CASE("Node sizes: that of a rounded corner goes to both ends of its arc when the rectangle becomes a path") {
    Shape rounded = made(ShapeKind::Rectangle, {{0, 0}, {4, 3}});
    rounded.as<RectangleForm>().radius = 0.5;
    const Document document = *setNodeSize(*addShape({}, rounded), {{1, 2}}, kFine); // at (4, 3)
    CHECK(sizedPlaces(*convertToPath(document, 1)) == std::vector<Vec2>{{4, 2.5}, {3.5, 3}});
    const PlaneMap turn = PlaneMap::rotation(30.0, {0, 0});
    const std::vector<Vec2> turned = sizedPlaces(*transformSelection(document, shapeOf(1), turn));
    REQUIRE(turned.size() == 2);
    CHECK(distance(turned[0], turn({4, 2.5})) < 1e-12);
    CHECK(distance(turned[1], turn({3.5, 3})) < 1e-12);
}

TEST_CASE("Node sizes: a repair moves them with their nodes, and reports those whose nodes it removes") {
    Document document = *addShape({}, made(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 3}, {0, 3}}));
    document = *addShape(document, made(ShapeKind::Polygon, {{4.02, 0}, {8, 0}, {8, 3}, {4.02, 3}}));
    for (const NodeRef sized : {NodeRef{1, 2}, NodeRef{2, 3}}) {
        CAPTURE(sized.shape);
        const auto repaired = repairDrawing(*setNodeSize(document, {sized}, kFine), 0.1);
        REQUIRE(repaired.ok());
        CHECK(repaired->lostSizes.empty());
        const std::vector<Vec2> places = sizedPlaces(repaired->document);
        REQUIRE(places.size() == 1);
        CHECK(distance(places[0], {4.01, 3}) < 0.02);
        const Domain domain = toDomain(repaired->document);
        CHECK(std::find(domain.nodes.begin(), domain.nodes.end(), places[0]) != domain.nodes.end());
    }
    Shape rounded = made(ShapeKind::Rectangle, {{0, 0}, {4, 3}});
    rounded.as<RectangleForm>().radius = 0.5;
    const Document crossed = *addShape(*addShape({}, rounded), made(ShapeKind::Rectangle, {{-1, 1}, {1, 2}}));
    const auto joined = repairDrawing(*setNodeSize(crossed, {{1, 2}}, kFine), 0.0);
    REQUIRE(joined.ok());
    CHECK(joined->lostSizes.empty());
    CHECK(sizedPlaces(joined->document).size() == 2); // both ends of the arc

    Shape line = made(ShapeKind::Polyline, {{2, 1}, {2, -5}});
    line.use = ShapeUse::Constraint;
    document = *setNodeSize(*addShape(document, line), {{3, 1}}, kFine); // outside the domain
    const auto repaired = repairDrawing(document, 0.0);
    REQUIRE(repaired.ok());
    REQUIRE(repaired->lostSizes.size() == 1);
    CHECK(repaired->lostSizes[0].message ==
          "node 2 of polyline 3 lost its element size 0.05, because the repair removed the node");
    CHECK(repaired->lostSizes[0].at == Vec2{2, -5});
}

TEST_CASE("Node sizes: stay when paths are split, joined and trimmed") {
    const Document document = plainSquare();
    for (std::uint32_t node = 0; node < 4; ++node) {
        CHECK(sizedPlaces(*splitPath(document, {1, node})) == kSame);
    }
    Document open = *addShape({}, made(ShapeKind::Polyline, {{0, 0}, {2, 0}, kPlace, {6, 3}}));
    open = *addShape(open, made(ShapeKind::Polyline, {{9, 0}, {9, 3}}));
    open = *setNodeSize(open, {{1, 2}, {2, 1}}, kFine);
    const std::vector<Vec2> both{kPlace, {9, 3}};
    for (const std::uint32_t node : {1U, 2U}) {
        const Document split = *splitPath(open, {1, node});
        std::vector<Vec2> places = sizedPlaces(split);
        std::sort(places.begin(), places.end(), comesBefore);
        CHECK(places == both);
    }
    for (const std::uint32_t first : {0U, 3U}) {
        for (const std::uint32_t second : {0U, 1U}) {
            const Document joined = *joinEnds(open, {1, first}, {2, second});
            REQUIRE(joined.shapes.size() == 1);
            std::vector<Vec2> places = sizedPlaces(joined);
            std::sort(places.begin(), places.end(), comesBefore);
            CHECK(places == both);
        }
    }
    const Document crossed = *addShape(document, made(ShapeKind::Polyline, {{-1, 1}, {5, 1}}));
    CHECK(sizedPlaces(*trimAt(crossed, 1, {2, 0})) == kSame);
    CHECK(sizedPlaces(*trimAt(crossed, 1, {2, 3})).empty());
}

TEST_CASE("Node sizes: stay in copies, transformations, unions and repairs") {
    const Document document = plainSquare();
    const PlaneMap turn = PlaneMap::rotation(90.0, {0, 0});
    CHECK(sizedPlaces(*transformSelection(document, shapeOf(1), turn)) == std::vector<Vec2>{turn(kPlace)});
    Selection copies;
    const Document twice = *duplicateSelection(document, shapeOf(1), {10, 0}, &copies);
    CHECK(sizedPlaces(twice) == std::vector<Vec2>{kPlace, {14, 3}});
    const Document cut = *addShape(document, made(ShapeKind::Rectangle, {{-1, -1}, {1, 1}}));
    CHECK(sizedPlaces(*combineShapes(cut, {1, 2}, ShapeOperation::Difference)) == kSame);
    CHECK(sizedPlaces(*combineShapes(cut, {1, 2}, ShapeOperation::Union)) == kSame);
    Document folded = *addShape({}, made(ShapeKind::Polygon, {{0, 0}, {4, 3}, {4, 0}, {0, 3}}));
    folded = *setNodeSize(folded, {{1, 1}}, kFine);
    const auto repaired = repairDrawing(folded, 0.0);
    REQUIRE(repaired.ok());
    CHECK(repaired->document.shapes.size() == 2);
    CHECK(sizedPlaces(repaired->document) == kSame);
    Insertion insertion;
    const Document scaled = insertDrawing({}, document, 0.001, &insertion);
    CHECK(scaled.shapes[0]->nodeSizes.at(2).size == doctest::Approx(5e-5)); // a length, as the drawing
}

TEST_CASE("Node sizes: corners of a rectangle keep theirs through turns and as a path") {
    Document document = *addShape({}, made(ShapeKind::Rectangle, {{0, 0}, {4, 3}}));
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
        CAPTURE(corner);
        const Document sized = *setNodeSize(document, {{1, corner}}, kFine);
        const Vec2 place = handlesOf(*sized.shapes[0])[corner];
        CHECK(sizedPlaces(sized) == std::vector<Vec2>{place});
        CHECK(sizedPlaces(*convertToPath(sized, 1)) == std::vector<Vec2>{place});
        for (const double degrees : {90.0, 180.0, 270.0, 30.0}) {
            const PlaneMap turn = PlaneMap::rotation(degrees, {1, 1});
            const std::vector<Vec2> places = sizedPlaces(*transformSelection(sized, shapeOf(1), turn));
            REQUIRE(places.size() == 1);
            CHECK(distance(places[0], turn(place)) < 1e-12);
        }
        CHECK(sizedPlaces(*filletCorners(sized, nodeOf(1, (corner + 1) % 4), 0.5)) == std::vector<Vec2>{place});
    }
    const Document disc = *addShape({}, made(ShapeKind::Circle, {{0, 0}, {2, 0}}));
    CHECK(setNodeSize(disc, {{1, 0}}, kFine).faults().front().code == "no-such-node"); // the centre
    const Document rim = *setNodeSize(disc, {{1, 1}}, kFine);
    CHECK(sizedPlaces(*convertToPath(rim, 1)) == std::vector<Vec2>{{2, 0}});
}

TEST_CASE("Node sizes: corners of a rectangle keep theirs when its numbers change, wherever it was begun") {
    for (const auto &[a, c] : {std::pair(Vec2{0, 0}, Vec2{4, 3}), std::pair(Vec2{4, 3}, Vec2{0, 0}),
                               std::pair(Vec2{4, 0}, Vec2{0, 3}), std::pair(Vec2{0, 3}, Vec2{4, 0})}) {
        const Document drawn = *addShape({}, made(ShapeKind::Rectangle, {a, c}));
        for (std::uint32_t corner = 0; corner < 4; ++corner) {
            Document wider = *setNodeSize(drawn, {{1, corner}}, kFine);
            const Vec2 before = handlesOf(*drawn.shapes[0])[corner];
            REQUIRE(setNumber(wider, "shape/1/width"_number, 8.0).empty());
            CHECK(sizedPlaces(wider) == std::vector<Vec2>{{2.0 * before.x, before.y}});
        }
    }
}

TEST_CASE("Node sizes: invalid ones are refused, and nullopt removes them") {
    const Document document = plainSquare();
    CHECK(setNodeSize(document, {{1, 4}}, kFine).faults().front().code == "no-such-node");
    CHECK(setNodeSize(document, {{2, 0}}, kFine).faults().front().code == "no-such-shape");
    const auto negative = setNodeSize(document, {{1, 0}}, PartSize{-0.5, 0.2});
    REQUIRE_FALSE(negative.ok());
    CHECK(negative.faults().front().code == "bad-size");
    CHECK(negative.faults().front().message == "node 1 of polygon 1 has the size -0.5; expected a number above 0");
    const auto shrinking = setNodeSize(document, {{1, 0}}, PartSize{0.5, -1.0});
    REQUIRE_FALSE(shrinking.ok());
    CHECK(shrinking.faults().front().message ==
          "node 1 of polygon 1 has the growth -1; expected a number of at least 0");
    CHECK(shrinking.faults().front().advice == "enter a growth such as 0.2");
    CHECK(setNodeSize(document, {{1, 2}}, std::nullopt)->shapes[0]->nodeSizes.empty());
}

TEST_CASE("Node sizes: changing size or growth of several nodes keeps what each has otherwise") {
    Document document = *setNodeSize(plainSquare(), {{1, 0}}, PartSize{0.5, 0.1}); // node 2 has kFine
    document = *changeNodeSizes(document, {{1, 0}, {1, 1}, {1, 2}}, {.size = {}, .growth = 0.4});
    CHECK(document.shapes[0]->nodeSizes == std::map<std::uint32_t, PartSize>{{0, {0.5, 0.4}}, {2, {kFine.size, 0.4}}});
    document = *setNodeSize(document, {{1, 0}}, PartSize{0.5, 0.1});
    document = *changeNodeSizes(document, {{1, 0}, {1, 1}, {1, 2}}, {.size = 0.3, .growth = {}});
    CHECK(document.shapes[0]->nodeSizes ==
          std::map<std::uint32_t, PartSize>{{0, {0.3, 0.1}}, {1, {0.3, PartSize{}.growth}}, {2, {0.3, 0.4}}});
}

TEST_CASE("Node sizes: can follow formulas, which move with their nodes") {
    Document document = *setParameters(plainSquare(), {{"h", "0.05"}});
    CHECK(readNumber(document, "shape/1/size/2"_number) == 0.05);
    CHECK(readNumber(document, "shape/1/growth/2"_number) == 0.3);
    CHECK_FALSE(readNumber(document, "shape/1/size/0"_number).has_value());
    document.formulas["shape/1/size/2"_number] = "h";
    CHECK(setParameters(document, {{"h", "0.2"}})->shapes[0]->nodeSizes.at(2).size == doctest::Approx(0.2));
    Document longer = *insertNode(document, {1, 0}, {2, 0});
    carryFormulas(document, longer);
    CHECK(longer.formulas.at("shape/1/size/3"_number) == "h");
    CHECK(longer.formulas.size() == 1);
}

TEST_CASE("Node sizes: are written to projects and read back, and faults are located") {
    const Document document = plainSquare();
    const auto read = parseProject(projectText(document), "test");
    REQUIRE(read.ok());
    CHECK(read->shapes[0]->nodeSizes == document.shapes[0]->nodeSizes);
    const auto faultOf = [](const std::string &sizes) {
        const auto refused =
            parseProject("{\"format\": \"forefront\", \"version\": 2, \"shapes\": [{\"id\": 1, \"kind\": \"circle\", "
                         "\"nodes\": [[0, 0], [1, 0]],\n\"nodeSizes\": " +
                             sizes + "}]}",
                         "test");
        return refused ? std::string() : refused.faults().front().code + ' ' + std::to_string(refused.faults()[0].line);
    };
    CHECK(faultOf(R"([{"node": 1, "size": 0.5}])").empty());
    CHECK(faultOf(R"([{"node": 0, "size": 0.5}])") == "bad-index 2"); // the centre
    CHECK(faultOf(R"([{"node": 2, "size": 0.5}])") == "bad-index 2");
    CHECK(faultOf(R"([{"node": 1, "size": 0.5}, {"node": 1, "size": 1}])") == "bad-index 2");
    CHECK(faultOf(R"([{"node": 1, "size": 0}])") == "bad-number 2");
    CHECK(faultOf(R"([{"node": 1, "size": 1, "growth": -1}])") == "bad-number 2");
    CHECK(faultOf(R"([{"node": 1}])") == "missing-field 2");
    CHECK(faultOf("[1]") == "bad-field 2");
}
