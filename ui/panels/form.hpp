#pragma once

#include "core/engine/base/vec2.hpp"
#include "ui/workspace/number_field.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

/// Rows of the editing panels: a muted label in a fixed column, then a field. `name` is the widget name.
namespace forefront::form {

/// Width of the label column, design pixels.
inline constexpr double kLabel = 100.0;

void label(Workspace &context, const char *text);
/// Draws a number field; returns true when a new number was entered. For `address` see ui::inputNumber().
bool number(Workspace &context, const std::string &name, const char *text, double &value,
            const ui::FieldAddress &address = {});
/// Draws an optional number; an empty field shows the hint. Width in design pixels; negative: the rest of the row.
bool optionalField(Workspace &context, const std::string &name, std::optional<double> &value, const char *hint,
                   float width = -1.0F, const ui::FieldAddress &address = {});
/// Returns half of the width left in the row, in design pixels.
float halfWidth(const Workspace &context);
/// Draws a word before a field that shares `width` design pixels with it, such as "min": a hint in the field would be
/// gone once there is a number. Returns the width of the field.
float wordBefore(Workspace &context, const char *word, float width);
/// The addresses of two numbers.
struct PairAddress {
    ui::FieldAddress x, y;
};
/// Draws two numbers side by side, "NAME/x" and "NAME/y".
bool pair(Workspace &context, const std::string &name, const char *text, Vec2 &value, const PairAddress &address = {});
bool text(Workspace &context, const std::string &name, const char *text, std::string &value, const char *hint);
/// Draws fields for a tag >= 1 and its name. Returns true when the tag changed; a new name is stored in `rename`.
bool tag(Workspace &context, const std::string &name, const char *text, std::int32_t &value,
         const std::string &shownName, std::optional<std::string> &rename);

} // namespace forefront::form
