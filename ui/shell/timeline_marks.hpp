#pragma once

#include "core/engine/session/snapshot.hpp"
#include "ui/input/pixels.hpp"
#include "ui/parts/shell.hpp"

#include <optional>
#include <string>

namespace forefront::shell {

/// The scale of the timeline: advances from left to right, then steps of the improvement, in pixels.
struct TimeAxis {
    float left = 0.0F, right = 0.0F;
    std::uint64_t length = 0; ///< position at the right end, > 0

    float x(double position) const {
        return left + static_cast<float>(position / static_cast<double>(length)) * (right - left);
    }
    std::uint64_t positionAt(float x) const;
};

/// Returns the name of a position of a run: "Advance 12", or after its last advance "Improvement 3".
std::string positionName(const SessionSnapshot &run, std::uint64_t position);

/// Draws the marks below the bar of the timeline, whose middle is at `y`. Where common marks would overlap, only one is
/// drawn; rare marks are always drawn.
void drawMarks(Workspace &context, const TimeAxis &axis, float y);
/// Returns the visible mark under the pointer, the rarest of those within three design pixels.
std::optional<TimelineMark> markUnderPointer(const Workspace &context, const TimeAxis &axis, float y);
/// Returns the name of a kind of mark, such as "Deferral".
const char *markName(MarkKind kind);

/// Draws the button that opens the popup for breakpoints and marks, and the popup while it is open.
void drawBreakpointsButton(Shell &context);

/// Returns why a run stopped, or what was found: "Two fronts join. "; empty without a reason.
std::string stopText(const SessionSnapshot &run, const Breakpoints &breakpoints);

} // namespace forefront::shell
