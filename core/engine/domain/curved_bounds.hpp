#pragma once

#include "core/engine/domain/domain.hpp"

namespace forefront {

/// Returns the box of all nodes with finite coordinates and of the parts of curves that segments follow, which may
/// reach beyond their chords.
Box2 curvedBounds(const Domain &domain);

} // namespace forefront
