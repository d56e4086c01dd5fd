#pragma once

#include "core/drawing_files/project/project.hpp"
#include "tests/ui/edit_driver.hpp"

#include <doctest/doctest.h>

#include <deque>
#include <set>
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
    void touch(std::string_view widget, int clicks = 1) {
        finish();
        const WidgetRegistry::Widget *const found = context().widgets.find(widget);
        const std::string name(widget);
        REQUIRE_MESSAGE(found != nullptr, name);
        const Pixel at = found->rect.centre();
        add({.kind = InputKind::MouseMove, .x = at.x, .y = at.y}, 0.0);
        for (int k = 0; k < clicks; ++k) {
            add({.kind = InputKind::MouseButton, .pressed = true}, k == 0 ? 0.0 : 0.06);
            add({.kind = InputKind::MouseButton}, 0.04);
        }
        rest();
    }
    /// Waits until all that was typed has had its effect.
    void finish() {
        deliver();
        settle();
    }
    /// Waits until all that was typed has been taken.
    void deliver() {
        while (!typed_.empty() || !editor().input().empty()) {
            while (!typed_.empty() && typed_.front().first <= platform().now()) {
                editor().input().push(typed_.front().second);
                typed_.pop_front();
            }
            frames(1);
            noteField();
        }
    }
    /// Presses the button at a place of the canvas, and moves the pointer by some pixels.
    void grab(Vec2 place, Pixel by) {
        finish();
        const Pixel from = pixel(place);
        add({.kind = InputKind::MouseMove, .x = from.x, .y = from.y}, 0.0);
        add({.kind = InputKind::MouseButton, .pressed = true}, 0.0);
        held_ = from + by;
        add({.kind = InputKind::MouseMove, .x = held_.x, .y = held_.y}, 0.04);
        if (!slow_) {
            deliver(); // what follows the pointer may be drawn in every frame
        }
    }
    /// Releases the button.
    void drop() {
        add({.kind = InputKind::MouseMove, .x = held_.x, .y = held_.y}, 0.0);
        add({.kind = InputKind::MouseButton}, 0.04);
        rest();
    }
    /// Returns the fields that were typed into so far.
    const std::set<std::string> &fields() const { return fields_; }
    bool slow() const { return slow_; }
    std::string drawing() {
        finish();
        return projectText(document());
    }

  private:
    void noteField() {
        const FieldFocus &focus = context().widgets.fields;
        if (!focus.entry && !focus.focused().empty()) {
            fields_.insert(focus.focused()); // one that commits every character
        } else if (focus.entry && focus.entry->text != focus.entry->initial) {
            fields_.insert(focus.entry->name);
        }
    }
    void add(InputEvent event, double after) {
        clock_ = std::max(clock_, platform().now()) + after;
        event.time = clock_;
        typed_.emplace_back(clock_, std::move(event));
    }
    void rest() {
        if (!slow_) {
            finish();
        }
    }

    bool slow_;
    double clock_ = 0.0;
    Pixel held_{};
    std::set<std::string> fields_;
    std::deque<std::pair<double, InputEvent>> typed_; ///< with the time when they are typed
};

} // namespace forefront::test
