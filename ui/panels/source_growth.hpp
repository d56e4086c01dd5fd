#pragma once

#include "core/drawing/document/number_address.hpp"

namespace forefront {

struct Shell;
struct SizeSource;

/// Draws the rows of the inspector for how the size of a source changes away from it: its growth, or for a line whether
/// it is a gradient over the plane, and how that changes. `address` is that of the growth. Returns true if it changed.
bool drawSourceGrowth(Shell &context, SizeSource &source, const NumberAddress &address);

} // namespace forefront
