#pragma once

#include "ui/input/input_queue.hpp"

#include <span>

struct ImGuiContext;

namespace forefront {

class Platform;

/// A Dear ImGui context that takes its input from our input queue and draws with the OpenGL 3 backend.
class ImGuiBridge {
  public:
    explicit ImGuiBridge(Platform &platform);
    ~ImGuiBridge();
    ImGuiBridge(const ImGuiBridge &) = delete;
    ImGuiBridge &operator=(const ImGuiBridge &) = delete;

    /// Makes this the current context of Dear ImGui; several editors may live in one process.
    void activate();
    void beginFrame(std::span<const InputEvent> events, double elapsedSeconds);
    /// Ends the interface built in this frame, and draws it over the contents of the target framebuffer if the frame is
    /// shown.
    void endFrame();
    /// Updates the font texture; call after rebuilding the fonts.
    void fontsChanged();

  private:
    void feed(const InputEvent &event);

    Platform &platform_;
    ImGuiContext *context_;
    double pressedAt_ = -1.0; ///< when a button was pressed last
};

} // namespace forefront
