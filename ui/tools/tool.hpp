#pragma once

#include "core/base/vec2.hpp"
#include "ui/input/keys.hpp"
#include "ui/platform/platform.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

struct AppContext;
class CanvasPainter;

namespace ui {
class Flow;
}

/// What happened on the canvas, handed to the active tool in order, none lost.
struct CanvasEvent {
    enum class Kind : std::uint8_t {
        Press,   ///< a button went down over the canvas; clicks: 1, 2 (double), ...
        Drag,    ///< the pointer moved with a button held that was pressed on the canvas
        Release, ///< that button went up, wherever
        Hover,   ///< the pointer moved with no button held
        Leave,   ///< the pointer left the canvas
        Wheel,   ///< with ctrl or shift only; the bare wheel zooms
        Key,     ///< pressed or repeated
        Text     ///< a character was typed
    };
    Kind kind = Kind::Hover;
    Vec2 place; ///< under the pointer, in domain units
    Vec2 pixel; ///< framebuffer pixels
    MouseButton button = MouseButton::Left;
    int clicks = 0;
    int key = 0;           ///< Key: see ui/input/keys.hpp
    bool repeated = false; ///< Key: auto-repeat
    char32_t character = 0;
    double wheel = 0.0; ///< steps, positive away from the user
    Modifiers modifiers;
};

/// What the pointer does on the canvas. One file a tool, one line in makeTools(). It changes the document by
/// context.document().apply(...) only; half-finished input lives in the tool.
class Tool {
  public:
    virtual ~Tool() = default;
    /// Stable name; the button in the strip is the widget "tool/ID".
    virtual const char *id() const = 0;
    virtual const char *name() const = 0;
    /// From ui/style/icons.hpp.
    virtual const char *icon() const = 0;
    /// The key that chooses it, a capital letter.
    virtual int key() const = 0;

    virtual void activate(AppContext &) {}
    /// Another tool is chosen: finish or drop what is half done.
    virtual void deactivate(AppContext &) {}
    /// True if the event is used up. A key that is not goes on to the shortcuts (so a tool in the middle of a path may
    /// take digits, Enter, Backspace, Esc).
    virtual bool handle(const CanvasEvent &event, AppContext &context) = 0;
    virtual void drawOverlay(CanvasPainter &, AppContext &) {}
    /// Whether a strip with options stands over the canvas now.
    virtual bool hasOptions(const AppContext &) const { return false; }
    /// Its widgets, each an item of `flow`: brush radius, snapping ...
    virtual void drawOptions(AppContext &, ui::Flow &) {}
    virtual CursorShape cursor() const { return CursorShape::Arrow; }
    /// One short line for the status bar: what a click does now.
    virtual std::string statusText(const AppContext &) const { return {}; }
    /// Undo and redo inside half-finished input (the path being drawn) come first. True if done.
    virtual bool undo(AppContext &) { return false; }
    virtual bool redo(AppContext &) { return false; }
};

/// All tools in the order of the strip. The first is active at the start.
std::vector<std::unique_ptr<Tool>> makeTools();

} // namespace forefront
