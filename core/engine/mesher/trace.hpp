#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/mesher/front_rules.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// The ten steps of S. H. Lo's advancing front technique.
enum class Step : std::uint8_t {
    BoundaryToFront = 1, ///< 1  Γ := boundary segments
    TakeBase,            ///< 2  take a base segment AB from Γ, by FrontRules::base
    EvaluateSpacing,     ///< 3  ρ at the midpoint of AB, clamped
    IdealPoint,          ///< 4  ideal point C
    FindCandidates,      ///< 5  candidate nodes near C
    Score,               ///< 6  α(ABC)·δ(AC)·δ(CB)
    Sort,                ///< 7  sort, equal ones by number; withdraw C where it is too near the front
    Test,                ///< 8  test candidate segments against Γ
    Update,              ///< 9  store ABC, update Γ and grid
    Finish               ///< 10 stop when Γ = ∅
};
inline constexpr int kStepCount = 10;
/// Returns the title of a step under the rules of a run, such as "Take a base segment AB from the front, the shortest
/// first". `rules`: of the classic method; null for the fast method.
std::string stepTitle(Step step, const FrontRules *rules);
/// Returns the formula of the score under the rules of a run: "α(ABC)² · δ(AC)·δ(CB)".
std::string scoreFormula(const FrontRules &rules);

/// The result of testing a candidate node.
enum class Verdict : std::uint8_t {
    NotTried, ///< a better one was accepted first
    Accepted,
    Withdrawn,    ///< the ideal point: a front node or segment is too near
    NotLeft,      ///< triangle ABC has no area on the left of AB, or is flat within rounding
    OutsideAngle, ///< AC or CB leaves the unmeshed side at A, B or C
    CrossesFront, ///< AC or CB meets a segment of Γ
    ContainsNode, ///< a front node lies in ABC or, within rounding, on it
    BadShape,     ///< quadrilaterals: the square would be badly shaped or of the wrong size
    OneColour,    ///< quadrilaterals: all nodes of the triangle would have one colour
    FlatCorner    ///< quadrilaterals: a nearly straight angle of the boundary would be one corner
};
template <>
struct EnumWords<Verdict> {
    static constexpr auto kLast = Verdict::FlatCorner;
    static constexpr std::array<std::string_view, 10> kList = {
        "not-tried",     "accepted",      "withdrawn", "not-left",   "outside-angle",
        "crosses-front", "contains-node", "bad-shape", "one-colour", "flat-corner"};
};

/// A square that the two-coloured front makes at once.
enum class SquareKind : std::uint8_t {
    None,    ///< half a square, found by a search
    Row,     ///< continues a row at a corner of Γ, with one new node
    Opening, ///< starts a row over a segment, with two new nodes
    Closing  ///< closes a gap one square wide, without a new node
};

/// Returns the title of a step of the two-coloured front, such as "Take a base AB: a diagonal, else the oldest leg".
std::string colouredStepTitle(Step step);
/// Returns what a square does: "continues the row", "opens a row", "closes the gap"; empty for half a square.
const char *squareText(SquareKind kind);
/// Returns a verdict as text, such as "crosses the front".
const char *verdictText(Verdict verdict);

/// A candidate node with its score and verdict.
struct CandidateTrace {
    Vec2 position;
    NodeId node = kNoNode;               ///< kNoNode: the ideal point itself
    double alpha = 0.0;                  ///< α of ABC; the minimum where several elements are made at once
    double deltaAC = 0.0, deltaCB = 0.0; ///< δ of the outer sides
    double rho = 0.0;                    ///< the spacing that δ compares lengths with
    double score = 0.0;                  ///< see FrontRules::score()
    Verdict verdict = Verdict::NotTried;
    /// Classic method: how often Γ passes through the node. It is accepted if one of the passes is.
    unsigned passes = 1;
    /// Fast method: the front nodes whose segments share this candidate, in order; empty: AB alone.
    std::vector<Vec2> over;
    bool blocked = false; ///< ruled out by the front segment blockA-blockB, or the front node there if both are equal
    Vec2 blockA, blockB;
    /// Classic method, an ideal point withdrawn by a blocking segment or node: its distance from it, and the clearance.
    double blockDistance = 0.0, blockClearance = 0.0;
    // Quadrilaterals.
    SquareKind square = SquareKind::None;
    Vec2 second;     ///< Opening: the new node over A; `position` is the one over B. Closing: the other end of the gap
    int colour = -1; ///< of the node: 0 or 1; -1: triangles
};

