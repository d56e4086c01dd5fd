#pragma once

#include "core/session/snapshot.hpp"

#include <vector>

namespace forefront {

/// What is known at the moment that the timeline rests on inside an advance: of the whole advance, or up to the event
/// under the cursor.
struct Moment {
    const AdvanceExplanation *advance = nullptr; ///< null: nothing to explain
    std::size_t cursor = 0;                      ///< into events; events.size(): the whole advance
    Step step = Step::Finish;
    std::size_t tests = 0;      ///< seen so far: tests[0 .. tests)
    std::size_t cells = 0;      ///< seen so far
    std::size_t candidates = 0; ///< proposed so far: candidates[0 .. candidates)
    bool idealKnown = false, candidatesKnown = false, scoresKnown = false, updated = false;
    std::vector<bool> judged; ///< per candidate: its verdict is known

    explicit operator bool() const { return advance != nullptr; }
};

/// The moment of a snapshot. None while the front races, at the start, and where the improved mesh is shown.
Moment momentOf(const SessionSnapshot &snapshot);

} // namespace forefront
