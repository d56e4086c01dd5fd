#pragma once

#include "ui/input/input_queue.hpp"

#include <span>

struct ImGuiContext;

namespace forefront {

class Platform;

/// The context of Dear ImGui, fed from the input queue rather than from a backend, drawn with its OpenGL 3 backend.
class ImGuiBridge {
  public:
    explicit ImGuiBridge(Platform &platform);
    ~ImGuiBridge();
    ImGuiBridge(const ImGuiBridge &) = delete;
    ImGuiBridge &operator=(const ImGuiBridge &) = delete;

    /// Makes this the current context of Dear ImGui; several editors may live in one process.
    void activate();
    void beginFrame(std::span<const InputEvent> events, double elapsedSeconds);
    /// Draws what was built over what is in the target framebuffer.
    void endFrame();
    /// The fonts were built anew.
    void fontsChanged();

  private:
    void feed(const InputEvent &event);

    Platform &platform_;
    ImGuiContext *context_;
};

} // namespace forefront
