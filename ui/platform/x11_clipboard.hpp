#pragma once

#include <memory>
#include <string>
#include <thread>

namespace forefront {

/// Exchanges drawings with other programs through the clipboard of the X server, as SVG: drawing programs such as
/// Inkscape offer and take "image/svg+xml", but GLFW knows only text. Has its own connection, and a thread that serves
/// other programs. It is not in the BackgroundList: its thread answers to the X server, and the window awaits nothing
/// of it.
class X11Clipboard {
  public:
    /// Returns null if there is no X server.
    static std::unique_ptr<X11Clipboard> open();
    ~X11Clipboard();
    X11Clipboard(const X11Clipboard &) = delete;
    X11Clipboard &operator=(const X11Clipboard &) = delete;

    /// Offers a drawing, as SVG and as text, until something else is copied.
    void offer(std::string svg);
    /// Returns the drawing that is offered as SVG, by this or another program; empty if there is none, or if its owner
    /// does not answer within a second.
    static std::string take();

  private:
    class Owner;

    X11Clipboard();

    std::unique_ptr<Owner> owner_;
    std::jthread thread_; ///< runs the owner
};

} // namespace forefront
