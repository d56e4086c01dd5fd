#pragma once

#include "core/files/format_list.hpp"

namespace FOREFRONT_API forefront {

/// Returns all formats: projects, maps, drawings, and those of the engine.
const FormatList &allFormats();

} // namespace forefront
