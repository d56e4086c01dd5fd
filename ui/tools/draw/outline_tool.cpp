#include "ui/tools/draw/outline_tool.hpp"

#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/engine/base/out_of_memory.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <utility>

namespace forefront {

namespace {

/// Returns the map from pixels of a picture, from its lower left corner, to the plane.
PlaneMap planeOfPixels(const BackgroundPicture &placed, const Picture &pixels) {
    return {(1.0 / pixels.columns) * lowerEdge(placed), (1.0 / pixels.rows) * leftEdge(placed), placed.corner};
}

} // namespace

const char *OutlineTool::icon() const {
    return icon::kOutline;
}

OutlineTool::Traced OutlineTool::answer(const LatestTurn<Request, Traced> &turn) {
    try {
        return trace(turn);
    } catch (const std::bad_alloc &) {
        Traced failed;
        failed.of = turn.request;
        failed.faults = outOfMemory("to find this outline", "use a smaller picture");
        return failed;
    }
}

OutlineTool::Traced OutlineTool::trace(const LatestTurn<Request, Traced> &turn) {
    const Request &request = turn.request;
    Traced traced = turn.earlier;
    const bool same = traced.outlines && traced.of.sameRegion(request);
    Progress progress;
    progress.stop = turn.stop;
    progress.report = [&turn, shown = std::string()](std::string_view stage, double) mutable {
        if (stage != shown) {
            shown = stage;
            Traced now = turn.earlier;
            now.stage = stage;
            turn.publish(std::move(now));
        }
    };
    if (!same) {
        const Picture &picture = *request.picture;
        const ColourRegion region =
            floodByColour({picture.rgba, picture.columns, picture.rows}, request.seed, request.tolerance, progress);
        traced.outlines = std::make_shared<const std::vector<PixelLoop>>(outlinesOf(region, progress));
    }
    traced.of = request;
    traced.faults.clear();
    traced.fit = std::make_shared<const OutlineFit>(fitOutlines(*traced.outlines, request.smoothness, progress));
    traced.stage.clear();
    return progress.cancelled() ? turn.earlier : traced;
}

void OutlineTool::activate(Shell &context) {
    if (!worker_) {
        worker_ = std::make_unique<Worker>(context.background, answer);
    }
}

void OutlineTool::drop(Shell &context) {
    seed_.reset();
    takesWhenFound_ = false;
    if (worker_) {
        worker_->clear();
    }
    context.animate();
}

void OutlineTool::deactivate(Shell &context) {
    drop(context);
}

void OutlineTool::forget(Shell &context) {
    drop(context);
}

bool OutlineTool::undo(Shell &context) {
    const bool shown = seed_.has_value();
    drop(context);
    return shown;
}

const OutlineFit *OutlineTool::found() const {
    if (!seed_ || !worker_) {
        return nullptr;
    }
    const Traced &now = worker_->now();
    const bool current = now.fit && now.of.sameRegion(*seed_) && now.of.smoothness == seed_->smoothness;
    return current ? now.fit.get() : nullptr;
}

void OutlineTool::request(Shell &context) {
    if (seed_) {
        seed_->tolerance = tolerance_;
        seed_->smoothness = smoothness_;
        worker_->submit(*seed_);
        context.animate();
    }
}

void OutlineTool::press(Vec2 at, Shell &context) {
    const std::optional<BackgroundPicture> &placed = context.document.current()->picture;
    const std::shared_ptr<const Picture> &pixels = context.pictures.shown();
    if (!placed || !pixels) {
        context.log.refuse(placed ? "The background picture cannot be read, so there is nothing to trace"
                                  : "Add a background picture first: File > Add background picture");
        return;
    }
    const Vec2 share = shareOf(*placed, at);
    const int column = static_cast<int>(std::floor(share.x * pixels->columns));
    const int row = static_cast<int>(std::floor((1.0 - share.y) * pixels->rows));
    if (column < 0 || row < 0 || column >= pixels->columns || row >= pixels->rows) {
        context.log.refuse("Click an area inside the background picture");
        return;
    }
    drop(context);
    seed_ = Request{pixels, {column, row}, tolerance_, smoothness_};
    clicked_ = at;
    request(context);
}

bool OutlineTool::handle(const CanvasEvent &event, Shell &context) {
    using Kind = CanvasEvent::Kind;
    if (event.kind == Kind::Press && event.button == MouseButton::Left) {
        press(event.place, context);
        return true;
    }
    if (event.kind != Kind::Key || event.modifiers.control() || !seed_) {
        return false;
    }
    if (event.key == key::kEnter) {
        take(context);
        return true;
    }
    if (event.key == key::kEscape || event.key == key::kBackspace) {
        drop(context);
        return true;
    }
    return false;
}

void OutlineTool::take(Shell &context) {
    const OutlineFit *const fit = found();
    const std::optional<BackgroundPicture> &placed = context.document.current()->picture;
    takesWhenFound_ = fit == nullptr;
    if (fit == nullptr || !placed) {
        return;
    }
    const std::shared_ptr<const Document> before = context.document.current();
    std::vector<Shape> shapes = boundariesAlong(*fit, planeOfPixels(*placed, *seed_->picture));
    Document grown = *before; // with the islands so far, each of which gets a tag of its own unless one is chosen
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        shapes[k].tag = k == 0                ? state_->tagOfDrawn(shapes[k], grown)
                        : state_->boundaryTag ? *state_->boundaryTag
                                              : freeBoundaryTag(grown);
        grown.shapes.push_back(std::make_shared<const Shape>(shapes[k]));
    }
    const std::size_t count = shapes.size();
    if (context.applyCommand(addShapes(*before, std::move(shapes)), "Trace by colour")) {
        context.selection.clear();
        for (std::uint32_t k = 0; k < count; ++k) {
            context.selection.shapes.insert(before->nextId + k);
        }
        drop(context);
    }
}

