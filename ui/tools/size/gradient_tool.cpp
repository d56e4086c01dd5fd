#include "ui/tools/size/gradient_tool.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/parts/paint/paint.hpp"
#include "core/engine/spacing/parts/sources/graded_sources.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/source_parts.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns the closed shapes that are selected.
std::vector<const Shape *> selectedAreas(const Shell &context) {
    std::vector<const Shape *> areas;
    for (const auto &shape : context.document.current()->shapes) {
        if (context.selection.touches(shape->id) && isClosed(*shape)) {
            areas.push_back(shape.get());
        }
    }
    return areas;
}

/// Finds the points inside some closed shapes by the even-odd rule, row by row: a selected hole is left out.
class RowsInside {
  public:
    RowsInside(const std::vector<const Shape *> &areas, double circleTolerance) {
        for (const Shape *area : areas) {
            const Chords chords = chordsOf(*area, outlineOf(*area), circleTolerance);
            for (std::size_t k = 0; k < chords.size(); ++k) {
                edges_.emplace_back(chords.from(k), chords.to(k));
            }
        }
    }
    /// Quick for points of one row after the other.
    bool contains(Vec2 p) {
        if (!(p.y == row_)) {
            findCrossings(p.y);
        }
        const auto left = std::lower_bound(crossings_.begin(), crossings_.end(), p.x) - crossings_.begin();
        return left % 2 == 1;
    }

  private:
    void findCrossings(double y) {
        row_ = y;
        crossings_.clear();
        for (const auto &[a, b] : edges_) {
            if ((a.y > y) != (b.y > y)) {
                crossings_.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
            }
        }
        std::sort(crossings_.begin(), crossings_.end());
    }

    std::vector<std::pair<Vec2, Vec2>> edges_;
    std::vector<double> crossings_; ///< of the row
    double row_ = std::numeric_limits<double>::quiet_NaN();
};

} // namespace

const char *GradientTool::icon() const {
    return icon::kGradient;
}

SizeSource GradientTool::gradient(Vec2 a, Vec2 b, const Shell &context) const {
    const double rho = context.preview->spacing ? context.preview->spacing->at(a) : EditState::reach(context, 40.0);
    SizeSource gradient;
    gradient.shape = SourceShape::Line;
    gradient.a = a;
    gradient.b = b;
    const double size = state_->held(&EditState::gradientSize, context);
    const double endSize = state_->held(&EditState::gradientEndSize, context);
    gradient.size = size > 0.0 ? size : roundedTo(0.5 * rho, 2);
    gradient.endSize = endSize > 0.0 ? endSize : roundedTo(2.0 * rho, 2);
    gradient.plane = true;
    gradient.geometric = state_->gradientGeometric;
    return gradient;
}

void GradientTool::place(Vec2 at, Shell &context) {
    if (!first_) {
        first_ = at;
        return;
    }
    if (at == *first_) {
        return;
    }
    const SizeSource drawn = gradient(*first_, at, context);
    first_.reset();
    state_->propose(&EditState::gradientSize, drawn.size, context);
    state_->propose(&EditState::gradientEndSize, *drawn.endSize, context);
    if (state_->gradientInSelection) {
        paintSelection(context, drawn);
    } else {
        addSource(context, drawn);
    }
}

void GradientTool::addSource(Shell &context, SizeSource gradient) {
    gradient.name = freeSourceName(*context.document.current(), "gradient");
    if (context.applyCommand(forefront::addSource(*context.document.current(), std::move(gradient)), "Add gradient")) {
        const auto count = context.document.current()->spacing.sources.size();
        context.selection.clear();
        context.selection.sources.insert(static_cast<std::uint32_t>(count - 1));
    }
}

