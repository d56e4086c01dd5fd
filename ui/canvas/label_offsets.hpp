#pragma once

#include "ui/input/pixels.hpp"

#include <vector>

namespace forefront {

/// Returns the offsets from a place at which a label is tried, in order: `offset`, the other side of the place, and
/// levels below and above both. `size` is that of the label with its plate; all in design pixels.
std::vector<Pixel> offsetsBeside(Pixel size, Pixel offset);

} // namespace forefront
