#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace FOREFRONT_API forefront {

/// The order in which the classic method takes bases from Γ. Segments that were deferred come after all others,
/// whatever the order.
enum class BaseRule : std::uint8_t {
    Shortest, ///< by length, of equal ones the oldest
    Oldest,   ///< by age: the front advances in rings
    Longest,  ///< by length, the longest first, of equal ones the oldest
    Random    ///< by a number drawn for each segment, see FrontRules::seed
};

template <>
struct EnumWords<BaseRule> {
    static constexpr auto kLast = BaseRule::Random;
    static constexpr std::array<std::string_view, 4> kList = {"shortest", "oldest", "longest", "random"};
};

} // namespace forefront
