#pragma once

#include "core/engine/grid/all_grids.hpp"
#include "core/engine/mesher/recorder.hpp"
#include "core/engine/quads/coloured_candidate.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// What is too near for a new node: a segment of Γ, or a node of it if both ends are equal.
struct Obstacle {
    Vec2 a, b;
    double clearance = 0.0; ///< minimum distance from it
};

/// A square that the two-coloured front proposes, before it is tested.
struct SquareProposal {
    SquareKind kind = SquareKind::Row;
    std::span<const Vec2> over; ///< the nodes of Γ that its new sides join
    NodeId node = kNoNode;      ///< Closing: the end of the gap
    Vec2 corner;                ///< the new node (Opening: over B), or the end of the gap
    Vec2 second;                ///< see CandidateTrace::second
    double side = 0.0;          ///< mean of the sides that the node spacing asks for
    double shape = 0.0;         ///< scaled Jacobian of the square
    int colour = 0;             ///< of the corner
};

/// Records nothing and costs nothing.
struct NoSquareTrace : NoTrace {
    using Fans = NoTrace;
    static constexpr bool kRecords = false;

    void beginBase(const FrontState &, const Base &, std::uint64_t, bool, std::uint32_t) {}
    void proposeSquare(const SquareProposal &) {}
    void rankSearch(const Base &, std::span<const ColouredCandidate>, double) {}
    template <class Make>
    void skip(const Make &, Verdict, const Obstacle & = {}) {}
    template <class Make>
    void keepHalf(const Base &, const Make &) {}
    void endAdvance(const FrontState &, const AdvanceDelta &, Vec2, SquareKind) {}
};

/// Records one advance of the two-coloured front into an AdvanceExplanation. Squares are candidates as well: they are
/// tried in order, before a search.
class SquareRecorder : public Recorder {
  public:
    using Fans = Recorder;
    static constexpr bool kRecords = true;
    using Recorder::Recorder;

    /// Begins the record of an advance. `number`: of the advance, from 1. `diagonal`: the base joins nodes of one
    /// colour. `row`: that it was offered for.
    void beginBase(const FrontState &state, const Base &base, std::uint64_t number, bool diagonal, std::uint32_t row);
    /// Records a square that is tested next.
    void proposeSquare(const SquareProposal &square);
    /// Records the candidates of a search in the order of their scores, all of them colourings that are allowed.
    void rankSearch(const Base &base, std::span<const ColouredCandidate> candidates, double radius);
    /// Records a candidate that the search ranked next leaves out, and why. `make`: returns it.
    template <class Make>
    void skip(const Make &make, Verdict why, const Obstacle &near = {}) {
        skipped_.push_back({make(), why, near});
    }
    /// Records the half that is made of a square whose second half was refused. `make`: returns its apex.
    template <class Make>
    void keepHalf(const Base &base, const Make &make) {
        underTest_ = static_cast<std::uint32_t>(out_.candidates.size());
        add(base, make(), Verdict::Accepted);
        event(Step::Test, underTest_);
    }
    void endAdvance(const FrontState &state, const AdvanceDelta &delta, Vec2 apex, SquareKind square);

  private:
    struct Skipped {
        ColouredCandidate candidate;
        Verdict why;
        Obstacle near;
    };
    CandidateTrace &add(const Base &base, const ColouredCandidate &candidate, Verdict verdict);

    std::vector<Skipped> skipped_; ///< of the search that is ranked next
};

} // namespace forefront

/// Instantiates a template on grids and traces for every background grid, with and without recording.
// NOLINTBEGIN(bugprone-macro-parentheses): the arguments are names of templates and classes
#define FOREFRONT_INSTANTIATE_SQUARES_ON(Template, Grid)                                                               \
    template class Template<Grid, NoSquareTrace>;                                                                      \
    template class Template<Grid, SquareRecorder>;
// NOLINTEND(bugprone-macro-parentheses)
#define FOREFRONT_INSTANTIATE_FOR_SQUARES(Template) FOREFRONT_FOR_EACH_GRID(FOREFRONT_INSTANTIATE_SQUARES_ON, Template)
