#include "ui/platform/glfw_platform.hpp"

#include <GLFW/glfw3.h>
#include <glad/gl.h>

#include <algorithm>
#include <cmath>

namespace forefront {

static_assert(key::kEscape == GLFW_KEY_ESCAPE && key::kEnd == GLFW_KEY_END && key::kF5 == GLFW_KEY_F5 &&
              key::kKeypadEnter == GLFW_KEY_KP_ENTER && key::kRightSuper == GLFW_KEY_RIGHT_SUPER);
static_assert(Modifiers::kShift == GLFW_MOD_SHIFT && Modifiers::kControl == GLFW_MOD_CONTROL &&
              Modifiers::kAlt == GLFW_MOD_ALT);

namespace {

Modifiers modifiersOf(int bits) {
    return {static_cast<std::uint8_t>(bits & (GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT))};
}

/// Returns the requested size, limited to the work area of the desktop.
PixelSize withinDesktop(PixelSize wanted) {
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) {
        return wanted;
    }
    int x = 0, y = 0, width = 0, height = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
    return width > 0 && height > 0 ? PixelSize{std::min(wanted.width, width), std::min(wanted.height, height)} : wanted;
}

/// Minimum size of a window in which the whole interface is usable, in design pixels.
constexpr PixelSize kSmallestWindow{800, 500};

/// Returns true if the title bar of a window at this position can be reached on some screen.
bool onScreen(const WindowPlace &place) {
    int count = 0;
    GLFWmonitor **monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        int x = 0, y = 0, width = 0, height = 0;
        glfwGetMonitorWorkarea(monitors[i], &x, &y, &width, &height);
        constexpr int kReachable = 60;
        if (place.x + place.width >= x + kReachable && place.x + kReachable <= x + width && place.y >= y &&
            place.y + kReachable <= y + height) {
            return true;
        }
    }
    return false;
}

void restore(GLFWwindow *window, const std::optional<WindowPlace> &place) {
    float scaleX = 1.0F, scaleY = 1.0F;
    glfwGetWindowContentScale(window, &scaleX, &scaleY);
    const PixelSize smallest = withinDesktop({static_cast<int>(static_cast<float>(kSmallestWindow.width) * scaleX),
                                              static_cast<int>(static_cast<float>(kSmallestWindow.height) * scaleY)});
    glfwSetWindowSizeLimits(window, smallest.width, smallest.height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    if (place && onScreen(*place)) {
        const PixelSize size = withinDesktop({place->width, place->height});
        glfwSetWindowSize(window, std::max(size.width, smallest.width), std::max(size.height, smallest.height));
        glfwSetWindowPos(window, place->x, place->y);
        if (place->maximised) {
            glfwMaximizeWindow(window);
        }
    }
    glfwShowWindow(window);
}

/// Converts window coordinates to framebuffer pixels; they differ only if the system scales windows itself.
void toPixels(GLFWwindow *window, double &x, double &y) {
    int width = 0, height = 0, pixelWidth = 0, pixelHeight = 0;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixelWidth, &pixelHeight);
    x *= width > 0 ? static_cast<double>(pixelWidth) / width : 1.0;
    y *= height > 0 ? static_cast<double>(pixelHeight) / height : 1.0;
}

} // namespace

struct GlfwPlatform::Callbacks {
    static InputQueue &queue(GLFWwindow *window) {
        return static_cast<GlfwPlatform *>(glfwGetWindowUserPointer(window))->pending_;
    }
    static void move(GLFWwindow *window, double x, double y) {
        toPixels(window, x, y);
        queue(window).push({.kind = InputKind::MouseMove, .x = x, .y = y});
    }
    static void button(GLFWwindow *window, int code, int action, int modifiers) {
        if (code <= static_cast<int>(MouseButton::Middle)) {
            queue(window).push({.kind = InputKind::MouseButton,
                                .code = code,
                                .pressed = action == GLFW_PRESS,
                                .modifiers = modifiersOf(modifiers),
                                .time = glfwGetTime()});
        }
    }
    static void scroll(GLFWwindow *window, double x, double y) {
        queue(window).push({.kind = InputKind::Scroll, .x = x, .y = y});
    }
    static void key(GLFWwindow *window, int code, int, int action, int modifiers) {
        if (code >= 0) {
            queue(window).push({.kind = InputKind::Key,
                                .code = code,
                                .pressed = action != GLFW_RELEASE,
                                .repeated = action == GLFW_REPEAT,
                                .modifiers = modifiersOf(modifiers)});
        }
    }
    static void text(GLFWwindow *window, unsigned codePoint) {
        queue(window).push({.kind = InputKind::Text, .code = static_cast<int>(codePoint)});
    }
    static void focus(GLFWwindow *window, int focused) {
        queue(window).push({.kind = InputKind::Focus, .pressed = focused != 0});
    }
    static void drop(GLFWwindow *window, int count, const char **paths) {
        queue(window).push({.kind = InputKind::Drop, .paths = {paths, paths + count}});
    }
    static void place(GLFWwindow *window, int, int) {
        static_cast<GlfwPlatform *>(glfwGetWindowUserPointer(window))->notePlace();
    }
    static void close(GLFWwindow *window) {
        glfwSetWindowShouldClose(window, GLFW_FALSE);
        queue(window).push({.kind = InputKind::Close});
    }
};

