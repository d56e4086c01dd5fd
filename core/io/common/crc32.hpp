#pragma once

#include <cstdint>
#include <string_view>

namespace forefront {

/// Returns the check sum of the chunks of PNG files (ISO 3309).
std::uint32_t crc32(std::string_view bytes);

} // namespace forefront
