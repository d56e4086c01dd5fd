#include "tests/ui/driver.hpp"

#include "ui/parts/shown_panels.hpp"
#include "ui/shell/pointer_hints.hpp"

#include <doctest/doctest.h>
#include <glm/common.hpp>

#include <chrono>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace forefront::test {

Driver::Driver(EditorSetup setup, PixelSize size, double contentScale, bool shown) {
    std::string fault;
    platform_ = EglPlatform::create(size, contentScale, fault);
    if (!platform_) {
        throw std::runtime_error("no headless OpenGL: " + fault);
    }
    platform_->show(shown);
    editor_ = std::make_unique<Editor>(*platform_, std::move(setup));
    context().settings.live = false;
    context().settings.reduceMotion = true;
    for (const auto &tool : context().tools.tools) {
        context().settings.toolUses[tool->id()] = kHintedUses; // no hints at the pointer, which pictures would show
    }
    frames(4);
    settle();
}

void Driver::frames(int count) {
    for (int i = 0; i < count; ++i) {
        editor_->frame();
    }
}

void Driver::settle() {
    frames(3);
    until([this] { return editor_->settled() && !editor_->needsFrame(); });
}

void Driver::until(const std::function<bool()> &condition) {
    while (!condition()) {
        if (context().redraw <= 0 && editor_->input().empty()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // only workers are busy
        }
        editor_->frame();
    }
}

void Driver::push(const InputEvent &event) {
    editor_->input().push(event);
}

void Driver::drain() {
    while (!editor_->input().empty()) {
        editor_->frame();
    }
    frames(2);
}

void Driver::unfoldLayers() {
    if (!has("layer/domain")) {
        showPanel("layers");
    }
}

void Driver::showPanel(std::string_view panel) {
    const bool known = context().actions.run("panel." + std::string(panel), context());
    const std::string message(panel);
    CHECK_MESSAGE(known, "no panel " << message);
    settle();
}

void Driver::workspace(WorkspaceKind kind) {
    chooseWorkspace(context(), kind);
    settle();
}

bool Driver::has(std::string_view widget) const {
    return editor_->context().widgets.find(widget) != nullptr;
}

bool Driver::hover(std::string_view name) {
    const WidgetRegistry::Widget *widget = context().widgets.find(name);
    const std::string message(name);
    CHECK_MESSAGE(widget != nullptr, "no widget " << message);
    if (widget == nullptr) {
        return false;
    }
    CHECK_MESSAGE(widget->visible, "out of sight: " << message);
    moveTo(widget->rect.centre());
    return true;
}

bool Driver::click(std::string_view name) {
    if (!hover(name)) {
        return false;
    }
    const WidgetRegistry::Widget *widget = context().widgets.find(name);
    const std::string message(name);
    CHECK_MESSAGE((widget != nullptr && widget->enabled), "disabled: " << message);
    if (widget == nullptr) {
        return false;
    }
    clickAt(widget->rect.centre());
    return true;
}

void Driver::moveTo(Pixel pixel) {
    push({.kind = InputKind::MouseMove, .x = pixel.x, .y = pixel.y});
    drain();
}

void Driver::press(Pixel pixel, MouseButton button) {
    push({.kind = InputKind::MouseMove, .x = pixel.x, .y = pixel.y});
    push({.kind = InputKind::MouseButton, .code = static_cast<int>(button), .pressed = true});
    drain();
}

void Driver::release(Pixel pixel, MouseButton button) {
    push({.kind = InputKind::MouseMove, .x = pixel.x, .y = pixel.y});
    push({.kind = InputKind::MouseButton, .code = static_cast<int>(button), .pressed = false});
    drain();
}

void Driver::clickAt(Pixel pixel) {
    push({.kind = InputKind::MouseMove, .x = pixel.x, .y = pixel.y});
    push({.kind = InputKind::MouseButton, .code = 0, .pressed = true});
    push({.kind = InputKind::MouseButton, .code = 0, .pressed = false});
    drain();
}

