#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Reads the shapes of an SVG drawing. Closed outlines bound the domain by the even-odd rule, open ones are
/// constraints.
Result<Domain> readSvg(const SourceText &source);
/// Reads the shapes as drawn, unlike readSvg(): each has segments and nodes of its own, even where it meets or overlaps
/// another shape, and nothing outside the domain is dropped. Shapes drawn twice are read once. A drawing without closed
/// outlines is read as by readSvg().
Result<Domain> readSvgShapes(const SourceText &source);
/// Returns true if the first bytes of a file show that it is SVG.
bool looksLikeSvg(std::string_view head);

} // namespace forefront
