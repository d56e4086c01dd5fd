#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/picking/pick_index.hpp"
#include "ui/input/pixels.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace forefront {

struct Shell;

/// The drag of a guide: a new one out of a ruler, or one that exists. It snaps like nodes do. One undo step.
class GuideDrag {
  public:
    bool active() const { return index_.has_value(); }
    /// Begins with a new guide under the pointer.
    void beginNew(Shell &context, bool upright, Pixel pointer);
    /// Begins with a guide of the document.
    void begin(Shell &context, std::size_t index);
    /// Moves the guide to the pointer; `off`: without snapping.
    void update(Shell &context, Pixel pointer, bool off);
    /// Ends the drag: back at its ruler, outside the canvas, the guide is removed.
    void finish(Shell &context, Pixel pointer);
    /// Ends the drag and leaves the document as it was.
    void cancel(Shell &context);

  private:
    void beginStroke(Shell &context);

    std::optional<std::size_t> index_; ///< of the guide while it is dragged
    bool upright_ = false, fresh_ = false;
    std::string stroke_;
    std::uint64_t strokes_ = 0;
    std::shared_ptr<const PickIndex> targets_; ///< of the document when the drag began
};

/// Returns the guide within a distance of a place, the nearest one; none if guides are hidden.
std::optional<std::size_t> guideAt(const Shell &context, Vec2 place, double reach);

} // namespace forefront
