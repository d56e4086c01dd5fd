#pragma once

#include "core/drawing/document/number_address.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace forefront {

struct Workspace;

namespace ui {

/// The address of the number of the document that a field shows, if it shows one.
using FieldAddress = std::optional<NumberAddress>;

/// The digits that a field shows while it is not edited: those of coordinateText(), or of listedNumber(). While it is
/// edited, it shows all.
enum class Digits : std::uint8_t { Rounded, Listed };

/// Draws an entry() for a number or an expression of the parameters. A text without a finite value is reported beside
/// the field and in the log, and the old value is kept. A field with an address shows the formula that its number
/// follows; a formula typed there is stored by the next Workspace::applyCommand() in this frame. A field without one
/// says that the parameters in a typed expression are used only once. The field of a length shows the unit of the
/// document, and a length typed in another unit, such as "2 in", is converted to it. `unit`: of a length without an
/// address.
bool inputNumber(Workspace &context, std::string_view name, double &value, float width = -1.0F,
                 const FieldAddress &address = {}, LengthUnit unit = LengthUnit::None);
/// Refuses the text that the field has just committed: the field keeps it with the focus, the old value stays in
/// effect, `reason` is shown beside the field, and the log has the faults.
void refuseEntry(Workspace &context, std::string_view name, const Diagnostics &faults, std::string reason);
/// Reports faults in the log, and the first one beside the field that was last committed in this frame, if any.
void refuseCommand(Workspace &context, const Diagnostics &faults);
/// Returns true if a number entered in the field is positive, or 0 where `zero` allows that; otherwise it is reported
/// like a text without a value.
bool checkPositive(Workspace &context, std::string_view name, double value, bool zero = false);
/// The same for a number from `minimum` to `maximum`.
bool checkRange(Workspace &context, std::string_view name, double value, double minimum, double maximum);
/// The same for a whole number from `minimum` to `maximum`.
bool checkWhole(Workspace &context, std::string_view name, double value, double minimum, double maximum);
/// The same as inputNumber() for an optional number; without one, the field is empty and shows the hint.
bool inputOptional(Workspace &context, std::string_view name, std::optional<double> &value, const char *hint,
                   float width = -1.0F, const FieldAddress &address = {}, LengthUnit unit = LengthUnit::None);

constexpr double kMaxTag = 1e9;
/// Returns true for a number that can be a tag, a whole number from 1 to kMaxTag; reports any other like a text without
/// a value.
bool checkTag(Workspace &context, std::string_view name, double value);

/// The same as inputNumber() for a number whose expression the caller keeps in `formula`, which is shown instead of the
/// number; empty for a plain number. `unit`: of a length. Returns true if either changed.
bool inputExpression(Workspace &context, std::string_view name, double &value, std::string &formula,
                     float width = -1.0F, LengthUnit unit = LengthUnit::None);

/// A number and the expression that it was typed as; empty for a plain number.
struct TypedNumber {
    double value = 0.0;
    std::string formula;
};
/// Returns the number that is being typed into a field; none if the text is unchanged or has no value.
std::optional<TypedNumber> numberBeingTyped(const Workspace &context, std::string_view name);
/// Returns true while a field whose name begins with `prefix` shows that its text was refused.
bool showsFault(const Workspace &context, std::string_view prefix);

/// Draws the fields "NAME/x" and "NAME/y" of a point side by side, each `width` design pixels wide. "x, y" typed into
/// one of them sets both; "1,5" without a blank is refused, since it may be meant as one number.
bool inputPoint(Workspace &context, const std::string &name, Vec2 &value, float width, const FieldAddress &addressX,
                const FieldAddress &addressY, Digits digits = Digits::Rounded);

/// Draws an entry() beside which refuseEntry() and refuseCommand() can report.
bool inputName(Workspace &context, std::string_view name, std::string &value, std::string_view hint = {},
               float width = -1.0F, bool selectAll = false);
/// Draws a field for a text that the caller checks and may refuse, see refuseEntry(). Returns the new text when one was
/// committed. An empty field shows the hint.
std::optional<std::string> inputChecked(Workspace &context, std::string_view name, const std::string &shown,
                                        std::string_view hint, float width);

} // namespace ui
} // namespace forefront
