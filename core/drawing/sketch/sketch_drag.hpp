#pragma once

#include "core/drawing/sketch/sketch_system.hpp"

#include <memory>
#include <span>
#include <vector>

namespace forefront {

/// An unknown that is pulled to a value.
struct SketchPull {
    std::uint32_t unknown = 0;
    double value = 0.0;
    bool firm = true; ///< gets this value exactly, bit for bit, where there is a solution near by
};

/// A drag of unknowns of a sketch that holds. Each step gives the solution nearest to where the drag began, with the
/// pulled unknowns at their values, or near them where the equations do not let them go there; so the way back leads to
/// the same sketch. Corrections of the step before would drift, and flip every seventh sketch.
class SketchDrag {
  public:
    explicit SketchDrag(SketchSystem start);
    ~SketchDrag();
    SketchDrag(SketchDrag &&) noexcept;
    SketchDrag &operator=(SketchDrag &&) noexcept;

    /// Pulls unknowns, the same in every step. Returns false, and keeps the values of the step before, where no
    /// solution is found. If all are at their values of the start, so is the sketch, bit for bit.
    bool pull(std::span<const SketchPull> pulls);
    /// Returns the values after the last step that was solved.
    const std::vector<double> &values() const;

  private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace forefront
