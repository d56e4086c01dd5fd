#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/vec2.hpp"
#include "ui/input/keys.hpp"
#include "ui/parts/context_menu.hpp"
#include "ui/platform/platform.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

struct Shell;
class CanvasPainter;

namespace ui {
class Flow;
}

/// An input event on the canvas. The active tool gets every event, in order.
struct CanvasEvent {
    enum class Kind : std::uint8_t {
        Press,   ///< a button went down over the canvas; clicks: 1, 2 (double), ...
        Drag,    ///< the pointer moved while a button pressed on the canvas was held
        Release, ///< that button went up, anywhere
        Hover,   ///< the pointer moved with no button held
        Leave,   ///< the pointer left the canvas
        Wheel,   ///< only with Ctrl or Shift; the wheel alone zooms
        Key,     ///< pressed or repeated
        Text     ///< a character was typed
    };
    Kind kind = Kind::Hover;
    Vec2 place;    ///< under the pointer, in domain units
    Pixel pixel{}; ///< of the pointer
    MouseButton button = MouseButton::Left;
    int clicks = 0;
    int key = 0;           ///< Key: see ui/input/keys.hpp
    bool repeated = false; ///< Key: auto-repeat
    char32_t character = 0;
    double wheel = 0.0; ///< steps, positive away from the user
    Modifiers modifiers;
};

/// A canvas tool. One file per tool, one line in makeTools(). A tool changes the document only through
/// DocumentStore::apply(); unfinished input stays in the tool.
class Tool {
  public:
    virtual ~Tool() = default;
    /// Returns the stable name of the tool; its button in the strip is the widget "tool/ID".
    virtual const char *id() const = 0;
    virtual const char *name() const = 0;
    /// Returns an icon from ui/style/icons.hpp.
    virtual const char *icon() const = 0;
    /// Returns the proposed shortcut, a capital letter; the user may give the action "tool.ID" another one.
    virtual int key() const = 0;

    virtual void activate(Shell &) {}
    /// Finishes or discards unfinished input when another tool is chosen.
    virtual void deactivate(Shell &) {}
    /// Forgets unfinished input, and numbers that belong to one drawing, when another document is opened.
    virtual void forget(Shell &) {}
    /// Returns the unfinished path as an open shape, so that a crash does not lose it.
    virtual std::optional<Shape> unfinished() const { return std::nullopt; }
    /// Handles an event and returns true if it was used. Unused keys go to the shortcuts, so that a tool in the middle
    /// of a path can take digits, Enter, Backspace and Esc.
    virtual bool handle(const CanvasEvent &event, Shell &context) = 0;
    /// Keeps labels of the layers off the handles that drawOverlay() will draw.
    virtual void reserveOverlay(CanvasPainter &, const Shell &) {}
    virtual void drawOverlay(CanvasPainter &, Shell &) {}
    /// Returns true if the options strip should be shown now.
    virtual bool hasOptions(const Shell &) const { return false; }
    /// Draws the widgets of the options strip, each an item of `flow`.
    virtual void drawOptions(Shell &, ui::Flow &) {}
    /// Handles a command of the tool that has a shortcut, such as "larger" for the brush. Returns true if it was used.
    virtual bool command(std::string_view, Shell &) { return false; }
    virtual CursorShape cursor() const { return CursorShape::Arrow; }
    /// Returns a line for the status bar that describes the effect of a click.
    virtual std::string statusText(const Shell &) const { return {}; }
    /// Returns a hint on typing numbers, shown after statusText() if there is room.
    virtual std::string typingHint(const Shell &) const { return {}; }
    /// Returns the tool's own commands for a right click at a place; those on the selection and the view follow.
    virtual std::vector<ContextGroup> menu(Shell &, Vec2 place) {
        static_cast<void>(place);
        return {};
    }
    /// Returns the text that Ctrl+C copies instead of the selection; empty: none.
    virtual std::string copyText(const Shell &) const { return {}; }
    /// Undoes or redoes within unfinished input (the path being drawn). Returns true if there was something to undo or
    /// redo.
    virtual bool undo(Shell &) { return false; }
    virtual bool redo(Shell &) { return false; }
    /// Returns the step that undo() or redo() would undo or redo, for the menu; empty: none.
    virtual std::string undoLabel(const Shell &) const { return {}; }
    virtual std::string redoLabel(const Shell &) const { return {}; }
};

} // namespace forefront
