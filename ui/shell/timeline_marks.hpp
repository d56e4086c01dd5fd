#pragma once

#include "core/engine/session/snapshot.hpp"
#include "ui/input/pixels.hpp"
#include "ui/parts/shell.hpp"

#include <optional>
#include <string>

namespace forefront::shell {

/// The scale of the timeline: advances from left to right, in pixels.
struct TimeAxis {
    float left = 0.0F, right = 0.0F;
    std::uint64_t known = 0; ///< advances at the right end, > 0

    float x(double advance) const {
        return left + static_cast<float>(advance / static_cast<double>(known)) * (right - left);
    }
    std::uint64_t advanceAt(float x) const;
};

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
