#pragma once

#include "ui/input/input_queue.hpp"
#include "ui/parts/action.hpp"
#include "ui/parts/tool.hpp"

#include <optional>

namespace forefront {

/// Decides who gets an event: Dear ImGui (which has seen it already), the camera, the active tool, or a shortcut.
class CanvasInput {
  public:
    /// Call between Dear ImGui's NewFrame and the building of the windows.
    void dispatch(const InputEvent &event, Shell &context);
    bool panning() const { return panning_; }
    /// Runs the shortcut or click that took the keyboard from a text field, now that the field has taken what was
    /// typed.
    void runWaiting(Shell &context);

  private:
    void move(const InputEvent &event, Shell &context);
    void button(const InputEvent &event, Shell &context);
    void scroll(const InputEvent &event, Shell &context);
    void key(const InputEvent &event, Shell &context);
    void fieldKey(const InputEvent &event, Shell &context);
    void spaceKey(const InputEvent &event, Shell &context);
    bool offer(CanvasEvent event, Shell &context) const;
    int countClicks(const InputEvent &event, Shell &context);

    Vec2 pixel_;
    Modifiers modifiers_;
    bool over_ = false;
    bool panning_ = false;
    std::optional<MouseButton> held_; ///< pressed on the canvas, for the tool
    bool spaceDown_ = false, spaceUsed_ = false;
    std::optional<Shortcut> waiting_;        ///< for the field to be left
    std::optional<InputEvent> waitingPress_; ///< of a button on the canvas, likewise
    Vec2 clickPixel_;
    double clickTime_ = -1.0;
    int clicks_ = 0;
};

} // namespace forefront
