#pragma once

namespace forefront {

struct Shell;

/// Draws the gradation in the Spacing panel: a number, and a slider that the node spacing and the live mesh follow
/// while it is dragged. A drag is one undo step; Esc takes it back.
class GradationRow {
  public:
    void draw(Shell &context);

  private:
    void drawSlider(Shell &context);

    bool dragged_ = false;   ///< the slider has changed the gradation, and the button is still down
    bool cancelled_ = false; ///< Esc was pressed; the button is still down
};

} // namespace forefront
