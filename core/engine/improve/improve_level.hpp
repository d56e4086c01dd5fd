#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace FOREFRONT_API forefront {

/// The effort spent on improving the mesh once the front is closed. Default swaps edges and smooths, in a fraction of
/// the time of the front. Best takes several times as long for the best shapes and edge lengths, and also adds and
/// removes nodes. Default does so only where it may bring the geometric mean of α to .95, from
/// .93 on.
enum class ImproveLevel : std::uint8_t { None, Default, Best };

template <>
struct EnumWords<ImproveLevel> {
    static constexpr auto kLast = ImproveLevel::Best;
    static constexpr std::array<std::string_view, 3> kList = {"none", "default", "best"};
};

} // namespace forefront
