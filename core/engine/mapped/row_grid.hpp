#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/vec2.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {

/// The nodes of a face in rows: (along + 1) by (across + 1) places. Seen along the first index, the second one counts
/// to the left, so that the cells with corners (i, j), (i+1, j), (i+1, j+1), (i, j+1) are counter-clockwise. The places
/// with i = 0 may all be equal.
class RowGrid {
  public:
    RowGrid(std::size_t along, std::size_t across)
        : along_(along), across_(across), places_((along + 1) * (across + 1)) {}

    std::size_t along() const { return along_; }
    std::size_t across() const { return across_; }
    Vec2 &at(std::size_t i, std::size_t j) { return places_[i * (across_ + 1) + j]; }
    Vec2 at(std::size_t i, std::size_t j) const { return places_[i * (across_ + 1) + j]; }

    /// Sets the inner places by transfinite interpolation of the outer ones.
    void interpolate();

    using Cell = std::pair<std::size_t, std::size_t>;
    /// Returns the first cell that is not convex; with `triangles`, that no diagonal divides into two triangles that
    /// are counter-clockwise. Exact.
    std::optional<Cell> invertedCell(bool triangles) const;
    Vec2 cellCentre(Cell cell) const;

    /// Moves the inner places towards a solution of Winslow's equations until no cell is inverted. Returns false if one
    /// remains, or once cancelled.
    bool smoothUntilValid(bool triangles, const Progress &progress = {});

    /// Returns true if the diagonal from (i, j) divides a cell into the better triangles, by their least angle.
    bool firstDiagonal(std::size_t i, std::size_t j) const;

  private:
    std::array<Vec2, 4> corners(std::size_t i, std::size_t j) const {
        return {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
    }
    void smoothOnce();

    std::size_t along_, across_;
    std::vector<Vec2> places_;
};

} // namespace forefront
