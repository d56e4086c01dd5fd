#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/divide_at_joints.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>

namespace forefront {

/// Tells the user where shapes that nearly meet were joined in the domain of a drawing, and where not.
class JointNotes {
  public:
    JointNotes(const Document &document, const Domain &domain) : document_(document), domain_(domain) {}

    /// Adds a note on joints of nodes that were drawn up to this far from each other or from sides; none if that is no
    /// more than rounding.
    void joined(double farthest, Diagnostics &notes) const;
    /// Warns of a node beside a curve. `shape`: index of the curve's shape.
    void beside(const NodeBesideCurve &node, std::uint32_t shape, Diagnostics &notes) const;
    /// Warns of a line along a side of a shape, given by its index, with which it was not joined. Once for each shape.
    void along(std::uint32_t shape, Diagnostics &notes) const;

  private:
    const Document &document_;
    const Domain &domain_;
};

} // namespace forefront
