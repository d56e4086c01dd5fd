#include "core/teaching/lesson/guess.hpp"

#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

/// A guess counts as a candidate within this distance of it, in units of |AB|.
constexpr double kReach = 0.25;
/// Points deducted per |AB| between the guess and the chosen node.
constexpr double kLoss = 10.0;

std::string figure(double value) {
    return numberText(std::round(value * 100.0) / 100.0, 8);
}

std::string nameOf(const CandidateTrace &candidate) {
    return candidate.node == kNoNode ? "the ideal point C" : "node " + std::to_string(index(candidate.node));
}

/// Returns the candidate nearest to a position, if it is within reach.
std::optional<std::size_t> candidateNear(const AdvanceExplanation &advance, Vec2 place, double base) {
    std::optional<std::size_t> nearest;
    double limit = kReach * base;
    for (std::size_t k = 0; k < advance.candidates.size(); ++k) {
        const double away = distance(advance.candidates[k].position, place);
        // The ideal point may be listed twice: as a candidate and as withdrawn. The first counts.
        if (away < limit) {
            nearest = k;
            limit = away;
        }
    }
    return nearest;
}

std::string praise(const CandidateTrace &chosen) {
    if (chosen.node == kNoNode) {
        return "Right: the ideal point C becomes a new node; nothing on the front is too near.";
    }
    return "Right: of the candidates that pass the tests, node " + std::to_string(index(chosen.node)) +
           " has the highest score, " + figure(chosen.score) + '.';
}

/// Explains why a candidate other than the chosen one lost.
std::string whyNot(const CandidateTrace &guessed, const CandidateTrace &chosen) {
    const std::string name = nameOf(guessed), winner = nameOf(chosen);
    switch (guessed.verdict) {
    case Verdict::NotTried:
        return name + " scores " + figure(guessed.score) + "; " + winner + " scores " + figure(chosen.score) +
               ", so it is tried first, and passes.";
    case Verdict::Withdrawn:
        return name + " is withdrawn: a node or segment of the front is too near, so " + winner + " is used.";
    case Verdict::NotLeft:
        return "With " + name + " the triangle would have no area; " + winner + " is used.";
    case Verdict::OutsideAngle:
        return "A side to " + name + " would leave the unmeshed part; " + winner + " is used.";
    case Verdict::CrossesFront:
        return "A side to " + name + " would cross the front; " + winner + " is used.";
    case Verdict::ContainsNode:
        return "The triangle with " + name + " would contain a node of the front; " + winner + " is used.";
    case Verdict::BadShape:
        return "The square with " + name + " would be badly shaped; " + winner + " is used.";
    case Verdict::OneColour:
        return "With " + name + " three nodes of one colour would be joined; " + winner + " is used.";
    case Verdict::FlatCorner:
        return "With " + name + " a corner of the boundary would be flat; " + winner + " is used.";
    case Verdict::Accepted:
        break;
    }
    return {};
}

/// Explains why there is no candidate at a guess.
std::string noCandidate(const AdvanceExplanation &advance, Vec2 guess, const CandidateTrace &chosen) {
    if (cross(advance.b - advance.a, guess - advance.a) <= 0.0) {
        return "That is on the meshed side: the unmeshed part lies to the left of AB. The method takes " +
               nameOf(chosen) + '.';
    }
    return "There is no candidate here: the candidates are the ideal point and the front nodes near it. The method "
           "takes " +
           nameOf(chosen) + '.';
}

std::string capitalised(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text;
}

} // namespace

GuessReview reviewGuess(const AdvanceExplanation &advance, Vec2 guess) {
    GuessReview review;
    const auto accepted = std::find_if(advance.candidates.begin(), advance.candidates.end(),
                                       [](const CandidateTrace &c) { return c.verdict == Verdict::Accepted; });
    if (accepted == advance.candidates.end()) {
        review.words = "No candidate passes the tests here: the base is put back and tried again later. This guess "
                       "does not count.";
        return review;
    }
    const double base = distance(advance.a, advance.b);
    review.comparable = true;
    review.distance = distance(guess, accepted->position) / base;
    review.candidate = candidateNear(advance, guess, base);
    review.same = review.candidate && advance.candidates[*review.candidate].position == accepted->position;
    review.points = review.same ? GuessReview::kMaxPoints
                                : static_cast<int>(std::lround(
                                      std::clamp(GuessReview::kMaxPoints - 1.0 - kLoss * review.distance, 0.0, 9.0)));
    review.words = review.same        ? praise(*accepted)
                   : review.candidate ? capitalised(whyNot(advance.candidates[*review.candidate], *accepted))
                                      : noCandidate(advance, guess, *accepted);
    return review;
}

} // namespace forefront
