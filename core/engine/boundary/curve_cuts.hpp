#pragma once

#include "core/engine/boundary/spacing_integral.hpp"
#include "core/engine/domain/curve_chains.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace forefront {

/// A piece of a chain: between its cuts `index` - 1 and `index`, where its ends count as cuts.
struct ChainPiece {
    std::uint32_t chain = 0;
    std::uint32_t index = 0;

    friend auto operator<=>(const ChainPiece &, const ChainPiece &) = default;
};

/// The division of a domain's curved chains into pieces.
class CurveCuts {
  public:
    /// `elements`: numbers of elements that curves must have.
    explicit CurveCuts(const Domain &domain, SegmentElements elements = {});

    bool any() const;
    /// Returns the chain of a segment, or kNoIndex if it is straight.
    std::uint32_t chainOf(std::uint32_t segment) const { return chains_.ofSegment[segment]; }
    const CurveChain &chain(std::uint32_t chain) const { return chains_.list[chain]; }
    /// Returns the first of the chain's segments in the order of the domain.
    std::uint32_t firstSegment(std::uint32_t chain) const { return first_[chain]; }
    /// Returns true for nodes that only divide a chain into chords.
    bool vanishes(std::uint32_t node) const { return !inner_.empty() && inner_[node] != 0; }

    /// Returns the parameters of all cuts of a chain, ends included; empty before divide().
    const std::vector<double> &cuts(std::uint32_t chain) const { return cuts_[chain]; }
    const Curve &curve(std::uint32_t chain) const { return domain_.curves[chains_.list[chain].curve]; }
    /// Returns the domain segment that a piece is attributed to: the one at its middle.
    std::uint32_t source(const ChainPiece &piece) const;

    /// Divides a chain by the spacing, or into the number of elements that it must have; `integral` is scratch space;
    /// afterwards it holds the location of a fault, if any.
    SpacingIntegral::Outcome divide(std::uint32_t chain, const SpacingField &spacing, double longest, double limit,
                                    const Progress &progress, SpacingIntegral &integral);
    /// Sets the parameters of all cuts of a chain.
    void setCuts(std::uint32_t chain, std::vector<double> cuts) { cuts_[chain] = std::move(cuts); }
    /// Returns true if one piece between two parameters is close enough to the curve of a chain.
    bool allowsPiece(std::uint32_t chain, double from, double to) const;
    /// Removes the cuts within a distance of an end, as far as the piece there stays close to the curve; none of a
    /// chain with a number of elements, or of a loop.
    void joinEnd(std::uint32_t chain, bool atStart, double length);
    /// Halves pieces. Where a piece is already much finer than the chords of the domain, these are used as straight
    /// segments instead, and the rest of the chain must be divided again. Duplicates in the list count once.
    void refine(std::vector<ChainPiece> pieces);
    /// Returns the segments that were taken as straight, in order.
    std::vector<std::uint32_t> straightened() const;

  private:
    void addChain(CurveChain chain);
    void cutWithBias(std::uint32_t chain, std::uint32_t count);
    bool isFine(const ChainPiece &piece) const;
    void straighten(const ChainPiece &piece);
    void cutOut(std::uint32_t chain);
    void halve(std::span<const ChainPiece> pieces);

    const Domain &domain_;
    SegmentElements elements_;
    double tolerance_;
    std::vector<std::uint8_t> straight_; ///< per segment
    CurveChains chains_;
    std::vector<std::uint8_t> inner_;       ///< per node of the domain; empty without chains
    std::vector<std::uint32_t> first_;      ///< per chain
    std::vector<std::vector<double>> cuts_; ///< per chain
};

} // namespace forefront
