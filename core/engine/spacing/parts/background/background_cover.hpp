#pragma once

#include "core/engine/spacing/parts/background/background_part.hpp"
#include "core/engine/spacing/parts/part_input.hpp"

namespace forefront {

/// Compares where a background mesh and the domain lie. Returns the error bad-background if they do not meet, a note if
/// the mesh covers only a part of the domain, and nothing if it covers the domain or the domain has no inside yet.
Diagnostics compareCover(const BackgroundMesh &mesh, const BackgroundPart &part, const PartInput &input);

} // namespace forefront
