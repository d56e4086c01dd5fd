#pragma once

#include "core/engine/mesher/fan.hpp"
#include "core/engine/mesher/front_update.hpp"

namespace forefront {

/// The fast method: takes bases by length class and walks from each along its loop. Where a base and its neighbours on
/// the loop make ordinary angles, one new node serves two or three of them at once. A sharp corner is closed. All other
/// bases, and those for which these simple cases fail, go through the search of the ten steps. The closing guarantee is
/// that of the ClassicAdvancer: fans keep as far from Γ as its ideal points, and their nodes are never small.
///
/// It works strip by strip, see FrontStrips. A base whose search leaves its strip is left to a later strip.
template <class Grid, class Trace>
class FastAdvancer {
  public:
    /// Cell width of the HierarchicalGrid, in segment lengths. Large, since its queries skip distant segments at little
    /// cost, and segments that stay in one cell are cheaper to change. Measured: graded meshes are 3 % faster than with
    /// 10; more makes no difference.
    static constexpr double kCellPerLength = 12.0;

    FastAdvancer(FrontState &state, Grid &grid, const SpacingField &spacing, Trace trace)
        : state_(state), trace_(trace), fans_(state, grid, spacing, trace_),
          search_(state, grid, spacing, trace_, Ties::Exact, FrontRules{}), update_(state, grid, &spacing),
          spacing_(spacing) {}
    FastAdvancer(const FastAdvancer &) = delete; // its parts share one trace
    FastAdvancer &operator=(const FastAdvancer &) = delete;

    /// Prepares the state for a new run: the node spacing at the nodes of Γ and the bases of the first strip.
    static void prepare(FrontState &state, const DiscreteDomain &boundary, const SpacingField &spacing,
                        double perStrip = FrontStrips::kPerStrip);

    /// Makes one to three elements, or defers a base. Returns false when no strip has a base left: Γ = ∅.
    bool advance(AdvanceDelta &delta);
    /// Undoes the last advance, exactly. The log must have been kept.
    void retreat(const AdvanceDelta &delta);
    /// Starts or stops keeping the log that retreat() needs.
    void keepLog(bool keep) { state_.walkOrder.keepLog(keep); }

  private:
    enum class Outcome : std::uint8_t { Done, LeftToLaterStrip };

    SlotId nextBase();
    void offerStrip();
    Outcome tryBase(SlotId slotA, AdvanceDelta &delta);
    bool trySimple(const Base &base, AdvanceDelta &delta, Vec2 &apex);
    bool tryFan(SlotId first, unsigned segments, AdvanceDelta &delta, Vec2 &apex);
    bool makeFan(const Fan &fan, AdvanceDelta &delta, Vec2 &apex);
    bool tryCorner(const Base &base, SlotId first, AdvanceDelta &delta, Vec2 &apex);
    Outcome searchApex(Base &base, AdvanceDelta &delta, Vec2 &apex);
    bool mayConnect(const Candidate &apex) const;
    double cosine(SlotId corner) const;
    bool similar(SlotId first, unsigned segments) const;
    void continueWalk(const AdvanceDelta &delta);
    const Box2 *limits() const;

    FrontState &state_;
    Trace trace_;
    FanBuilder<Grid, Trace> fans_;
    ApexSearch<Grid, Trace> search_;
    FrontUpdate<Grid> update_;
    const SpacingField &spacing_;
    /// The segments of Γ inside each strip of a phase, so that not every strip has to look at all of Γ. Advances in
    /// other strips of the phase do not change them. Empty until the first strip is entered.
    std::vector<std::vector<SlotId>> inStrips_;
    std::uint32_t listedFrom_ = 0; ///< the strip entered when the lists were made
};

/// Offers the segments of Γ that lie in the box to the order, sorted by their nodes so that slots do not matter.
void offerAll(WalkOrder &order, const GenerationFront &front, const Box2 &box);

} // namespace forefront
