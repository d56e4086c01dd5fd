#pragma once

#include "ui/widgets/widget_context.hpp"

#include <string_view>

struct ImGuiStorage;

namespace forefront::ui {

/// Lays out items side by side and starts a new row when the next one no longer fits. An item is everything drawn until
/// the next one begins; its width is taken from the last frame.
class Flow {
  public:
    /// `room` is the width of a row, `gap` the distance between items, in pixels. With `overflow`, there is a single
    /// row: labels are left out if everything fits only without them; else what does not fit goes to the window of
    /// Dear ImGui with that name, one item below the other.
    Flow(WidgetContext &context, float room, float gap, const char *overflow = nullptr);
    ~Flow() { end(); }
    Flow(const Flow &) = delete;
    Flow &operator=(const Flow &) = delete;

    /// Begins an item; its name is unique among those of the window.
    void item(const char *name);
    /// Draws the label in front of a field, unless labels are left out. The tooltip of the field must say what it is.
    void label(std::string_view text);
    /// Draws a short name in front of a field that has equals beside it; it is never left out.
    void name(std::string_view text);
    float room() const { return room_; }
    /// Returns the width of the row so far, in pixels.
    float used() const { return used_; }
    /// Returns true if the items begun so far do not all fit into the row of a flow with overflow.
    bool overflows() const { return overflows_; }
    /// Ends the last item; the next thing drawn is none.
    void finish();

  private:
    void beginInRow();
    void end();

    WidgetContext &context_;
    float room_, gap_;
    const char *overflow_;
    bool overflows_ = false;
    bool labels_ = true;
    float used_ = 0.0F;              ///< width of the row so far
    float whole_ = 0.0F;             ///< width of all items in one row, with the labels that are drawn
    float leftOut_ = 0.0F;           ///< width of the labels that are not
    float labelled_ = 0.0F;          ///< width of all labels
    ImGuiStorage *widths_ = nullptr; ///< of the items of a single row; null: that of the current window
    unsigned int begun_ = 0;         ///< key under which Dear ImGui stores the width of the current item; 0: none
};

} // namespace forefront::ui
