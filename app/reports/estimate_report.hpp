#pragma once

#include "core/engine/pipeline/run_estimate.hpp"

#include <string>

namespace forefront {

/// Returns the estimate of a run in a few lines.
std::string estimateText(const RunEstimate &estimate, const MeshingOptions &options);
/// Returns the JSON object that mesh --dry-run --json prints.
std::string estimateJson(const RunEstimate &estimate, const std::string &input);

} // namespace forefront
