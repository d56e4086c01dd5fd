#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace forefront {

struct Workspace;

namespace ui {

/// Draws an entry() for a number. Logs an error for anything but a finite number and keeps the old value.
bool inputNumber(Workspace &context, std::string_view name, double &value, float width = -1.0F);
/// Parses a typed number; reports an invalid one in the log and returns nothing.
std::optional<double> typedNumber(Workspace &context, const std::string &typed);

} // namespace ui
} // namespace forefront
