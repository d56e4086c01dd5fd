#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/picking/selected_faces.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/source_parts.hpp"
#include "ui/tools/select/select_tool.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace forefront {

std::optional<Control> SelectTool::controlAt(Vec2 place, Shell &context) const {
    std::optional<Control> best;
    double limit = EditState::reach(context, 8.0);
    const double apart = EditState::reach(context, 4.0); // nearer to its node, a click means the node
    for (const Control &control : controlsOf(*context.document.current(), context.selection)) {
        const double d = distance(control.at, place);
        if (d <= limit && distance(control.at, control.node) > apart && d <= distance(control.node, place)) {
            best = control;
            limit = d;
        }
    }
    return best;
}

std::optional<NodeHit> SelectTool::nodeAt(Vec2 place, const PickIndex::Filter &pickable, Shell &context) const {
    const PickIndex &index = *state_->index(context);
    const auto isShown = [&](const Shape &shape) {
        return pickable.shapes(shape) && (shape.is<PointForm>() || context.selection.touches(shape.id));
    };
    const auto shown = index.node(place, EditState::reach(context, 8.0), isShown);
    return shown ? shown : index.node(place, EditState::reach(context, 4.0), pickable);
}

std::optional<SelectTool::Hit> SelectTool::constraintAt(Vec2 place, Shell &context) const {
    constexpr std::string_view kPrefix = "sketch/";
    const Pixel pixel = context.view.camera.toPixel(place);
    const WidgetRegistry::Map &all = context.widgets.all();
    for (auto widget = all.lower_bound(kPrefix); widget != all.end() && widget->first.starts_with(kPrefix); ++widget) {
        const std::string_view name = widget->first;
        Hit hit;
        std::from_chars(name.data() + kPrefix.size(), name.data() + name.size(), hit.constraint);
        const PixelRect &rect = widget->second.rect;
        if (rect.contains(pixel) && findConstraint(*context.document.current(), hit.constraint) != nullptr) {
            hit.kind = Hit::Kind::Constraint;
            hit.at = context.view.camera.toPlane({rect.x + 0.5 * rect.width, rect.y + 0.5 * rect.height});
            return hit;
        }
    }
    return std::nullopt;
}

SelectTool::Hit SelectTool::hitAt(Vec2 place, Shell &context, bool waits) const {
    const PickIndex &index = *state_->index(context);
    const SelectionFilter &picks = state_->picks;
    const auto isFree = [&picks](const Shape &shape) { return !shape.locked && picks.shapes; };
    const auto hasNodes = [&](const Shape &shape) { return isFree(shape) && picks.nodes; };
    Hit hit;
    hit.at = place;
    if (const auto control = controlAt(place, context)) {
        hit.kind = Hit::Kind::Control;
        hit.control = control->ref;
        hit.shape = control->ref.shape;
        hit.at = control->at;
    } else if (const auto constraint = picks.constraints ? constraintAt(place, context) : std::nullopt;
               constraint && !index.node(place, EditState::reach(context, 4.0), hasNodes)) {
        return *constraint;
    } else if (const auto node = nodeAt(place, hasNodes, context)) {
        hit.kind = Hit::Kind::Node;
        hit.node = node->ref;
        hit.shape = node->ref.shape;
        hit.at = node->at;
    } else if (const auto source = index.source(place, EditState::reach(context, 8.0)); source && picks.sources) {
        hit.kind = Hit::Kind::Source;
        hit.source = *source;
        const SizeSource &what = index.document().spacing.sources[source->source];
        hit.at = placeOfPart(what, source->part, place, EditState::reach(context, 8.0));
    } else if (const auto marker = markerAt(place, context); marker && picks.markers) {
        hit.kind = Hit::Kind::Marker;
        hit.marker = *marker;
        hit.at = index.document().regionMarkers[*marker].at;
    } else if (const auto handle = transform_.at(place, context)) {
        hit.kind = Hit::Kind::Transform;
        hit.transform = *handle;
    } else if (const auto segment = index.segment(place, EditState::reach(context, 6.0), isFree)) {
        hit.kind = Hit::Kind::Segment;
        hit.segment = segment;
        hit.shape = segment->ref.shape;
        hit.at = segment->at;
    } else if (const auto guide = guideAt(context, place, EditState::reach(context, 4.0))) {
        hit.kind = Hit::Kind::Guide;
        hit.guide = *guide;
    } else {
        hitInside(hit, context, waits);
    }
    return hit;
}

std::optional<std::uint32_t> SelectTool::markerAt(Vec2 place, Shell &context) const {
    if (const auto marker = state_->index(context)->marker(place, EditState::reach(context, 9.0))) {
        return marker;
    }
    const std::optional<NamedThing> label = labelAt(context, context.view.camera.toPixel(place));
    const bool region = label && label->kind == NamedThing::Kind::Region &&
                        label->marker < context.document.current()->regionMarkers.size();
    return region ? std::optional(label->marker) : std::nullopt;
}

bool SelectTool::isSelected(const Hit &hit, const Selection &selection) const {
    switch (hit.kind) {
    case Hit::Kind::Control:
    case Hit::Kind::Transform:
        return true; // only those of the selection are shown
    case Hit::Kind::Node:
        return selection.nodes.contains(hit.node);
    case Hit::Kind::Source:
        return selection.sources.contains(hit.source.source);
    case Hit::Kind::Constraint:
        return selection.constraints.contains(hit.constraint);
    case Hit::Kind::Marker:
        return selection.markers.contains(hit.marker);
    case Hit::Kind::Segment:
        return selection.shapes.contains(hit.shape) || selection.segments.contains(hit.segment->ref);
    case Hit::Kind::Inside:
        return selection.shapes.contains(hit.shape);
    case Hit::Kind::Face:
        return isFaceSelected(*hit.faces, *start_, selection, hit.face);
    case Hit::Kind::Guide:
    case Hit::Kind::Nothing:
        break;
    }
    return false;
}

} // namespace forefront
