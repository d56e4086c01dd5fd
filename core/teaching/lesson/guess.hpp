#pragma once

#include "core/engine/mesher/trace.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace forefront {

/// A learner's guess of the apex of the next element, compared with the method's choice.
struct GuessReview {
    static constexpr int kMaxPoints = 10;

    bool comparable = false;              ///< false: the base was deferred, so no node was chosen
    double distance = 0.0;                ///< from the guess to the chosen node, in units of |AB|
    std::optional<std::size_t> candidate; ///< the candidate at the guess, if there is one
    bool same = false;                    ///< the guess is the chosen candidate
    int points = 0;                       ///< 10 for the chosen candidate, less with distance, at least 0
    std::string words;                    ///< why the guess is right or wrong
};

/// Reviews a guess of the apex of an advance.
GuessReview reviewGuess(const AdvanceExplanation &advance, Vec2 guess);

} // namespace forefront
