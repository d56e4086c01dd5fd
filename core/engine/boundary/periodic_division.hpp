#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/boundary/curve_cuts.hpp"
#include "core/engine/domain/periodic_sides.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace forefront {

/// Which segments are divided like others, and by which spacing. Refers to the domain, the spacing and the sides.
class PeriodicDivision {
  public:
    /// `sides`: null or empty: each segment is divided by itself.
    PeriodicDivision(const Domain &domain, const SpacingField &spacing, const PeriodicSides *sides);

    /// Returns the segment whose division a segment gets: itself, or the one that it is an image of.
    std::uint32_t leader(std::uint32_t segment) const { return follows(segment) ? mate(segment) : segment; }
    bool follows(std::uint32_t segment) const { return ties(segment) && sides_->mates[segment].follows; }
    bool ties(std::uint32_t segment) const { return sides_ != nullptr && sides_->ties(segment); }
    std::uint32_t mate(std::uint32_t segment) const { return sides_->mates[segment].segment; }
    bool reversed(std::uint32_t segment) const { return ties(segment) && sides_->mates[segment].reversed; }

    /// Returns the spacing along a segment that leads: the smaller one of both parts.
    const SpacingField &spacing(std::uint32_t segment) const;
    /// Returns the place on a segment that follows, or p itself on others. `p`: on its leader.
    Vec2 image(std::uint32_t segment, Vec2 p) const;

    /// Returns the chain that a chain is divided like, itself if it leads; kNoIndex: another number of its segments
    /// meet others than of the chain that it is tied to.
    std::uint32_t leadingChain(const CurveCuts &curves, std::uint32_t chain) const;
    /// Returns true if the parameters of the chain that a chain is tied to run against its own.
    bool chainReversed(const CurveCuts &curves, std::uint32_t chain) const;
    /// Returns the cuts of a chain that follows, from those of its leader.
    std::vector<double> mirroredCuts(const CurveCuts &curves, std::uint32_t leader, std::uint32_t follower) const;
    /// Adds the pieces that lie on the other parts.
    void addMirrored(const CurveCuts &curves, std::vector<ChainPiece> &pieces) const;

    /// Returns the fault of a curve whose leadingChain() is kNoIndex.
    static Status crossedElsewhere(Vec2 at);

  private:
    bool matches(const CurveCuts &curves, std::uint32_t chain, std::uint32_t other) const;
    std::uint32_t tiedChain(const CurveCuts &curves, std::uint32_t chain) const;

    const Domain &domain_;
    const SpacingField &spacing_;
    const PeriodicSides *sides_;
    std::vector<std::unique_ptr<const SpacingField>> paired_; ///< per link
};

} // namespace forefront