std::unique_ptr<GlfwPlatform> GlfwPlatform::create(PixelSize size, const std::string &title,
                                                   const std::optional<WindowPlace> &place, std::string &fault) {
    if (glfwInit() == GLFW_FALSE) {
        const char *reason = nullptr;
        glfwGetError(&reason);
        fault = reason != nullptr ? reason : "no display";
        return nullptr;
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE); // restore() shows it once it is in position
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "forefront");
    size = withinDesktop(size);
    GLFWwindow *window = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    if (window == nullptr) {
        const char *reason = nullptr;
        glfwGetError(&reason);
        fault = reason != nullptr ? reason : "cannot create an OpenGL 3.3 window";
        glfwTerminate();
        return nullptr;
    }
    restore(window, place);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    std::unique_ptr<GlfwPlatform> platform(new GlfwPlatform(window));
    if (gladLoadGL(glfwGetProcAddress) == 0) {
        fault = "cannot load the OpenGL 3.3 functions";
        return nullptr;
    }
    return platform;
}

GlfwPlatform::GlfwPlatform(GLFWwindow *window) : window_(window), drawings_(X11Clipboard::open()) {
    glfwSetWindowUserPointer(window_, this);
    glfwSetCursorPosCallback(window_, Callbacks::move);
    glfwSetMouseButtonCallback(window_, Callbacks::button);
    glfwSetScrollCallback(window_, Callbacks::scroll);
    glfwSetKeyCallback(window_, Callbacks::key);
    glfwSetCharCallback(window_, Callbacks::text);
    glfwSetWindowFocusCallback(window_, Callbacks::focus);
    glfwSetDropCallback(window_, Callbacks::drop);
    glfwSetWindowCloseCallback(window_, Callbacks::close);
    glfwSetWindowPosCallback(window_, Callbacks::place);
    glfwSetWindowSizeCallback(window_, Callbacks::place);
    notePlace();
    const std::array<int, 7> shapes{GLFW_ARROW_CURSOR,     GLFW_HAND_CURSOR,    GLFW_IBEAM_CURSOR,
                                    GLFW_CROSSHAIR_CURSOR, GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR,
                                    GLFW_CROSSHAIR_CURSOR};
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        cursors_[i] = glfwCreateStandardCursor(shapes[i]);
    }
}

GlfwPlatform::~GlfwPlatform() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void GlfwPlatform::makeCurrent() {
    glfwMakeContextCurrent(window_);
}

PixelSize GlfwPlatform::framebufferSize() const {
    PixelSize size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return size;
}

double GlfwPlatform::contentScale() const {
    float x = 1.0F, y = 1.0F;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(static_cast<double>(std::max(x, y)), 0.5, 6.0);
}

double GlfwPlatform::now() const {
    return glfwGetTime();
}

void GlfwPlatform::poll(InputQueue &queue, double waitSeconds) {
    if (waitSeconds > 0.0) {
        glfwWaitEventsTimeout(waitSeconds);
    } else {
        glfwPollEvents();
    }
    while (!pending_.empty()) {
        for (InputEvent &event : pending_.takeFrame()) {
            queue.push(std::move(event));
        }
    }
}

void GlfwPlatform::wake() {
    glfwPostEmptyEvent();
}

void GlfwPlatform::notePlace() {
    const bool maximised = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) != 0;
    const bool minimised = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != 0;
    if (!maximised && !minimised) {
        glfwGetWindowPos(window_, &place_.x, &place_.y);
        glfwGetWindowSize(window_, &place_.width, &place_.height);
    }
}

std::optional<WindowPlace> GlfwPlatform::windowPlace() const {
    WindowPlace place = place_;
    place.maximised = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) != 0;
    return place;
}

void GlfwPlatform::present() {
    glfwSwapBuffers(window_);
}

void GlfwPlatform::setTitle(const std::string &title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void GlfwPlatform::setIcon(PixelSize size, const std::vector<std::uint8_t> &rgba) {
    std::vector<std::uint8_t> pixels = rgba;
    const GLFWimage image{size.width, size.height, pixels.data()};
    glfwSetWindowIcon(window_, 1, &image);
}

void GlfwPlatform::setCursor(CursorShape shape) {
    if (shape == cursor_) {
        return;
    }
    cursor_ = shape;
    glfwSetInputMode(window_, GLFW_CURSOR, shape == CursorShape::Hidden ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
    glfwSetCursor(window_, cursors_[static_cast<std::size_t>(shape)]);
}

std::string GlfwPlatform::clipboard() const {
    const char *text = glfwGetClipboardString(window_);
    return text != nullptr ? text : "";
}

void GlfwPlatform::setClipboard(const std::string &text) {
    glfwSetClipboardString(window_, text.c_str());
}

std::string GlfwPlatform::copiedDrawing() const {
    std::string svg = drawings_ ? X11Clipboard::take() : std::string();
    return svg.empty() ? clipboard() : svg;
}

void GlfwPlatform::copyDrawing(const std::string &svg) {
    if (drawings_) {
        drawings_->offer(svg);
    } else {
        setClipboard(svg);
    }
}

} // namespace forefront
