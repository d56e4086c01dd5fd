#include "ui/dialogs/combine_action.hpp"

#include "core/drawing/commands/combine_shapes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "ui/dialogs/operation_dialog.hpp"
#include "ui/parts/shell.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <string_view>
#include <vector>

namespace forefront {
namespace {

constexpr std::array kCombinations{ShapeOperation::Union, ShapeOperation::Difference, ShapeOperation::Intersection,
                                   ShapeOperation::Exclusion, ShapeOperation::Divide};

/// Returns true if the outline of a closed boundary passes a place.
bool passes(const Document &document, const Shape &shape, Vec2 place, double reach) {
    if (shape.use != ShapeUse::Boundary || !isClosed(shape)) {
        return false;
    }
    const Chords chords = chordsOf(shape, outlineOf(shape), document.circleTolerance);
    for (std::size_t k = 0; k < chords.size(); ++k) {
        if (distanceToSegment(chords.from(k), chords.to(k), place) <= reach) {
            return true;
        }
    }
    return false;
}

/// Returns the closed boundaries that meet where the first fault of that kind is; fewer than two: there is none.
std::set<std::uint32_t> overlappingShapes(const Shell &context) {
    const Document &document = *context.document.current();
    const Diagnostics &faults = context.preview->faults;
    const auto fault = std::find_if(faults.begin(), faults.end(), [](const Diagnostic &each) {
        return each.at && (each.code == "crossing-segments" || each.code == "overlapping-segments");
    });
    std::set<std::uint32_t> shapes;
    if (fault == faults.end() || context.preview->revision != context.document.revision()) {
        return shapes;
    }
    constexpr double kRounding = 1e-9; // of the place of the fault, relative to the drawing
    const double reach = kRounding * boundsOf(document).diagonal();
    for (const auto &shape : document.shapes) {
        if (passes(document, *shape, *fault->at, reach)) {
            shapes.insert(shape->id);
        }
    }
    return shapes;
}

Operation combineOperation() {
    Operation operation;
    operation.id = "combine";
    operation.title = "Combine shapes";
    operation.fields = {{.id = "operation",
                         .label = "",
                         .kind = OperationField::Kind::Choice,
                         .choices = {"Union", "Difference", "Intersection", "Exclusion", "Divide"}}};
    operation.run = [](const Document &document, const Selection &selection, const std::vector<double> &values,
                       Selection *made) {
        return combineShapes(document, selection.shapes, kCombinations[static_cast<std::size_t>(values[0])], made);
    };
    return operation;
}

} // namespace

void addCombineAction(ActionRegistry &actions) {
    actions.add({.id = "edit.combine",
                 .menu = "Shape",
                 .title = "Combine overlapping shapes\xe2\x80\xa6",
                 .run =
                     [](Shell &c) {
                         c.selection.clear();
                         c.selection.shapes = overlappingShapes(c);
                         c.dialogs.open(std::make_unique<OperationDialog>(combineOperation(), c));
                     },
                 .enabled = [](const Shell &c) { return overlappingShapes(c).size() > 1; }});
}

} // namespace forefront
