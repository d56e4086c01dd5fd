#pragma once

namespace forefront {

/// Version of the project files this program writes; it reads this and all earlier ones.
inline constexpr int kProjectVersion = 1;

} // namespace forefront