/// A test of a candidate segment against a segment of Γ.
struct TestTrace {
    Vec2 candidateFrom, candidateTo;
    Vec2 frontA, frontB;
    std::uint32_t candidate = 0; ///< index into AdvanceExplanation::candidates
    bool meets = false;
};

/// A moment within an advance at which the timeline can pause.
struct TraceEvent {
    Step step = Step::TakeBase;
    std::uint32_t candidate = kNoIndex; ///< the candidate involved
    std::uint32_t test = kNoIndex;      ///< the segment test involved
    std::uint32_t cellsSeen = 0;        ///< cells visited so far: cells[0 .. cellsSeen)
    std::uint32_t candidatesSeen = 0;   ///< candidates proposed so far: candidates[0 .. candidatesSeen)
    std::uint32_t delivered = 0;        ///< segments that the grid has delivered so far
    /// Classic method. TakeBase: the number of segments that come first by the order of bases within rounding, with AB;
    /// 0 if others come before it. Sort: the number of candidates with the best score within rounding.
    std::uint32_t equal = 0;
};

/// Everything that happened in one advance. It is derived by running the advance again with recording, which is exact
/// because advances are deterministic.
struct AdvanceExplanation {
    std::uint64_t advance = 0; ///< number of the advance, from 1
    Vec2 a, b;                 ///< base segment AB
    NodeId nodeA = kNoNode, nodeB = kNoNode;
    double fieldRho = 0.0; ///< value of the node spacing function
    double rho = 0.0;      ///< spacing used: fieldRho after clamping
    Vec2 ideal;            ///< ideal point C
    double searchRadius = 0.0;
    int widening = 0;                       ///< how often the search was widened
    bool deferred = false;                  ///< no candidate passed: the base was put back
    std::vector<CandidateTrace> candidates; ///< by search, then by (score, id); a withdrawn ideal point last
    std::vector<TestTrace> tests;
    std::vector<Box2> cells;     ///< visited cells of the background grid, in order
    std::uint32_t delivered = 0; ///< segments that the grid delivered
    std::vector<TraceEvent> events;
    Vec2 apex;                             ///< apex of the elements made, unless deferred
    ElementId element = kNoElement;        ///< first element made
    unsigned elements = 0;                 ///< number of elements made
    std::vector<std::array<Vec2, 3>> made; ///< corners of the elements made
    FrontRules rules{};                    ///< classic method; else the defaults
    bool earlierDeferred = false; ///< classic method: a segment that comes earlier waits, since it was deferred
    bool walked = false;          ///< fast method: the base continues the walk along the front
    // Quadrilaterals.
    bool coloured = false;                ///< the advance is one of the two-coloured front
    bool diagonal = false;                ///< A and B have one colour: AB is the diagonal of half a square
    bool forced = false;                  ///< made of existing nodes, since no other choice was left
    std::uint32_t row = 0;                ///< of AB, counted from the boundary or the start of the lattice
    SquareKind square = SquareKind::None; ///< made by the advance
};

/// Returns a moment as a caption: "Edge 41-42: node 7 accepted (α 0.982); 2 candidates rejected: 2 cross the front; 1
/// new point too near the front". `cursor` is an index into events; past the end, the caption sums up the advance.
std::string caption(const AdvanceExplanation &explanation, std::size_t cursor);

} // namespace forefront
