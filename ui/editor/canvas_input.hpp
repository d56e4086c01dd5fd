#pragma once

#include "ui/input/input_queue.hpp"
#include "ui/parts/action.hpp"
#include "ui/parts/tool.hpp"

#include <cstdint>
#include <optional>

namespace forefront {

/// Routes input events to the camera, the active tool or a shortcut, unless Dear ImGui has used them already.
class CanvasInput {
  public:
    /// Handles one event. Call after Dear ImGui's NewFrame and before the windows are built.
    void dispatch(const InputEvent &event, Shell &context);
    bool panning() const { return panning_; }
    /// Ends a frame, once the windows are built: runs the shortcut or click that ended the editing of a text field, now
    /// that the field has committed its text, and tells the tool what a key, an edit or the camera brought under the
    /// pointer.
    void endFrame(Shell &context);

  private:
    /// The state that determines the item under a resting pointer.
    struct Scene {
        std::uint64_t revision = 0;
        Vec2 corner; ///< place at the first pixel of the canvas
        double zoom = 0.0;
        bool operator==(const Scene &) const = default;
    };
    void runWaiting(Shell &context);
    static void runShortcut(Shortcut shortcut, bool repeated, Shell &context);
    void showTool(Shell &context);
    void move(const InputEvent &event, Shell &context);
    void button(const InputEvent &event, Shell &context);
    void scroll(const InputEvent &event, Shell &context);
    void key(const InputEvent &event, Shell &context);
    void fieldKey(const InputEvent &event, Shell &context);
    bool openMenu(const InputEvent &event, Shell &context);
    void menuKey(const InputEvent &event, Shell &context);
    void spaceKey(const InputEvent &event, Shell &context);
    bool offer(CanvasEvent event, Shell &context) const;
    int countClicks(const InputEvent &event, Shell &context);

    Pixel pixel_{};
    Modifiers modifiers_;
    bool over_ = false;
    bool panning_ = false;
    std::optional<MouseButton> held_; ///< button pressed on the canvas, held for the tool
    bool spaceDown_ = false, spaceUsed_ = false;
    std::optional<Shortcut> waiting_;        ///< runs once the text field is left
    char waitingMenu_ = 0;                   ///< letter of the menu that opens once the text field is left; 0: none
    std::optional<InputEvent> waitingPress_; ///< click on the canvas, handled once the text field is left
    Pixel clickPixel_{};
    double clickTime_ = -1.0;
    int clicks_ = 0;
    bool keyed_ = false; ///< a key was pressed since the tool last saw the pointer
    Scene seen_;         ///< when the tool last saw the pointer
};

} // namespace forefront
