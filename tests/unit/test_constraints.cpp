#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/constraints/carry_constraints.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_drag.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/constraints/settle.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/constraints/sketch_state.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/document/history.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace forefront::constraint_test {

using namespace edit_test;
using Kind = ConstraintKind;

TEST_CASE("Constraints: the text of a part is read as the same part") {
    const Document document = everyShape();
    for (const SketchPart &part : partsOf(document)) {
        CHECK((parseSketchPart(toString(part)) == part));
    }
    for (const char *text :
         {"", "shape", "shape/1", "shape/1/node", "shape/x/node/1", "shape/1/node/1x", "shape/1/origin/0", "node/1",
          "shape/1//1", "shape//node/1", "xAxis/1", "shape/1/node/-1"}) {
        CAPTURE(text);
        CHECK(!parseSketchPart(text));
    }
}

TEST_CASE("Constraints: every kind that fits two parts of any shapes can be made, holds, and survives a project") {
    const Document document = everyShape();
    const std::vector<SketchPart> parts = partsOf(document);
    std::set<std::pair<Kind, std::pair<PartForm, PartForm>>> made;
    std::size_t solved = 0, refused = 0;
    for (const Kind kind : valuesOf<Kind>()) {
        for (const SketchPart &a : parts) {
            for (const SketchPart &b : parts) {
                // Pairs of every third part are enough: each form comes with every other.
                if (a == b || (a.shape * 7 + b.shape * 3 + a.index + b.index) % 3 != 0) {
                    continue;
                }
                const Result<SketchConstraint> constraint = makeConstraint(document, kind, {a, b});
                if (!constraint) {
                    continue;
                }
                const Result<Document> next = addConstraint(document, *constraint);
                if (!next) {
                    ++refused;
                    CHECK(next.faults().front().code.starts_with("constraint-"));
                    continue;
                }
                CAPTURE(toString(a));
                CAPTURE(toString(b));
                CAPTURE(std::string(wordOf(kind)));
                ++solved;
                made.insert(
                    {kind, {formOfPart(document, constraint->parts[0]), formOfPart(document, constraint->parts[1])}});
                CHECK(holdsIn(*next, *next->constraints.back()));
                for (const auto &shape : next->shapes) {
                    CHECK(checkShape(*shape).empty());
                }
                if (solved % 10 == 0) {
                    const std::string text = projectText(*next);
                    const Result<Document> read = parseProject(text, "a.json");
                    REQUIRE_MESSAGE(read.ok(), messageOf(read));
                    CHECK(projectText(*read) == text);
                    CHECK(sameConstraints(*next, *read));
                    CHECK(read->nextId == next->nextId);
                }
            }
        }
    }
    INFO(solved, " solved, ", refused, " refused, ", made.size(), " combinations");
    CHECK(solved > 1000);
    CHECK(refused * 10 < solved);
    CHECK(made.size() == 27); // all forms of two parts, but for two ellipses
}

