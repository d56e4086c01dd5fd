#include "ui/dialogs/shape_actions.hpp"

#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/combine_shapes.hpp"
#include "core/drawing/commands/corner_commands.hpp"
#include "core/drawing/commands/junction_constraints.hpp"
#include "core/drawing/commands/offset_shapes.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/dialogs/clipboard_actions.hpp"
#include "ui/dialogs/combine_action.hpp"
#include "ui/dialogs/constraint_actions.hpp"
#include "ui/dialogs/group_actions.hpp"
#include "ui/dialogs/operation_dialog.hpp"
#include "ui/parts/shell.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/joined_command.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using Kind = OperationField::Kind;

/// Returns true unless faces alone are selected, of which only the markers would be mapped.
bool canTransform(const Shell &context) {
    return hasSelection(context) && !context.selection.onlyFaces();
}

bool canRepeat(const Shell &context) {
    return canCopy(context) && !context.selection.onlyFaces();
}

/// Returns a step at which copies do not overlap the selection.
Vec2 stepBeside(const Shell &context) {
    const Vec2 size = boundsOf(*context.document.current(), context.selection).size();
    if (size.x > 1e-9 * size.y) {
        return {roundedTo(1.25 * size.x, 2), 0.0};
    }
    return size.y > 0.0 ? Vec2{0.0, roundedTo(1.25 * size.y, 2)} : Vec2{2.0 * EditState::gridStep(context), 0.0};
}

Operation transformOperation() {
    Operation operation;
    operation.id = "transform";
    operation.title = "Transform";
    operation.fields = {{.id = "x", .label = "Move x", .isLength = true},
                        {.id = "y", .label = "Move y", .isLength = true},
                        {.id = "angle", .label = "Rotate", .tooltip = "Angle in degrees, counter-clockwise"},
                        {.id = "scalex", .label = "Scale x (%)", .value = 100.0},
                        {.id = "scaley", .label = "Scale y (%)", .value = 100.0},
                        {.id = "about",
                         .label = "About",
                         .tooltip = "The point that stays when rotating and scaling",
                         .kind = Kind::Choice,
                         .choices = {"Centre", "Origin"}},
                        {.id = "copy", .label = "Keep the original", .kind = Kind::Flag}};
    operation.run = [](const Document &document, const Selection &selection, const std::vector<double> &values,
                       Selection *made) {
        const Vec2 about = values[5] == 0.0 ? boundsOf(document, selection).centre() : Vec2{};
        const PlaneMap scale = PlaneMap::scaling({0.01 * values[3], 0.01 * values[4]}, about);
        const PlaneMap turned = PlaneMap::rotation(values[2], about).after(scale);
        const PlaneMap map = PlaneMap::translation({values[0], values[1]}).after(turned);
        if (values[6] != 0.0) {
            return copySelection(document, selection, std::vector{map}, made);
        }
        Result<Document> next = transformSelection(document, selection, map);
        return next ? carryJoints(document, *next) : next;
    };
    return operation;
}

Operation linearArrayOperation(const Shell &context) {
    const Vec2 step = stepBeside(context);
    Operation operation;
    operation.id = "lineararray";
    operation.title = "Linear array";
    operation.fields = {{.id = "count", .label = "Number", .value = 3.0, .tooltip = "Including the original"},
                        {.id = "x",
                         .label = "Step x",
                         .value = step.x,
                         .tooltip = "Distance from one copy to the next along x",
                         .isLength = true},
                        {.id = "y",
                         .label = "Step y",
                         .value = step.y,
                         .tooltip = "Distance from one copy to the next along y",
                         .isLength = true}};
    operation.run = [](const Document &document, const Selection &selection, const std::vector<double> &values,
                       Selection *made) {
        return linearArray(document, selection, values[0], {values[1], values[2]}, made);
    };
    return operation;
}

