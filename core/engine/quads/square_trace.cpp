#include "core/engine/quads/square_trace.hpp"

#include "core/engine/geometry/polygon.hpp"
#include "core/engine/mesh/quality.hpp"

#include <utility>

namespace forefront {

void SquareRecorder::beginBase(const FrontState &state, const Base &base, std::uint64_t number, bool diagonal,
                               std::uint32_t row) {
    begin(state, base);
    skipped_.clear();
    out_.advance = number;
    out_.coloured = true;
    out_.diagonal = diagonal;
    out_.row = row;
}

void SquareRecorder::proposeSquare(const SquareProposal &square) {
    CandidateTrace candidate;
    candidate.square = square.kind;
    candidate.over.assign(square.over.begin(), square.over.end());
    candidate.position = square.corner;
    candidate.second = square.second;
    candidate.node = square.node;
    candidate.colour = square.colour;
    candidate.alpha = square.shape;
    candidate.rho = square.side;
    // The new sides: of a row both meet at the corner; an opening has them over B and over A; a closing has one.
    const Vec2 first = candidate.over.front(), last = candidate.over.back();
    const Vec2 beforeFirst = square.kind == SquareKind::Row ? square.corner : square.second;
    candidate.deltaAC = spacingConformity(distance(first, beforeFirst), square.side);
    candidate.deltaCB = spacingConformity(distance(last, square.corner), square.side);
    if (square.kind == SquareKind::Closing) {
        candidate.deltaAC = candidate.deltaCB = spacingConformity(distance(square.second, square.corner), square.side);
    }
    propose(std::move(candidate), square.side, square.kind != SquareKind::Closing);
}

CandidateTrace &SquareRecorder::add(const Base &base, const ColouredCandidate &candidate, Verdict verdict) {
    CandidateTrace &trace = out_.candidates.emplace_back();
    trace.position = candidate.apex.position;
    trace.node = candidate.apex.node;
    trace.colour = candidate.colour;
    trace.alpha = candidate.figures.shape;
    trace.deltaAC = candidate.figures.deltaAC;
    trace.deltaCB = candidate.figures.deltaCB;
    trace.rho = base.rho;
    trace.score = candidate.apex.score;
    trace.verdict = verdict;
    return trace;
}

void SquareRecorder::rankSearch(const Base &base, std::span<const ColouredCandidate> candidates, double radius) {
    out_.searchRadius = radius;
    firstOfSearch_ = static_cast<std::uint32_t>(out_.candidates.size());
    recorded_.clear();
    for (const ColouredCandidate &candidate : candidates) {
        recorded_.push_back(static_cast<std::uint32_t>(out_.candidates.size()));
        add(base, candidate, Verdict::NotTried);
    }
    for (const Skipped &skipped : skipped_) {
        CandidateTrace &trace = add(base, skipped.candidate, skipped.why);
        if (skipped.why == Verdict::Withdrawn) {
            trace.blocked = true;
            trace.blockA = skipped.near.a;
            trace.blockB = skipped.near.b;
            trace.blockClearance = skipped.near.clearance;
            trace.blockDistance = distanceToSegment(trace.blockA, trace.blockB, trace.position);
        }
    }
    skipped_.clear();
    event(Step::FindCandidates);
    event(Step::Score);
    event(Step::Sort, candidates.empty() ? kNoIndex : firstOfSearch_);
}

void SquareRecorder::endAdvance(const FrontState &state, const AdvanceDelta &delta, Vec2 apex, SquareKind square) {
    out_.square = square;
    out_.forced = delta.forced;
    end(state, delta, apex);
}

} // namespace forefront
