#pragma once

#include "core/io/text/text_writer.hpp"
#include "core/mesh/mesh.hpp"

namespace forefront {

/// The section $PhysicalNames, the same in MSH 2.2 and 4.1: points and edges by boundary name, triangles by region
/// name.
void writePhysicalNames(const Mesh &mesh, TextWriter &out);

} // namespace forefront
