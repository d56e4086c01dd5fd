#pragma once

#include "core/files/format_list.hpp"

namespace FOREFRONT_API forefront {

/// Returns all formats: projects, maps, drawings, and the engine's own.
const FormatList &allFormats();

} // namespace forefront