TEST_CASE("Constraints: kinds of one part, of three, and tangents where curves meet can be made and hold") {
    const Document document = everyShape();
    const auto check = [&](Kind kind, const std::vector<SketchPart> &parts, std::size_t count) {
        CAPTURE(std::string(wordOf(kind)));
        const Result<Document> next = addConstraint(document, kind, parts);
        REQUIRE_MESSAGE(next.ok(), messageOf(next));
        CHECK(next->constraints.back()->parts.size() == count);
        checkAllHold(*next);
        const Result<Document> read = parseProject(projectText(*next), "a.json");
        REQUIRE_MESSAGE(read.ok(), messageOf(read));
        CHECK(sameContent(*read, *next));
    };
    for (const SketchPart &part : partsOf(document)) {
        switch (formOfPart(document, part)) {
        case PartForm::Point:
            if (part != node(2, 0) && part != node(8, 0)) {
                check(Kind::Midpoint, {part, node(2, 0), node(8, 0)}, 3);
            }
            break;
        case PartForm::Line:
            if (part.shape != 0 && part.shape != 3 && part.shape != 9) {
                check(Kind::Horizontal, {part}, 1);
                check(Kind::Vertical, {part}, 1);
                check(Kind::Length, {part}, 2);
            }
            check(Kind::Symmetric, {part, node(5, 0), node(8, 0)}, 3);
            break;
        case PartForm::Circle:
            check(Kind::Radius, {part}, 1);
            check(Kind::Diameter, {part}, 1);
            break;
        case PartForm::Rounding:
            check(Kind::Radius, {part}, 1);
            break;
        default:
            break;
        }
    }
    check(Kind::Fixed, {node(4, 0)}, 1);
    check(Kind::Fixed, {segment(1, 0)}, 1);
    check(Kind::Fixed, {segment(1, 1)}, 1);
    check(Kind::Symmetric, {node(1, 0), node(2, 1), node(5, 0)}, 3);
    check(Kind::Tangent, {segment(1, 0), segment(1, 1)}, 4);
    check(Kind::Tangent, {segment(1, 1), segment(1, 2)}, 4);
    check(Kind::Tangent, {segment(1, 3), segment(1, 2)}, 4);
    check(Kind::Tangent, {segment(1, 4), segment(1, 3)}, 4);
    // Tangent on both sides of an arc, a fillet whose radius is driven.
    Document fillet = document;
    constrain(fillet, Kind::Tangent, {segment(1, 0), segment(1, 1)});
    constrain(fillet, Kind::Tangent, {segment(1, 1), segment(1, 2)});
    constrain(fillet, Kind::Radius, {segment(1, 1)});
    for (const double radius : {0.5, 1.0, 3.0}) {
        const Result<Document> next = setDimension(fillet, fillet.constraints.back()->id, radius);
        REQUIRE_MESSAGE(next.ok(), messageOf(next));
        checkAllHold(*next);
    }
}

TEST_CASE("Constraints: dimensions drive a plate, near and far, and the way back gives the same numbers") {
    const Document plate = drivenPlate();
    for (const double width : {41.0, 400.0, 1.0, 40.0}) {
        const Result<Document> wide = setDimension(plate, kWidth, width);
        REQUIRE_MESSAGE(wide.ok(), messageOf(wide));
        const std::vector<Vec2> &nodes = wide->shapes[0]->nodes;
        CHECK(nodes[0] == Vec2{0, 0});
        CHECK(distance(nodes[1], {width, 0}) < 1e-8 * width);
        CHECK(distance(nodes[2], {width, 30}) < 1e-8 * (width + 30));
        CHECK(distance(nodes[3], {0, 30}) < 1e-8 * 30);
        checkAllHold(*wide);
    }
    CHECK(sameContent(*setDimension(plate, kWidth, 40.0), plate));
    CHECK(codeOf(setDimension(plate, kWidth, 0.0)) == "bad-constraint");
    CHECK(codeOf(setDimension(plate, kWidth, -1.0)) == "bad-constraint");
    CHECK(codeOf(setDimension(plate, 1, 5.0)) == "no-such-constraint");
    CHECK(codeOf(setDimension(plate, 2, 5.0)) == "bad-constraint");
}

TEST_CASE("Constraints: what cannot hold is refused with a minimal set of names and changes nothing") {
    const Document plate = drivenPlate();
    const std::string text = projectText(plate);
    Result<SketchConstraint> opposite = makeConstraint(plate, Kind::Length, {segment(1, 2)});
    REQUIRE(opposite.ok());
    const Result<Document> redundant = addConstraint(plate, *opposite);
    CHECK(codeOf(redundant) == "constraint-redundant");
    CHECK(messageOf(redundant) ==
          "Length 3 follows from Horizontal 1, Horizontal 2, Vertical 1, Vertical 2 and Length 1");
    opposite->value = 50.0;
    const Result<Document> conflict = addConstraint(plate, *opposite);
    CHECK(codeOf(conflict) == "constraint-conflict");
    CHECK(messageOf(conflict) ==
          "Length 3 cannot hold together with Horizontal 2, Vertical 1, Vertical 2 and Length 1");
    CHECK(projectText(plate) == text);

    Document triangle = documentOf({makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {0, 3}})});
    for (std::uint32_t k = 0; k < 3; ++k) {
        constrain(triangle, Kind::Length, {segment(1, k)});
    }
    const Result<Document> flat = setDimension(triangle, 3, 20.0);
    CHECK(codeOf(flat) == "constraint-conflict");
    CHECK(messageOf(flat) == "constraints Length 1, Length 2 and Length 3 cannot hold together");
}

