#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/mesher/front_state.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/spacing/spacing_field.hpp"

namespace forefront {

/// Advances the fast method through all strips but the last, the strips of a phase in parallel. Each strip has its own
/// part of Γ, nodes, elements and grid; they are merged in the order of the strips, which gives the same mesh as
/// advancing through the strips one after the other. The state must not have advanced yet; a grid over its Γ must be
/// rebuilt afterwards. Returns false when cancelled or when there are more than `maxElements`; the state is then
/// unusable, as it is after an exception.
bool runStrips(FrontState &state, const SpacingField &spacing, unsigned threads, const Progress &progress,
               double estimatedElements, std::uint64_t maxElements = kMaxElements);

} // namespace forefront
