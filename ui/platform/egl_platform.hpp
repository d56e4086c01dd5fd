#pragma once

#include "ui/platform/platform.hpp"

#include <memory>

namespace forefront {

/// A headless platform: EGL without a surface, drawing to a framebuffer object, no X server. A frame lasts 1/60 s
/// unless told otherwise.
class EglPlatform final : public Platform {
  public:
    /// Returns null, with the reason in `fault`, if EGL provides no OpenGL 3.3 context.
    static std::unique_ptr<EglPlatform> create(PixelSize size, double contentScale, std::string &fault);
    ~EglPlatform() override;

    void makeCurrent() override;
    PixelSize framebufferSize() const override { return size_; }
    double contentScale() const override { return scale_; }
    double now() const override { return now_; }
    void poll(InputQueue &queue, double waitSeconds) override;
    void wake() override {}
    unsigned targetFramebuffer() const override { return shown_ ? framebuffer_ : onePixel_; }
    bool shown() const override { return shown_; }
    void present() override { now_ += frameSeconds_; }
    void setTitle(const std::string &title) override { title_ = title; }
    void setIcon(PixelSize, const std::vector<std::uint8_t> &) override {}
    void setCursor(CursorShape shape) override { cursor_ = shape; }
    std::string clipboard() const override { return clipboard_; }
    void setClipboard(const std::string &text) override { clipboard_ = text; }

    void resize(PixelSize size, double contentScale);
    /// Sets how long the next frames last.
    void setFrameSeconds(double seconds) { frameSeconds_ = seconds; }
    /// Sets whether the next frames are shown. Of the others only what moves on the canvas and the pictures of large
    /// meshes are drawn, the former into a single pixel, since software rasterising takes most of the frame time.
    void show(bool shown) { shown_ = shown; }
    const std::string &title() const { return title_; }
    CursorShape cursor() const { return cursor_; }
    /// Returns the last frame that was shown as RGBA, row by row from the top.
    std::vector<std::uint8_t> pixels() const;

  private:
    struct Context;
    EglPlatform(std::unique_ptr<Context> context, PixelSize size, double contentScale);
    void makeFramebuffers();
    void dropFramebuffers();

    std::unique_ptr<Context> context_;
    PixelSize size_;
    double scale_ = 1.0;
    double now_ = 0.0, frameSeconds_ = 1.0 / 60.0;
    bool shown_ = true;
    unsigned framebuffer_ = 0, colour_ = 0, depthStencil_ = 0;
    unsigned onePixel_ = 0, pixelColour_ = 0, pixelDepthStencil_ = 0;
    std::string title_, clipboard_;
    CursorShape cursor_ = CursorShape::Arrow;
};

} // namespace forefront
