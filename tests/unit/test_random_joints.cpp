// Maps of abutting shapes under random constraints, dimensions, drags and edits: no gaps, exact undo.
#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_drag.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/constraints/sketch_state.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/document/history.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/base/number_text.hpp"
#include "tests/unit/abutting_map.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront::constraint_test {

using namespace edit_test;
using Kind = ConstraintKind;

namespace {

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

    Result<Document> drag(const Document &document) {
        const SketchPart part = anyNode(document);
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
                       code == "joined-locked" || code == "joint-conflict"));
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
            for (const std::uint32_t id : state.violated) { // sides with a distance may be turned by a drag
                CHECK(isSlantedDistance(*next, *findConstraint(*next, id)));
            }
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
