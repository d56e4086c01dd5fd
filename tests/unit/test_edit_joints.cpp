// Joints: nodes at the same place, and nodes on segments, stay together through commands.
#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/shared_segments.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/edit_support.hpp"

#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

/// Applies a command with the joints of the document.
Result<Document> jointly(const Document &document, const Result<Document> &command) {
    return command ? carryJoints(document, *command) : command;
}

Document jointed(const Document &document, const Result<Document> &command) {
    Result<Document> next = jointly(document, command);
    REQUIRE_MESSAGE(next.ok(), codeOf(next));
    return *std::move(next);
}

Shape lineOf(std::vector<Vec2> nodes) {
    return makeShape(ShapeKind::Polyline, std::move(nodes), ShapeUse::Constraint);
}

const Shape &shapeOfId(const Document &document, std::uint32_t id) {
    const Shape *const shape = findShape(document, id);
    REQUIRE(shape != nullptr);
    return *shape;
}

} // namespace

TEST_CASE("Joints: nodes at the same place move together, however they are moved") {
    const Document document = documentOf({square({0, 0}, 1), square({1, 0}, 1)});
    const auto check = [](const Document &next, Vec2 place) {
        CHECK(shapeOfId(next, 1).nodes[2] == place);
        CHECK(shapeOfId(next, 2).nodes[3] == place);
        CHECK(shapeOfId(next, 2).nodes[0] == Vec2{1, 0});
        CHECK(shapeOfId(next, 2).nodes[2] == Vec2{2, 1});
    };
    check(jointed(document, setHandle(document, {1, 2}, {1.25, 1.5})), {1.25, 1.5});
    Selection node;
    node.nodes = {{2, 3}};
    check(jointed(document, moveSelection(document, node, {0.0, 0.5})), {1.0, 1.5});

    // Without carryJoints(), the node is detached.
    const Document detached = *setHandle(document, {1, 2}, {1.25, 1.5});
    CHECK(shapeOfId(detached, 2).nodes[3] == Vec2{1, 1});
}

TEST_CASE("Joints: a shape that is moved takes the border with its neighbour along") {
    const Document document = documentOf({square({0, 0}, 1), square({1, 0}, 1)});
    const Document next = jointed(document, moveSelection(document, selected({2}), {0.5, 0.0}));
    CHECK(shapeOfId(next, 1).nodes == std::vector<Vec2>{{0, 0}, {1.5, 0}, {1.5, 1}, {0, 1}});
}

TEST_CASE("Joints: neighbours follow a transformation, by their common nodes only") {
    const Document document = documentOf({square({0, 0}, 1), square({1, 0}, 1)});
    const PlaneMap wider = PlaneMap::scaling({1.5, 1.0}, {2.0, 0.0});
    const Document scaled = jointed(document, transformSelection(document, selected({2}), wider));
    CHECK(shapeOfId(scaled, 1).nodes == std::vector<Vec2>{{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}});
    const PlaneMap mirror = PlaneMap::scaling({-1.0, 1.0}, {1.5, 0.0}); // onto itself
    const Document mirrored = jointed(document, transformSelection(document, selected({2}), mirror));
    CHECK(boundsOf(shapeOfId(mirrored, 1)) == boundsOf(shapeOfId(document, 1)));
}

TEST_CASE("Joints: what does not move keeps its bits and its shape") {
    const Document document = documentOf({square({0, 0}, 1), square({1, 0}, 1), square({5, 5}, 1)});
    const Document next = jointed(document, setHandle(document, {1, 2}, {1.25, 1.5}));
    CHECK(next.shapes[2] == document.shapes[2]);
    const Document same = jointed(document, setShapeTag(document, {1}, 3));
    CHECK(same.shapes[1] == document.shapes[1]);
}

TEST_CASE("Joints: corners of rectangles are joined, and move the corners beside them") {
    Document document = documentOf(
        {makeShape(ShapeKind::Rectangle, {{0, 0}, {2, 1}}), lineOf({{2, 1}, {3, 3}}), lineOf({{2, 0}, {4, -1}})});
    document = jointed(document, setHandle(document, {2, 0}, {2.5, 1.5}));
    CHECK(shapeOfId(document, 1).nodes == std::vector<Vec2>{{0, 0}, {2.5, 1.5}});
    CHECK(shapeOfId(document, 3).nodes[0] == Vec2{2.5, 0}); // the corner beside it has moved
    CHECK(shapeOfId(document, 3).nodes[1] == Vec2{4, -1});
}

