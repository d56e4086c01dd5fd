#pragma once

#include "core/mesh/quality.hpp"
#include "core/mesh/sharp_corners.hpp"
#include "core/mesher/pipeline.hpp"

#include <cstdint>
#include <string>

namespace forefront {

/// Corners sharper than this, in degrees, are named: no mesh has greater angles there.
inline constexpr double kSharpCorner = 20.0;

/// Figures of a finished run.
struct RunReport {
    MeshQuality quality;
    SharpCorners sharp; ///< corners of the domain below kSharpCorner
    WorkCounters work;
    ImproveLevel improve = ImproveLevel::None;
    double secondsPrepare = 0.0, secondsMesh = 0.0, secondsImprove = 0.0;
    std::uint64_t hash = 0;
    std::uint64_t peakBytes = 0; ///< greatest resident memory of the program so far

    /// CPU seconds of meshing and improvement, with validation, spacing and discretisation; no reading or writing.
    double meshCpu() const { return secondsPrepare + secondsMesh + secondsImprove; }
};

RunReport reportOf(const MeshingOutcome &outcome, const MeshingOptions &options);
/// The JSON object that --stats writes.
std::string statisticsJson(const RunReport &report);
/// A few lines for people.
std::string summary(const RunReport &report);

} // namespace forefront