TEST_CASE("Constraints: parameters drive dimensions, and what they contradict is refused") {
    Document plate = setFormula(setFormula(drivenPlate(), {NumberOwner::ofConstraint(kWidth), Quantity::Value}, "2*w"),
                                {NumberOwner::ofConstraint(kHeight), Quantity::Value}, "w + 10");
    plate.parameters = {{"w", "20"}};
    const Result<Document> same = applyFormulas([&] {
        Document named = plate;
        named.spacing.names = parameterValues(named.parameters);
        return named;
    }());
    REQUIRE_MESSAGE(same.ok(), messageOf(same));
    CHECK(same->shapes == plate.shapes);
    const Result<Document> larger = overrideParameters(*same, {{"w", "30"}});
    REQUIRE_MESSAGE(larger.ok(), messageOf(larger));
    CHECK(distance(larger->shapes[0]->nodes[2], {60, 40}) < 1e-6);
    CHECK(numberName(*larger, {NumberOwner::ofConstraint(kWidth), Quantity::Value}) == "value of Length 1");
    CHECK(codeOf(overrideParameters(*same, {{"w", "-30"}})) == "bad-constraint");
    // A dimension that is typed loses its formula.
    Result<Document> typed = setDimension(*larger, kWidth, 55.0);
    REQUIRE(typed.ok());
    typed = settleCommand(*larger, *typed);
    REQUIRE(typed.ok());
    CHECK(typed->formulas.size() == 1);
    CHECK(distance(typed->shapes[0]->nodes[2], {55, 40}) < 1e-6);
}

TEST_CASE("Constraints: moved nodes keep to the constraints, and rest where they were put if possible") {
    const Document plate = drivenPlate();
    // Determined: nothing moves.
    const Result<Document> pulled = settleCommand(plate, *setHandle(plate, {1, 2}, {60, 50}));
    REQUIRE_MESSAGE(pulled.ok(), messageOf(pulled));
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(distance(pulled->shapes[0]->nodes[k], plate.shapes[0]->nodes[k]) < 1e-7);
    }
    // Free in both directions: the node stays where it was put, and its neighbours follow.
    const Document free = removeConstraints(plate, {kWidth, kHeight});
    CHECK(free.constraints.size() == 5);
    const Result<Document> moved = settleCommand(free, *setHandle(free, {1, 2}, {60, 50}));
    REQUIRE_MESSAGE(moved.ok(), messageOf(moved));
    CHECK(moved->shapes[0]->nodes[2] == Vec2{60, 50});
    CHECK(distance(moved->shapes[0]->nodes[1], {60, 0}) < 1e-6);
    CHECK(distance(moved->shapes[0]->nodes[3], {0, 50}) < 1e-6);
    checkAllHold(*moved);
}

