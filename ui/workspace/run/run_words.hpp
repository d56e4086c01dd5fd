#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/session/meshing_session.hpp"

#include <string>

namespace forefront {

/// Returns a line for the log on the finished mesh of a run: its elements and nodes, seconds and quality.
std::string resultText(const SessionSnapshot &run);

/// Returns a line on the preview of a mesh with larger elements.
std::string previewText(const SessionSnapshot &run);

/// Returns the notes on a finished mesh: the rules of the specified spacing, the curves that the mesh does not follow,
/// uneven elements of second order, and the places with smaller angles than the least one.
Diagnostics notesOf(const SessionSnapshot &run);

} // namespace forefront
