#pragma once

#include "core/drawing/document/document.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace forefront {

struct EditState;
struct Workspace;

namespace ui {
class Flow;
}

/// Draws the option "Tag [ 1 ]  name" for the next shape drawn.
void drawTagOption(Workspace &context, ui::Flow &flow, EditState &state, ShapeUse use, const char *tooltip);
/// Draws the option "LABEL [ 0.5 ]" for a positive number. `unit`: of a length. Returns true if it changed.
bool drawSizeOption(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                    const char *tooltip, LengthUnit unit = LengthUnit::None);
/// Draws the option for an optional length in the unit of the document; the empty field shows the hint.
bool drawOptionalSizeOption(Workspace &context, ui::Flow &flow, const char *name, const char *label,
                            std::optional<double> &value, const char *hint, const char *tooltip);

/// Draws the option "LABEL [ 0.5 ]" for a number of the next item drawn, which follows the expression `formula` until
/// it is drawn: see ui::inputExpression(). Returns true if it changed.
bool drawFormulaOption(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                       std::string &formula, const char *tooltip, bool zero, LengthUnit unit = LengthUnit::None);

/// Draws the option "LABEL [ 0.5 ]" for a number that is not negative; `unit`: of a length. Returns true if it changed.
bool drawLengthOption(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                      const char *tooltip, LengthUnit unit = LengthUnit::None);

} // namespace forefront
