#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Reads a DXF drawing in ASCII, versions R12 to 2018. Closed curves and lines that form closed loops bound the domain
/// by the even-odd rule; other lines are constraints. Each layer is a part with its name. ImportOptions::layer is the
/// name of a layer, or several with commas between them; without it, all layers are read but frozen ones and those
/// that are off. Curves stay exact, except for those of kDxfSplineError.
Result<Domain> readDxf(const SourceText &source);
/// Returns true if the first bytes of a file show that it is DXF in ASCII.
bool looksLikeDxf(std::string_view head);

} // namespace forefront
