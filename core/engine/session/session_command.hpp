#pragma once

#include "core/engine/mesher/options.hpp"
#include "core/engine/session/meshing_session.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <variant>

namespace forefront {

// Commands from the UI thread to the worker.
struct StartCommand {
    std::shared_ptr<const MeshingJob> job;
    StartMode mode = StartMode::Pause;
    double budget = std::numeric_limits<double>::infinity(); ///< elements
    std::uint64_t position = 0;                              ///< StartMode::Pause: advances done where it waits
    ImprovementPace improvement = ImprovementPace::Steps;
    std::uint64_t number = 0; ///< of the run, see RunNumbers
};
struct PlayCommand {
    double rate = 0.0;
};
struct StepCommand {
    Granularity granularity = Granularity::Advance;
    std::int64_t count = 0;
};
struct SeekCommand {
    std::uint64_t advance = 0;
};
struct SeekStopCommand {
    bool forward = true;
};
struct SeekBirthCommand {
    Vec2 place;
    double tolerance = 0.0;
};
struct BreakpointsCommand {
    Breakpoints breakpoints;
};
struct FinishCommand {};
struct PauseCommand {};
struct CancelCommand {};
struct ClearCommand {};
struct LayersCommand {
    SnapshotLayers layers;
};

using SessionCommand =
    std::variant<StartCommand, PlayCommand, StepCommand, SeekCommand, SeekStopCommand, SeekBirthCommand,
                 BreakpointsCommand, FinishCommand, PauseCommand, CancelCommand, ClearCommand, LayersCommand>;

} // namespace forefront
