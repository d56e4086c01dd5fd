#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesher/front_state.hpp"
#include "core/engine/mesher/trace.hpp"

#include <cstdint>
#include <span>
#include <vector>

// Declared outside FOREFRONT_API: these types are not part of the public surface.
namespace forefront {
struct Base;
struct Candidate;
struct Fan;
} // namespace forefront

namespace FOREFRONT_API forefront {

/// Records nothing and costs nothing: every call compiles to nothing.
struct NoTrace {
    void takeBase(bool) {}
    void takeFirst(const FrontState &, SlotId) {}
    void begin(const FrontState &, const Base &) {}
    void evaluateSpacing(const Base &) {}
    void visitCell(const Box2 &) {}
    void deliver(std::uint32_t) {}
    void widen() {}
    void rank(const Base &, std::span<const Candidate>, double, bool) {}
    void proposeFan(const Fan &) {}
    void proposeCorner(const FrontState &, const Fan &, unsigned) {}
    void beginTest(std::size_t) {}
    void testSegment(Vec2, Vec2, Vec2, Vec2, bool) {}
    void block(Vec2, Vec2) {}
    void blockIdeal(Vec2, Vec2, double, double) {}
    void endTest(Verdict) {}
    void end(const FrontState &, const AdvanceDelta &, Vec2) {}
};

/// Records one advance into an AdvanceExplanation.
class Recorder {
  public:
    explicit Recorder(AdvanceExplanation &out) : out_(out) {}

    /// Records the chosen base; `continuesWalk`: it follows the base before along the front.
    void takeBase(bool continuesWalk) { out_.walked = continuesWalk; }
    /// Records a base of the classic method, which compares lengths and scores within rounding.
    void takeFirst(const FrontState &state, SlotId slotA);
    /// Discards the record of a base that is left to a later strip (step 2).
    void begin(const FrontState &state, const Base &base);
    /// Records steps 3 and 4.
    void evaluateSpacing(const Base &base);
    /// Records a cell that the grid visited.
    void visitCell(const Box2 &cell) { out_.cells.push_back(cell); }
    /// Records that the grid delivered this many segments.
    void deliver(std::uint32_t segments) { out_.delivered += segments; }
    /// Records that no candidate passed and the search continues within a larger radius.
    void widen() { ++out_.widening; }
    /// Records steps 5 to 7 of a search: its candidates in their order; `withdrawn`: the ideal point is not among them
    /// since it is too near the front.
    void rank(const Base &base, std::span<const Candidate> candidates, double radius, bool withdrawn);
    /// Records that the front segment ab, or the front node a = b, is nearer to the ideal point, which was withdrawn,
    /// than its clearance.
    void blockIdeal(Vec2 a, Vec2 b, double distance, double clearance);
    /// Records steps 3 to 7 for a new node over all segments of a fan.
    void proposeFan(const Fan &fan);
    /// Records steps 3 to 7 for the element of a corner of two segments, of which segment `base` is the base.
    void proposeCorner(const FrontState &state, const Fan &corner, unsigned base);
    /// Begins step 8 for candidate `k` of the search ranked last, one pass of Γ through its node.
    void beginTest(std::size_t k);
    /// Records that the candidate segment from–to was tested against the front segment ab.
    void testSegment(Vec2 from, Vec2 to, Vec2 a, Vec2 b, bool meets);
    /// Records that the front segment ab, or the front node a = b, rules out the candidate under test.
    void block(Vec2 a, Vec2 b);
    /// Ends step 8 for the candidate under test.
    void endTest(Verdict verdict);
    /// Records steps 9 and 10, after Γ has changed.
    void end(const FrontState &state, const AdvanceDelta &delta, Vec2 apex);

  protected:
    void event(Step step, std::uint32_t candidate = kNoIndex, std::uint32_t test = kNoIndex);
    void eventWithTies(Step step, std::uint32_t candidate, std::size_t equal);
    void propose(CandidateTrace candidate, double fieldRho, bool newNode);

    AdvanceExplanation &out_;
    std::uint32_t firstOfSearch_ = 0;     ///< index of the first candidate of the search ranked last
    std::vector<std::uint32_t> recorded_; ///< by candidate of that search: its index in the explanation
    std::uint32_t underTest_ = 0;         ///< index of the candidate under test

  private:
    bool roundsTies_ = false; ///< classic method
    FrontRules rules_{};      ///< classic method
    FirstBases first_;        ///< classic method
};

} // namespace forefront
