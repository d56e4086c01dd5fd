// Maps of abutting shapes under random constraints, dimensions, drags and edits: no gaps, exact undo.
#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_drag.hpp"
#include "core/drawing/constraints/sketch_state.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/document/history.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/base/number_text.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront::constraint_test {

using namespace edit_test;
using Kind = ConstraintKind;

namespace {

/// A rectangular region divided into shapes that share sides, corners and parts of sides.
class AbuttingMap {
  public:
    explicit AbuttingMap(Random &random) : random_(random) {
        divide({{0, 0}, {12, 9}}, 4);
        document = documentOf(std::move(shapes_));
        for (const auto &shape : document.shapes) {
            const std::vector<Vec2> handles = handlesOf(*shape);
            for (std::uint32_t k = 0; k < handles.size(); ++k) {
                places_.push_back({{shape->id, k}, handles[k]});
            }
        }
        findJoints();
        findOutline();
    }

    Document document;

    /// Returns the longest distance between what was joined at the start.
    double widestGap(const Document &now) const {
        double widest = 0.0;
        for (const auto &[node, other] : joined_) {
            widest = std::max(widest, distance(at(now, node), at(now, other)));
        }
        for (const auto &[node, side] : onSides_) {
            const Vec2 a = at(now, side.first), along = at(now, side.second) - a;
            widest = std::max(widest, std::fabs(cross(along, at(now, node) - a)) / length(along));
        }
        return widest;
    }

    /// Returns the area of the outline minus the sum of the areas of the shapes.
    double missingArea(const Document &now) const {
        double sum = 0.0;
        for (const auto &shape : now.shapes) {
            sum += signedArea(handlesOf(*shape));
        }
        std::vector<Vec2> outline;
        for (const NodeRef node : outline_) {
            outline.push_back(at(now, node));
        }
        return signedArea(outline) - sum;
    }

    /// Returns true if all nodes on sides are still between their ends, and no shape has become flat or turned over.
    bool isInOrder(const Document &now) const {
        constexpr double kFlat = 1e-3;
        const bool between = std::all_of(onSides_.begin(), onSides_.end(), [&](const auto &on) {
            const Vec2 a = at(now, on.second.first), along = at(now, on.second.second) - a;
            const double t = dot(at(now, on.first) - a, along) / lengthSquared(along);
            return t > kFlat && t < 1.0 - kFlat;
        });
        return between && std::all_of(now.shapes.begin(), now.shapes.end(), [](const auto &shape) {
                   const std::vector<Vec2> nodes = handlesOf(*shape);
                   double shortest = distance(nodes[3], nodes[0]);
                   for (std::size_t k = 0; k < 3; ++k) {
                       shortest = std::min(shortest, distance(nodes[k], nodes[k + 1]));
                   }
                   return shortest > kFlat && signedArea(nodes) > 0.0;
               });
    }

  private:
    static Vec2 at(const Document &document, NodeRef node) {
        return handlesOf(*findShape(document, node.shape))[node.node];
    }
    static double signedArea(const std::vector<Vec2> &nodes) {
        double twice = 0.0;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            twice += cross(nodes[k], nodes[(k + 1) % nodes.size()]);
        }
        return 0.5 * twice;
    }

    void divide(const Box2 &box, int depth) {
        const Vec2 size = box.max - box.min;
        if (depth == 0 || (depth < 3 && random_.below(4) == 0)) {
            shapes_.push_back(random_.below(2) == 0
                                  ? makeShape(ShapeKind::Rectangle, {box.min, box.max})
                                  : makeShape(ShapeKind::Polygon,
                                              {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}));
            return;
        }
        const double share = 0.25 * (1 + random_.below(3));
        Box2 low = box, high = box;
        if (size.x > size.y) {
            low.max.x = high.min.x = box.min.x + share * size.x;
        } else {
            low.max.y = high.min.y = box.min.y + share * size.y;
        }
        divide(low, depth - 1);
        divide(high, depth - 1);
    }

    void findJoints() {
        for (const auto &[node, place] : places_) {
            for (const auto &[other, there] : places_) {
                if (node < other && place == there) {
                    joined_.emplace_back(node, other);
                }
                const NodeRef end{other.shape, (other.node + 1) % 4};
                const Vec2 along = at(document, end) - there;
                const double t = dot(place - there, along) / lengthSquared(along);
                if (other.shape != node.shape && t > 0.0 && t < 1.0 && cross(along, place - there) == 0.0) {
                    onSides_.emplace_back(node, std::pair(other, end));
                }
            }
        }
    }