TEST_CASE("Joints: an end on a segment moves with it, and stays on it when dragged") {
    const Document document = documentOf({square({0, 0}, 4), lineOf({{2, 0}, {2, 2}})});
    const Document lowered = jointed(document, setHandle(document, {1, 1}, {4, -2}));
    CHECK(shapeOfId(lowered, 2).nodes == std::vector<Vec2>{{2, -1}, {2, 2}});

    const Document dragged = jointed(document, setHandle(document, {2, 0}, {3, 0.7}));
    CHECK(shapeOfId(dragged, 2).nodes == std::vector<Vec2>{{3, 0}, {2, 2}});
    const Document beyond = jointed(document, setHandle(document, {2, 0}, {9, -0.7}));
    CHECK(shapeOfId(beyond, 2).nodes[0] == Vec2{4, 0});
    const Document inner = jointed(document, setHandle(document, {2, 1}, {3, 3}));
    CHECK(shapeOfId(inner, 2).nodes == std::vector<Vec2>{{2, 0}, {3, 3}});
}

TEST_CASE("Joints: a border is edited as one") {
    const Document document = documentOf({square({0, 0}, 1), square({1, 0}, 1)});
    const Document inserted = jointed(document, insertNode(document, {1, 1}, {1, 0.5}));
    CHECK(shapeOfId(inserted, 1).nodes.size() == 5);
    CHECK(shapeOfId(inserted, 2).nodes.size() == 5);
    CHECK(shapeOfId(inserted, 2).nodes[4] == Vec2{1, 0.5});

    Selection node;
    node.nodes = {{2, 4}};
    const Document removed = jointed(inserted, deleteSelection(inserted, node));
    CHECK(shapeOfId(removed, 1).nodes == document.shapes[0]->nodes);
    CHECK(shapeOfId(removed, 2).nodes == document.shapes[1]->nodes);

    node.nodes = {{1, 2}};
    CHECK(codeOf(jointly(document, deleteSelection(document, node))) == "joined-node");
}

TEST_CASE("Joints: a joined node is not deleted with the last of its line or triangle") {
    const Document document =
        documentOf({lineOf({{0, 0}, {4, 0}}), lineOf({{0, 0}, {-2, 3}, {-4, 3}}), lineOf({{0, 0}, {-2, -3}}),
                    makeShape(ShapeKind::Polygon, {{4, 0}, {6, 1}, {6, -1}})});
    const JointIndex index(document);
    const auto deleted = [&](std::set<NodeRef> nodes) {
        Selection selection;
        selection.nodes = std::move(nodes);
        return jointly(document, deleteUnlessJoined(index, selection));
    };
    CHECK(codeOf(deleted({{1, 0}})) == "joined-node");
    CHECK(codeOf(deleted({{1, 1}})) == "joined-node");
    CHECK(codeOf(deleted({{2, 0}})) == "joined-node");
    CHECK(codeOf(deleted({{4, 0}})) == "joined-node");
    const Result<Document> free = deleted({{2, 2}});
    REQUIRE(free.ok());
    CHECK(shapeOfId(*free, 2).nodes.size() == 2);
    const Result<Document> line = deleted({{3, 1}}); // the other end: a line of one node is none
    REQUIRE(line.ok());
    CHECK(findShape(*line, 3) == nullptr);
    const Result<Document> all = deleted({{3, 0}, {3, 1}});
    REQUIRE(all.ok());
    CHECK(all->shapes.size() == 3);
}

TEST_CASE("Joints: a locked shape does not move, so neither does what is joined with it") {
    Document document = documentOf({square({0, 0}, 1), square({1, 0}, 1)});
    document = *setLocked(document, {2}, true);
    CHECK(codeOf(jointly(document, setHandle(document, {1, 2}, {1.25, 1.5}))) == "joined-locked");
    CHECK(codeOf(jointly(document, setHandle(document, {1, 3}, {0.25, 1.5}))).empty());
}

TEST_CASE("Joints: the parts of a split path stay joined") {
    Document document = documentOf({lineOf({{0, 0}, {1, 0}, {2, 1}})});
    const Result<Document> split = splitPath(document, {1, 1});
    REQUIRE(split);
    document = jointed(document, split);
    REQUIRE(document.shapes.size() == 2);
    document = jointed(document, setHandle(document, {document.shapes[0]->id, 1}, {1, 0.5}));
    CHECK(document.shapes[1]->nodes.front() == Vec2{1, 0.5});
}

namespace {

constexpr int kColumns = 10, kRows = 5;

/// A made-up map of 50 counties: an outline, and borders as polylines that meet where three or four counties do.
class CountyMap {
  public:
    CountyMap() {
        std::vector<Shape> shapes;
        Shape outline = makeShape(ShapeKind::Polygon, {});
        for (int k = 0; k < kColumns; ++k) {
            outline.nodes.push_back(corner(k, 0));
        }
        for (int k = 0; k < kRows; ++k) {
            outline.nodes.push_back(corner(kColumns, k));
        }
        for (int k = kColumns; k > 0; --k) {
            outline.nodes.push_back(corner(k, kRows));
        }
        for (int k = kRows; k > 0; --k) {
            outline.nodes.push_back(corner(0, k));
        }
        shapes.push_back(outline);
        for (int i = 0; i <= kColumns; ++i) {
            for (int j = 0; j <= kRows; ++j) {
                if (i < kColumns && j > 0 && j < kRows) {
                    shapes.push_back(border(corner(i, j), corner(i + 1, j)));
                }
                if (j < kRows && i > 0 && i < kColumns) {
                    shapes.push_back(border(corner(i, j), corner(i, j + 1)));
                }
            }
        }
        document = documentOf(std::move(shapes));
        for (int i = 0; i < kColumns; ++i) {
            for (int j = 0; j < kRows; ++j) {
                const std::int32_t tag = 1 + i + kColumns * j;
                document.regionMarkers.push_back({{i + 0.5, j + 0.5}, tag});
            }
        }
    }

