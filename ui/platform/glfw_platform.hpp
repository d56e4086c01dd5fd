#pragma once

#include "ui/platform/platform.hpp"
#include "ui/platform/x11_clipboard.hpp"

#include <array>
#include <memory>

struct GLFWwindow;
struct GLFWcursor;

namespace forefront {

/// A desktop window, opened with GLFW.
class GlfwPlatform final : public Platform {
  public:
    /// Opens a window of `size` design pixels, or at `place` if that is given and at least partly on a screen. Returns
    /// null, with the reason in `fault`, if there is no display or no OpenGL 3.3.
    static std::unique_ptr<GlfwPlatform> create(PixelSize size, const std::string &title,
                                                const std::optional<WindowPlace> &place, std::string &fault);
    ~GlfwPlatform() override;

    void makeCurrent() override;
    PixelSize framebufferSize() const override;
    double contentScale() const override;
    double now() const override;
    void poll(InputQueue &queue, double waitSeconds) override;
    void wake() override;
    unsigned targetFramebuffer() const override { return 0; }
    void present() override;
    std::optional<WindowPlace> windowPlace() const override;
    void setTitle(const std::string &title) override;
    void setIcon(PixelSize size, const std::vector<std::uint8_t> &rgba) override;
    void setCursor(CursorShape shape) override;
    std::string clipboard() const override;
    void setClipboard(const std::string &text) override;
    std::string copiedDrawing() const override;
    void copyDrawing(const std::string &svg) override;

  private:
    struct Callbacks;
    explicit GlfwPlatform(GLFWwindow *window);
    void notePlace();

    GLFWwindow *window_;
    InputQueue pending_; ///< filled by callbacks, emptied by poll()
    std::array<GLFWcursor *, 8> cursors_{};
    CursorShape cursor_ = CursorShape::Arrow;
    WindowPlace place_;
    std::unique_ptr<X11Clipboard> drawings_; ///< null without an X server
};

} // namespace forefront
