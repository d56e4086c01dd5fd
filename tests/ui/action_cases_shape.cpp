#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/shapes/dimensions.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "tests/ui/action_cases.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace forefront::test {

namespace {

Box2 boxOf(Draughtsman &driver, std::size_t k) {
    return boundsOf(*driver.document().shapes[k]);
}

bool same(double a, double b) {
    return std::fabs(a - b) < 1e-9;
}

/// Returns true if all three boxes have the same value of a number, which is `value`.
template <class Number>
bool allAre(Draughtsman &driver, Number number, double value) {
    return same(number(boxOf(driver, 0)), value) && same(number(boxOf(driver, 1)), value) &&
           same(number(boxOf(driver, 2)), value);
}

bool firstNodeIs(Draughtsman &driver, Vec2 place) {
    return distance(driver.document().shapes[0]->nodes[0], place) < 1e-9;
}

std::size_t shapesOf(Draughtsman &driver) {
    return driver.document().shapes.size();
}

/// Draws two squares that overlap, and selects them.
void drawOverlap(Draughtsman &driver) {
    Shape square;
    square.nodes = {{2, 2}, {6, 2}, {6, 6}, {2, 6}};
    Shape other = square;
    other.nodes = {{4, 4}, {8, 4}, {8, 8}, {4, 8}};
    drawShapes(driver, {square, other});
    driver.key('A', {Modifiers::kControl});
    driver.settle();
}

double areaOf(Draughtsman &driver) {
    double area = 0.0;
    for (const auto &shape : driver.document().shapes) {
        const auto &nodes = shape->nodes;
        double twice = 0.0;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            twice += cross(nodes[k], nodes[(k + 1) % nodes.size()]);
        }
        area += 0.5 * std::fabs(twice);
    }
    return area;
}

void selectNode(Draughtsman &driver, std::uint32_t node) {
    driver.context().selection.clear();
    driver.context().selection.nodes = {{driver.document().shapes[0]->id, node}};
    driver.settle();
}

void selectSegment(Draughtsman &driver, std::uint32_t segment) {
    driver.context().selection.clear();
    driver.context().selection.segments = {{driver.document().shapes[0]->id, segment}};
    driver.settle();
}

NodeKind firstKind(Draughtsman &driver) {
    return nodeKind(*driver.document().shapes[0], 0);
}

void drawSmooth(Draughtsman &driver) {
    drawTriangle(driver);
    selectNode(driver, 0);
    driver.key('S', {Modifiers::kShift});
    driver.settle();
}

CurveKind firstCurve(Draughtsman &driver) {
    const auto &curves = driver.document().shapes[0]->path().curves;
    return curves.empty() ? CurveKind::Line : curves[0].kind();
}

std::vector<ActionCase> pathCases() {
    return {{"path.corner", drawSmooth, [](D &d, const B &) { return firstKind(d) == NodeKind::Corner; }},
            {"path.smooth",
             [](D &d) {
                 drawTriangle(d);
                 selectNode(d, 0);
             },
             [](D &d, const B &) { return firstKind(d) != NodeKind::Corner; }},
            {"path.symmetric",
             [](D &d) {
                 drawTriangle(d);
                 selectNode(d, 0);
             },
             [](D &d, const B &) { return firstKind(d) == NodeKind::Symmetric; }},
            {"path.line",
             [](D &d) {
                 drawSmooth(d);
                 selectSegment(d, 0);
             },
             [](D &d, const B &) { return firstCurve(d) == CurveKind::Line; }},
            {"path.curve",
             [](D &d) {
                 drawTriangle(d);
                 selectSegment(d, 0);
             },
             [](D &d, const B &) { return firstCurve(d) == CurveKind::Cubic; }},
            {"path.split",
             [](D &d) {
                 drawTriangle(d);
                 selectNode(d, 1);
             },
             [](D &d, const B &) { return d.document().shapes[0]->kind() == ShapeKind::Polyline; }},
            {"path.join",
             [](D &d) {
                 Shape line;
                 line.form = PathForm{.closed = false};
                 line.use = ShapeUse::Constraint;
                 line.nodes = {{2, 2}, {6, 2}, {6, 5}, {2, 3}};
                 drawShapes(d, {line});
                 const std::uint32_t id = d.document().shapes[0]->id;
                 d.context().selection.nodes = {{id, 0}, {id, 3}};
             },
             [](D &d, const B &) { return d.document().shapes[0]->kind() == ShapeKind::Polygon; }}};
}

