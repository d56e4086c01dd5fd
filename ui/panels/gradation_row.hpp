#pragma once

#include "ui/panels/slider_drag.hpp"

namespace forefront {

struct Shell;

/// Draws the gradation in the Spacing panel: a number, and a slider that the node spacing and the live mesh follow
/// while it is dragged. A drag is one undo step; Esc takes it back.
class GradationRow {
  public:
    void draw(Shell &context);

  private:
    void drawSlider(Shell &context);

    SliderDrag drag_{"gradation slider"};
};

} // namespace forefront
