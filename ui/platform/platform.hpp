#pragma once

#include "ui/input/input_queue.hpp"
#include "ui/input/pixels.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// The position and size of a desktop window, in screen coordinates.
struct WindowPlace {
    int x = 0, y = 0, width = 0, height = 0; ///< of the window when not maximised
    bool maximised = false;
    friend bool operator==(const WindowPlace &, const WindowPlace &) = default;
};

enum class CursorShape : std::uint8_t { Arrow, Hand, Text, Crosshair, ResizeHorizontal, ResizeVertical, Move, Hidden };

/// The platform the editor runs on: a GLFW window, or headless EGL with a fixed time step.
class Platform {
  public:
    virtual ~Platform() = default;
    virtual PixelSize framebufferSize() const = 0;
    /// Makes its OpenGL context current on this thread.
    virtual void makeCurrent() = 0;
    /// Returns the number of pixels per design pixel: Xft.dpi / 96 or the monitor's scale, without the user's setting.
    virtual double contentScale() const = 0;
    /// Returns the seconds since start; headless, the number of frames / 60.
    virtual double now() const = 0;
    /// Waits up to `waitSeconds` for input and queues it; 0 returns immediately.
    virtual void poll(InputQueue &queue, double waitSeconds) = 0;
    /// Ends the wait in poll(). Safe from any thread.
    virtual void wake() = 0;
    /// Returns the framebuffer object to draw to.
    virtual unsigned targetFramebuffer() const = 0;
    /// Returns whether anyone will see the next frame. If not, the interface is laid out but not drawn.
    virtual bool shown() const { return true; }
    virtual void present() = 0;
    /// Returns the position of the window, to be restored at the next start; empty if there is no window.
    virtual std::optional<WindowPlace> windowPlace() const { return std::nullopt; }
    virtual void setTitle(const std::string &title) = 0;
    /// Sets the window icon from RGBA pixels, row by row from the top.
    virtual void setIcon(PixelSize size, const std::vector<std::uint8_t> &rgba) = 0;
    virtual void setCursor(CursorShape shape) = 0;
    virtual std::string clipboard() const = 0;
    virtual void setClipboard(const std::string &text) = 0;
    /// Returns the drawing on the clipboard: as SVG if another program offers it so, else its text.
    virtual std::string copiedDrawing() const { return clipboard(); }
    /// Puts a drawing on the clipboard, as SVG and as text.
    virtual void copyDrawing(const std::string &svg) { setClipboard(svg); }
};

} // namespace forefront
