#pragma once

#include "core/drawing/document/document.hpp"

#include <cstddef>
#include <memory>

namespace forefront {

struct Shell;

/// The rows of the inspector for the sketch: the constraints on the selected shapes and their parts, with the value of
/// dimensions, and how much the sketch leaves free.
class ConstraintRows {
  public:
    void draw(Shell &context);

  private:
    /// Returns the degrees of freedom of the sketch, found again after a change once no mouse button is down.
    std::size_t degrees(const Shell &context);

    std::shared_ptr<const Document> measured_; ///< whose degrees_ these are
    std::size_t degrees_ = 0;
};

} // namespace forefront