std::vector<ActionCase> arrangementCases() {
    return {{"shape.alignLeft", drawThree,
             [](D &d, const B &) {
                 return allAre(
                     d, [](const Box2 &b) { return b.min.x; }, 1.0);
             }},
            {"shape.alignCentreX", drawThree,
             [](D &d, const B &) {
                 return allAre(
                     d, [](const Box2 &b) { return b.centre().x; }, 5.25);
             }},
            {"shape.alignRight", drawThree,
             [](D &d, const B &) {
                 return allAre(
                     d, [](const Box2 &b) { return b.max.x; }, 9.5);
             }},
            {"shape.alignTop", drawThree,
             [](D &d, const B &) {
                 return allAre(
                     d, [](const Box2 &b) { return b.max.y; }, 9.0);
             }},
            {"shape.alignCentreY", drawThree,
             [](D &d, const B &) {
                 return allAre(
                     d, [](const Box2 &b) { return b.centre().y; }, 5.0);
             }},
            {"shape.alignBottom", drawThree,
             [](D &d, const B &) {
                 return allAre(
                     d, [](const Box2 &b) { return b.min.y; }, 1.0);
             }},
            {"shape.distributeX", drawThree,
             [](D &d, const B &) {
                 return same(boxOf(d, 1).min.x - boxOf(d, 0).max.x, boxOf(d, 2).min.x - boxOf(d, 1).max.x);
             }},
            {"shape.distributeY", drawThree,
             [](D &d, const B &) {
                 return same(boxOf(d, 1).min.y - boxOf(d, 0).max.y, boxOf(d, 2).min.y - boxOf(d, 1).max.y);
             }},
            {"shape.arrange", drawThree, [](D &d, const B &) { return d.has("menu/shape.arrange/shape.alignLeft"); }},
            {"shape.mirrorX", drawTriangle,
             [](D &d, const B &) {
                 return firstNodeIs(d, {6, 2});
             }},
            {"shape.mirrorY", drawTriangle,
             [](D &d, const B &) {
                 return firstNodeIs(d, {2, 4});
             }},
            {"shape.turnLeft", drawTriangle,
             [](D &d, const B &) {
                 return firstNodeIs(d, {5, 1});
             }},
            {"shape.turnRight", drawTriangle, [](D &d, const B &) {
                 return firstNodeIs(d, {3, 5});
             }}};
}

std::vector<ActionCase> visibilityCases() {
    const auto hidden = [](D &d) {
        drawTriangle(d);
        d.key('H', {Modifiers::kControl});
        d.settle();
    };
    const auto locked = [](D &d) {
        drawTriangle(d);
        d.key('L', {Modifiers::kControl});
        d.settle();
    };
    return {{"shape.hide", drawTriangle, [](D &d, const B &) { return d.document().shapes[0]->hidden; }},
            {"shape.isolate",
             [](D &d) {
                 drawThree(d);
                 d.context().selection.shapes = {d.document().shapes[0]->id};
             },
             [](D &d, const B &) { return d.document().shapes[1]->hidden && !d.document().shapes[0]->hidden; }},
            {"shape.showAll", hidden, [](D &d, const B &) { return !d.document().shapes[0]->hidden; }},
            {"shape.group",
             [](D &d) {
                 drawThree(d);
                 d.key('A', {Modifiers::kControl});
             },
             [](D &d, const B &) { return d.document().shapes[0]->group != 0; }},
            {"shape.ungroup",
             [](D &d) {
                 drawThree(d);
                 d.key('A', {Modifiers::kControl});
                 d.key('G', {Modifiers::kControl});
             },
             [](D &d, const B &) { return d.document().shapes[0]->group == 0 && d.undoLabel() == "Ungroup"; }},
            {"shape.lock", drawTriangle, [](D &d, const B &) { return d.document().shapes[0]->locked; }},
            {"shape.unlockAll", locked, [](D &d, const B &) { return !d.document().shapes[0]->locked; }}};
}

std::vector<ActionCase> operationCases() {
    return {
        {"edit.combine", drawOverlap,
         [](D &d, const B &) {
             const bool previewed = d.context().dialogs.any() && shapesOf(d) == 1 && same(areaOf(d), 28);
             d.key(key::kEscape);
             d.settle();
             return previewed && shapesOf(d) == 2;
         }},
        {"edit.union", drawOverlap, [](D &d, const B &) { return shapesOf(d) == 1 && same(areaOf(d), 28); }},
        {"edit.difference", drawOverlap, [](D &d, const B &) { return shapesOf(d) == 1 && same(areaOf(d), 12); }},
        {"edit.intersection", drawOverlap, [](D &d, const B &) { return shapesOf(d) == 1 && same(areaOf(d), 4); }},
        {"edit.exclusion", drawOverlap, [](D &d, const B &) { return same(areaOf(d), 24); }},
        {"edit.divide", drawOverlap,
         [](D &d, const B &) { return d.document().shapes.back()->use == ShapeUse::Constraint; }},
        {"shape.transform", drawTriangle, [](D &d, const B &) { return dialogIs(d, "transform"); }},
        {"shape.linearArray", drawTriangle, [](D &d, const B &) { return dialogIs(d, "lineararray"); }},
        {"shape.polarArray", drawTriangle, [](D &d, const B &) { return dialogIs(d, "polararray"); }},
        {"shape.constrain",
         [](D &d) {
             drawTriangle(d);
             selectSegment(d, 0);
         },
         [](D &d, const B &) { return d.has("menu/shape.constrain/constraint.horizontal"); }},
        {"shape.dimension",
         [](D &d) {
             drawTriangle(d);
             selectSegment(d, 0);
         },
         [](D &d, const B &) { return d.has("menu/shape.dimension/constraint.length"); }},
        {"shape.construction", drawTriangle, [](D &d, const B &) { return d.document().shapes.back()->construction; }},
        {"shape.fillet", drawTriangle, [](D &d, const B &) { return dialogIs(d, "fillet"); }},
        {"shape.chamfer", drawTriangle, [](D &d, const B &) { return dialogIs(d, "chamfer"); }},
        {"shape.offset", drawTriangle, [](D &d, const B &) { return dialogIs(d, "offset"); }}};
}

} // namespace

std::vector<ActionCase> shapeActionCases() {
    std::vector<ActionCase> cases = pathCases();
    for (auto &&list : {arrangementCases(), visibilityCases(), operationCases()}) {
        cases.insert(cases.end(), list.begin(), list.end());
    }
    return cases;
}

} // namespace forefront::test
