// Joints hold exactly however shapes are moved, with and without constraints, and neighbours change little.
#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "tests/unit/abutting_map.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

const std::vector<Vec2> &nodesOf(const Document &document, std::uint32_t shape) {
    return findShape(document, shape)->nodes;
}

Result<Document> jointly(const Document &document, const Result<Document> &command) {
    return command ? carryJoints(document, *command) : command;
}

Document jointed(const Document &document, const Result<Document> &command) {
    Result<Document> next = jointly(document, command);
    REQUIRE_MESSAGE(next.ok(), next.faults().front().message);
    return *std::move(next);
}

Shape lineOf(std::vector<Vec2> nodes) {
    return makeShape(ShapeKind::Polyline, std::move(nodes), ShapeUse::Constraint);
}

Shape rectangleOf(Vec2 a, Vec2 b) {
    return makeShape(ShapeKind::Rectangle, {a, b});
}

/// A large square, and two small ones that lie on its right side and share a corner there.
Document besideOneSide() {
    return documentOf({square({0, 0}, 4), makeShape(ShapeKind::Polygon, {{4, 0}, {6, 0}, {6, 2}, {4, 2}}),
                       makeShape(ShapeKind::Polygon, {{4, 2}, {6, 2}, {6, 4}, {4, 4}})});
}

/// Draws a random move of a shape, a side or a node, as the editor, scripts and the table of nodes make it.
Result<Document> randomMove(const Document &document, Random &random) {
    const Shape &shape = *document.shapes[random.below(static_cast<std::uint32_t>(document.shapes.size()))];
    const std::uint32_t handle = random.below(4);
    const Vec2 at = handlesOf(shape)[handle], by = random.place(0.7);
    Selection selection;
    switch (random.below(6)) {
    case 0:
        return moveSelection(document, selected({shape.id}), by);
    case 1:
        selection.segments = {{shape.id, handle}};
        return moveSelection(document, selection, by);
    case 2:
        return transformSelection(document, selected({shape.id}), PlaneMap::scaling({1.0 + 0.3 * by.x, 1.0}, at));
    case 3:
        return isPath(shape) ? transformSelection(document, selected({shape.id}), PlaneMap::rotation(5.0 * by.x, at))
                             : setHandle(document, {shape.id, handle}, at + by);
    case 4:
        selection.nodes = {{shape.id, handle}, {shape.id, (handle + 2) % 4}};
        return moveSelection(document, selection, by);
    default:
        return setHandle(document, {shape.id, handle}, at + by);
    }
}

} // namespace

TEST_CASE("Joints: maps of abutting shapes stay without gaps through random moves without constraints") {
    std::size_t moved = 0, refused = 0, checked = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        AbuttingMap map(random);
        Document document = map.document;
        for (int step = 0; step < 20; ++step) {
            CAPTURE(step);
            const Result<Document> command = randomMove(document, random);
            REQUIRE(command.ok());
            Result<Document> next = carryJoints(document, *command);
            if (!next) {
                ++refused;
                CHECK(next.faults().front().code == "joint-conflict");
                continue;
            }
            ++moved;
            if (map.isInOrder(*next)) { // else joints have gone, or come
                ++checked;
                CHECK(map.widestGap(*next) < 1e-12);
                CHECK(std::fabs(map.missingArea(*next)) < 1e-11);
                document = *std::move(next);
            }
        }
    }
    INFO(moved, " moved, of which ", checked, " in order; ", refused, " refused");
    CHECK(checked > 1500);
    CHECK(refused < moved / 10);
}

TEST_CASE("Joints: a drag gives at each step what the command alone gives, also back at the start") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const AbuttingMap map(random);
        const auto start = std::make_shared<const Document>(map.document);
        const Joints joints(start);
        const NodeRef node{1 + random.below(static_cast<std::uint32_t>(start->shapes.size())), random.below(4)};
        const Vec2 from = handlesOf(*findShape(*start, node.shape))[node.node];
        for (int step = 0; step < 6; ++step) {
            const Result<Document> moved = setHandle(*start, node, step < 5 ? from + random.place(0.6) : from);
            REQUIRE(moved.ok());
            const Result<Document> dragged = joints.carry(*moved), alone = carryJoints(*start, *moved);
            REQUIRE(dragged.ok() == alone.ok());
            for (std::size_t k = 0; dragged && k < start->shapes.size(); ++k) {
                CHECK(dragged->shapes[k]->nodes == alone->shapes[k]->nodes);
                CHECK((step < 5 || dragged->shapes[k]->nodes == start->shapes[k]->nodes));
            }
        }
    }
}