    void findOutline() {
        const auto side = [](Vec2 p) { return p.y == 0 ? 0 : p.x == 12 ? 1 : p.y == 9 ? 2 : p.x == 0 ? 3 : 4; };
        std::vector<std::pair<double, NodeRef>> around;
        for (const auto &[node, p] : places_) {
            const double way[] = {p.x, 12 + p.y, 21 + (12 - p.x), 33 + (9 - p.y)};
            if (side(p) < 4) {
                around.emplace_back(p == Vec2{0, 0} ? 0.0 : way[side(p)], node);
            }
        }
        std::sort(around.begin(), around.end());
        for (std::size_t k = 0; k < around.size(); ++k) {
            if (k == 0 || around[k].first > around[k - 1].first) {
                outline_.push_back(around[k].second);
            }
        }
    }

    Random &random_;
    std::vector<Shape> shapes_;
    std::vector<std::pair<NodeRef, Vec2>> places_;
    std::vector<std::pair<NodeRef, NodeRef>> joined_;
    std::vector<std::pair<NodeRef, std::pair<NodeRef, NodeRef>>> onSides_;
    std::vector<NodeRef> outline_;
};

/// Draws random acts of a user on a map whose shapes keep their corners.
class MapEdits {
  public:
    explicit MapEdits(Random &random) : random_(random) {}

    Result<Document> next(const Document &document) {
        switch (random_.below(8)) {
        case 0:
            return addConstraint(document, random_.below(2) == 0 ? Kind::Horizontal : Kind::Vertical,
                                 {anySide(document)});
        case 1:
            return addConstraint(document, Kind::Fixed, {anyNode(document)});
        case 2:
            return addConstraint(document, Kind::Distance, {anyNode(document), anyNode(document)});
        case 3:
            return addConstraint(document, Kind::Length, {anySide(document)});
        case 4:
        case 5:
            return dimension(document);
        case 6:
            return parameter(document);
        default:
            return drag(document);
        }
    }

  private:
    SketchPart anyNode(const Document &document) {
        return node(1 + random_.below(static_cast<std::uint32_t>(document.shapes.size())), random_.below(4));
    }
    SketchPart anySide(const Document &document) {
        return segment(1 + random_.below(static_cast<std::uint32_t>(document.shapes.size())), random_.below(4));
    }

    Result<Document> dimension(const Document &document) {
        std::vector<const SketchConstraint *> dimensions;
        for (const auto &constraint : document.constraints) {
            if (isDimension(constraint->kind)) {
                dimensions.push_back(constraint.get());
            }
        }
        if (dimensions.empty()) {
            return document;
        }
        const SketchConstraint &one = *dimensions[random_.below(static_cast<std::uint32_t>(dimensions.size()))];
        return setDimension(document, one.id, one.value * random_.real(0.8, 1.25));
    }

    /// Ties the width of a rectangle to the parameter, or changes it.
    Result<Document> parameter(const Document &document) {
        const std::uint32_t id = anyNode(document).shape;
        const Shape &shape = *findShape(document, id);
        if (!shape.is<RectangleForm>() || document.formulas.size() > 1) {
            return overrideParameters(document, {{"s", std::to_string(random_.real(0.9, 1.1))}});
        }
        const double width = shape.nodes[1].x - shape.nodes[0].x;
        const Document tied = setFormula(document, {NumberOwner::ofShape(id), Quantity::Width, 0},
                                         numberText(width / document.spacing.names.at("s"), 17) + "*s");
        return applyFormulas(tied);
    }

    /// Returns true if a constraint names a node or a side that ends at it.
    static bool isNamed(const Document &document, const SketchPart &node) {
        return std::any_of(document.constraints.begin(), document.constraints.end(), [&](const auto &constraint) {
            return std::any_of(constraint->parts.begin(), constraint->parts.end(), [&](const SketchPart &part) {
                const bool isEnd = part.index == node.index || (part.index + 1) % 4 == node.index;
                return part.shape == node.shape && (part.kind == SketchPartKind::Node ? part == node : isEnd);
            });
        });
    }

