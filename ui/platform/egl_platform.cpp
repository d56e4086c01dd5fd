#include "ui/platform/egl_platform.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <glad/gl.h>

#include <algorithm>
#include <string>
#include <vector>

namespace forefront {

struct EglPlatform::Context {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    Context() = default;
    Context(const Context &) = delete;
    Context &operator=(const Context &) = delete;
    ~Context() {
        if (display != EGL_NO_DISPLAY) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            if (context != EGL_NO_CONTEXT) {
                eglDestroyContext(display, context);
            }
            eglTerminate(display);
        }
    }
};

namespace {

/// Opens an OpenGL context of a display; returns what is missing, or an empty text.
std::string openContext(EGLenum kind, EGLDeviceEXT device, EGLDisplay &display, EGLContext &context) {
    display = eglGetPlatformDisplay(kind, device, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
        display = EGL_NO_DISPLAY;
        return "no EGL display without a window; install libegl-mesa0";
    }
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
        return "EGL does not support desktop OpenGL; install libgl1-mesa-dri";
    }
    const EGLint configAttributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, configAttributes, &config, 1, &count);
    const EGLint contextAttributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context = eglCreateContext(display, count > 0 ? config : nullptr, EGL_NO_CONTEXT, contextAttributes);
    if (context == EGL_NO_CONTEXT || eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
        return "no OpenGL 3.3 core context from EGL; install libgl1-mesa-dri";
    }
    return {};
}

/// Returns the graphics cards that EGL knows.
std::vector<EGLDeviceEXT> graphicsCards() {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    std::vector<EGLDeviceEXT> cards(16);
    EGLint count = 0;
    if (query == nullptr || query(static_cast<EGLint>(cards.size()), cards.data(), &count) == EGL_FALSE) {
        count = 0;
    }
    cards.resize(static_cast<std::size_t>(count));
    return cards;
}

void makeFramebuffer(PixelSize size, unsigned &framebuffer, unsigned &colour, unsigned &depthStencil) {
    glGenRenderbuffers(1, &colour);
    glBindRenderbuffer(GL_RENDERBUFFER, colour);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width, size.height);
    glGenRenderbuffers(1, &depthStencil);
    glBindRenderbuffer(GL_RENDERBUFFER, depthStencil);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, size.width, size.height);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depthStencil);
}

} // namespace

std::unique_ptr<EglPlatform> EglPlatform::create(PixelSize size, double contentScale, std::string &fault) {
    auto context = std::make_unique<Context>();
    fault = openContext(EGL_PLATFORM_SURFACELESS_MESA, nullptr, context->display, context->context);
    // Without Mesa, the drivers of graphics cards offer a display for each card instead.
    const std::vector<EGLDeviceEXT> cards = fault.empty() ? std::vector<EGLDeviceEXT>() : graphicsCards();
    for (std::size_t k = 0; k < cards.size() && !fault.empty(); ++k) {
        context = std::make_unique<Context>();
        if (openContext(EGL_PLATFORM_DEVICE_EXT, cards[k], context->display, context->context).empty()) {
            fault.clear();
        }
    }
    if (!fault.empty()) {
        return nullptr;
    }
    if (gladLoadGL(reinterpret_cast<GLADloadfunc>(eglGetProcAddress)) == 0) {
        fault = "cannot load the OpenGL 3.3 functions";
        return nullptr;
    }
    return std::unique_ptr<EglPlatform>(new EglPlatform(std::move(context), size, contentScale));
}

EglPlatform::EglPlatform(std::unique_ptr<Context> context, PixelSize size, double contentScale)
    : context_(std::move(context)), size_(size), scale_(contentScale) {
    makeFramebuffers();
}

EglPlatform::~EglPlatform() {
    makeCurrent();
    dropFramebuffers();
}

void EglPlatform::makeCurrent() {
    eglMakeCurrent(context_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_->context);
}

void EglPlatform::poll(InputQueue &, double) {}

void EglPlatform::resize(PixelSize size, double contentScale) {
    makeCurrent();
    size_ = size;
    scale_ = contentScale;
    dropFramebuffers();
    makeFramebuffers();
}

void EglPlatform::makeFramebuffers() {
    makeFramebuffer(size_, framebuffer_, colour_, depthStencil_);
    makeFramebuffer({1, 1}, onePixel_, pixelColour_, pixelDepthStencil_);
}

void EglPlatform::dropFramebuffers() {
    const unsigned framebuffers[] = {framebuffer_, onePixel_};
    const unsigned buffers[] = {colour_, depthStencil_, pixelColour_, pixelDepthStencil_};
    glDeleteFramebuffers(2, framebuffers);
    glDeleteRenderbuffers(4, buffers);
}

std::vector<std::uint8_t> EglPlatform::pixels() const {
    const std::size_t stride = static_cast<std::size_t>(size_.width) * 4;
    const std::size_t rows = static_cast<std::size_t>(size_.height);
    std::vector<std::uint8_t> bottomUp(stride * rows);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, bottomUp.data());
    std::vector<std::uint8_t> picture(bottomUp.size());
    for (std::size_t row = 0; row < rows; ++row) {
        std::copy_n(&bottomUp[(rows - 1 - row) * stride], stride, &picture[row * stride]);
    }
    return picture;
}

} // namespace forefront