void GradientTool::paintSelection(Shell &context, const SizeSource &gradient) {
    const std::shared_ptr<const Document> document = context.document.current();
    const std::vector<const Shape *> areas = selectedAreas(context);
    Box2 box;
    for (const Shape *area : areas) {
        box.add(boundsOf(*area));
    }
    if (areas.empty()) {
        context.log.refuse("Nothing changed: select closed shapes first, or apply the gradient everywhere");
        return;
    }
    const std::optional<GradedSources> field =
        GradedSources::build(std::array{gradient}, std::numeric_limits<double>::infinity(), box);
    if (!field) {
        return;
    }
    PaintedSpacing painted = document->spacing.paint;
    if (painted.tiles.empty()) {
        painted = emptyPaint(boundsOf(*document));
        painted.replaces = true;
    } else if (context.preview->spacing) {
        painted = replacing(painted, [&](Vec2 at) { return context.preview->spacing->at(at); });
    }
    RowsInside inside(areas, document->circleTolerance);
    painted = fill(painted, box, [&](Vec2 at) { return inside.contains(at) ? field->at(at) : 0.0; });
    context.document.apply(setPaint(*document, std::move(painted)), "Paint gradient");
}

void GradientTool::drawSketch(CanvasPainter &painter, Shell &context) {
    const Theme &theme = context.theme;
    for (const Shape *area : state_->gradientInSelection ? selectedAreas(context) : std::vector<const Shape *>()) {
        painter.outline(outlineOf(*area), theme.selection, 2.0);
    }
    if (!over_) {
        return;
    }
    const SizeSource shown = gradient(first_.value_or(pointer_.at), pointer_.at, context);
    if (!first_) {
        drawMeasure(painter, context, "\xcf\x81=" + ui::number(shown.size, 3));
        return;
    }
    painter.arrow(*first_, pointer_.at, theme.brush, 2.0);
    painter.dot(*first_, 4.0, theme.brush);
    const Vec2 along = pointer_.at - *first_;
    if (const double size = length(along); size > 0.0) {
        const Vec2 across = painter.camera().length(60.0 * painter.scale()) / size * Vec2{-along.y, along.x};
        for (const Vec2 end : {*first_, pointer_.at}) {
            painter.dashed(end - across, end + across, fade(theme.brush, 0.6), 1.25);
        }
    }
    painter.label(*first_, {10.0, -18.0}, "\xcf\x81=" + ui::number(shown.size, 3), theme.text, fade(theme.popup, 0.9),
                  context.fonts.small);
    drawMeasure(painter, context, "\xcf\x81=" + ui::number(*shown.endSize, 3));
}

void GradientTool::drawOptions(Shell &context, ui::Flow &flow) {
    const Vec2 at = first_.value_or(over_ ? pointer_.at : context.view.camera.centre);
    const SizeSource shown = gradient(at, at, context);
    double size = shown.size, endSize = *shown.endSize;
    if (drawSizeOption(context, flow, "options/gradient/size", "From", size, "Element size at the first end",
                       context.document.current()->unit)) {
        state_->gradientSize = size;
    }
    if (drawSizeOption(context, flow, "options/gradient/endsize", "To", endSize, "Element size at the second end",
                       context.document.current()->unit)) {
        state_->gradientEndSize = endSize;
    }
    flow.item("geometric");
    ui::checkbox(context, "options/gradient/geometric", "Equal factors", state_->gradientGeometric);
    ui::tooltip(context, "The size grows by equal factors over equal distances; otherwise by equal amounts.");
    flow.item("selection");
    ui::checkbox(context, "options/gradient/selection", "Only in selection", state_->gradientInSelection);
    ui::tooltip(context,
                "Paint the gradient into the selected closed shapes. Otherwise it covers the whole plane, and its "
                "ends can be dragged later.");
    state_->drawSnapOptions(context, flow);
}

std::string GradientTool::statusText(const Shell &) const {
    return first_ ? "Click the other end, or type distance, Tab, angle, Enter"
                  : "Click or drag from the fine end to the coarse one, or the other way round; or type x, Tab, y, "
                    "Enter";
}

} // namespace forefront