Operation polarArrayOperation(const Shell &context) {
    const Document &current = *context.document.current();
    const Box2 drawing = boundsOf(current), own = boundsOf(current, context.selection);
    Vec2 centre = drawing.empty() ? own.centre() : drawing.centre();
    if (distance(centre, own.centre()) <= 1e-9 * own.diagonal()) { // copies would coincide with the selection
        centre = centre - stepBeside(context);
    }
    Operation operation;
    operation.id = "polararray";
    operation.title = "Polar array";
    operation.fields = {{.id = "count", .label = "Number", .value = 6.0, .tooltip = "Including the original"},
                        {.id = "x",
                         .label = "Centre x",
                         .value = centre.x,
                         .tooltip = "Default: the centre of the drawing, or a point beside the selection",
                         .isLength = true},
                        {.id = "y", .label = "Centre y", .value = centre.y, .isLength = true},
                        {.id = "angle",
                         .label = "Angle",
                         .value = 360.0,
                         .tooltip = "From the original to the last copy, in degrees; 360 fills the circle"},
                        {.id = "turn", .label = "Rotate the copies", .value = 1.0, .kind = Kind::Flag}};
    operation.run = [](const Document &document, const Selection &selection, const std::vector<double> &values,
                       Selection *made) {
        return polarArray(document, selection, values[0], {values[1], values[2]}, values[3], values[4] != 0.0, made);
    };
    return operation;
}

/// Returns an operation with one length, proposed as a part of the size of the selection; of the drawing, if a single
/// node is selected.
Operation lengthOperation(const Shell &context, const char *id, const char *title, const char *label,
                          const char *tooltip) {
    const double selected = boundsOf(*context.document.current(), context.selection).diagonal();
    const double size = selected > 0.0 ? selected : boundsOf(*context.document.current()).diagonal();
    Operation operation;
    operation.id = id;
    operation.title = title;
    operation.fields = {
        {.id = "size", .label = label, .value = roundedTo(0.05 * size, 2), .tooltip = tooltip, .isLength = true}};
    return operation;
}

/// Lets the corners of the rectangles among the rounded shapes follow an expression. Returns true if there are no
/// others.
bool followCornerRadius(Document &document, const Selection &selection, const std::vector<std::string> &formulas) {
    std::set<std::uint32_t> rounded = selection.shapes;
    for (const NodeRef node : selection.nodes) {
        rounded.insert(node.shape);
    }
    bool all = true;
    for (const std::uint32_t id : rounded) {
        const bool rectangle = findShape(document, id)->is<RectangleForm>();
        all = all && rectangle;
        if (rectangle) {
            document = setFormula(std::move(document), {NumberOwner::ofShape(id), Quantity::Radius}, formulas.front());
        }
    }
    return all;
}

/// Selected nodes stand for single corners; their shapes need not be selected.
Operation filletOperation(const Shell &context) {
    Operation operation = lengthOperation(context, "fillet", "Fillet", "Radius",
                                          "Rounds the selected nodes, or all corners of the selected shapes");
    operation.run = [](const Document &document, const Selection &selection, const std::vector<double> &values,
                       Selection *made) {
        made->shapes = selection.shapes;
        return filletCorners(document, selection, values[0]);
    };
    operation.follow = followCornerRadius;
    operation.constrain = constrainJunctions;
    return operation;
}

Operation chamferOperation(const Shell &context) {
    Operation operation = lengthOperation(
        context, "chamfer", "Chamfer", "Distance",
        "Cuts the selected nodes, or all corners of the selected shapes, at this distance on both sides");
    operation.run = [](const Document &document, const Selection &selection, const std::vector<double> &values,
                       Selection *made) {
        made->shapes = selection.shapes;
        return chamferCorners(document, selection, values[0]);
    };
    return operation;
}

Operation offsetOperation(const Shell &context) {
    Operation operation = lengthOperation(context, "offset", "Offset", "Distance",
                                          "Above 0: outside; below 0: inside. Around an open path: a band");
    operation.run = [](const Document &document, const Selection &selection, const std::vector<double> &values,
                       Selection *made) { return offsetShapes(document, selection.shapes, values[0], made); };
    return operation;
}

/// Adds an action that opens a dialog for an operation.
void addOperation(ActionRegistry &actions, const char *id, const char *title, Shortcut shortcut,
                  Operation (*operation)(const Shell &), bool (*enabled)(const Shell &), bool separator = false) {
    actions.add({.id = id,
                 .menu = "Shape",
                 .title = title,
                 .shortcuts = {shortcut},
                 .run = [operation](Shell &c) { c.dialogs.open(std::make_unique<OperationDialog>(operation(c), c)); },
                 .enabled = enabled,
                 .separatorBefore = separator});
}

/// Adds an action that maps the selection about the centre of its box.
void addMap(ActionRegistry &actions, const char *id, const char *title, Shortcut shortcut, PlaneMap (*map)(Vec2)) {
    actions.add({.id = id,
                 .menu = "Shape",
                 .title = title,
                 .shortcuts = {shortcut},
                 .run =
                     [title, map](Shell &c) {
                         const Document &document = *c.document.current();
                         const Vec2 centre = boundsOf(document, c.selection).centre();
                         applyJoined(c, transformSelection(document, c.selection, map(centre)), title);
                     },
                 .enabled = canTransform});
}

