#pragma once

#include "core/engine/session/snapshot.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace forefront {

/// The work of the background grid in one of the ten steps.
struct StepWork {
    std::size_t cells = 0;    ///< visited
    std::size_t segments = 0; ///< delivered
};

/// The part of an advance completed at the position of the timeline: the whole advance, or the part before the event
/// under the cursor.
struct Moment {
    const AdvanceExplanation *advance = nullptr; ///< null: nothing to explain
    std::size_t cursor = 0;                      ///< into events; events.size(): the whole advance
    Step step = Step::Finish;
    std::size_t tests = 0;      ///< seen so far: tests[0 .. tests)
    std::size_t cells = 0;      ///< seen so far
    std::size_t candidates = 0; ///< proposed so far: candidates[0 .. candidates)
    bool idealKnown = false, candidatesKnown = false, scoresKnown = false, updated = false;
    std::vector<bool> judged;                    ///< per candidate: its verdict is known
    std::array<StepWork, kStepCount + 1> work{}; ///< by step, of the events seen so far

    explicit operator bool() const { return advance != nullptr; }
};

/// Returns the moment of a snapshot; it is empty while the front runs fast, at the start, and when the improved mesh
/// is shown.
Moment momentOf(const SessionSnapshot &snapshot);

} // namespace forefront