TEST_CASE("Joints: a corner of two shapes on the side of a third slides along it") {
    const Document document = besideOneSide();
    const Document next = jointed(document, setHandle(document, {2, 3}, {4.4, 2.5}));
    CHECK(nodesOf(next, 1) == nodesOf(document, 1));
    CHECK(nodesOf(next, 2)[3] == Vec2{4, 2.5});
    CHECK(nodesOf(next, 3)[0] == Vec2{4, 2.5});
}

TEST_CASE("Joints: a side goes with a shape that lies on a part of it") {
    const Document document =
        documentOf({square({0, 0}, 4), makeShape(ShapeKind::Polygon, {{4, 1}, {6, 1}, {6, 3}, {4, 3}})});
    const Document next = jointed(document, moveSelection(document, selected({2}), {0.5, 0.25}));
    CHECK(nodesOf(next, 2) == std::vector<Vec2>{{4.5, 1.25}, {6.5, 1.25}, {6.5, 3.25}, {4.5, 3.25}});
    CHECK(nodesOf(next, 1)[0] == Vec2{0, 0});
    CHECK(nodesOf(next, 1)[3] == Vec2{0, 4});
    CHECK(nodesOf(next, 1)[1].x == doctest::Approx(4.5).epsilon(1e-14));
    CHECK(nodesOf(next, 1)[2].x == doctest::Approx(4.5).epsilon(1e-14));

    const Document rectangles = documentOf({rectangleOf({0, 0}, {4, 4}), rectangleOf({4, 1}, {6, 3})});
    const Document wider = jointed(rectangles, moveSelection(rectangles, selected({2}), {0.5, 0.0}));
    CHECK(nodesOf(wider, 1) == std::vector<Vec2>{{0, 0}, {4.5, 4}});
    CHECK(nodesOf(wider, 2) == std::vector<Vec2>{{4.5, 1}, {6.5, 3}});
}

TEST_CASE("Joints: an end on a side goes round its corner, and stops at the last one and before curves") {
    const Document document = documentOf({square({0, 0}, 4), lineOf({{4, 2}, {8, 2}})});
    const auto endAt = [](const Document &from, Vec2 to) {
        return nodesOf(jointed(from, setHandle(from, {2, 0}, to)), 2)[0];
    };
    CHECK(endAt(document, {5, 3}) == Vec2{4, 3});
    CHECK(endAt(document, {5, 4.5}) == Vec2{4, 4}); // the corner is nearest
    CHECK(endAt(document, {3, 4.5}) == Vec2{3, 4});
    CHECK(endAt(document, {-1, 4.5}) == Vec2{0, 4});
    CHECK(endAt(document, {1, -3}) == Vec2{1, 0});
    CHECK(endAt(document, {1, 2}) == Vec2{4, 2}); // not through the square
    const Document open = documentOf({lineOf({{4, 0}, {4, 4}}), lineOf({{4, 2}, {8, 2}})});
    CHECK(endAt(open, {3, 6}) == Vec2{4, 4});
    const Document rectangle = documentOf({rectangleOf({0, 0}, {4, 4}), lineOf({{4, 2}, {8, 2}})});
    CHECK(endAt(rectangle, {3, 4.5}) == Vec2{3, 4});
}

TEST_CASE("Joints: a control point bends the curve of both neighbours, unless it is locked or detached") {
    Shape left = square({0, 0}, 4), right = square({4, 0}, 4);
    left.path().curves.assign(4, Curve());
    right.path().curves.assign(4, Curve());
    left.path().curves[1] = Curve::cubic({4, 0}, {5, 1}, {5, 3}, {4, 4});
    right.path().curves[3] = Curve::cubic({4, 4}, {5, 3}, {5, 1}, {4, 0});
    Document document = documentOf({left, right});
    const ControlRef first{1, 1, false};
    const Document bent = jointed(document, moveControl(document, first, {6, 1.5}));
    CHECK(findShape(bent, 1)->path().curves[1] == Curve::cubic({4, 0}, {6, 1.5}, {5, 3}, {4, 4}));
    CHECK(findShape(bent, 2)->path().curves[3] == Curve::cubic({4, 4}, {5, 3}, {6, 1.5}, {4, 0}));
    CHECK(moveControl(document, first, {6, 1.5})->shapes[1] == document.shapes[1]);
    document = *setLocked(document, {2}, true);
    CHECK(codeOf(jointly(document, moveControl(document, first, {6, 1.5}))) == "joined-locked");
}

TEST_CASE("Joints: a neighbour that cannot follow is named, and nothing changes") {
    const Document document = documentOf({square({0, 0}, 4), rectangleOf({4, 0}, {8, 4})});
    const Result<Document> turned =
        jointly(document, transformSelection(document, selected({1}), PlaneMap::rotation(10.0, {2, 2})));
    REQUIRE_FALSE(turned.ok());
    CHECK(turned.faults().front().code == "joint-conflict");
    CHECK(turned.faults().front().message.find("rectangle 2") != std::string::npos);
    CHECK(turned.faults().front().advice.find("convert") != std::string::npos);
}

