#pragma once

#include "core/base/api.hpp"

#include <cstdint>

namespace FOREFRONT_API forefront {

/// How much work the mesh is given after the front has closed. Default swaps and smooths in a fraction of the time of
/// the front; Best takes several times as long for the best shapes and edges nearest to the spacing, and lets nodes
/// come and go.
enum class ImproveLevel : std::uint8_t { None, Default, Best };

} // namespace forefront
