#pragma once

#include "core/base/api.hpp"
#include "core/base/enum_words.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace FOREFRONT_API forefront {

/// How much work the mesh is given after the front has closed. Default swaps and smooths in a fraction of the time of
/// the front; Best takes several times as long for the best shapes and edges nearest to the spacing, and lets nodes
/// come and go.
enum class ImproveLevel : std::uint8_t { None, Default, Best };

template <>
struct EnumWords<ImproveLevel> {
    static constexpr auto kLast = ImproveLevel::Best;
    static constexpr std::array<std::string_view, 3> kList = {"none", "default", "best"};
};

} // namespace forefront
