#pragma once

#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"

#include <deque>
#include <string>
#include <string_view>
#include <utility>

namespace forefront::test {

/// Types like a person, who does not wait for frames: a key every 60 ms, released 40 ms later. With `slow` frames of
/// 300 ms several keys arrive per frame; otherwise the editor comes to rest after each.
class Typist : public Draughtsman {
  public:
    explicit Typist(bool slow) : slow_(slow) {
        if (slow_) {
            platform().setFrameSeconds(0.3);
        }
    }

    /// Presses a key without text, such as Tab.
    void tap(int code, Modifiers modifiers = {}) {
        const std::pair<bool, int> held[] = {{modifiers.control(), key::kLeftControl},
                                             {modifiers.shift(), key::kLeftShift},
                                             {modifiers.alt(), key::kLeftAlt}};
        for (const auto &[wanted, which] : held) {
            if (wanted) {
                add({.kind = InputKind::Key, .code = which, .pressed = true}, 0.0);
            }
        }
        add({.kind = InputKind::Key, .code = code, .pressed = true, .modifiers = modifiers}, 0.0);
        add({.kind = InputKind::Key, .code = code, .modifiers = modifiers}, 0.04);
        for (const auto &[wanted, which] : held) {
            if (wanted) {
                add({.kind = InputKind::Key, .code = which}, 0.0);
            }
        }
        clock_ += 0.02;
        rest();
    }
    /// Types characters: each key, then its character.
    void write(std::string_view text) {
        for (const char c : text) {
            const int code = c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
            add({.kind = InputKind::Key, .code = code, .pressed = true}, 0.0);
            add({.kind = InputKind::Text, .code = static_cast<unsigned char>(c)}, 0.0);
            add({.kind = InputKind::Key, .code = code}, 0.04);
            clock_ += 0.02;
            rest();
        }
    }
    /// Clicks a widget that is on the screen when all that was typed has had its effect, and types on at once.
    void touch(std::string_view widget) {
        finish();
        const WidgetRegistry::Widget *const found = context().widgets.find(widget);
        const std::string name(widget);
        REQUIRE_MESSAGE(found != nullptr, name);
        const Pixel at = found->rect.centre();
        add({.kind = InputKind::MouseMove, .x = at.x, .y = at.y}, 0.0);
        add({.kind = InputKind::MouseButton, .pressed = true}, 0.0);
        add({.kind = InputKind::MouseButton}, 0.04);
        rest();
    }
    /// Waits until all that was typed has had its effect.
    void finish() {
        while (!typed_.empty() || !editor().input().empty()) {
            while (!typed_.empty() && typed_.front().first <= platform().now()) {
                editor().input().push(typed_.front().second);
                typed_.pop_front();
            }
            frames(1);
        }
        settle();
    }
    std::string drawing() {
        finish();
        return projectText(document());
    }

  private:
    void add(InputEvent event, double after) {
        clock_ = std::max(clock_, platform().now()) + after;
        typed_.emplace_back(clock_, std::move(event));
    }
    void rest() {
        if (!slow_) {
            finish();
        }
    }

    bool slow_;
    double clock_ = 0.0;
    std::deque<std::pair<double, InputEvent>> typed_; ///< with the time when they are typed
};

} // namespace forefront::test