TEST_CASE("Constraints: references follow inserted, removed and reversed nodes") {
    const Document plate = removeConstraints(drivenPlate(), {6}); // without the fixed corner
    const Result<Document> inserted = settleCommand(plate, *insertNode(plate, {1, 0}, {10, 0}));
    REQUIRE_MESSAGE(inserted.ok(), messageOf(inserted));
    checkAllHold(*inserted);
    CHECK(lostConstraints(plate, *inserted).empty());
    CHECK(inserted->constraints.size() == plate.constraints.size() + 1); // both parts of the side stay in line
    CHECK(findConstraint(*inserted, kWidth)->parts == std::vector<SketchPart>{node(1, 0), node(1, 2)});
    CHECK(findConstraint(*inserted, kHeight)->parts == std::vector<SketchPart>{node(1, 2), node(1, 3)});
    CHECK(inserted->constraints.back()->kind == Kind::Collinear);

    Selection gone;
    gone.nodes = {{1, 1}};
    const Result<Document> deleted = settleCommand(*inserted, deleteSelection(*inserted, gone));
    REQUIRE_MESSAGE(deleted.ok(), messageOf(deleted));
    CHECK(deleted->shapes[0]->nodes == plate.shapes[0]->nodes);
    checkAllHold(*deleted);
    CHECK(findConstraint(*deleted, kWidth)->parts == findConstraint(plate, kWidth)->parts);

    gone.nodes = {{1, 0}};
    const Result<Document> corner = settleCommand(plate, deleteSelection(plate, gone));
    REQUIRE_MESSAGE(corner.ok(), messageOf(corner));
    checkAllHold(*corner);
    CHECK(lostConstraints(plate, *corner) == std::vector<std::string>{"Horizontal 1", "Vertical 2", "Length 1"});

    gone.nodes.clear();
    gone.shapes = {1};
    CHECK(settleCommand(plate, deleteSelection(plate, gone))->constraints.empty());
}

TEST_CASE("Constraints: a rectangle, circle or slot that becomes a path keeps its form and its dimensions") {
    Document document = everyShape();
    constrain(document, Kind::Length, {segment(3, 0)});
    constrain(document, Kind::Radius, {segment(4)});
    constrain(document, Kind::Diameter, {segment(7, 1)});
    constrain(document, Kind::Distance, {node(4, 0), node(7, 1)});
    const std::size_t before = document.constraints.size();
    Result<Document> paths = convertToPaths(document, {3, 4, 7});
    REQUIRE(paths.ok());
    paths = settleCommand(document, *paths);
    REQUIRE_MESSAGE(paths.ok(), messageOf(paths));
    CHECK(lostConstraints(document, *paths).empty());
    CHECK(paths->constraints.size() == before + 4 + 3 + 5);
    checkAllHold(*paths);
    const Result<Document> wide = setDimension(*paths, document.constraints[0]->id, 12.0);
    REQUIRE_MESSAGE(wide.ok(), messageOf(wide));
    checkAllHold(*wide);
}

TEST_CASE("Constraints: turned, mirrored, scaled and copied shapes take their constraints along") {
    const Document plate = removeConstraints(drivenPlate(), {6});
    for (const PlaneMap &map :
         {PlaneMap::rotation(30.0, {20, 15}), PlaneMap::rotation(90.0, {20, 15}), PlaneMap::reflection(0.0, {0, 0}),
          PlaneMap::reflection(25.0, {1, 2}), PlaneMap::scaling({2.0, 2.0}, {0, 0}), PlaneMap::translation({3, 4})}) {
        const Result<Document> mapped = transformSelection(plate, selected({1}), map);
        REQUIRE(mapped.ok());
        const Result<Document> settled = settleCommand(plate, *mapped);
        REQUIRE_MESSAGE(settled.ok(), messageOf(settled));
        CHECK(settled->shapes[0]->nodes == mapped->shapes[0]->nodes);
        checkAllHold(*settled);
        CHECK(settled->constraints.size() == plate.constraints.size() - (map.keepsAxes() ? 0 : 1));
        const double scale = std::sqrt(std::fabs(map.determinant()));
        CHECK(std::fabs(findConstraint(*settled, kWidth)->value - 40.0 * scale) < 1e-9);

        Selection copies;
        const Result<Document> copied = copySelection(plate, selected({1}), std::vector<PlaneMap>{map}, &copies);
        REQUIRE(copied.ok());
        checkAllHold(*copied);
        CHECK(copied->constraints.size() == 2 * plate.constraints.size() - (map.keepsAxes() ? 0 : 1));
    }
}