    Result<Document> drag(const Document &document) {
        const SketchPart part = anyNode(document);
        if (!isNamed(document, part)) { // then joints hold as in drawings without constraints
            return document;
        }
        const auto start = std::make_shared<const Document>(document);
        const Vec2 from = handlesOf(*findShape(document, part.shape))[part.index], by = random_.place(0.7);
        ConstraintDrag drag(start);
        const Joints joints(start);
        Result<Document> last = document;
        for (const double share : {0.5, 1.0}) {
            const Result<Document> moved = setHandle(document, {part.shape, part.index}, from + share * by);
            last = moved ? joints.carry(*moved) : moved;
            if (last) {
                last = drag.carry(*last);
            }
        }
        return last;
    }

    Random &random_;
};

} // namespace

TEST_CASE("Sketch joints: maps of abutting shapes stay without gaps through random dimensions, drags and parameters") {
    std::size_t applied = 0, moved = 0, refused = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        AbuttingMap map(random);
        map.document.parameters = {{"s", "1"}};
        map.document.spacing.names = {{"s", 1.0}};
        REQUIRE(map.widestGap(map.document) == 0.0);
        REQUIRE(map.missingArea(map.document) == doctest::Approx(0.0));
        MapEdits edits(random);
        History history(map.document);
        std::vector<std::shared_ptr<const Document>> steps = {history.shared()};
        for (int step = 0; step < 24; ++step) {
            CAPTURE(step);
            const Document &before = history.document();
            Result<Document> next = edits.next(before);
            next = next ? completeCommand(before, *std::move(next)) : next;
            if (!next) {
                ++refused;
                const std::string code = next.faults().front().code;
                CAPTURE(messageOf(next));
                CHECK((code.starts_with("constraint-") || code == "bad-formula" || code == "bad-constraint" ||
                       code == "joined-locked"));
                continue;
            }
            ++applied;
            if (!map.isInOrder(*next)) { // joints have gone, or come
                continue;
            }
            moved += next->shapes != before.shapes ? 1 : 0;
            CHECK(map.widestGap(*next) < 1e-7);
            CHECK(std::fabs(map.missingArea(*next)) < 1e-6);
            checkAllHold(*next);
            if (history.commit("step", *std::move(next))) {
                steps.push_back(history.shared());
            }
        }
        for (std::size_t k = steps.size(); k-- > 1;) {
            CHECK(history.shared() == steps[k]);
            REQUIRE(history.undo());
        }
        CHECK(sameContent(history.document(), map.document));
    }
    INFO(applied, " applied, of which ", moved, " moved nodes; ", refused, " refused");
    CHECK(applied > 600);
    CHECK(moved > 250);
}

namespace {

/// Draws random acts on any drawing: constraints of all kinds, edits of nodes and shapes, formulas and undo.
class AnyEdits {
  public:
    explicit AnyEdits(Random &random) : random_(random) {}

    /// Returns the drawing after an act, with its joints as the editor carries them.
    Result<Document> next(const Document &document) {
        const std::vector<SketchPart> parts = partsOf(document);
        const auto anyPart = [&] { return parts[below(parts.size())]; };
        const Shape &shape = *document.shapes[below(document.shapes.size())];
        const auto handle = below(handleCount(shape));
        Selection selection;
        switch (below(12)) {
        case 0:
        case 1:
        case 2:
            return addConstraint(document, static_cast<Kind>(below(20)), {anyPart(), anyPart()});
        case 3:
            return addConstraint(document, static_cast<Kind>(below(20)), {anyPart()});
        case 4:
            return changed(document);
        case 5:
            return jointly(document,
                           setHandle(document, {shape.id, handle}, random_.place(1.0) + handlesOf(shape)[handle]));
        case 6:
            return jointly(document, insertInto(document, shape));
        case 7:
            selection.nodes = {{shape.id, handle}};
            return document.shapes.size() > 4 ? jointly(document, deleteSelection(document, selection))
                                              : Result<Document>(document);
        case 8:
            return jointly(document, transformSelection(document, selected({shape.id}),
                                                        PlaneMap::rotation(random_.real(-30, 30), random_.place(9))));
        case 9:
            return document.shapes.size() < 14
                       ? duplicateSelection(document, selected({shape.id}), random_.place(6.0), nullptr)
                       : Result<Document>(document);
        case 10:
            return overrideParameters(document, {{"s", std::to_string(random_.real(0.8, 1.2))}});
        default:
            return tied(document, shape.id, handle);
        }
    }

  private:
    std::uint32_t below(std::size_t n) { return random_.below(static_cast<std::uint32_t>(n)); }

