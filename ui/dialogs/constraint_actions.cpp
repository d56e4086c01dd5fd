#include "ui/dialogs/constraint_actions.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_figures.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/parts/shell.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns the selected parts of the sketch: nodes, segments, and shapes of one segment or one node. Empty if anything
/// else is selected.
std::vector<SketchPart> selectedParts(const Document &document, const Selection &selection) {
    if (!selection.sources.empty() || !selection.markers.empty()) {
        return {};
    }
    std::vector<SketchPart> parts;
    for (const NodeRef node : selection.nodes) {
        parts.push_back({node.shape, SketchPartKind::Node, node.node});
    }
    for (const SegmentRef segment : selection.segments) {
        parts.push_back({segment.shape, SketchPartKind::Segment, segment.segment});
    }
    for (const std::uint32_t id : selection.shapes) {
        const Shape *const shape = findShape(document, id);
        const bool point = shape != nullptr && shape->is<PointForm>();
        if (shape == nullptr || (!point && taggedSegments(*shape) != 1)) {
            return {};
        }
        parts.push_back({id, point ? SketchPartKind::Node : SketchPartKind::Segment, 0});
    }
    return parts;
}

std::string actionId(ConstraintKind kind) {
    return "constraint." + std::string(wordOf(kind));
}

bool canConstrain(const Shell &context, ConstraintKind kind) {
    const Document &document = *context.document.current();
    constexpr std::size_t kMostParts = 4; // of any kind, as a tangent at ends
    std::vector<SketchPart> parts = selectedParts(document, context.selection);
    return !parts.empty() && parts.size() <= kMostParts && makeConstraint(document, kind, std::move(parts)).ok();
}

/// Opens the field for the value of a dimension that was just added, beside what it measures.
void openField(Shell &context, const SketchConstraint &dimension, std::string stroke) {
    const Document &document = *context.document.current();
    const std::optional<DimensionFigure> figure = dimensionFigure(document, dimension);
    if (!figure) {
        return;
    }
    const Vec2 at = figure->form == DimensionFigure::Form::Linear ? 0.5 * (figure->from + figure->to) : figure->to;
    const double gap = static_cast<double>(context.px(12.0)); // what is measured stays in sight
    context.dimensionEntry.open(document, context.document.revision(), dimension.id,
                                context.view.camera.toPixel(at) + Pixel{gap, gap});
    context.dimensionEntry.stroke = std::move(stroke);
    context.animate();
}

void constrain(Shell &context, ConstraintKind kind) {
    const std::shared_ptr<const Document> document = context.document.current();
    Result<Document> next = addConstraint(*document, kind, selectedParts(*document, context.selection));
    const std::string name = next ? next->constraints.back()->name : kindName(kind);
    const std::string stroke = isDimension(kind) ? "dimension " + name : std::string();
    if (context.applyCommand(std::move(next), "Add " + name, stroke) && isDimension(kind)) {
        openField(context, *context.document.current()->constraints.back(), stroke);
    }
}

/// Adds a submenu of the kinds that fit the selection.
void addSubmenu(ActionRegistry &actions, const char *id, const char *title, bool dimensions) {
    const auto entries = [dimensions](const Shell &c) {
        std::vector<MenuEntry> list;
        for (const ConstraintKind kind : valuesOf<ConstraintKind>()) {
            if (isDimension(kind) == dimensions && canConstrain(c, kind)) {
                list.push_back({.id = actionId(kind), .title = kindName(kind), .run = [kind](Shell &s) {
                                    s.actions.run(actionId(kind), s);
                                }});
            }
        }
        return list;
    };
    actions.add({.id = id,
                 .menu = "Shape",
                 .title = title,
                 .run = {},
                 .enabled = [entries](const Shell &c) { return !entries(c).empty(); },
                 .entries = entries,
                 .separatorBefore = !dimensions});
}

/// Returns true if all selected shapes are construction geometry.
bool isConstruction(const Shell &context) {
    const Document &document = *context.document.current();
    return !context.selection.shapes.empty() &&
           std::all_of(context.selection.shapes.begin(), context.selection.shapes.end(), [&](std::uint32_t id) {
               const Shape *const shape = findShape(document, id);
               return shape != nullptr && shape->construction;
           });
}

} // namespace

void addConstraintActions(ActionRegistry &actions) {
    for (const ConstraintKind kind : valuesOf<ConstraintKind>()) {
        actions.add({.id = actionId(kind),
                     .menu = "",
                     .title = (isDimension(kind) ? "Dimension: " : "Sketch constraint: ") + kindName(kind),
                     .run = [kind](Shell &c) { constrain(c, kind); },
                     .enabled = [kind](const Shell &c) { return canConstrain(c, kind); }});
    }
    addSubmenu(actions, "shape.constrain", "Sketch constraint", false);
    addSubmenu(actions, "shape.dimension", "Dimension", true);
    actions.add({.id = "shape.construction",
                 .menu = "Shape",
                 .title = "Construction geometry",
                 .run =
                     [](Shell &c) {
                         c.applyCommand(setConstruction(*c.document.current(), c.selection.shapes, !isConstruction(c)),
                                        "Change construction");
                     },
                 .enabled = [](const Shell &c) { return !c.selection.shapes.empty(); },
                 .checked = isConstruction});
}

} // namespace forefront