void addTransforms(ActionRegistry &actions) {
    addOperation(
        actions, "shape.transform", "Transform\xe2\x80\xa6", {'M', kControlShift},
        [](const Shell &) { return transformOperation(); }, canTransform);
    addMap(actions, "shape.mirrorX", "Mirror left-right", {'H', kShift},
           [](Vec2 centre) { return PlaneMap::reflection(90.0, centre); });
    addMap(actions, "shape.mirrorY", "Mirror top-bottom", {'V', kShift},
           [](Vec2 centre) { return PlaneMap::reflection(0.0, centre); });
    addMap(actions, "shape.turnLeft", "Rotate 90\xc2\xb0 left", {key::kLeftBracket, kControl},
           [](Vec2 centre) { return PlaneMap::rotation(90.0, centre); });
    addMap(actions, "shape.turnRight", "Rotate 90\xc2\xb0 right", {key::kRightBracket, kControl},
           [](Vec2 centre) { return PlaneMap::rotation(-90.0, centre); });
    addOperation(actions, "shape.linearArray", "Linear array\xe2\x80\xa6", {'L', kControlShift}, linearArrayOperation,
                 canRepeat, true);
    addOperation(actions, "shape.polarArray", "Polar array\xe2\x80\xa6", {'P', kControlShift}, polarArrayOperation,
                 canRepeat);
}

void addCorners(ActionRegistry &actions) {
    const auto corners = [](const Shell &c) { return hasCorners(*c.document.current(), c.selection); };
    addOperation(actions, "shape.fillet", "Fillet\xe2\x80\xa6", {'F', kControlShift}, filletOperation, corners, true);
    addOperation(actions, "shape.chamfer", "Chamfer\xe2\x80\xa6", {'K', kControlShift}, chamferOperation, corners);
    addOperation(actions, "shape.offset", "Offset\xe2\x80\xa6", {'O', kControlShift}, offsetOperation,
                 [](const Shell &c) { return !c.selection.shapes.empty(); });
}

/// A way to line up the selection.
struct ArrangeAction {
    const char *id, *title;
    Result<Document> (*run)(const Document &, const Selection &);
    std::size_t items; ///< needed at least
};

template <Alignment alignment>
Result<Document> align(const Document &document, const Selection &selection) {
    return alignSelection(document, selection, alignment);
}

template <bool alongX>
Result<Document> distribute(const Document &document, const Selection &selection) {
    return distributeSelection(document, selection, alongX);
}

constexpr ArrangeAction kArrangements[] = {
    {"shape.alignLeft", "Align left", align<Alignment::Left>, 2},
    {"shape.alignCentreX", "Align centres horizontally", align<Alignment::CentreX>, 2},
    {"shape.alignRight", "Align right", align<Alignment::Right>, 2},
    {"shape.alignTop", "Align top", align<Alignment::Top>, 2},
    {"shape.alignCentreY", "Align centres vertically", align<Alignment::CentreY>, 2},
    {"shape.alignBottom", "Align bottom", align<Alignment::Bottom>, 2},
    {"shape.distributeX", "Equal gaps horizontally", distribute<true>, 3},
    {"shape.distributeY", "Equal gaps vertically", distribute<false>, 3}};

/// Adds the commands that line up shapes: to the palette, and as a submenu.
void addArrangements(ActionRegistry &actions) {
    for (const ArrangeAction &arrangement : kArrangements) {
        actions.add(
            {.id = arrangement.id,
             .menu = "",
             .title = arrangement.title,
             .run =
                 [&arrangement](Shell &c) {
                     applyJoined(c, arrangement.run(*c.document.current(), c.selection), arrangement.title);
                 },
             .enabled = [&arrangement](const Shell &c) { return alignableItems(c.selection) >= arrangement.items; }});
    }
    actions.add({.id = "shape.arrange",
                 .menu = "Shape",
                 .title = "Align and distribute",
                 .run = {},
                 .enabled = [](const Shell &c) { return alignableItems(c.selection) >= 2; },
                 .entries =
                     [](const Shell &c) {
                         std::vector<MenuEntry> entries;
                         for (const ArrangeAction &arrangement : kArrangements) {
                             if (alignableItems(c.selection) >= arrangement.items) {
                                 entries.push_back(
                                     {.id = arrangement.id,
                                      .title = arrangement.title,
                                      .run = [&arrangement](Shell &s) { s.actions.run(arrangement.id, s); }});
                             }
                         }
                         return entries;
                     }});
}

