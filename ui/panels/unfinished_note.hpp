#pragma once

#include <string>

namespace forefront {

struct Shell;

/// Warns that the mesh shown is not whole, with a button that goes to the end of the run; draws nothing if it is.
/// `panel` begins the names of the widgets "PANEL/unfinished" and "PANEL/finish".
void drawUnfinishedNote(Shell &context, const std::string &panel);

} // namespace forefront