namespace {

/// Gives formulas of the parameter w, which is 4, and sets it to 5.
Document withFive(Document document, const std::vector<std::pair<NumberAddress, std::string>> &formulas) {
    document.parameters = {{"w", "4"}};
    document.spacing.names = {{"w", 4.0}};
    for (const auto &[address, text] : formulas) {
        document = setFormula(document, address, text);
    }
    const Result<Document> next = overrideParameters(document, {{"w", "5"}});
    REQUIRE_MESSAGE(next.ok(), next.faults().front().message);
    return *next;
}

NumberAddress numberOf(std::uint32_t shape, Quantity quantity, std::uint32_t handle = 0) {
    return {NumberOwner::ofShape(shape), quantity, handle};
}

} // namespace

TEST_CASE("Sketch joints: what a parameter moves keeps its other numbers, and what lies on its side follows") {
    const Document point =
        withFive(documentOf({square({0, 0}, 4), makeShape(ShapeKind::Point, {{4, 2}}, ShapeUse::Constraint)}),
                 {{numberOf(1, Quantity::X, 1), "w"}});
    CHECK(nodesOf(point, 1) == std::vector<Vec2>{{0, 0}, {5, 0}, {4, 4}, {0, 4}});
    const Vec2 on = nodesOf(point, 2)[0];
    CHECK(on.x + 0.25 * on.y == doctest::Approx(5.0));
    CHECK(distance(on, {4, 2}) < 0.5);

    const Document line = withFive(documentOf({square({0, 0}, 4), lineOf({{4, 2}, {8, 2}}),
                                               makeShape(ShapeKind::Polygon, {{8, 2}, {10, 0}, {10, 4}})}),
                                   {{numberOf(1, Quantity::X, 1), "w"}});
    CHECK(nodesOf(line, 1) == std::vector<Vec2>{{0, 0}, {5, 0}, {4, 4}, {0, 4}});
    CHECK(nodesOf(line, 2)[1] == Vec2{8, 2});
    CHECK(nodesOf(line, 3) == std::vector<Vec2>{{8, 2}, {10, 0}, {10, 4}});
}

TEST_CASE("Sketch joints: a parameter that moves several neighbours leaves the first where it is") {
    const Document two = withFive(documentOf({rectangleOf({0, 0}, {4, 3}), rectangleOf({4, 0}, {8, 3})}),
                                  {{numberOf(1, Quantity::Width), "w"}, {numberOf(2, Quantity::Width), "w"}});
    CHECK(nodesOf(two, 1) == std::vector<Vec2>{{0, 0}, {5, 3}});
    CHECK(nodesOf(two, 2) == std::vector<Vec2>{{5, 0}, {10, 3}});

    const Document four = withFive(documentOf({rectangleOf({0, 0}, {4, 3}), rectangleOf({0, 3}, {4, 6}),
                                               rectangleOf({4, 0}, {8, 3}), rectangleOf({4, 3}, {8, 6})}),
                                   {{numberOf(1, Quantity::Width), "w"},
                                    {numberOf(4, Quantity::Width), "w"},
                                    {numberOf(2, Quantity::Height), "w-1"}});
    CHECK(nodesOf(four, 1) == std::vector<Vec2>{{0, 0}, {5, 3}});
    CHECK(nodesOf(four, 2) == std::vector<Vec2>{{0, 3}, {5, 7}});
    CHECK(nodesOf(four, 3) == std::vector<Vec2>{{5, 0}, {10, 3}});
    CHECK(nodesOf(four, 4) == std::vector<Vec2>{{5, 3}, {10, 7}});

    const Document beside = withFive(documentOf({rectangleOf({0, 0}, {4, 3}), rectangleOf({4, -2}, {9, 8})}),
                                     {{numberOf(1, Quantity::Width), "w"}});
    CHECK(nodesOf(beside, 1) == std::vector<Vec2>{{0, 0}, {5, 3}});
    CHECK(nodesOf(beside, 2) == std::vector<Vec2>{{5, -2}, {9, 8}});
}

TEST_CASE("Sketch joints: a formula that puts an end beyond the corner of a side takes the corner along") {
    const Document beyond = withFive(documentOf({lineOf({{4, 2}, {8, 2}}), square({0, 0}, 4)}),
                                     {{numberOf(1, Quantity::Y, 0), "w-2+2*(w-4)"}});
    CHECK(nodesOf(beyond, 1) == std::vector<Vec2>{{4, 5}, {8, 2}});
    CHECK(nodesOf(beyond, 2) == std::vector<Vec2>{{0, 0}, {4, 0}, {4, 5}, {0, 4}});
}