TEST_CASE("Constraints: what is turned comes with its neighbours where they settle, so that it is solved once") {
    Document document = documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {4, 0}, {7, 2}}),
                                    makeShape(ShapeKind::Polygon, {{4, 0}, {6, -3}, {3, -4}})});
    constrain(document, Kind::Length, {segment(1, 0)});
    constrain(document, Kind::Coincident, {node(1, 1), node(2, 0)});
    constrain(document, Kind::Coincident, {node(1, 2), node(2, 1)});
    for (const PlaneMap &map : {PlaneMap::rotation(20.0, {5, -2}), PlaneMap::scaling({1.2, 1.2}, {6, -3})}) {
        const Result<Document> turned = transformSelection(document, selected({2}), map);
        REQUIRE_MESSAGE(turned.ok(), messageOf(turned));
        CHECK(turned->shapes[0]->nodes != document.shapes[0]->nodes); // the neighbour has followed
        checkAllHold(*turned);
        const Result<Document> completed = settleCommand(document, *turned);
        REQUIRE_MESSAGE(completed.ok(), messageOf(completed));
        for (std::size_t k = 0; k < document.shapes.size(); ++k) {
            CHECK(completed->shapes[k]->nodes == turned->shapes[k]->nodes);
        }
    }
}

TEST_CASE("Constraints: a drag comes near the pointer, holds throughout, and leads back to the start") {
    Document linkage =
        documentOf({makeShape(ShapeKind::Polyline, {{0, 0}, {0.5, 1.5}, {3.5, 2.5}, {4, 0}}, ShapeUse::Constraint)});
    constrain(linkage, Kind::Fixed, {node(1, 0)});
    constrain(linkage, Kind::Fixed, {node(1, 3)});
    for (std::uint32_t k = 0; k < 3; ++k) {
        constrain(linkage, Kind::Length, {segment(1, k)});
    }
    const auto start = std::make_shared<const Document>(linkage);
    ConstraintDrag drag(start);
    for (int step = 0; step <= 20; ++step) {
        const double angle = 0.05 * step;
        const Vec2 to{0.5 + std::sin(angle) * 0.5, 1.5 - 0.2 * std::sin(angle)};
        const Document at = drag.carry(*setHandle(linkage, {1, 1}, to));
        checkAllHold(at);
        CHECK(distance(at.shapes[0]->nodes[1], to) < 0.1);
        CHECK(settle(linkage, at)->shapes == at.shapes);
    }
    CHECK(drag.carry(linkage).shapes[0]->nodes == linkage.shapes[0]->nodes);
}

TEST_CASE("Constraints: the state tells what is free, determined, redundant and violated") {
    const Document plate = drivenPlate();
    SketchState state = sketchState(plate);
    CHECK(state.degrees == 0);
    CHECK(state.redundant.empty());
    CHECK(state.violated.empty());
    CHECK(state.isDetermined(node(1, 2)));
    CHECK(state.isDetermined(segment(1, 2)));
    state = sketchState(removeConstraints(plate, {kWidth}));
    CHECK(state.degrees == 1);
    CHECK(!state.isDetermined(node(1, 2)));
    CHECK(state.isDetermined(node(1, 0)));
    CHECK(state.isDetermined(segment(1, 3)));
    Document wrong = plate;
    SketchConstraint width = *findConstraint(plate, kWidth);
    width.value = 41.0;
    wrong.constraints[5] = std::make_shared<const SketchConstraint>(width);
    CHECK(sketchState(wrong).violated == std::set<std::uint32_t>{kWidth});
}

