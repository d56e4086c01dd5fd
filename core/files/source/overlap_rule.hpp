#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace FOREFRONT_API forefront {

/// Decides which feature a face belongs to where several cover it. Under either rule, a feature inside another feature
/// keeps its own area.
enum class OverlapRule : std::uint8_t {
    Later,  ///< the one that comes later in the file, as in a painting
    Smaller ///< the one with the smaller area; the later of equal ones
};

template <>
struct EnumWords<OverlapRule> {
    static constexpr auto kLast = OverlapRule::Smaller;
    static constexpr std::array<std::string_view, 2> kList = {"later", "smaller"};
};

} // namespace forefront
