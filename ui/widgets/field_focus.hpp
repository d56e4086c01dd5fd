#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Which text field has the keyboard, what is being typed into it, and where Tab leads. Dear ImGui 1.86 tabs only
/// within one window, and forgets what was typed when another widget takes the focus.
class FieldFocus {
  public:
    /// What is being typed. It counts once the field is left.
    struct Entry {
        std::string name;
        std::string initial; ///< what stood in the field when it was entered
        std::string text;
    };

    void beginFrame() { order_.clear(); }
    /// All fields of the frame are known: Tab finds its neighbour.
    void endFrame();
    /// A field is drawn; `group`: the window around it, within which Tab stays.
    void drawn(std::string_view name, unsigned group) { order_.push_back({std::string(name), group}); }

    /// Tab was pressed in the field `name`.
    void tab(std::string_view name, bool back);
    /// True once: the field is to take the focus in this frame.
    bool takes(std::string_view name);
    /// The field has the focus.
    void arrived(std::string_view name);
    /// The focus is on its way to a field: input waits and frames are drawn, or keys would be taken for shortcuts.
    bool travelling() const { return !wanted_.empty(); }

    /// The field that has the focus takes what was typed and lets go.
    void leave() { leaving_ = true; }
    bool leaving() const { return leaving_; }

    std::optional<Entry> entry;

  private:
    struct Field {
        std::string name;
        unsigned group = 0;
    };

    bool inSight(std::string_view name) const;

    std::vector<Field> order_; ///< fields of this frame as they were drawn
    std::optional<std::string> tabbed_;
    bool back_ = false;
    std::string wanted_; ///< empty: none
    bool asked_ = false; ///< Dear ImGui was asked to give it the focus
    int patience_ = 0;   ///< frames until the wish is dropped
    bool leaving_ = false;
};

} // namespace forefront
