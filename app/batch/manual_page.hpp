#pragma once

#include "app/batch/option_table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Returns the manual page forefront(1) in the man macros of troff, of the same texts as the help. `usage` is the help
/// text of the program: a title, the commands, a heading "Examples:" with examples, and a line of exit codes.
std::string manualPage(std::string_view usage, const std::vector<CommandInfo> &commands);

} // namespace forefront
