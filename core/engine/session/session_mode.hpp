#pragma once

#include "core/engine/base/api.hpp"

#include <cstdint>

namespace FOREFRONT_API forefront {

/// The length of a step.
enum class Granularity : std::uint8_t {
    Event,   ///< one moment inside an advance
    Advance, ///< one front advance: an element (fast method: up to three), or a deferred base
    Layer    ///< once around the front: as many advances as Γ had segments
};

/// The behaviour of a new run once it is prepared.
enum class StartMode : std::uint8_t {
    Pause,   ///< waits before the first advance; up to kQuietElements, the length of the run is known then
    Run,     ///< meshes to the end at full speed and publishes progress and partial meshes on the way
    RunQuiet ///< as Run, but publishes nothing before the end, so that the previous mesh stays visible after an edit; a
             ///< run above kQuietElements publishes its progress all the same
};
/// The part that the improvement has on the timeline of a run. The mesh does not depend on it.
enum class ImprovementPace : std::uint8_t {
    Steps, ///< its steps follow the last advance; a quiet run finds them out when it is first moved along its timeline
    AtOnce ///< the last advance leads to the improved mesh
};
/// Maximum predicted number of elements of a quiet run. Larger runs take long enough for their progress to matter.
inline constexpr double kQuietElements = 100'000.0;

} // namespace forefront