TEST_CASE("Constraints: undo restores the document exactly, and equality sees constraints") {
    const Document plate = drivenPlate();
    History history(plate);
    CHECK(history.commit("width", *setDimension(plate, kWidth, 77.0)));
    CHECK(history.commit("remove", removeConstraints(history.document(), {kHeight})));
    CHECK(!sameContent(history.document(), plate));
    CHECK(history.undo());
    CHECK(history.undo());
    CHECK(sameContent(history.document(), plate));
    CHECK(projectText(history.document()) == projectText(plate));
}

TEST_CASE("Constraints: construction geometry is kept in projects but not in the domain") {
    Document document =
        documentOf({square({0, 0}, 4.0), makeShape(ShapeKind::Polyline, {{-1, 2}, {5, 2}}, ShapeUse::Constraint, 9)});
    const Domain whole = toDomain(*setConstruction(document, {}, true));
    Result<Document> marked = setConstruction(document, {2}, true);
    REQUIRE(marked.ok());
    CHECK(whole.segments.size() == 5);
    CHECK(toDomain(*marked).segments.size() == 4);
    constrain(*marked, Kind::Symmetric, {node(1, 0), node(1, 3), segment(2, 0)});
    const Result<Document> read = parseProject(projectText(*marked), "a.json");
    REQUIRE(read.ok());
    CHECK(sameContent(*read, *marked));
    CHECK(read->shapes[1]->construction);
    CHECK(codeOf(setConstruction(document, {7}, true)) == "no-such-shape");
}

TEST_CASE("Constraints: a project with bad constraints is refused with the place of each") {
    const auto faultOf = [](const std::string &constraint) {
        const Result<Document> read =
            parseProject("{\"format\": \"forefront\", \"version\": 2, \"shapes\": [{\"id\": 1, \"kind\": \"polygon\", "
                         "\"nodes\": [[0, 0], [4, 0], [4, 3]]}, {\"id\": 2, \"kind\": \"circle\", \"nodes\": [[0, 0], "
                         "[1, 0]]}],\n\"constraints\": [" +
                             constraint + "]}",
                         "a.json");
        REQUIRE(!read.ok());
        CHECK(read.faults().front().line == 2);
        return read.faults().front().message;
    };
    CHECK(faultOf(R"({"id": 1, "kind": "horizontal", "of": ["shape/3/segment/0"]})") ==
          "constraint 'Horizontal 1': no part of the drawing that can be constrained is shape/3/segment/0");
    CHECK(faultOf(R"({"id": 1, "kind": "horizontal", "of": ["shape/1/segment/3"]})") ==
          "constraint 'Horizontal 1': no part of the drawing that can be constrained is shape/1/segment/3");
    CHECK(faultOf(R"({"id": 1, "kind": "horizontal", "name": "H", "of": ["shape/2/segment/0"]})") ==
          "constraint 'H': expected a line or two points");
    CHECK(faultOf(R"({"id": 1, "kind": "horizontal", "of": ["segment 3"]})") ==
          "invalid part 'segment 3'; expected one such as \"shape/1/node/0\" or \"shape/1/segment/0\"");
    CHECK(faultOf(R"({"id": 1, "kind": "coincident", "of": ["shape/1/node/0", "shape/1/node/0"]})") ==
          "constraint 'Coincident 1': a part is given twice");
    CHECK(faultOf(R"({"id": 1, "kind": "radius", "of": ["shape/2/segment/0"]})").find("value") != std::string::npos);
    CHECK(faultOf(R"({"id": 1, "kind": "radius", "value": -2, "of": ["shape/2/segment/0"]})") ==
          "expected a number greater than 0 for the value of a dimension");
    CHECK(faultOf(R"({"id": 1, "kind": "level", "of": ["shape/1/segment/0"]})")
              .starts_with("expected one of \"coincident\", "));
    CHECK(
        faultOf(
            R"({"id": 1, "kind": "fixed", "of": ["shape/1/node/0"]}, {"id": 1, "kind": "fixed", "of": ["shape/1/node/1"]})") ==
        "another constraint has the id 1");
}

} // namespace forefront::constraint_test
