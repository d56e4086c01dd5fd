#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

/// Moves the corners of mapped regions with the nodes that they are, in a drawing that a command and the joints have
/// changed. Corners that the command has set itself stay. `tolerance`: the distance within which a corner is a node.
Document carryCorners(const Document &before, Document after, double tolerance);

} // namespace forefront
