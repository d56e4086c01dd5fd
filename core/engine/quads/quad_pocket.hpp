#pragma once

#include "core/engine/quads/quad_workspace.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// Some elements of one face that make up a disc: their outline is one loop, without tagged edges and fixed nodes
/// inside.
class QuadPocket {
  public:
    /// Begins with one element. Refers to the mesh.
    QuadPocket(const QuadWorkspace &mesh, std::uint32_t cell);

    std::span<const std::uint32_t> cells() const { return cells_; }
    /// Returns the nodes of the outline, counter-clockwise as the elements are numbered.
    std::span<const std::uint32_t> outline() const { return outline_; }
    /// Returns the number of triangles among the elements.
    std::size_t triangles() const;
    bool holds(std::uint32_t cell) const;

    /// Adds the neighbours that leave it a disc, one ring of them, as far as its outline has at most `limit` nodes.
    /// `first`: elements that are added before the others. Returns false if there are none.
    bool grow(std::size_t limit, std::span<const std::uint32_t> first);
    /// Returns true if two nodes of the outline have a common edge outside.
    bool joinedOutside(std::uint32_t a, std::uint32_t b) const;

  private:
    bool add(std::uint32_t cell, std::size_t limit);
    std::optional<std::vector<std::uint32_t>> findOutline() const;

    const QuadWorkspace &mesh_;
    std::vector<std::uint32_t> cells_, outline_;
};

} // namespace forefront
