#pragma once

namespace forefront {

/// Version of the program, "MAJOR.MINOR.PATCH".
inline constexpr const char *kVersion = FOREFRONT_VERSION;

} // namespace forefront
