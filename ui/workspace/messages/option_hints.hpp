#pragma once

#include "core/engine/base/diagnostic.hpp"

#include <string>
#include <string_view>

namespace forefront {

/// Where the editor offers the options for reading a file.
inline constexpr std::string_view kInImport = "in File > Import drawing, ";

/// Replaces the options of the command line that a text of the core suggests by what to do in the editor, preceded by
/// `place`; empty within the import dialog.
std::string withEditorHints(std::string text, std::string_view place = kInImport);
Diagnostic withEditorHints(Diagnostic diagnostic);

} // namespace forefront
