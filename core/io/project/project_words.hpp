#pragma once

#include <array>
#include <string_view>

namespace forefront {

/// Version of the project files this program writes; it reads this and all earlier ones.
inline constexpr int kProjectVersion = 1;

/// Words of the project file, in the order of the enumerations.
inline constexpr std::array<std::string_view, 5> kShapeKinds = {"polygon", "polyline", "rectangle", "circle", "point"};
inline constexpr std::array<std::string_view, 2> kShapeUses = {"boundary", "constraint"};
inline constexpr std::array<std::string_view, 3> kSourceShapes = {"point", "line", "circle"};
inline constexpr std::array<std::string_view, 2> kMethods = {"fast", "classic"};
inline constexpr std::array<std::string_view, 3> kGridKinds = {"none", "uniform", "hierarchical"};
inline constexpr std::array<std::string_view, 3> kImproveLevels = {"none", "default", "best"};

} // namespace forefront