/// Adds the commands that combine the areas of the selected shapes.
void addShapeOperations(ActionRegistry &actions) {
    const struct {
        ShapeOperation operation;
        const char *id, *title;
        int key;
    } operations[] = {{ShapeOperation::Union, "edit.union", "Union", 'U'},
                      {ShapeOperation::Difference, "edit.difference", "Difference", 'D'},
                      {ShapeOperation::Intersection, "edit.intersection", "Intersection", 'I'},
                      {ShapeOperation::Exclusion, "edit.exclusion", "Exclusion", 'X'},
                      {ShapeOperation::Divide, "edit.divide", "Divide", 'V'}};
    for (const auto &entry : operations) {
        actions.add({.id = entry.id,
                     .menu = "Shape",
                     .title = entry.title,
                     .shortcuts = {{entry.key, kControlShift}},
                     .run =
                         [operation = entry.operation, title = entry.title](Shell &c) {
                             Selection made;
                             const Document &before = *c.document.current();
                             if (c.applyCommand(combineShapes(before, c.selection.shapes, operation, &made), title)) {
                                 c.selection = std::move(made);
                             }
                         },
                     .enabled = [](const Shell &c) { return canCombine(*c.document.current(), c.selection); },
                     .separatorBefore = entry.operation == ShapeOperation::Union});
    }
    addCombineAction(actions);
}

/// Returns the ids of all shapes that satisfy `wanted`.
template <class Wanted>
std::set<std::uint32_t> shapesWith(const Shell &context, Wanted wanted) {
    std::set<std::uint32_t> ids;
    for (const auto &shape : context.document.current()->shapes) {
        if (wanted(*shape)) {
            ids.insert(shape->id);
        }
    }
    return ids;
}

std::set<std::uint32_t> hiddenShapes(const Shell &context) {
    return shapesWith(context, [](const Shape &shape) { return shape.hidden; });
}

std::set<std::uint32_t> lockedShapes(const Shell &context) {
    return shapesWith(context, [](const Shape &shape) { return shape.locked; });
}

std::set<std::uint32_t> otherShapes(const Shell &context) {
    return shapesWith(
        context, [&](const Shape &shape) { return !shape.hidden && !context.selection.shapes.contains(shape.id); });
}

/// Adds an action that hides, shows, locks or unlocks shapes.
void addVisibility(ActionRegistry &actions, const char *id, const char *title, Shortcut shortcut,
                   std::set<std::uint32_t> (*shapes)(const Shell &),
                   Result<Document> (*change)(const Document &, const std::set<std::uint32_t> &, bool), bool on,
                   bool separator = false) {
    actions.add({.id = id,
                 .menu = "Shape",
                 .title = title,
                 .shortcuts = {shortcut},
                 .run =
                     [=](Shell &c) {
                         const std::set<std::uint32_t> ids = shapes(c);
                         if (c.applyCommand(change(*c.document.current(), ids, on), title) && on) {
                             c.selection.drop(ids);
                         }
                     },
                 .enabled = [=](const Shell &c) { return !shapes(c).empty(); },
                 .separatorBefore = separator});
}

void addVisibilities(ActionRegistry &actions) {
    const auto selected = [](const Shell &c) { return c.selection.shapes; };
    addVisibility(actions, "shape.hide", "Hide", {'H', kControl}, selected, setHidden, true, true);
    addVisibility(
        actions, "shape.isolate", "Isolate", {'I', Modifiers{Modifiers::kAlt}},
        [](const Shell &c) { return c.selection.shapes.empty() ? std::set<std::uint32_t>() : otherShapes(c); },
        setHidden, true);
    addVisibility(actions, "shape.showAll", "Show all shapes", {'H', kControlShift}, hiddenShapes, setHidden, false);
    addVisibility(actions, "shape.lock", "Lock", {'L', kControl}, selected, setLocked, true);
    addVisibility(actions, "shape.unlockAll", "Unlock all", {'L', Modifiers{Modifiers::kAlt}}, lockedShapes, setLocked,
                  false);
}

} // namespace

bool hasSelection(const Shell &context) {
    return !context.selection.empty();
}

void addShapeActions(ActionRegistry &actions) {
    addTransforms(actions);
    addArrangements(actions);
    addCorners(actions);
    addShapeOperations(actions);
    addConstraintActions(actions);
    addGroupActions(actions);
    addVisibilities(actions);
}

} // namespace forefront
