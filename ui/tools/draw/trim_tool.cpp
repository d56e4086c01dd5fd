#include "ui/tools/draw/trim_tool.hpp"

#include "core/drawing/commands/trim_commands.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"

namespace forefront {
namespace {

bool isEnd(const Shape &shape, std::uint32_t node) {
    return shape.isPolyline() && (node == 0 || node + 1 == shape.nodes.size());
}

} // namespace

const char *TrimTool::icon() const {
    return icon::kTrim;
}

void TrimTool::deactivate(Shell &) {
    change_.reset();
    crossed_ = {};
    extended_.reset();
}

const Result<Curve> &TrimTool::extensionOf(const std::shared_ptr<const PickIndex> &index, NodeRef end) {
    if (!extended_ || extended_->index != index || extended_->end != end) {
        extended_ = Extended{index, end, extensionAt(index->document(), end)};
    }
    return extended_->added;
}

const std::vector<double> &TrimTool::crossingsOf(const std::shared_ptr<const PickIndex> &index, std::uint32_t shape) {
    if (crossed_.index != index || crossed_.shape != shape) {
        Result<std::vector<double>> places = crossingsAlong(index->document(), shape);
        crossed_ = {index, shape, places ? *std::move(places) : std::vector<double>()};
    }
    return crossed_.places;
}

std::optional<TrimTool::Change> TrimTool::changeAt(Vec2 place, Shell &context) {
    const std::shared_ptr<const PickIndex> shared = state_->index(context);
    const PickIndex &index = *shared;
    const Document &document = index.document();
    const auto isFree = [](const Shape &shape) { return !shape.locked; };
    const auto node = index.node(place, EditState::reach(context, 8.0),
                                 [](const Shape &shape) { return !shape.locked && shape.isPolyline(); });
    std::string fault;
    if (node && isEnd(*findShape(document, node->ref.shape), node->ref.node)) {
        if (const Result<Curve> &added = extensionOf(shared, node->ref)) {
            return Change{node->ref.shape, node->ref, node->at, {*added}, {}};
        } else {
            fault = added.faults().front().message;
        }
    }
    const auto segment = index.segment(place, EditState::reach(context, 6.0), isFree);
    if (!segment) {
        return std::nullopt;
    }
    Change change{segment->ref.shape, {}, segment->at, {}, {}};
    if (Result<std::vector<Curve>> removed =
            partToTrim(document, change.shape, change.at, crossingsOf(shared, change.shape))) {
        change.curves = *std::move(removed);
    } else {
        change.fault = fault.empty() ? removed.faults().front().message : fault;
    }
    return change;
}

void TrimTool::apply(const Change &change, Shell &context) const {
    const Document &document = *context.document.current();
    if (change.curves.empty()) {
        context.log.refuse(change.fault);
        return;
    }
    context.selection.drop({change.shape}); // its nodes and segments get other numbers
    if (change.end) {
        context.applyCommand(extendEnd(document, *change.end), "Extend");
    } else {
        context.applyCommand(trimAt(document, change.shape, change.at), "Trim");
    }
}

bool TrimTool::handle(const CanvasEvent &event, Shell &context) {
    using Kind = CanvasEvent::Kind;
    switch (event.kind) {
    case Kind::Hover:
    case Kind::Drag:
    case Kind::Release:
        change_ = changeAt(event.place, context);
        return true;
    case Kind::Leave:
        change_.reset();
        return true;
    case Kind::Press:
        if (event.button == MouseButton::Right) {
            context.selection.clear(); // it is not drawn in this tool, so the menu must not act on it
            context.contextMenu = true;
        } else if (event.button == MouseButton::Left) {
            if (const std::optional<Change> change = changeAt(event.place, context)) {
                apply(*change, context);
            }
            change_.reset();
        }
        return true;
    case Kind::Key:
    case Kind::Text:
    case Kind::Wheel:
        break;
    }
    return false;
}

void TrimTool::drawOverlay(CanvasPainter &painter, Shell &context) {
    if (!change_) {
        return;
    }
    const Colour colour = change_->end ? context.theme.selection : context.theme.bad;
    for (const Curve &curve : change_->curves) {
        painter.curve(curve, colour, 4.0);
    }
    if (change_->curves.empty()) {
        painter.label(change_->at, {16.0, 14.0}, change_->fault, context.theme.bad, fade(context.theme.popup, 0.9),
                      context.fonts.small);
    } else if (change_->end) {
        painter.ring(change_->curves.back().point(1.0), 5.0, colour, 1.5);
    }
}

std::string TrimTool::statusText(const Shell &) const {
    return change_ && change_->end ? "Click to extend the path to the next line"
                                   : "Click the part of an outline between two crossings to remove it, or an open end "
                                     "to extend it";
}

} // namespace forefront
