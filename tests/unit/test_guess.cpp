#include "core/teaching/lesson/guess.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace forefront {

namespace {

/// An advance over the base (0, 0)-(2, 0) with the ideal point accepted, or another candidate.
AdvanceExplanation advanceOver(std::vector<CandidateTrace> candidates) {
    AdvanceExplanation advance;
    advance.a = {0, 0};
    advance.b = {2, 0};
    advance.candidates = std::move(candidates);
    return advance;
}

CandidateTrace candidateAt(Vec2 place, NodeId node, double score, Verdict verdict) {
    CandidateTrace candidate;
    candidate.position = place;
    candidate.node = node;
    candidate.score = score;
    candidate.verdict = verdict;
    return candidate;
}

const std::vector<CandidateTrace> kTwo = {candidateAt({1, 2}, kNoNode, 0.9, Verdict::Accepted),
                                          candidateAt({3, 2}, NodeId{7}, 0.4, Verdict::NotTried)};

} // namespace

TEST_CASE("Guess: the chosen candidate earns full points, even if the click is slightly off") {
    for (const Vec2 guess : {Vec2{1, 2}, Vec2{1.3, 2.2}}) {
        const GuessReview review = reviewGuess(advanceOver(kTwo), guess);
        CHECK(review.comparable);
        CHECK(review.same);
        CHECK(review.points == 10);
        CHECK(review.words.starts_with("Right: the ideal point C"));
    }
    CHECK(reviewGuess(advanceOver(kTwo), {1, 1}).distance == doctest::Approx(0.5));
}

TEST_CASE("Guess: explains why another candidate lost") {
    const GuessReview lower = reviewGuess(advanceOver(kTwo), {3, 2});
    CHECK_FALSE(lower.same);
    CHECK(lower.points == 0);
    CHECK(lower.words == "Node 7 scores 0.4; the ideal point C scores 0.9, so it is tried first, and passes.");
    const struct {
        Verdict verdict;
        const char *part;
    } cases[] = {{Verdict::Withdrawn, "too near"},
                 {Verdict::NotLeft, "no area"},
                 {Verdict::OutsideAngle, "leave the unmeshed part"},
                 {Verdict::CrossesFront, "cross the front"},
                 {Verdict::ContainsNode, "contain a node"}};
    for (const auto &[verdict, part] : cases) {
        const auto advance = advanceOver(
            {candidateAt({1, 2}, kNoNode, 0.9, verdict), candidateAt({2, 2}, NodeId{3}, 0.8, Verdict::Accepted)});
        const GuessReview review = reviewGuess(advance, {1, 2});
        CHECK(review.words.find(part) != std::string::npos);
        CHECK(review.words.find("node 3") != std::string::npos);
    }
}

TEST_CASE("Guess: a place without a candidate loses a point for each tenth of the base") {
    const GuessReview near = reviewGuess(advanceOver(kTwo), {1, 1.2}); // 0.4 |AB| away
    CHECK_FALSE(near.candidate);
    CHECK(near.points == 5);
    CHECK(near.words.starts_with("There is no candidate"));
    const GuessReview wrong = reviewGuess(advanceOver(kTwo), {1, -1});
    CHECK(wrong.words.starts_with("That is on the meshed side"));
    CHECK(wrong.points == 0);
}

TEST_CASE("Guess: an advance that makes no element earns no points") {
    const GuessReview review =
        reviewGuess(advanceOver({candidateAt({1, 2}, kNoNode, 0.9, Verdict::CrossesFront)}), {1, 2});
    CHECK_FALSE(review.comparable);
    CHECK(review.points == 0);
    CHECK_FALSE(review.words.empty());
}

} // namespace forefront
