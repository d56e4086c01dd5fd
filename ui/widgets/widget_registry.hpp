#pragma once

#include "ui/input/pixels.hpp"
#include "ui/widgets/field_focus.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace forefront {

/// Finds the widgets of the last frame by name, for scripts and tests.
class WidgetRegistry {
  public:
    struct Widget {
        PixelRect rect;
        bool enabled = true;
        bool visible = true;             ///< not scrolled or clipped away
        std::optional<PixelRect> clip{}; ///< the part of its window that shows it; not set: all of the window
    };
    using Map = std::map<std::string, Widget, std::less<>>;

    void beginFrame() {
        current_.clear();
        fields.beginFrame();
    }
    void endFrame() {
        last_.swap(current_);
        fields.endFrame();
    }
    void add(std::string_view name, const Widget &widget) { current_.insert_or_assign(std::string(name), widget); }
    /// Returns a widget of the last complete frame, or null if it was not drawn.
    const Widget *find(std::string_view name) const {
        const auto found = last_.find(name);
        return found == last_.end() ? nullptr : &found->second;
    }
    const Map &all() const { return last_; }

    FieldFocus fields;
    /// Widgets that scroll into view when they are drawn; for the frames of a change, so that users can scroll on.
    std::set<std::string, std::less<>> revealed;

  private:
    Map current_, last_;
};

} // namespace forefront
