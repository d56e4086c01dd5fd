#pragma once

namespace forefront {

/// Version of the project files this program writes; it reads this and all earlier ones. Version 2 added curves,
/// ellipses and rounded corners.
inline constexpr int kProjectVersion = 2;

} // namespace forefront
