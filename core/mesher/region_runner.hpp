#pragma once

#include "core/base/progress.hpp"
#include "core/mesher/front_state.hpp"
#include "core/spacing/spacing_field.hpp"

namespace forefront {

/// Advances the fast method through all regions but the last, those of a phase at once: each on a part of Γ of its own,
/// with nodes, elements and grid of its own, put together in the order of the regions. That gives the mesh that
/// advancing through them one after the other gives. The state must stand before its first advance; a grid over its Γ
/// must be made anew afterwards. `slack`: see gridSlack(). False when cancelled: the state is
/// then of no use any more, as after an exception.
bool runRegions(FrontState &state, const SpacingField &spacing, double slack, unsigned threads,
                const Progress &progress, double estimatedElements);

} // namespace forefront
