#pragma once

#include <cstdint>

namespace forefront {

/// The tag of the faces without a marker of their region. Settings of this region stay where no such face is left.
inline constexpr std::int32_t kUnmarkedRegion = 1;

} // namespace forefront
