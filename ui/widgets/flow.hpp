#pragma once

#include "ui/widgets/widget_context.hpp"

namespace forefront::ui {

/// Lays out items side by side and starts a new row when the next one no longer fits. An item is everything drawn until
/// the next one begins; its width is taken from the last frame.
class Flow {
  public:
    /// `room` is the width of a row, `gap` the distance between items, in pixels.
    Flow(WidgetContext &context, float room, float gap) : context_(context), room_(room), gap_(gap) {}
    ~Flow() { end(); }
    Flow(const Flow &) = delete;
    Flow &operator=(const Flow &) = delete;

    /// Begins an item; its name is unique among those of the window.
    void item(const char *name);
    float room() const { return room_; }

  private:
    void end();

    WidgetContext &context_;
    float room_, gap_;
    float used_ = 0.0F;      ///< width of the row so far
    unsigned int begun_ = 0; ///< key under which Dear ImGui stores the width of the current item; 0: none
};

} // namespace forefront::ui
