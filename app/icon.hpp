#pragma once

#include <cstdint>
#include <vector>

namespace forefront {

/// The icon of the program: a meshed corner and the front before it. RGBA, `size` x `size`, from the top.
std::vector<std::uint8_t> makeIcon(int size);

} // namespace forefront
