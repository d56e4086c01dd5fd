#pragma once

#include "core/drawing/document/document.hpp"

#include <vector>

namespace forefront {

/// Returns the addresses in `before` of the numbers that had a formula and have none after a change, although their
/// shape, source, marker or other owner is still there.
std::vector<NumberAddress> lostFormulas(const Document &before, const Document &after);

} // namespace forefront
