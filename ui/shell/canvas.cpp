#include "ui/shell/canvas.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/hash.hpp"
#include "core/teaching/moment/moment.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/glide.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/canvas/mesh_glide.hpp"
#include "ui/canvas/near_front.hpp"
#include "ui/gl/draw_pace.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/mesh_batch.hpp"
#include "ui/gl/still_picture.hpp"
#include "ui/parts/preview_dialog.hpp"
#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/platform/steady_seconds.hpp"
#include "ui/shell/pointer_hints.hpp"
#include "ui/shell/presentation.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/messages/blamed_constraints.hpp"
#include "ui/workspace/ranks.hpp"
#include "ui/workspace/view/chosen_candidate.hpp"

#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace forefront {

namespace {

void clearTo(const Colour &colour) {
    const glm::vec4 channels = colour.channels();
    glClearColor(channels.r, channels.g, channels.b, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

/// Number of elements above which a picture is heavy.
constexpr std::size_t kHeavy = 30'000;

using OverlaidMesh = std::shared_ptr<const MeshSnapshot>;

bool isHeavy(const LayerFrame &frame, const LayerSlot &slot) {
    return slot.visible && slot.layer->stillElements(frame) > kHeavy;
}

/// Returns true if the still parts take too long to draw while the camera moves.
bool isHeavy(const LayerFrame &frame, const OverlaidMesh &overlaid) {
    return (overlaid && overlaid->mesh.elements.size() > kHeavy) ||
           std::any_of(frame.layers.begin(), frame.layers.end(),
                       [&](const LayerSlot &slot) { return isHeavy(frame, slot); });
}

/// Returns the key of the picture of the still parts.
PictureContent contentOf(const LayerFrame &frame, std::uint64_t loads, const OverlaidMesh &overlaid) {
    Hash64 heavy;
    heavy.add(overlaid ? overlaid->version : 0);
    for (const double number : {frame.camera.viewport.width, frame.camera.viewport.height, frame.scale}) {
        heavy.add(number);
    }
    heavy.add(static_cast<std::uint64_t>(frame.theme.kind));
    Hash64 all = heavy;
    for (const LayerSlot &slot : frame.layers) {
        all.add(slot.visible ? slot.layer->stillVersion(frame) : ~std::uint64_t{0});
        heavy.add(isHeavy(frame, slot) ? slot.layer->stillShape(frame) : 0);
    }
    return {.all = all.value(), .heavy = heavy.value(), .subject = loads};
}

/// Returns true if a layer draws over the others. The constraints of a drawing that is only offered would hide it.
bool drawsOver(const Shell &context, const LayerSlot &slot) {
    return slot.visible && !(offersDrawing(context) && std::string_view(slot.layer->id()) == "sketch");
}

} // namespace

struct Canvas::Parts {
    explicit Parts(BackgroundList &list) : gl(list), comparedBatch(list) {}

    GlKit gl;
    StillPicture still;
    MeshBatch comparedBatch;
    std::uint64_t stillDraws = 0;
    /// Where the next piece of a heavy picture begins.
    struct Slicing {
        std::size_t layer = 0; ///< as many as there are layers: the compared mesh
        std::size_t chunk = 0;
    };
    Slicing slicing;
    std::vector<DrawPace> paces;          ///< of the layers, then of the compared mesh
    std::shared_ptr<const Domain> domain; ///< of the document of this frame

    NearFront nearFront;
    Glide glide;
    const AdvanceExplanation *stepped = nullptr; ///< whose elements were shown last, if any
    double steppedAt = -1e300, fresh = 0.0;      ///< see LayerFrame::fresh
    bool appears = false;                        ///< that step has made or changed something
    MeshGlide meshGlide;
    std::shared_ptr<const MeshSnapshot> gliding; ///< of this frame, see LayerFrame::gliding

    Box2 rasterBox;
    double rasterZoom = 0.0;

    std::shared_ptr<const SpacingRaster> raster; ///< as drawn; never null
    std::vector<CanvasPainter::Placed> labels;   ///< of the last frame

    void followSteps(Shell &context);
    void requestRaster(Shell &context);
    void takeRaster(const Shell &context);
    LayerFrame frameOf(const Shell &context, const Camera &camera);
    void drawStill(Shell &context, const LayerFrame &frame);
    void drawSlices(Shell &context, const LayerFrame &frame, const PictureContent &content);
    void drawPiece(Shell &context, LayerFrame &around, DrawSlice &slice);
    void drawOverlaid(const Shell &context, const LayerFrame &frame);
    void drawLive(Shell &context, const LayerFrame &frame);
    static void drawLegends(Shell &context, CanvasPainter &painter, const LayerFrame &frame);
    static void reservePlates(const Shell &context, CanvasPainter &painter);
    void drawOverlays(Shell &context, const LayerFrame &frame);
};

Canvas::Canvas(BackgroundList &list) : parts_(std::make_unique<Parts>(list)) {}

Canvas::~Canvas() = default;

std::uint64_t Canvas::stillDraws() const {
    return parts_->stillDraws;
}

std::size_t Canvas::meshBytes() const {
    return parts_->gl.elements().bytes() + parts_->comparedBatch.bytes();
}

std::size_t Canvas::frontWalks() const {
    return parts_->nearFront.walks();
}

const std::vector<CanvasPainter::Placed> &Canvas::labels() const {
    return parts_->labels;
}

bool Canvas::pictureIncomplete() const {
    return parts_->still.pictureIncomplete();
}

/// Notes when the elements of a step appear, so that they can fade in.
void Canvas::Parts::followSteps(Shell &context) {
    constexpr double kSeconds = 0.25;
    const Moment moment = momentOf(context.run.now());
    const AdvanceExplanation *const now = moment && moment.updated ? moment.advance : nullptr;
    const bool improved = meshGlide.follow(context.run.now());
    if (now != stepped || improved) {
        stepped = now;
        steppedAt = context.platform.now();
        appears = now != nullptr || improved;
    }
    const double left = 1.0 - (context.platform.now() - steppedAt) / kSeconds;
    fresh = appears && !context.settings.reduceMotion ? std::max(0.0, left) : 0.0;
    gliding = meshGlide.at(fresh);
    if (fresh > 0.0) {
        context.animate();
    }
}

/// Requests a raster of ρ over the part in view and a margin around it. Makes a new request only when the last raster
/// no longer covers the view or is too coarse, so that panning does not resample constantly.
void Canvas::Parts::requestRaster(Shell &context) {
    const LayerSlot *layer = context.layer("size");
    const Box2 bounds = domain->bounds();
    if (layer == nullptr || !layer->visible || bounds.empty()) {
        context.examiner.submitRaster({}, 0, 0);
        rasterBox = {};
        return;
    }
    const Camera &camera = context.view.camera;
    const auto within = [&](const Box2 &box) {
        return Box2{{std::max(box.min.x, bounds.min.x), std::max(box.min.y, bounds.min.y)},
                    {std::min(box.max.x, bounds.max.x), std::min(box.max.y, bounds.max.y)}};
    };
    const Box2 visible = camera.visible();
    const Box2 seen = within(visible);
    if (seen.empty()) {
        return;
    }
    const bool serves = !rasterBox.empty() && rasterBox.contains(seen.min) && rasterBox.contains(seen.max) &&
                        within(rasterBox) == rasterBox && camera.zoom < 1.9 * rasterZoom &&
                        camera.zoom > 0.3 * rasterZoom;
    if (!serves) {
        constexpr double kPixelsPerSample = 2.5;
        rasterBox = within(visible.grown(0.25 * std::min(visible.size().x, visible.size().y)));
        rasterZoom = camera.zoom;
        const double samples = camera.zoom / (kPixelsPerSample * static_cast<double>(context.scale));
        const auto count = [&](double length) { return std::clamp(static_cast<int>(length * samples), 8, 1400); };
        context.examiner.submitRaster(rasterBox, count(rasterBox.size().x), count(rasterBox.size().y));
    }
}

/// Uses the newest raster, unless it belongs to another document than the preview while the raster drawn does not,
/// since the two are drawn together.
void Canvas::Parts::takeRaster(const Shell &context) {
    std::shared_ptr<const SpacingRaster> newest = context.examiner.raster();
    const std::uint64_t revision = context.preview->revision;
    if (!raster || newest->revision == revision || raster->revision != revision) {
        raster = std::move(newest);
    }
}

/// Returns what layers need to draw a frame with `camera`, which must outlive the result.
namespace {

/// Returns the scale by which room for labels is measured. A presentation shows those that were there before it: its
/// letters are larger, and its panels leave a canvas that is smaller by about the same factor.
double roomScale(const Shell &context) {
    const double factor = context.presentedFrom ? shell::kPresentedScale * shell::kPresentedScale : 1.0;
    return static_cast<double>(context.scale) / factor;
}

} // namespace

LayerFrame Canvas::Parts::frameOf(const Shell &context, const Camera &camera) {
    return {.camera = camera,
            .theme = context.theme,
            .fonts = context.fonts,
            .scale = static_cast<double>(context.scale),
            .roomScale = roomScale(context),
            .gridStep = context.snapping.gridStep,
            .snapshot = context.run.now(),
            .breakpoints = context.run.breakpoints(),
            .document = *context.document.current(),
            .domain = *domain,
            .revision = context.document.revision(),
            .preview = *context.preview,
            .raster = raster,
            .layerPlan = context.examiner.layers().plan(),
            .selection = context.selection,
            .pointer = context.view.pointer,
            .blamed = blamedConstraints(context.log, context.document.revision()),
            .facePlace = context.view.facePlace,
            .candidate = chosenCandidate(context.view, context.run.now()),
            .judgement = *context.judgement,
            .isolatedBin = context.view.isolatedBin,
            .measureRange = measureRange(context),
            .measureMap = measureMap(context),
            .measureBounds = measureBounds(context),
            .outOfDate = context.run.outOfDate(),
            .fresh = fresh,
            .gliding = gliding,
            .picture = context.pictures.shown(),
            .pictureFailed = context.pictures.failed(),
            .layers = context.layers,
            .gl = gl,
            .nearFront = nearFront};
}

/// Draws the still parts again if they or the camera have changed. A large mesh is drawn over several frames; while the
/// camera moves over it, its picture is moved instead.
void Canvas::Parts::drawStill(Shell &context, const LayerFrame &frame) {
    const OverlaidMesh overlaid = context.sides.overlay();
    const PictureContent content = contentOf(frame, context.document.loads(), overlaid);
    if (still.sharp(content, frame.camera)) {
        return;
    }
    const bool heavy = isHeavy(frame, overlaid);
    if (still.moves(content, frame.camera, context.platform.now(), heavy)) {
        context.animate();
        return;
    }
    if (heavy) {
        drawSlices(context, frame, content);
        return;
    }
    if (!context.platform.shown()) { // a heavy picture is drawn all the same, since it takes many frames
        still.abandon();
        return;
    }
    ++stillDraws;
    const Camera wide = still.begin(content, frame.camera);
    const LayerFrame around = frameOf(context, wide);
    clearTo(frame.theme.canvas);
    for (LayerSlot &slot : context.layers) {
        if (slot.visible) {
            slot.layer->drawStill(around);
        }
    }
    drawOverlaid(context, around);
}

/// Draws the edges of a compared mesh over all layers.
void Canvas::Parts::drawOverlaid(const Shell &context, const LayerFrame &frame) {
    comparedBatch.update(context.sides.overlay(), true);
    MeshStyle style;
    style.edge = frame.theme.compared;
    style.edgeWidth = 1.2 * frame.scale;
    style.denseEdges = 0.35;
    comparedBatch.draw(frame.gl, frame.camera, style, frame.slice);
}

/// Draws the next pieces of a heavy picture, as many as fit into a frame, so that the window answers input in between.
/// On a GPU, millions of elements need few frames; with software rendering, none takes long.
void Canvas::Parts::drawSlices(Shell &context, const LayerFrame &frame, const PictureContent &content) {
    const double begin = steadySeconds();
    bool begins = false;
    const Camera wide = still.refine(content, frame.camera, begins);
    if (begins) {
        clearTo(frame.theme.canvas);
        slicing = {};
        paces.resize(context.layers.size() + 1);
        std::for_each(paces.begin(), paces.end(), [](DrawPace &pace) { pace.restart(); });
    }
    LayerFrame around = frameOf(context, wide);
    double left = context.drawSeconds;
    bool goesOn = true;
    while (goesOn) {
        DrawPace &pace = paces[slicing.layer];
        DrawSlice slice{.elements = pace.next(left), .first = slicing.chunk};
        const double before = steadySeconds();
        drawPiece(context, around, slice);
        const double after = steadySeconds();
        pace.record(slice.done, after - before);
        slicing = {slicing.layer + (slice.more ? 0 : 1), slice.more ? slice.first : 0};
        left = context.drawSeconds - (after - begin);
        goesOn = slicing.layer < paces.size() && !slice.waits && (left > 0.0 || slice.done == 0);
    }
    if (slicing.layer == paces.size()) {
        still.finishRefining();
        ++stillDraws;
    }
    context.animate();
}

/// Draws a piece of a layer, or of the compared mesh, and waits until it is drawn.
void Canvas::Parts::drawPiece(Shell &context, LayerFrame &around, DrawSlice &slice) {
    around.slice = &slice;
    if (slicing.layer == context.layers.size()) {
        drawOverlaid(context, around);
    } else if (LayerSlot &slot = context.layers[slicing.layer]; slot.visible) {
        slot.layer->drawStill(around);
    }
    glFinish(); // or the time of this piece would be that of another
}

void Canvas::Parts::drawLive(Shell &context, const LayerFrame &frame) {
    const PixelRect &rect = frame.camera.viewport;
    const int x = static_cast<int>(rect.x), width = static_cast<int>(rect.width),
              height = static_cast<int>(rect.height);
    const int y = context.platform.framebufferSize().height - static_cast<int>(rect.y) - height;
    glBindFramebuffer(GL_FRAMEBUFFER, context.platform.targetFramebuffer());
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, width, height);
    clearTo(frame.theme.canvas); // for what the moved picture does not cover
    still.show(frame.camera, {x, y});
    glBindFramebuffer(GL_FRAMEBUFFER, context.platform.targetFramebuffer());
    glViewport(x, y, width, height);
    for (LayerSlot &slot : context.layers) {
        if (slot.visible) {
            slot.layer->drawLive(frame);
        }
    }
    glDisable(GL_SCISSOR_TEST);
}

/// Draws the legends from right to left along the bottom of the canvas, then in rows above.
void Canvas::Parts::drawLegends(Shell &context, CanvasPainter &painter, const LayerFrame &frame) {
    const PixelRect &rect = frame.camera.viewport;
    const double s = frame.scale;
    const int abreast = legendsAbreast(rect.width / s);
    int drawnSoFar = 0;
    for (LayerSlot &slot : context.layers) {
        const int column = drawnSoFar % abreast, row = drawnSoFar / abreast;
        const Pixel corner{rect.x + rect.width - (kLegendMargin + column * (kLegendWidth + kLegendGap)) * s,
                           rect.y + rect.height - (kLegendMargin + row * (kLegendHeight + kLegendGap)) * s};
        if (drawsOver(context, slot) && slot.layer->drawLegend(painter, frame, corner)) {
            ++drawnSoFar;
            ui::markRect(
                context, std::string("canvas/legend/") + slot.layer->id(),
                {corner.x - kLegendWidth * s, corner.y - kLegendHeight * s, kLegendWidth * s, kLegendHeight * s});
        }
    }
}

namespace {

/// Keeps labels off small closed outlines, such as holes, which they would hide.
void reserveSmallOutlines(const Shell &context, CanvasPainter &painter) {
    constexpr std::size_t kMaxShapes = 2000; // of more, most are too small to be seen
    constexpr double kSmall = 120.0;         // design pixels
    const Document &document = *context.document.current();
    const double small = painter.camera().length(kSmall * painter.scale());
    const Box2 visible = painter.camera().visible();
    for (std::size_t k = 0; k < document.shapes.size() && document.shapes.size() <= kMaxShapes; ++k) {
        const Shape &shape = *document.shapes[k];
        const Box2 box = shape.hidden || !isClosed(shape) ? Box2() : boundsOf(shape);
        if (!box.empty() && box.overlaps(visible) && std::max(box.size().x, box.size().y) <= small) {
            painter.reserve(outlineOf(shape));
        }
    }
}

} // namespace

/// Keeps labels on the canvas, and clear of the plates on it, as placed in the last frame, of the selected nodes and of
/// what the tool draws; not of messages, which pass.
void Canvas::Parts::reservePlates(const Shell &context, CanvasPainter &painter) {
    painter.keepInside(context.view.open);
    for (const auto &[name, widget] : context.widgets.all()) {
        const bool plate = name == "canvas/tools" || name.starts_with("plate/") || name == "hints" ||
                           name == "canvas/plate" || name == "run" || name.starts_with("canvas/legend/");
        if (plate) {
            painter.reserve(widget.rect);
        }
    }
    reserveSmallOutlines(context, painter);
    for (const NodeRef node : context.selection.nodes) {
        const Shape *const shape = findShape(*context.document.current(), node.shape);
        const std::vector<Vec2> handles = shape != nullptr ? handlesOf(*shape) : std::vector<Vec2>();
        if (node.node < handles.size()) {
            painter.reserve(handles[node.node], 6.0);
        }
    }
    context.tools.current().reserveOverlay(painter, context);
}

void Canvas::Parts::drawOverlays(Shell &context, const LayerFrame &frame) {
    const PixelRect &rect = frame.camera.viewport;
    ImDrawList &list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({static_cast<float>(rect.x), static_cast<float>(rect.y)},
                      {static_cast<float>(rect.x + rect.width), static_cast<float>(rect.y + rect.height)});
    CanvasPainter painter(list, frame.camera, frame.scale);
    reservePlates(context, painter);
    // What the tool draws lies above the layers, but its words, which are at the pointer, take their places first.
    painter.beginLevels();
    painter.setLevel(CanvasPainter::Level::Tool);
    context.tools.current().drawOverlay(painter, context);
    drawPointerHint(painter, context);
    if (!context.dialogs.any()) { // which may preview another drawing
        drawProbe(painter, context);
    }
    if (context.settings.workspace == WorkspaceKind::Judge && !isFolded(context, "worst")) {
        drawRanks(painter, context);
    }
    painter.setLevel(CanvasPainter::Level::Layers);
    for (LayerSlot &slot : context.layers) {
        if (drawsOver(context, slot)) {
            slot.layer->drawOverlay(painter, frame);
        }
    }
    painter.endLevels();
    labels = painter.labels();
    for (const CanvasPainter::Placed &label : labels) {
        if (!label.name.empty()) {
            ui::markRect(context, label.name, label.rect);
        }
    }
    constexpr double kFlagSeconds = 2.5;
    const double age = context.platform.now() - context.view.flagTime;
    if (context.view.flag && age < kFlagSeconds) {
        const double t = age / kFlagSeconds;
        painter.ring(*context.view.flag, 14.0 + 10.0 * std::abs(std::sin(6.0 * age)),
                     fade(context.theme.accent, 1.0 - t * t), 2.5);
        context.animate();
    }
    drawLegends(context, painter, frame);
    list.PopClipRect();
}

void Canvas::draw(Shell &context) {
    parts_->domain = context.document.domain();
    parts_->requestRaster(context);
    parts_->takeRaster(context);
    parts_->followSteps(context);
    const Camera camera = parts_->glide.next(context.view.camera, context.view.jumps, context.platform.now(),
                                             !context.settings.reduceMotion);
    if (parts_->glide.moving()) {
        context.animate();
    }
    const LayerFrame frame = parts_->frameOf(context, camera);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    parts_->drawStill(context, frame);
    const PixelSize size = context.platform.framebufferSize();
    glBindFramebuffer(GL_FRAMEBUFFER, context.platform.targetFramebuffer());
    glViewport(0, 0, size.width, size.height);
    clearTo(context.theme.panel);
    parts_->drawLive(context, frame);
    parts_->drawOverlays(context, frame);
    glViewport(0, 0, size.width, size.height);
}

} // namespace forefront
