#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/mesher/front_state.hpp"
#include "core/engine/spacing/spacing_field.hpp"

namespace forefront {

/// Advances the fast method through all strips but the last, the strips of a phase in parallel. Each strip has its own
/// part of Γ, nodes, elements and grid; they are merged in the order of the strips, which gives the same mesh as
/// advancing through the strips one after the other. The state must not have advanced yet; a grid over its Γ must be
/// rebuilt afterwards. `slack`: see gridSlack(). Returns false when cancelled; the state is then unusable, as it is
/// after an exception.
bool runStrips(FrontState &state, const SpacingField &spacing, double slack, unsigned threads, const Progress &progress,
               double estimatedElements);

} // namespace forefront
