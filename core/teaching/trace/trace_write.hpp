#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstdint>
#include <optional>

namespace forefront {

/// Runs a job step by step, without improvement, and writes every advance as JSON: first the boundary as it is divided,
/// then one advance a line, in the order of creation. The members are described in assets/exercise/README.md. `steps`:
/// the number of advances, at most; absent: all. Returns the faults of the job, or cancelled; faults of the sink are
/// its own.
Status writeTrace(MeshingJob job, std::optional<std::uint64_t> steps, TextWriter &out, const Progress &progress);

} // namespace forefront
