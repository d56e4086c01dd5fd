#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/source/source.hpp"

namespace forefront {

/// Returns the sizes of the elements of a mesh as a spacing, with a note that they are used since the file has no
/// values. Error: "no-values", the mesh has no elements.
Result<SpacingSpec> elementSizes(const Mesh &mesh, const SourceText &source);

} // namespace forefront
