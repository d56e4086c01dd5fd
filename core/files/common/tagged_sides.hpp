#pragma once

#include "core/engine/mesh/mesh_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A side of an element, as CellTraits numbers its edges.
struct ElementSide {
    std::uint32_t element;
    std::uint32_t side;
    bool along; ///< it runs in the direction of the tagged edge
};

/// The sides of elements along the tagged edges of a mesh.
class TaggedSides {
  public:
    explicit TaggedSides(const MeshView &mesh);

    /// Returns the sides along a tagged edge, ascending; empty if it is a side of no element.
    std::span<const ElementSide> of(std::size_t edge) const {
        return std::span(sides_).subspan(offsets_[edge], offsets_[edge + 1] - offsets_[edge]);
    }

  private:
    std::vector<std::size_t> offsets_; ///< per edge, where its sides begin; then their number
    std::vector<ElementSide> sides_;
};

} // namespace forefront
