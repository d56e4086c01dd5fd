#pragma once

#include "core/engine/mesher/trace.hpp"

#include <cstddef>
#include <string>

namespace forefront {

/// Returns a moment of an advance of the two-coloured front as a caption, as caption() does, without the edge.
std::string squareCaption(const AdvanceExplanation &explanation, std::size_t cursor);

} // namespace forefront