    Document document;

  private:
    static Vec2 corner(int i, int j) { // shifted by up to 0.12
        return {i + 0.12 * std::sin(1.7 * i + 2.9 * j), j + 0.12 * std::cos(2.3 * i + 1.1 * j)};
    }
    static Shape border(Vec2 a, Vec2 b) {
        const Vec2 middle = 0.5 * (a + b), across = 0.08 * Vec2{a.y - b.y, b.x - a.x};
        return lineOf({a, middle + across, b});
    }
};

/// Draws random commands of the kinds that a user gives while editing borders.
class RandomEdits {
  public:
    explicit RandomEdits(std::uint64_t seed) : engine_(seed) {}

    Result<Document> next(const Document &document) {
        const Shape &shape = *document.shapes[below(document.shapes.size())];
        const auto node = static_cast<std::uint32_t>(below(shape.nodes.size()));
        const auto segment = static_cast<std::uint32_t>(below(shape.nodes.size() - (isClosed(shape) ? 0 : 1)));
        const Vec2 by = {number(-0.1, 0.1), number(-0.1, 0.1)};
        Selection selection;
        switch (below(6)) {
        case 0:
            return insertNode(document, {shape.id, segment},
                              0.5 * (shape.nodes[segment] + shape.nodes[(segment + 1) % shape.nodes.size()]));
        case 1:
            selection.nodes = {{shape.id, node}};
            return deleteSelection(document, selection);
        case 2:
            selection.segments = {{shape.id, segment}};
            return moveSelection(document, selection, by);
        case 3:
            selection.nodes = {{shape.id, node}};
            return isClosed(shape) ? setHandle(document, {shape.id, node}, shape.nodes[node] + by)
                                   : splitPath(document, {shape.id, node});
        default:
            return setHandle(document, {shape.id, node}, shape.nodes[node] + by);
        }
    }

  private:
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
    double number(double a, double b) {
        return a + (b - a) * (static_cast<double>(engine_() >> 11) / 9007199254740992.0);
    }

    std::mt19937_64 engine_;
};

} // namespace

TEST_CASE("Joints: 50 counties edited by 500 random commands still mesh as 50 regions without gaps") {
    Document document = CountyMap().document;
    document.spacing.size = 0.25;
    const auto meshes = [](const Document &map) { return validate(toDomain(map)).empty(); };
    REQUIRE(meshes(document));
    RandomEdits edits(5);
    std::size_t done = 0, detached = 0;
    for (std::size_t tried = 0; done < 500 && tried < 5000; ++tried) {
        const Result<Document> command = edits.next(document);
        const Result<Document> next = jointly(document, command);
        if (next && next->shapes.size() >= document.shapes.size() &&
            meshes(*next)) { // a map whose borders do not cross
            detached += command->shapes != next->shapes ? 1 : 0;
            document = *next;
            ++done;
        }
    }
    CHECK(done == 500);
    CHECK(detached > 100); // commands that would have torn a joint
    const Result<MeshingOutcome> meshed = meshDomain(jobOf(document));
    REQUIRE(meshed);
    const std::vector<std::int32_t> &regions = meshed->mesh.blocks.front().regions;
    CHECK(std::set<std::int32_t>(regions.begin(), regions.end()).size() == kColumns * kRows);
}

TEST_CASE("Joints: corners of mapped regions go with their nodes, unless a command has moved them itself") {
    Document document = documentOf({square({0, 0}, 1), square({1, 0}, 1)});
    document.mapped = {{1, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {2, {}}};
    const Document moved = jointed(document, setHandle(document, {1, 2}, {1.25, 1.5}));
    CHECK(moved.mapped.front().corners == std::vector<Vec2>{{0, 0}, {1, 0}, {1.25, 1.5}, {0, 1}});
    CHECK(moved.mapped[1].corners.empty());
    Selection all;
    all.shapes = {1, 2};
    const Document shifted = jointed(document, moveSelection(document, all, {0.5, 0.0}));
    CHECK(shifted.mapped.front().corners == std::vector<Vec2>{{0.5, 0}, {1.5, 0}, {1.5, 1}, {0.5, 1}});
    Selection node;
    node.nodes = {{2, 3}}; // of the neighbour, joined with a corner
    const Document joint = jointed(document, moveSelection(document, node, {0.0, 0.5}));
    CHECK(joint.mapped.front().corners == std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1.5}, {0, 1}});
}
