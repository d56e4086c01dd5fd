#pragma once

#include "core/edit/references.hpp"
#include "ui/canvas/camera.hpp"
#include "ui/dialogs/dialog.hpp"
#include "ui/editor/action.hpp"
#include "ui/editor/document_store.hpp"
#include "ui/editor/message_log.hpp"
#include "ui/editor/preview.hpp"
#include "ui/editor/run_control.hpp"
#include "ui/editor/settings.hpp"
#include "ui/layers/layer.hpp"
#include "ui/panels/panel.hpp"
#include "ui/platform/platform.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/fonts.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/theme.hpp"
#include "ui/tools/tool.hpp"
#include "ui/widgets/widget_registry.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// What is in view.
struct View {
    Camera camera;
    PixelRect room;              ///< part of the canvas that plates and legends leave free: what is fitted goes there
    std::optional<Box2> fitted;  ///< shown whole whatever the size of the canvas, until the user pans or zooms
    std::optional<Vec2> pointer; ///< place under the pointer while it is over the canvas
    bool panels = true;          ///< Tab hides them
    bool fitPending = true;      ///< fit the drawing as soon as the size of the canvas is known
    std::optional<Vec2> flag;    ///< place gone to, marked by a ring that fades
    double flagTime = 0.0;
    std::optional<int> isolatedBin;          ///< bin of the histogram of α whose elements are shown alone
    std::optional<ColourRange> qualityRange; ///< of the colours of α; not set: it fits the mesh

    /// Shows a part of the plane whole, and goes on doing so while the canvas changes its size.
    void fit(const Box2 &box);
    void pan(Vec2 pixels);
    void zoomAt(Vec2 pixel, double factor);
    /// The canvas has another size, or another room in it: what was fitted fits again; else the place in the middle
    /// stays there. False if nothing changed.
    bool resize(const PixelRect &viewport, const PixelRect &roomInIt);
    /// Brings a place into view, close enough to see its surroundings, and marks it.
    void goTo(Vec2 place, double now);
};

/// The tools and which of them is active.
struct ToolBox {
    std::vector<std::unique_ptr<Tool>> tools;
    std::size_t active = 0;

    Tool &current() const { return *tools[active]; }
    void choose(std::string_view id, AppContext &context);
};

/// Everything the parts of the editor work on, handed to tools, panels, dialogs and actions. Owned by Editor.
struct AppContext {
    Platform &platform;
    WidgetRegistry widgets;
    Settings settings;
    Theme theme;
    Fonts fonts;
    float scale = 1.0F; ///< pixels per design pixel
    MessageLog log;
    ActionRegistry actions;
    DialogHost dialogs;
    View view;
    Selection selection;
    ToolBox tools;
    std::vector<LayerSlot> layers;
    std::vector<std::unique_ptr<Panel>> panels;
    DocumentStore store;
    std::unique_ptr<RunControl> runs;
    std::unique_ptr<Preview> previews;
    std::shared_ptr<const DocumentPreview> preview; ///< of this frame, never null
    bool quit = false;                              ///< end the program after this frame
    bool closeRequested = false;                    ///< the user closed the window; "file.quit" decides
    int redraw = 3;                                 ///< frames still to draw although nothing happens

    DocumentStore &document() { return store; }
    const DocumentStore &document() const { return store; }
    RunControl &run() { return *runs; }
    const RunControl &run() const { return *runs; }
    /// Design pixels to pixels.
    float px(double design) const { return static_cast<float>(design) * scale; }
    /// Draw some frames more: something moves that no event announces.
    void animate() { redraw = redraw > 2 ? redraw : 2; }
    /// A frame is to be drawn at that moment although nothing happens (a message that fades).
    void wakeAt(double time) { nextFrameAt = nextFrameAt < time ? nextFrameAt : time; }
    double nextFrameAt = 1e300; ///< reset at the start of each frame
    LayerSlot *layer(std::string_view id);
    /// Makes what was read from a file the document, whatever becomes of the one before; see openDocument() in
    /// ui/dialogs.
    std::function<void(const Document &, const std::filesystem::path &)> showDocument;
};

} // namespace forefront
