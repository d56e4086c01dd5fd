#pragma once

#include "core/engine/base/result.hpp"
#include "core/files/source/source.hpp"
#include "core/teaching/trace/traced_run.hpp"

#include <vector>

namespace forefront {

/// Reads the advances of a trace, written by `forefront trace` or by another program: `{"advances": [{"base": {"a":
/// [x, y], "b": [x, y]}, ...}, ...]}`. Members that are not compared are skipped. Faults, each with its place:
/// json-syntax, not-a-trace, bad-value, missing-member and others of JsonCheck.
Result<std::vector<TracedAdvance>> readTrace(const SourceText &source);

} // namespace forefront