    static Result<Document> jointly(const Document &document, const Result<Document> &next) {
        return next ? carryJoints(document, *next) : next;
    }

    Result<Document> changed(const Document &document) {
        if (document.constraints.empty()) {
            return document;
        }
        const SketchConstraint &one = *document.constraints[below(document.constraints.size())];
        return below(3) == 0 ? Result<Document>(removeConstraints(document, {one.id}))
                             : setDimension(document, one.id, one.value * random_.real(0.5, 2.0));
    }

    Result<Document> insertInto(const Document &document, const Shape &shape) {
        if (!isPath(shape) || shape.nodes.size() < 2) {
            return document;
        }
        const std::uint32_t k = below(outlineOf(shape).segmentCount());
        return insertNode(document, {shape.id, k}, midpoint(outlineOf(shape).from(k), outlineOf(shape).to(k)));
    }

    /// Gives a coordinate of a node a formula.
    Result<Document> tied(const Document &document, std::uint32_t id, std::uint32_t handle) {
        const Vec2 at = handlesOf(*findShape(document, id))[handle];
        const double s = document.spacing.names.at("s");
        return isPath(*findShape(document, id)) && document.formulas.size() < 4
                   ? applyFormulas(setFormula(document, {NumberOwner::ofShape(id), Quantity::X, handle},
                                              numberText(at.x / s, 17) + "*s"))
                   : Result<Document>(document);
    }

    Random &random_;
};

/// An abutting map with shapes of all kinds beside it that touch it at nodes and ends.
Document touchingShapes(Random &random) {
    std::vector<Shape> shapes;
    for (const auto &shape : AbuttingMap(random).document.shapes) {
        if (shapes.size() < 4) {
            shapes.push_back(*shape);
        }
    }
    const Vec2 corner = handlesOf(shapes.front())[2];
    Shape arc = makeShape(ShapeKind::Polyline, {corner, corner + Vec2{2, 0}}, ShapeUse::Constraint);
    arc.path().curves = {Curve::arc(corner + Vec2{1, 0}, {-1, 0}, {0, -1}, 0.0, 3.14159265358979312)};
    shapes.push_back(arc);
    shapes.push_back(makeShape(ShapeKind::Point, {corner}, ShapeUse::Constraint));
    shapes.push_back(makeShape(ShapeKind::Circle, {corner, corner + Vec2{0.5, 0}}, ShapeUse::Constraint));
    shapes.push_back(makeShape(ShapeKind::Polyline,
                               {midpoint(handlesOf(shapes[1])[0], handlesOf(shapes[1])[1]), {-3, -2}},
                               ShapeUse::Constraint));
    Document document = documentOf(std::move(shapes));
    document.parameters = {{"s", "1"}};
    document.spacing.names = {{"s", 1.0}};
    return document;
}

} // namespace

TEST_CASE("Sketch joints: random acts on touching shapes leave valid drawings, and are undone exactly") {
    std::size_t applied = 0, refused = 0;
    for (std::uint64_t seed = 1; seed <= 80; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        History history(touchingShapes(random));
        std::vector<std::shared_ptr<const Document>> steps = {history.shared()};
        AnyEdits edits(random);
        for (int step = 0; step < 25; ++step) {
            CAPTURE(step);
            const Document &before = history.document();
            Result<Document> next = edits.next(before);
            next = next ? completeCommand(before, *std::move(next)) : next;
            if (!next) {
                ++refused;
                CHECK(!next.faults().front().message.empty());
                continue;
            }
            ++applied;
            checkAllHold(*next);
            for (const auto &shape : next->shapes) {
                CHECK(checkShape(*shape).empty());
            }
            const SketchState state = sketchState(*next);
            CHECK(state.violated.empty());
            CHECK(state.degrees < 200);
            if (history.commit("step", *std::move(next))) {
                steps.push_back(history.shared());
            }
        }
        const std::string text = projectText(history.document());
        const Result<Document> read = parseProject(text, "a.json");
        REQUIRE_MESSAGE(read.ok(), messageOf(read));
        CHECK(projectText(*read) == text);
        for (std::size_t k = steps.size(); k-- > 1;) {
            CHECK(history.shared() == steps[k]);
            REQUIRE(history.undo());
        }
        CHECK(history.shared() == steps.front());
    }
    INFO(applied, " applied, ", refused, " refused");
    CHECK(applied > 1000);
    CHECK(refused > 100);
}

} // namespace forefront::constraint_test
