#pragma once

#include "ui/parts/shell.hpp"

#include <string>
#include <string_view>

namespace forefront {

class CanvasPainter;

/// Uses after which the hint of a tool no longer appears.
inline constexpr int kHintedUses = 2;

/// Returns what a click or drag with the tool does now; empty for a tool without a hint, and once it was used
/// kHintedUses times. `tool`: its id; `begun`: it has unfinished input.
std::string pointerHint(const Settings &settings, std::string_view tool, bool begun);

/// Returns true once the keys of the strip on the canvas are known: two of them were used, or the first mesh was made.
/// There is one strip for an empty drawing and one for others. Counted in Settings::toolUses, beside the tools.
bool knowsKeys(const Shell &context);
/// Counts a key without modifiers that was pressed, if it is in the strip that the drawing has.
void countKeyUse(Shell &context, int code);
/// Ends the strip of a drawing that is not empty.
void retireKeys(Shell &context);
/// Makes all keys unknown again.
void renewKeys(Shell &context);

/// Draws the hint of the active tool beside the pointer, unless hints are switched off.
void drawPointerHint(CanvasPainter &painter, Shell &context);

/// Counts the uses of a tool for its hint: the steps that it adds to the history while it handles an event.
class ToolUse {
  public:
    explicit ToolUse(const Shell &context);
    /// Call after the event. Counts one use if the tool has added a step.
    void finish(Shell &context) const;

  private:
    std::string tool_; ///< empty: its hint no longer appears
    std::string step_; ///< of the history before the event
};

} // namespace forefront
