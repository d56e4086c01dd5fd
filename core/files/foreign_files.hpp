#pragma once

#include "core/engine/base/diagnostic.hpp"

#include <string>
#include <string_view>

namespace forefront {

/// Names the kind of a file that cannot be read, but is often taken for one that can, such as a shapefile or a web
/// page, and says how to convert it. Empty for all other files.
Diagnostics foreignFile(std::string_view bytes);

/// Returns the name of the outermost element of XML or HTML, in lower case; empty if there is none.
std::string rootElement(std::string_view head);

} // namespace forefront
