#pragma once

#include "ui/panels/slider_drag.hpp"

#include <cstdint>
#include <memory>

namespace forefront {

struct Document;
struct Shell;

/// A search for the sizes that lead to a number of elements.
struct TargetSearch {
    std::shared_ptr<const Document> base;  ///< whose sizes are scaled
    std::shared_ptr<const Document> shown; ///< the current document when the search began: `base`, or what a drag made
    std::uint64_t target = 0;
};

/// Draws the number of elements to aim for in the Spacing panel: a field and a slider. A number scales all element
/// sizes: the slider by the estimate while it is dragged, so that the live mesh follows, and both by meshing in the
/// background afterwards, until the mesh has that number. It is one undo step.
class TargetRow {
  public:
    void draw(Shell &context);

  private:
    /// The number that was asked for, and the spacing that was found for it.
    struct Asked {
        std::uint64_t number = 0; ///< 0: none
        std::uint64_t loads = 0;  ///< see DocumentStore::loads()
        std::shared_ptr<const Document> found;
    };

    bool isAsked(const Shell &context) const;
    void search(Shell &context, TargetSearch search);
    void drawAsked(Shell &context) const;
    void drawSlider(Shell &context);
    void followDrag(Shell &context, bool moved, double knob);

    SliderDrag drag_{"target slider"};
    std::shared_ptr<const Document> base_;                     ///< before the drag; null: nothing is dragged
    std::shared_ptr<const Document> dragged_;                  ///< that the drag has made last
    double baseEstimate_ = 0.0;                                ///< number of elements of `base_`
    std::uint64_t target_ = 0;                                 ///< of the drag
    std::shared_ptr<Asked> asked_ = std::make_shared<Asked>(); ///< shared with the search for it
};

} // namespace forefront
