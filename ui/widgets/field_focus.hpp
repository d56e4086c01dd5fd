#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Tracks which text field has the focus, the text being typed into it, and the next field for Tab. Dear ImGui 1.86
/// moves with Tab only within one window, and loses the typed text when another widget takes the focus.
class FieldFocus {
  public:
    /// The text being typed; it takes effect when the field is left.
    struct Entry {
        std::string name;
        std::string initial; ///< text of the field when it was entered
        std::string text;
    };

    void beginFrame() {
        order_.clear();
        committed.clear();
    }
    /// Finds the next field for Tab. Call when all fields of the frame are drawn.
    void endFrame();
    /// Registers a field; Tab stays within its `group`, the window around it.
    void drawn(std::string_view name, unsigned group) { order_.push_back({std::string(name), group}); }

    /// Reports that Tab was pressed in the field `name`.
    void tab(std::string_view name, bool back);
    /// Reports that Tab was pressed in a group of fields none of which has the focus.
    void tabInto(unsigned group, bool back);
    /// Gives the field `name` the focus when it is drawn within the next frames, as when its dialog opens.
    void request(std::string_view name);
    /// Returns true once, in the frame in which the field must take the focus.
    bool takes(std::string_view name);
    /// Reports that the field has the focus.
    void gotFocus(std::string_view name);
    /// Gives the focus to a switch, which Dear ImGui does not do without its keyboard navigation; empty: to none.
    void hold(std::string_view name) { held_ = name; }
    /// Returns the switch that has the focus; empty: none.
    const std::string &held() const { return held_; }
    /// Returns true while the focus is moving to a field. Input must wait for it, or keys would be taken for shortcuts.
    bool travelling() const { return !wanted_.empty(); }

    /// Makes the field with the focus commit its text and give up the focus.
    void leave() { leaving_ = true; }
    bool leaving() const { return leaving_; }

    std::optional<Entry> entry;
    /// The field whose text was last committed in this frame; empty: none, or the widgets of the frame are drawn.
    std::string committed;

    /// A field that was clicked with the right button, for the menu that opens there.
    struct Clicked {
        std::string name;
        std::string text;
        std::string value;              ///< of the formula in the field; empty: it holds none
        std::size_t begin = 0, end = 0; ///< selected part of the text; all of it if nothing was selected
    };
    std::optional<Clicked> clicked;

    /// Gives a field another text when it is drawn within the next frames, as if it had been typed.
    void replace(std::string_view name, std::string text);
    /// Returns the text that replaces the text of a field, once.
    std::optional<std::string> replacement(std::string_view name);

  private:
    struct Field {
        std::string name;
        unsigned group = 0;
    };

    bool inSight(std::string_view name) const;
    void followTab();

    std::vector<Field> order_; ///< fields of this frame as they were drawn
    std::optional<std::string> tabbed_;
    std::optional<unsigned> tabbedInto_;
    bool back_ = false;
    std::string held_;
    std::string wanted_;   ///< empty: none
    bool asked_ = false;   ///< Dear ImGui was asked to give it the focus
    int framesLeft_ = 0;   ///< frames until the request is dropped
    std::string replaced_; ///< field that gets another text; empty: none
    std::string with_;
    int framesToReplace_ = 0;
    bool leaving_ = false;
};

} // namespace forefront
