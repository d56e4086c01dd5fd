#include "ui/workspace/edit_state.hpp"

#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

namespace forefront {

void SelectionFilter::apply(Selection &selection) const {
    if (!shapes) {
        selection.shapes.clear();
        selection.segments.clear();
    }
    if (!shapes || !nodes) {
        selection.nodes.clear();
    }
    if (!sources) {
        selection.sources.clear();
    }
    if (!markers) {
        selection.markers.clear();
        selection.faces.clear();
    }
    if (!constraints) {
        selection.constraints.clear();
    }
}

const std::shared_ptr<const PickIndex> &EditState::index(const Workspace &context) {
    const std::uint64_t revision = context.document.revision();
    if (!index_ || revision_ != revision) {
        index_ = std::make_shared<const PickIndex>(context.document.current());
        revision_ = revision;
    }
    return index_;
}

namespace {

constexpr std::int32_t kBoundary = 1, kConstraint = 2; // tags of shapes drawn where nobody has chosen one

/// Returns true if a part of a boundary, such as a hole, has the tag.
bool isOfBoundary(const Document &document, std::int32_t tag) {
    return std::any_of(document.shapes.begin(), document.shapes.end(), [tag](const auto &shape) {
        const auto &tags = shape->segmentTags;
        return shape->use == ShapeUse::Boundary &&
               (tags.empty() ? shape->tag == tag : std::find(tags.begin(), tags.end(), tag) != tags.end());
    });
}

} // namespace

std::int32_t EditState::tagOfNext(ShapeUse use, const Document &document) const {
    const bool boundary = use == ShapeUse::Boundary;
    const std::optional<std::int32_t> &chosen = boundary ? boundaryTag : constraintTag;
    const std::int32_t usual = boundary ? kBoundary : kConstraint;
    const bool special = (!boundary && isOfBoundary(document, usual)) || document.boundaryNames.contains(usual) ||
                         document.elementCounts.contains(usual) || document.spacing.partSizes.contains(usual);
    return chosen.value_or(special ? std::max(freeBoundaryTag(document), kConstraint + 1) : usual);
}

std::int32_t EditState::tagOfDrawn(const Shape &shape, const Document &document) const {
    const Box2 box = boundsOf(shape);
    const bool inside = shape.use == ShapeUse::Boundary && isClosed(shape) &&
                        std::any_of(document.shapes.begin(), document.shapes.end(), [&](const auto &other) {
                            const Box2 around = boundsOf(*other);
                            return other->use == ShapeUse::Boundary && around.contains(box.min) &&
                                   around.contains(box.max) && contains(*other, box.centre());
                        });
    return inside && !boundaryTag ? freeBoundaryTag(document) : tagOfNext(shape.use, document);
}

void EditState::forgetNumbers() {
    const EditState initial;
    boundaryTag = initial.boundaryTag;
    constraintTag = initial.constraintTag;
    freehandTolerance = initial.freehandTolerance;
    brushRadius = initial.brushRadius;
    brushSpacing = initial.brushSpacing;
    sourceSize = initial.sourceSize;
    sourceEndSize = initial.sourceEndSize;
    sourceGrowth = initial.sourceGrowth;
    sourceSizeFormula.clear();
    sourceGrowthFormula.clear();
    gradientSize = initial.gradientSize;
    gradientEndSize = initial.gradientEndSize;
}

double EditState::extent(const Workspace &context) const {
    const std::uint64_t revision = context.document.revision();
    if (extentRevision_ != revision) {
        extentRevision_ = revision;
        extent_ = boundsOf(*context.document.current()).diagonal();
    }
    return extent_;
}

void EditState::propose(double EditState::*number, double value, const Workspace &context) {
    if (held(number, context) == value) {
        return; // it is set, perhaps by the user
    }
    this->*number = value;
    std::erase_if(proposals_, [number](const Proposal &proposal) { return proposal.number == number; });
    proposals_.push_back({number, value, extent(context)});
}

double EditState::held(double EditState::*number, const Workspace &context) const {
    const double value = this->*number;
    const auto found = std::find_if(proposals_.begin(), proposals_.end(), [&](const Proposal &proposal) {
        return proposal.number == number && proposal.value == value; // else another one was entered
    });
    if (found == proposals_.end()) {
        return value;
    }
    const double now = extent(context);
    return now > 2.0 * found->extent || now < 0.5 * found->extent ? 0.0 : value;
}

std::string EditState::newStroke() {
    return "stroke " + std::to_string(++strokes_);
}

double EditState::reach(const Workspace &context, double designPixels) {
    return context.view.camera.length(static_cast<double>(context.px(designPixels)));
}

SnapQuery EditState::query(const Workspace &context, Vec2 place, bool angle, bool off) const {
    SnapQuery query;
    query.at = place;
    query.tolerance = reach(context, context.snapping.reach);
    query.gridPitch = context.snapping.toGrid ? gridStep(context) : 0.0;
    query.guides = context.snapping.toGuides;
    query.angle = angle;
    query.angleStep = context.snapping.angleStep;
    query.off = off;
    if (!context.snapping.toDrawing) {
        query.filter = [](const Shape &) { return false; };
    }
    return query;
}

double EditState::gridStep(const Workspace &context) {
    return steppedPitch(context.snapping.gridStep, reach(context, 1.0));
}

void EditState::drawSnapOptions(Workspace &context, ui::Flow &flow) {
    flow.item("snap");
    ui::checkbox(context, "options/snap/drawing", "Snap to drawing", context.snapping.toDrawing);
    ui::tooltip(context, "Snap to nodes, midpoints, centres, crossings, perpendiculars, tangents and segments. Hold "
                         "Ctrl to turn snapping off, Shift for directions in steps.");
    flow.item("snap/grid");
    ui::checkbox(context, "options/snap/grid", "Snap to grid", context.snapping.toGrid);
    ui::tooltip(
        context,
        "Place points on the drawing grid unless a target of the drawing, a guide or a relation is nearer. Hold "
        "Ctrl to turn snapping off. The layer Grid shows the grid or hides it.");
    drawGridStep(context);
}

/// Draws the field for the step of the grid beside its switch.
void EditState::drawGridStep(Workspace &context) {
    ImGui::SameLine(0, context.px(8));
    ImGui::BeginDisabled(!context.snapping.toGrid);
    std::optional<double> step =
        context.snapping.gridStep > 0.0 ? std::optional(context.snapping.gridStep) : std::nullopt;
    if (ui::inputOptional(context, "options/snap/step", step, "auto", 56.0F, {}, context.document.current()->unit) &&
        (!step || ui::checkPositive(context, "options/snap/step", *step))) {
        context.snapping.gridStep = step.value_or(0.0);
        context.animate();
    }
    ImGui::EndDisabled();
    ui::tooltip(context, "Grid step: the distance of the lines of the grid. Leave empty for one that follows the zoom: "
                         "now " +
                             ui::number(gridStep(context)));
}

} // namespace forefront
