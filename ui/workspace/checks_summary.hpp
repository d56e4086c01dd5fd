#pragma once

#include <cstdint>
#include <string>

namespace forefront {

struct Workspace;

/// The result of all checks: of the drawing, and of the mesh against the limits that the user has set.
struct ChecksSummary {
    enum class State : std::uint8_t {
        None,       ///< nothing to check
        Unfinished, ///< the run stands before its end, so that its mesh cannot be judged
        Ready,      ///< the drawing has no errors, and no limits are checked
        Met,        ///< the mesh meets all limits
        Violated    ///< the drawing has errors, or the mesh violates a limit
    };
    State state = State::None;
    std::string line;   ///< "1 limit fails: minimum angle 32.9° < 34°"
    std::string brief;  ///< for the status bar: "1 limit fails"; empty: nothing to tell
    bool warns = false; ///< the drawing has warnings, which `line` and `brief` count
};

ChecksSummary checksSummary(const Workspace &context);

/// Returns why the mesh shown must not be judged yet: "Unfinished mesh: advance 12 of 340"; empty if it is whole, being
/// made at full speed, or not the mesh of a run.
std::string unfinishedText(const Workspace &context);

} // namespace forefront
