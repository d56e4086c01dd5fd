#pragma once

#include "ui/panels/slider_drag.hpp"

#include <cstdint>
#include <memory>

namespace forefront {

struct Document;
struct Shell;

/// Draws the number of elements to aim for in the Spacing panel: a field and a slider. A number scales all element
/// sizes: the slider by the estimate while it is dragged, so that the live mesh follows, and both by meshing in the
/// background afterwards, until the mesh has that number. It is one undo step.
class TargetRow {
  public:
    void draw(Shell &context);

  private:
    void drawSlider(Shell &context);
    void followDrag(Shell &context, bool moved, double knob);

    SliderDrag drag_{"target slider"};
    std::shared_ptr<const Document> base_;    ///< before the drag; null: nothing is dragged
    std::shared_ptr<const Document> dragged_; ///< that the drag has made last
    double baseEstimate_ = 0.0;               ///< number of elements of `base_`
    std::uint64_t target_ = 0;                ///< of the drag
};

} // namespace forefront
