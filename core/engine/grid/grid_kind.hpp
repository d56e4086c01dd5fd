#pragma once

#include "core/engine/base/enum_words.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace FOREFRONT_API forefront {

/// The background grid that answers the searches of the front. It affects speed, never the mesh.
enum class GridKind : std::uint8_t { None, Uniform, Hierarchical };

template <>
struct EnumWords<GridKind> {
    static constexpr auto kLast = GridKind::Hierarchical;
    static constexpr std::array<std::string_view, 3> kList = {"none", "uniform", "hierarchical"};
};

} // namespace forefront
