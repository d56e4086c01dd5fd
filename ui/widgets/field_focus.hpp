#pragma once

#include <cstddef>
#include <cstdint>
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
        std::string initial; ///< text of the field when it was entered; Esc restores it
        std::string text;
        std::string hint{}; ///< shown in place of an empty text
    };

    void beginFrame() {
        order_.clear();
        committed.clear();
        focused_.clear();
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
    /// Returns the field that had the focus when it was drawn in this frame; empty: none.
    const std::string &focused() const { return focused_; }
    /// Gives the focus to a switch, which Dear ImGui does not do without its keyboard navigation; empty: to none.
    void hold(std::string_view name) { held_ = name; }
    /// Returns the switch that has the focus; empty: none.
    const std::string &held() const { return held_; }
    /// Returns true while the focus is moving to a field. Input must wait for it, or keys would be taken for shortcuts.
    bool travelling() const { return !wanted_.empty() || (refused_ && refused_->returns); }
    /// Returns true if the field is to take the focus.
    bool wants(std::string_view name) const { return !wanted_.empty() && wanted_ == name; }

    /// Why the field with the focus is to commit its text and give up the focus.
    enum class Leave : std::uint8_t { No, Shortcut, Click };
    void leave(Leave why) { leaving_ = why; }
    Leave leaving() const { return leaving_; }

    std::optional<Entry> entry;
    /// The field whose text was last committed in this frame; empty: none, or the widgets of the frame are drawn.
    std::string committed;
    /// Records what a field commits in this frame, in case it is refused. `tookFocus`: another widget has the focus.
    void commit(Entry what, bool tookFocus);

    /// A text that was refused. Its field goes on showing it, and the old value stays in effect.
    struct Refused {
        Entry entry;
        bool returns = false; ///< its field is about to take the focus back
    };
    /// Refuses the text that the field `name` committed in this frame: the field keeps it and, unless the user went on
    /// to another widget, the focus and the caret. Does nothing if the field has committed nothing.
    void refuse(std::string_view name);
    /// Returns the refused text that the field shows; null if there is none.
    const Refused *refused(std::string_view name) const;
    /// Reports that the field of the refused text has the focus again.
    void returned() { refused_->returns = false; }
    /// Forgets the refused text of the field; it shows its value again.
    void forgive(std::string_view name);

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
    void replaceMissing();

    std::vector<Field> order_; ///< fields of this frame as they were drawn
    std::optional<std::string> tabbed_;
    std::optional<unsigned> tabbedInto_;
    bool back_ = false;
    std::string held_, focused_;
    std::string wanted_;            ///< empty: none
    int asked_ = 0;                 ///< frames until Dear ImGui may be asked again to give it the focus
    int framesLeft_ = 0;            ///< frames until the request is dropped
    std::vector<std::string> next_; ///< fields that take its place if it is no longer drawn
    std::optional<Refused> refused_;
    std::optional<Entry> commit_; ///< in this frame
    bool tookFocus_ = false;      ///< another widget had the focus when it was committed
    std::string replaced_;        ///< field that gets another text; empty: none
    std::string with_;
    int framesToReplace_ = 0;
    Leave leaving_ = Leave::No;
};

} // namespace forefront
