#pragma once

#include <cstdint>
#include <vector>

namespace forefront {

/// Returns the icon of the program, a meshed corner with the front ahead of it, as `size` x `size` RGBA pixels, row by
/// row from the top.
std::vector<std::uint8_t> makeIcon(int size);

} // namespace forefront
