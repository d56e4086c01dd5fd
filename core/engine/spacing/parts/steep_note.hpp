#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/spacing/parts/part_input.hpp"

#include <span>
#include <string>

namespace forefront {

/// Returns the note that an expression or a mesh, `what`, changes faster than elements can follow and is limited.
Diagnostic steepNote(const std::string &what, Vec2 at);

/// Adds a note for each growth of a source, boundary part, segment, node or region that elements cannot follow, unless
/// a gradation is given. `names`: of the regions, by index into PlacedSizes::regions.
void noteSteepSources(const PartInput &input, Diagnostics &notes);
void noteSteepParts(const PartInput &input, Diagnostics &notes);
void noteSteepSegments(const PartInput &input, Diagnostics &notes);
void noteSteepNodes(const PartInput &input, Diagnostics &notes);
void noteSteepRegions(const PartInput &input, std::span<const std::string> names, Diagnostics &notes);

/// Adds a note if the limited background mesh `gentle` has a lower value than the given one anywhere in the domain.
void noteSteepMesh(const BackgroundMesh &gentle, const PartInput &input, Diagnostics &notes);

} // namespace forefront
