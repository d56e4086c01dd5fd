#pragma once

#include "ui/editor/editor.hpp"
#include "ui/platform/egl_platform.hpp"
#include "ui/shell/canvas.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::test {

/// Drives a headless editor as a user would, by widget names and keys. Every frame lasts 1/60 s. Live meshing is off,
/// so that tests decide when a mesh is made, and so is motion, so that settle() waits for none. The hints at the
/// pointer have retired.
class Driver {
  public:
    /// `shown`: the frames are drawn as in a window; see EglPlatform::show().
    explicit Driver(EditorSetup setup = {}, PixelSize size = {1280, 800}, double contentScale = 1.0,
                    bool shown = false);

    Editor &editor() { return *editor_; }
    Shell &context() { return editor_->context(); }
    EglPlatform &platform() { return *platform_; }
    const SessionSnapshot &run() { return context().run.now(); }

    /// Draws frames until the picture no longer changes without input. How long that takes depends on the machine; the
    /// test runner's timeout catches hangs.
    void settle();
    /// Draws frames until `condition` holds.
    void until(const std::function<bool()> &condition);
    void frames(int count);
    bool has(std::string_view widget) const;
    /// Shows the switches of the layers.
    void unfoldLayers();
    /// Shows a panel as its command does.
    void showPanel(std::string_view panel);
    void workspace(WorkspaceKind kind);
    /// Clicks the middle of a widget. Returns false, and fails a check, if it is not drawn or not enabled.
    bool click(std::string_view widget);
    bool hover(std::string_view widget);
    void moveTo(Pixel pixel);
    void clickAt(Pixel pixel);
    void press(Pixel pixel, MouseButton button = MouseButton::Left);
    void release(Pixel pixel, MouseButton button = MouseButton::Left);
    void drag(Pixel from, Pixel to, int steps = 8, Modifiers modifiers = {});
    /// Presses or releases the keys of modifiers; they are seen with the next event.
    void hold(Modifiers modifiers, bool pressed);
    void key(int code, Modifiers modifiers = {});
    void type(std::string_view text);
    /// Types lower-case letters and digits like a keyboard: each key, then its character.
    void keys(std::string_view text);
    void scroll(Pixel pixel, double steps);
    /// Runs a script with one command per line: `click WIDGET`, `key NAME` ("2", "Space", "Ctrl+Z", "."), `type TEXT`,
    /// `settle`.
    bool script(std::string_view commands);

    struct Picture {
        PixelSize size;
        std::vector<std::uint8_t> rgba;
        /// Returns the number of pixels of `area` that differ from another picture of the same size.
        std::size_t differences(const Picture &other, const PixelRect &area) const;
        std::size_t differences(const Picture &other) const;
    };
    /// Draws one more frame and returns it. Other frames are not kept as pictures.
    Picture picture();
    PixelRect canvas() const;

  private:
    void push(const InputEvent &event);
    void drain();

    std::unique_ptr<EglPlatform> platform_;
    std::unique_ptr<Editor> editor_;
};

} // namespace forefront::test
