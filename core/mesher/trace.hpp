#pragma once

#include "core/base/api.hpp"
#include "core/base/ids.hpp"
#include "core/base/vec2.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// The ten steps of the advancing front technique after S. H. Lo, in the terms of this program.
enum class Step : std::uint8_t {
    BoundaryToFront = 1, ///< 1  Γ := boundary segments
    TakeBase,            ///< 2  take a base segment AB from Γ, the shortest first
    EvaluateSpacing,     ///< 3  ρ at the midpoint of AB, clamped
    IdealPoint,          ///< 4  ideal point C
    FindCandidates,      ///< 5  candidate nodes near C
    Score,               ///< 6  α(ABC)·δ(AC)·δ(CB)
    Sort,                ///< 7  sort, withdraw C where it is too near the front
    Test,                ///< 8  test candidate segments against Γ
    Update,              ///< 9  store ABC, update Γ and grid
    Finish               ///< 10 stop when Γ = ∅
};
inline constexpr int kStepCount = 10;
/// "Evaluate the node spacing at AB": one line for each of the ten.
const char *stepTitle(Step step);

/// What became of a candidate node.
enum class Verdict : std::uint8_t {
    NotTried, ///< a better one was accepted first
    Accepted,
    Withdrawn,    ///< the ideal point: a front node or segment is too near
    NotLeft,      ///< triangle ABC has no positive area (exact)
    OutsideAngle, ///< AC or CB leaves the unmeshed side at A, B or C
    CrossesFront, ///< AC or CB meets a segment of Γ
    ContainsNode  ///< a front node lies in or on ABC
};
const char *verdictText(Verdict verdict);

struct CandidateTrace {
    Vec2 position;
    NodeId node = kNoNode;               ///< kNoNode: the ideal point itself
    double alpha = 0.0;                  ///< of element ABC; of several elements at once the least
    double deltaAC = 0.0, deltaCB = 0.0; ///< of the outer sides
    double score = 0.0;                  ///< product of the three
    Verdict verdict = Verdict::NotTried;
    /// Fast method: the nodes of the front, in order, whose segments this candidate would serve; empty: AB alone.
    std::vector<Vec2> over;
    bool blocked = false; ///< by the front segment blockA-blockB
    Vec2 blockA, blockB;
};

/// One candidate segment tested against one segment of Γ.
struct TestTrace {
    Vec2 candidateFrom, candidateTo;
    Vec2 frontA, frontB;
    std::uint32_t candidate = 0; ///< index into AdvanceExplanation::candidates
    bool meets = false;
};

/// A moment inside an advance that the timeline can rest on.
struct TraceEvent {
    Step step = Step::TakeBase;
    std::uint32_t candidate = kNoIndex; ///< candidate concerned
    std::uint32_t test = kNoIndex;      ///< segment test concerned
    std::uint32_t cellsSeen = 0;        ///< visited cells so far: cells[0 .. cellsSeen)
    std::uint32_t candidatesSeen = 0;   ///< proposed so far: candidates[0 .. candidatesSeen)
};

/// Everything that happened in one front advance: re-derived by running it again with recording, exact by determinism.
struct AdvanceExplanation {
    std::uint64_t advance = 0; ///< number of the advance, from 1
    Vec2 a, b;                 ///< base segment AB
    NodeId nodeA = kNoNode, nodeB = kNoNode;
    double rho = 0.0; ///< spacing used, after clamping
    Vec2 ideal;       ///< ideal point C
    double searchRadius = 0.0;
    int widening = 0;                       ///< 0: first search; then how often it was widened
    bool deferred = false;                  ///< no candidate passed: the base was put back
    std::vector<CandidateTrace> candidates; ///< search by search, by (score, id); a withdrawn ideal point last
    std::vector<TestTrace> tests;
    std::vector<Box2> cells; ///< cells of the background grid visited, in order
    std::vector<TraceEvent> events;
    Vec2 apex;                             ///< of the elements made (when not deferred)
    ElementId element = kNoElement;        ///< the first of them
    unsigned elements = 0;                 ///< how many
    std::vector<std::array<Vec2, 3>> made; ///< those elements
    bool walked = false;                   ///< fast method: the base follows the one before along the front
};

/// The moment in words, for the caption: "Edge 41-42: ideal point accepted; 3 candidates rejected: 2 cross the front, 1
/// too near". `cursor` is an index into events; past the end: the whole advance.
std::string caption(const AdvanceExplanation &explanation, std::size_t cursor);

} // namespace forefront
