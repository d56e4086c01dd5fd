#pragma once

#include "core/engine/base/api.hpp"

#include <cstddef>
#include <string_view>

namespace FOREFRONT_API forefront {

/// Line and column (in bytes) of a byte of a text, both counted from 1.
struct TextPlace {
    int line = 1;
    int column = 1;
};

/// Returns the line and column of a byte; beyond the end, of the end.
TextPlace placeOf(std::string_view text, std::size_t offset);

} // namespace forefront
