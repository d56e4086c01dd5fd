#pragma once

#include "core/engine/front/order_key.hpp"
#include "core/engine/mesher/front_state.hpp"
#include "core/engine/mesher/recorder.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <algorithm>
#include <vector>

namespace forefront {

/// Minimum height of the ideal point above AB, in units of |AB|.
inline constexpr double kMinHeight = FrontRules{}.minHeight;

/// Returns ρ clamped against the length of the base (step 3), which keeps neighbouring elements within a factor of two.
inline double clampedToBase(double rho, double length, const FrontRules &rules = {}) {
    return std::clamp(rho, rules.minRho * length, rules.maxRho * length);
}

/// A new node closer to Γ than this fraction of the node spacing counts as small, see FrontState::smallNodesLeft.
inline constexpr double kSmallNode = 0.5;

/// A base segment AB with the node spacing there.
struct Base {
    SlotId slotA, slotB;
    Vec2 a, b;
    NodeId nodeA, nodeB;
    double length;
    double rho = 0.0;      ///< fieldRho clamped against the length
    double fieldRho = 0.0; ///< value of the node spacing function
    Vec2 ideal;            ///< the ideal point C

    bool small() const { return rho < kSmallNode * fieldRho; }
};
/// Returns the base that starts at a slot, without its node spacing.
Base baseAt(const GenerationFront &front, SlotId slotA);

/// A candidate node for the apex.
struct Candidate {
    double score;
    Vec2 position;
    NodeId node; ///< kNoNode: the ideal point
    SlotId slot; ///< kNoSlot: the ideal point
};

/// A segment AB of Γ that a search has found near its base, or an isolated point (A = B).
struct NearSegment {
    SlotId slot;
    NodeId nodeA, nodeB;
    Vec2 a, b;
};

/// The work of the searches in one advance.
struct SearchWork {
    std::uint32_t delivered = 0, considered = 0, tested = 0, cells = 0, candidates = 0, rejected = 0;

    void store(AdvanceDelta &delta) const {
        delta.delivered = delivered;
        delta.considered = considered;
        delta.tested = tested;
        delta.cells = cells;
        delta.candidates = candidates;
        delta.rejected = static_cast<std::uint8_t>(std::min(rejected, 255U));
    }
};

/// How scores and distances compare that differ only by rounding.
enum class Ties : std::uint8_t {
    Rounded, ///< as equal: the mesh does not depend on the position and the unit of the drawing
    Exact
};

/// Performs steps 3 to 8 of the ten: finds the apex for a base segment. Changes only its own scratch memory.
template <class Grid, class Trace>
class ApexSearch {
  public:
    struct Limits {
        double radius;
        bool newNodes;
        bool flat = false; ///< accept flat elements, and sides that rounding cannot tell from touching a node of Γ
    };

    ApexSearch(const FrontState &state, const Grid &grid, const SpacingField &spacing, Trace &trace, Ties ties,
               const FrontRules &rules)
        : state_(state), grid_(grid), spacing_(spacing), trace_(trace), rules_(rules),
          droppedBits_(ties == Ties::Rounded ? kTieBits : 0U), slack_(ties == Ties::Rounded ? kTieWidth : 0.0),
          nodeClearance_(rules.withdraw ? rules.nodeClearance : kLeastClearance),
          segmentClearance_(rules.withdraw ? rules.segmentClearance : kLeastClearance) {}

    /// Evaluates ρ and places the ideal point (steps 3 and 4). ρ is a mean of its values at the midpoint of AB and at
    /// the ideal point that follows from the first.
    void evaluateSpacing(Base &base);
    /// Returns a box that contains or meets everything that find() depends on.
    static Box2 reach(const Base &base, double radius);
    /// Finds the apex within one search radius (steps 5 to 8). Returns false if no candidate passes.
    bool find(const Base &base, const Limits &limits, Candidate &apex);
    /// Finds the apex among existing nodes only; doubles the radius until one passes, which cannot fail. Takes a flat
    /// element only where the search has found no other among thousands of segments or all of Γ, or where three
    /// segments are left.
    void force(const Base &base, double radius, Candidate &apex);

    void startCounting() { work_ = {}; }
    const SearchWork &work() const { return work_; }
    SearchWork &work() { return work_; }

  private:
    using Neighbour = NearSegment;

    void gather(const Box2 &box);
    void rank(const Base &base, const Limits &limits);
    bool idealIsClear(const Base &base) const;
    void traceBlockOfIdeal(const Base &base);
    double score(const Base &base, Vec2 p) const;
    bool seenAll(const Base &base) const;
    Verdict test(const Base &base, const Candidate &candidate, bool flat);
    bool beside(Vec2 a, Vec2 b, Vec2 p) const;
    bool containsNode(const Base &base, const Candidate &candidate, bool flat);

    const FrontState &state_;
    const Grid &grid_;
    const SpacingField &spacing_;
    Trace &trace_;
    FrontRules rules_;
    unsigned droppedBits_; ///< of scores, see orderKey()
    double slack_;         ///< relative, of squared distances that equal a limit and of heights that equal 0
    double nodeClearance_, segmentClearance_; ///< of the ideal point, in ρ

    std::vector<std::uint32_t> stamps_; ///< per slot: search in which it was last delivered
    std::uint32_t stamp_ = 0;
    std::vector<Neighbour> neighbours_; ///< of the current search, by slot
    std::vector<SlotId> found_;
    std::vector<Candidate> candidates_; ///< by (score, id)
    SearchWork work_;
};

} // namespace forefront
