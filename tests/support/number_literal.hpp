#pragma once

#include "core/drawing/document/number_address.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace forefront {

/// Returns the address that a text of a project file stands for: "shape/1/radius"_number. Throws for an invalid text.
inline NumberAddress operator""_number(const char *text, std::size_t size) {
    return parseAddress(std::string_view(text, size)).value();
}

} // namespace forefront
