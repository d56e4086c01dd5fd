#pragma once

#include "core/engine/quads/quad_report.hpp"
#include "core/files/json/json_writer.hpp"

#include <string>

namespace forefront {

/// Adds the member "quadrilaterals": how they were made, and counts of what could not be avoided.
void addQuads(const QuadReport &quads, JsonWriter &json);

/// Returns lines on how quadrilaterals were made and what could not be avoided. `alone`: no triangles were wanted.
std::string quadLines(const QuadReport &quads, bool alone);

} // namespace forefront
