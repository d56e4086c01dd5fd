#include "ui/panels/constraint_rows.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/sketch_state.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/icons.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <set>
#include <string>

namespace forefront {
namespace {

/// Returns the shapes of which anything is selected.
std::set<std::uint32_t> touchedShapes(const Selection &selection) {
    std::set<std::uint32_t> shapes = selection.shapes;
    for (const NodeRef node : selection.nodes) {
        shapes.insert(node.shape);
    }
    for (const SegmentRef segment : selection.segments) {
        shapes.insert(segment.shape);
    }
    return shapes;
}

bool names(const SketchConstraint &constraint, const std::set<std::uint32_t> &shapes) {
    return std::any_of(constraint.parts.begin(), constraint.parts.end(),
                       [&](const SketchPart &part) { return shapes.contains(part.shape); });
}

/// Draws one constraint. Returns false once it has changed the document.
bool drawConstraint(Shell &context, const SketchConstraint &constraint) {
    const std::string name = "inspector/constraint/" + std::to_string(constraint.id);
    form::label(context, constraint.name.c_str());
    constexpr float kButton = 24.0F, kGap = 6.0F;
    bool same = true;
    if (isDimension(constraint.kind)) {
        const float width = ImGui::GetContentRegionAvail().x / context.scale - kButton - kGap;
        double value = constraint.value;
        if (ui::inputNumber(context, name, value, width,
                            NumberAddress{NumberOwner::ofConstraint(constraint.id), Quantity::Value})) {
            context.applyCommand(setDimension(*context.document.current(), constraint.id, value),
                                 "Change " + constraint.name);
            same = false;
        }
    } else {
        ui::muted(context, kindName(constraint.kind));
    }
    ImGui::SameLine(ImGui::GetContentRegionMax().x - context.px(kButton));
    if (ui::iconButton(context, name + "/remove", icon::kTrash, "Remove " + constraint.name, false, true, kButton)) {
        context.applyCommand(removeConstraints(*context.document.current(), {constraint.id}),
                             "Remove " + constraint.name);
        same = false;
    }
    return same;
}

} // namespace

std::size_t ConstraintRows::degrees(const Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    const bool sameSketch = measured_ && measured_->constraints == document->constraints; // as during a drag
    if (measured_ != document && !(sameSketch && ImGui::IsAnyMouseDown())) {
        measured_ = document;
        degrees_ = sketchState(*document).degrees;
    }
    return degrees_;
}

void ConstraintRows::draw(Shell &context) {
    const std::shared_ptr<const Document> held = context.document.current(); // a field below may replace it
    const std::set<std::uint32_t> shapes = touchedShapes(context.selection);
    bool first = true;
    for (const std::shared_ptr<const SketchConstraint> &constraint : held->constraints) {
        if (!names(*constraint, shapes) && !context.selection.constraints.contains(constraint->id)) {
            continue;
        }
        if (first) {
            const std::size_t free = degrees(context);
            form::label(context, "Sketch");
            ui::muted(context, free == 0 ? "fully determined" : countText(free, "degree") + " of freedom");
            ui::mark(context, "inspector/sketch");
            first = false;
        }
        if (!drawConstraint(context, *constraint)) {
            return;
        }
    }
}

} // namespace forefront