void OutlineTool::drawCount(CanvasPainter &painter, const Shell &context, const OutlineFit &fit) const {
    const std::size_t islands = fit.loops.empty() ? 0 : fit.loops.size() - 1;
    std::string text = ui::count(fit.nodes()) + " nodes";
    if (islands > 0) {
        text += ", " + ui::count(islands) + (islands == 1 ? " island" : " islands");
    }
    if (fit.dropped > 0) {
        text += ", " + ui::count(fit.dropped) + " smaller left out";
    }
    painter.label(clicked_, {14.0, 10.0}, text + "   Enter: take", context.theme.text, fade(context.theme.popup, 0.9),
                  context.fonts.small);
}

void OutlineTool::drawOverlay(CanvasPainter &painter, Shell &context) {
    if (worker_ && worker_->refresh()) {
        context.animate();
    }
    const std::optional<BackgroundPicture> &placed = context.document.current()->picture;
    if (!seed_ || !placed) {
        return;
    }
    if (seed_->picture != context.pictures.shown()) {
        drop(context); // replaced or hidden by undo
        return;
    }
    if (const Traced &last = worker_->now(); !last.faults.empty() && last.of.sameRegion(*seed_)) {
        context.log.add(last.faults);
        drop(context);
        return;
    }
    if (takesWhenFound_ && found() != nullptr) {
        take(context);
        return;
    }
    const Theme &theme = context.theme;
    painter.cross(clicked_, 6.0, theme.canvas, 4.0);
    painter.cross(clicked_, 6.0, theme.selection, 2.0);
    const Traced &now = worker_->now();
    if (now.fit) { // the one before, while the next is being found
        const PlaneMap map = planeOfPixels(*placed, *seed_->picture);
        for (const std::vector<Curve> &loop : now.fit->loops) {
            for (const Curve &curve : loop) {
                const Curve shown = curve.mapped(map);
                painter.curve(shown, theme.selection, 2.0);
                painter.handle(shown.point(0.0), 2.5, theme.canvas, theme.selection);
            }
        }
    }
    if (const OutlineFit *const fit = found()) {
        drawCount(painter, context, *fit);
    } else {
        painter.label(clicked_, {14.0, 10.0},
                      (now.stage.empty() ? "tracing" : now.stage) + "\xe2\x80\xa6   Esc: cancel", theme.text,
                      fade(theme.popup, 0.9), context.fonts.small);
    }
}

void OutlineTool::drawOptions(Shell &context, ui::Flow &flow) {
    if (!context.document.current()->picture) {
        flow.item("outline/add");
        if (ui::button(context, "options/outline/add", "Add picture\xe2\x80\xa6")) {
            context.actions.run("file.addPicture", context);
        }
        return;
    }
    flow.item("outline/tolerance");
    flow.label("Colour tolerance");
    bool changed = ui::slider(context, "options/outline/tolerance", tolerance_, 1.0, 60.0, "%.0f", true, 140.0F);
    ui::tooltip(context, "How far the colour may be from the one that you click: 2 is just visible, 100 lies between "
                         "black and white");
    flow.item("outline/smoothness");
    flow.label("Smoothness");
    changed =
        ui::slider(context, "options/outline/smoothness", smoothness_, 0.5, 20.0, "%.1f px", true, 140.0F) || changed;
    ui::tooltip(context, "Maximum distance of the curves from the pixels; more gives fewer nodes, and leaves out "
                         "islands that are smaller than four times this");
    if (changed) {
        request(context);
    }
    drawTagOption(context, flow, *state_, ShapeUse::Boundary, "Tag of the outline");
    flow.item("outline/take");
    if (ui::button(context, "options/outline/take", "Take outline", ui::ButtonKind::Plain, found() != nullptr)) {
        take(context);
    }
}

std::string OutlineTool::statusText(const Shell &context) const {
    if (!context.document.current()->picture) {
        return "Add a picture to trace, or drop a PNG or JPEG file onto the window";
    }
    return seed_
               ? "Adjust the sliders above, or click another area. Enter: make boundaries of the outline. Esc: drop it"
               : "Click an area of one colour, such as a lake, to trace its outline and islands";
}

} // namespace forefront
