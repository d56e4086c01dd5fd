#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The order of the lines around nodes at which very many end. Of the lines that end where a line does, only the next
/// one on each side can face it, as far as that reaches; without this, all of them would be measured from each.
class CrowdedNodes {
  public:
    /// `segments`: the segments of the domain, then its lone points; they must outlive this.
    CrowdedNodes(const Domain &domain, std::span<const PlacedSegment> segments);

    /// The lines that cannot face a part of a line, because the next one to it lies between.
    class Hidden {
      public:
        bool any() const { return ends_[0].node != kNoIndex || ends_[1].node != kNoIndex; }
        /// Returns true for the line at a position if it is hidden.
        bool contains(std::uint32_t position, const PlacedSegment &line, const DomainSegment &ends) const;

      private:
        friend class CrowdedNodes;
        struct End {
            std::uint32_t node = kNoIndex;                            ///< kNoIndex: nothing is hidden
            std::array<std::uint32_t, 2> next = {kNoIndex, kNoIndex}; ///< positions of the next on the left and right
            std::array<bool, 2> hides = {false, false};
        };
        Vec2 direction_; ///< of the line
        std::array<End, 2> ends_;
    };
    /// Returns the lines hidden from the part from a to b of the line at a position.
    Hidden hiddenFrom(std::uint32_t position, Vec2 a, Vec2 b) const;

  private:
    const Domain &domain_;
    std::span<const PlacedSegment> segments_;
    /// Per position: of the start and the end, the positions of the next lines on the left and right; empty without
    /// crowded nodes.
    std::vector<std::array<std::array<std::uint32_t, 2>, 2>> next_;
};

} // namespace forefront
