#pragma once

#include "core/mesher/trace.hpp"

namespace forefront {

/// Records nothing and costs nothing: every call vanishes at compile time.
struct NoTrace {
    static constexpr bool kRecords = false;
};

/// Records one advance into an AdvanceExplanation.
struct Recorder {
    static constexpr bool kRecords = true;

    AdvanceExplanation &out;

    void event(Step step, std::uint32_t candidate = kNoIndex, std::uint32_t test = kNoIndex) {
        out.events.push_back({step, candidate, test, static_cast<std::uint32_t>(out.cells.size())});
    }
};

} // namespace forefront
