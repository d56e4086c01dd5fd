#pragma once

#include "core/engine/mesh/edge_table.hpp"

#include <vector>

namespace forefront {

/// The sectors of elements around nodes of a mesh between cut edges and the boundary. A corner of an element is the
/// half-edge that starts there.
class CrackSectors {
  public:
    /// `cut`: per half-edge, whether elements are separated there. `chosen`: per node, whether its sectors are found.
    CrackSectors(const EdgeTable &table, const std::vector<bool> &cut, const std::vector<bool> &chosen);

    /// Returns the lowest corner of the sector that a corner at a chosen node belongs to.
    HalfEdge sectorOf(HalfEdge corner) const {
        while (parent_[corner] != corner) {
            corner = parent_[corner];
        }
        return corner;
    }

  private:
    void join(HalfEdge a, HalfEdge b);

    std::vector<HalfEdge> parent_; ///< per corner; the parent has a lower number
};

} // namespace forefront
