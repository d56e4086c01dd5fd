#pragma once

#include "core/mesher/front_state.hpp"
#include "core/mesher/recorder.hpp"
#include "core/spacing/spacing_field.hpp"

#include <vector>

namespace forefront {

/// The front advance after Lo: ten steps, one base segment, at most one element. Γ only ever changes here.
///
/// Closing guarantee. A base first looks for the best of the nearby front nodes and a new node. If none passes it is
/// deferred once; the second time, after a wider search, only existing nodes are taken and the search grows until it
/// covers all of Γ. Γ is a set of polygons with holes that do not cross (exact predicates), and such a set has a
/// triangulation, in which every segment has a visible apex: that last search cannot fail. By Euler's formula the
/// number of elements still needed without new nodes falls by one with each of them. New nodes keep a distance in
/// proportion to the node spacing from Γ, hence from all nodes, so only finitely many fit; those far smaller than the
/// node spacing are counted against FrontState::smallNodesLeft.
template <class Grid, class Trace>
class FrontAdvancer {
  public:
    FrontAdvancer(FrontState &state, Grid &grid, const SpacingField &spacing, double slack, Trace trace)
        : state_(state), grid_(grid), spacing_(spacing), slack_(slack), trace_(trace) {}

    /// Performs steps 2 to 9 once. False when Γ = ∅ (step 10).
    bool advance(AdvanceDelta &delta);
    /// Takes back the last advance, exactly.
    void retreat(const AdvanceDelta &delta);

  private:
    struct Neighbour {
        SlotId slot;
        NodeId nodeA, nodeB;
        Vec2 a, b;
    };
    struct Candidate {
        double score;
        Vec2 position;
        NodeId node; ///< kNoNode: the ideal point
        SlotId slot; ///< kNoSlot: the ideal point
    };
    struct Base {
        SlotId slotA, slotB;
        Vec2 a, b;
        NodeId nodeA, nodeB;
        double length;
        double rho;      ///< clamped
        double fieldRho; ///< as the node spacing function says
        Vec2 ideal;
    };
    struct Limits {
        double radius;
        bool newNodes;
    };

    void evaluateSpacing(Base &base);
    bool findApex(const Base &base, const Limits &limits, Candidate &apex);
    void gather(const Box2 &box);
    void rank(const Base &base, const Limits &limits);
    bool idealIsClear(const Base &base) const;
    double score(const Base &base, Vec2 p) const;
    Verdict test(const Base &base, const Candidate &candidate, std::uint32_t number);
    bool anglesAllow(const Base &base, const Candidate &candidate) const;
    bool crosses(const Base &base, Vec2 from, NodeId fromNode, const Candidate &to, std::uint32_t number);
    bool containsNode(const Base &base, const Candidate &candidate, std::uint32_t number);
    void update(const Base &base, const Candidate &apex, AdvanceDelta &delta);
    void defer(const Base &base, AdvanceDelta &delta);
    void applyNewNode(const Base &base, const Candidate &apex, AdvanceDelta &delta);
    void offer(SlotId id);
    void count(const AdvanceDelta &delta, std::size_t segments, bool forward);

    FrontState &state_;
    Grid &grid_;
    const SpacingField &spacing_;
    double slack_;
    Trace trace_;

    std::vector<std::uint32_t> stamps_; ///< per slot: search in which it was last delivered
    std::uint32_t stamp_ = 0;
    std::vector<Neighbour> neighbours_; ///< of the current search, by slot
    std::vector<SlotId> found_;
    std::vector<Candidate> candidates_; ///< by (score, id)
    std::uint32_t firstTraced_ = 0;     ///< index of the search's first candidate in the explanation
    std::uint32_t delivered_ = 0, tested_ = 0, cells_ = 0, ranked_ = 0;
};

} // namespace forefront