void Driver::hold(Modifiers modifiers, bool pressed) {
    const std::pair<bool, int> keys[] = {{modifiers.control(), key::kLeftControl},
                                         {modifiers.shift(), key::kLeftShift},
                                         {modifiers.alt(), key::kLeftAlt}};
    for (const auto &[wanted, which] : keys) {
        if (wanted) {
            push({.kind = InputKind::Key,
                  .code = which,
                  .pressed = pressed,
                  .modifiers = pressed ? modifiers : Modifiers{}});
        }
    }
}

void Driver::drag(Pixel from, Pixel to, int steps, Modifiers modifiers) {
    hold(modifiers, true);
    press(from);
    for (int i = 1; i <= steps; ++i) {
        moveTo(glm::mix(from, to, static_cast<double>(i) / steps));
    }
    release(to);
    hold(modifiers, false);
    drain();
}

void Driver::scroll(Pixel pixel, double steps) {
    push({.kind = InputKind::MouseMove, .x = pixel.x, .y = pixel.y});
    push({.kind = InputKind::Scroll, .y = steps});
    drain();
}

void Driver::key(int code, Modifiers modifiers) {
    hold(modifiers, true);
    push({.kind = InputKind::Key, .code = code, .pressed = true, .modifiers = modifiers});
    push({.kind = InputKind::Key, .code = code, .pressed = false, .modifiers = modifiers});
    hold(modifiers, false);
    drain();
}

void Driver::type(std::string_view text) {
    for (const char c : text) {
        push({.kind = InputKind::Text, .code = static_cast<unsigned char>(c)});
    }
    drain();
}

void Driver::keys(std::string_view text) {
    for (const char c : text) {
        const int code = c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
        push({.kind = InputKind::Key, .code = code, .pressed = true});
        push({.kind = InputKind::Text, .code = static_cast<unsigned char>(c)});
        push({.kind = InputKind::Key, .code = code, .pressed = false});
    }
    drain();
}

bool Driver::script(std::string_view commands) {
    std::istringstream lines{std::string(commands)};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string verb, rest;
        words >> verb;
        std::getline(words >> std::ws, rest);
        bool done = true;
        if (verb == "click") {
            done = click(rest);
        } else if (verb == "type") {
            type(rest);
        } else if (verb == "settle") {
            settle();
        } else if (verb == "key") {
            Shortcut found;
            for (int code = 32; code < 302 && found.key == 0; ++code) {
                for (std::uint8_t bits = 0; bits < 8; ++bits) {
                    const Shortcut candidate{code, {bits}};
                    found = toString(candidate) == rest ? candidate : found;
                }
            }
            done = found.key != 0;
            key(found.key, found.modifiers);
        } else if (!verb.empty()) {
            done = false;
        }
        CHECK_MESSAGE(done, "script: " << line);
        if (!done) {
            return false;
        }
    }
    return true;
}

Driver::Picture Driver::picture() {
    platform_->show(true);
    editor_->frame();
    editor_->frame(); // labels leave room for the legends of the last frame
    platform_->show(false);
    platform_->makeCurrent();
    return {platform_->framebufferSize(), platform_->pixels()};
}

PixelRect Driver::canvas() const {
    return editor_->context().view.camera.viewport;
}

std::size_t Driver::Picture::differences(const Picture &other, const PixelRect &area) const {
    if (!(size == other.size)) {
        return rgba.size();
    }
    std::size_t count = 0;
    for (int y = static_cast<int>(area.y); y < static_cast<int>(area.y + area.height); ++y) {
        for (int x = static_cast<int>(area.x); x < static_cast<int>(area.x + area.width); ++x) {
            const std::size_t at =
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x));
            const bool same =
                rgba[at] == other.rgba[at] && rgba[at + 1] == other.rgba[at + 1] && rgba[at + 2] == other.rgba[at + 2];
            count += same ? 0 : 1;
        }
    }
    return count;
}

std::size_t Driver::Picture::differences(const Picture &other) const {
    return differences(other, {0, 0, static_cast<double>(size.width), static_cast<double>(size.height)});
}

} // namespace forefront::test
