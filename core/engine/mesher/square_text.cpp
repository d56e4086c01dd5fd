#include "core/engine/mesher/square_text.hpp"

#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <array>

namespace forefront {

std::string colouredStepTitle(Step step) {
    switch (step) {
    case Step::BoundaryToFront:
        return "The boundary, its nodes in two colours by turns, becomes the generation front";
    case Step::TakeBase:
        return "Take a base AB from the front: a diagonal, to complete its square; else a leg, row by row";
    case Step::EvaluateSpacing:
        return "Evaluate the node spacing at AB";
    case Step::IdealPoint:
        return "Place the corners of a square over AB, or of half a square";
    case Step::FindCandidates:
        return "Propose a square that closes a gap, continues or opens a row; else find candidate nodes";
    case Step::Score:
        return "Score each: how near it is to half a square, times δ of its legs; nodes of the front 1.15 times that";
    case Step::Sort:
        return "Sort; leave out what is too near, of one colour, or would flatten a corner of the boundary";
    case Step::Test:
        return "Test the square, or the candidate segments, against the front";
    case Step::Update:
        return "Store the square or half of one, update front and grid";
    case Step::Finish:
        return "Stop when the front is empty; then all diagonals are dropped";
    }
    return "";
}

const char *squareText(SquareKind kind) {
    switch (kind) {
    case SquareKind::None:
        return "";
    case SquareKind::Row:
        return "continues the row";
    case SquareKind::Opening:
        return "opens a row";
    case SquareKind::Closing:
        return "closes the gap";
    }
    return "";
}

namespace {

std::string squareName(const CandidateTrace &square) {
    return std::string("the square that ") + squareText(square.square);
}

std::string nameOfCandidate(const CandidateTrace &candidate) {
    return candidate.square != SquareKind::None ? squareName(candidate)
           : candidate.node != kNoNode          ? "node " + std::to_string(index(candidate.node))
                                                : "a new node";
}

std::string baseOfSquare(const AdvanceExplanation &e) {
    return e.diagonal ? "a diagonal, its nodes have one colour, taken as base AB first, to complete its square"
                      : "a leg of row " + std::to_string(e.row + 1) + ", its nodes have two colours, taken as base AB";
}

std::string cornersText(const CandidateTrace &square) {
    const std::string text = squareName(square);
    switch (square.square) {
    case SquareKind::Opening:
        return text + " gets new corners at " + placeText(square.second) + " and " + placeText(square.position);
    case SquareKind::Closing:
        return text + " has all its corners on the front";
    default:
        return text + " gets its fourth corner at " + placeText(square.position);
    }
}

/// Returns what a square's proposal found, in the moment of an event; empty for events of a search.
std::string proposalText(const AdvanceExplanation &e, const TraceEvent &event) {
    const bool placed = event.step > Step::IdealPoint;
    const std::size_t at = event.candidatesSeen - (placed ? 1U : 0U); // recorded after its place
    if (at >= e.candidates.size() || e.candidates[at].square == SquareKind::None) {
        return {};
    }
    const CandidateTrace &square = e.candidates[at];
    switch (event.step) {
    case Step::EvaluateSpacing:
        return "the node spacing asks for sides of " + numberText(square.rho, 4) + " here";
    case Step::IdealPoint:
        return cornersText(square);
    case Step::FindCandidates:
        return "proposed: " + cornersText(square);
    case Step::Score:
        return squareName(square) + " has the scaled Jacobian " + numberText(square.alpha, 3) +
               "; squares are tried in turn, not by score";
    case Step::Sort:
        return squareName(square) + " is tried before any search";
    default:
        return {};
    }
}

std::string searchText(const AdvanceExplanation &e, const TraceEvent &event) {
    switch (event.step) {
    case Step::EvaluateSpacing:
        return "no square is made, so half of one is searched for; node spacing ρ = " + numberText(e.rho, 4) + " here";
    case Step::IdealPoint:
        return e.diagonal ? "the ideal point of the second half is at " + placeText(e.ideal)
                          : "the right angle of half a square may lie at A or at B";
    case Step::FindCandidates:
        return "the front nodes near C become candidates, beside the ideal points";
    case Step::Score:
        return "each scored by how near it is to half a square, and δ of its legs";
    case Step::Sort:
        return event.candidate == kNoIndex ? "no candidate is near enough"
                                           : "best first: " + nameOfCandidate(e.candidates[event.candidate]);
    default:
        return {};
    }
}

std::string testOfSquare(const AdvanceExplanation &e, const TraceEvent &event) {
    const CandidateTrace &candidate = e.candidates[event.candidate];
    std::string text = "test " + nameOfCandidate(candidate);
    if (event.test != kNoIndex) {
        text += e.tests[event.test].meets ? ": a new side meets the front" : ": this segment of the front is clear";
    } else if (candidate.verdict != Verdict::NotTried) {
        text += std::string(": ") + verdictText(candidate.verdict);
    }
    return text;
}

const char *madeText(SquareKind square) {
    switch (square) {
    case SquareKind::Row:
        return "row continued: a square with one new node";
    case SquareKind::Opening:
        return "row opened: a square with two new nodes";
    case SquareKind::Closing:
        return "gap closed: a square without a new node";
    case SquareKind::None:
        break;
    }
    return "half a square";
}

/// Returns why squares and candidates were refused: "; the square that closes the gap refused: badly shaped; 2
/// candidates cross the front".
std::string refusals(const AdvanceExplanation &e) {
    std::string text;
    std::array<std::size_t, EnumWords<Verdict>::kList.size()> counts{};
    for (const CandidateTrace &candidate : e.candidates) {
        if (candidate.verdict == Verdict::Accepted || candidate.verdict == Verdict::NotTried) {
            continue;
        }
        if (candidate.square != SquareKind::None) {
            text += "; " + squareName(candidate) + " refused: " + verdictText(candidate.verdict);
        } else {
            ++counts[static_cast<std::size_t>(candidate.verdict)];
        }
    }
    for (std::size_t v = 0; v < counts.size(); ++v) {
        if (counts[v] > 0) { // only new nodes are withdrawn
            const char *const what = static_cast<Verdict>(v) == Verdict::Withdrawn ? "new node" : "candidate";
            text += "; " + countText(counts[v], what) + " refused: " + verdictText(static_cast<Verdict>(v));
        }
    }
    return text;
}

std::string outcomeOfSquare(const AdvanceExplanation &e) {
    if (e.deferred) {
        return "no candidate passes, the segment is deferred" + refusals(e);
    }
    std::string text = madeText(e.square);
    const auto accepted = std::ranges::find(e.candidates, Verdict::Accepted, &CandidateTrace::verdict);
    if (accepted != e.candidates.end()) {
        text += accepted->square == SquareKind::None ? ", with " + nameOfCandidate(*accepted) + " (shape "
                                                     : std::string(" (scaled Jacobian ");
        text += numberText(accepted->alpha, 3) + ')';
    }
    if (e.forced) {
        text += ", of nodes that exist, since nothing else is left";
    }
    return text + refusals(e);
}

} // namespace

std::string squareCaption(const AdvanceExplanation &explanation, std::size_t cursor) {
    if (cursor >= explanation.events.size()) {
        return outcomeOfSquare(explanation);
    }
    const TraceEvent &event = explanation.events[cursor];
    switch (event.step) {
    case Step::BoundaryToFront:
    case Step::TakeBase:
        return baseOfSquare(explanation);
    case Step::Test:
        return testOfSquare(explanation, event);
    case Step::Update:
        return outcomeOfSquare(explanation);
    case Step::Finish:
        return outcomeOfSquare(explanation) + "; the front is empty";
    default:
        break;
    }
    const std::string proposal = proposalText(explanation, event);
    return proposal.empty() ? searchText(explanation, event) : proposal;
}

} // namespace forefront
