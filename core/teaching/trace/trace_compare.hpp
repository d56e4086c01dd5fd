#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/teaching/trace/traced_run.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace forefront {

/// The result of comparing a run with the trace of another program.
struct TraceComparison {
    std::uint64_t advances = 0;        ///< that agree, from the first one on
    bool agree = false;                ///< the traces agree to the end
    std::string difference;            ///< why the next one does not: one line; empty if all agree
    std::uint64_t otherTests = 0;      ///< candidates that both reject, by different tests
    std::string otherTest;             ///< the first of them: one line; empty if there is none
    std::optional<std::size_t> offset; ///< byte of the other trace's file where the advance that differs begins
};

/// Relative tolerance of comparisons: of co-ordinates and lengths, times the diagonal of the domain; of ρ and scores,
/// times the larger of the two.
inline constexpr double kTraceTolerance = 1e-6;

/// Runs a job step by step, without improvement, and compares it with `trace` by position, as far as both go and as
/// far as `trace` tells; within an advance in the order base, ρ, C, candidates, elements, front. `steps`: the number
/// of advances to compare, at most; absent: the whole run. Candidates and elements may come in any order. A candidate
/// rejected by another test than ours agrees, and is counted. Faults: those of the job, cancelled.
Result<TraceComparison> compareTrace(MeshingJob job, std::span<const TracedAdvance> trace,
                                     std::optional<std::uint64_t> steps, const Progress &progress);

} // namespace forefront
