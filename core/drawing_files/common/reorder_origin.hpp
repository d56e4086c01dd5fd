#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/files/source/domain_origin.hpp"

namespace forefront {

/// Puts the places of the parts of a domain into the order of `after`, which has the same parts in another order; nodes
/// may differ by rounding. Region markers must come in the same order.
void reorderOrigin(const Domain &before, const Domain &after, DomainOrigin &origin);

} // namespace forefront
