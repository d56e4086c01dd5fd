#pragma once

#include "core/files/source/import_notes.hpp"
#include "ui/parts/shell.hpp"

#include <optional>
#include <string>

namespace forefront {

/// Asks which layers of a file are read: one in a list, or switches where several can be. `chosen`: the layers as
/// ImportOptions::layer takes them; none: those of `contents`. Widths are in design pixels. Returns true if the choice
/// changed.
bool drawLayerChoice(Shell &context, const DrawingContents &contents, std::optional<std::string> &chosen, float labels,
                     float choices);

} // namespace forefront
