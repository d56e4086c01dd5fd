#pragma once

#include "core/engine/base/api.hpp"

#include <cstdint>
#include <vector>

namespace FOREFRONT_API forefront {

/// What a file says of a mesh beyond the mesh itself.
struct ExportOptions {
    /// Tags of the boundary parts through which water flows; all others are land. Only formats with
    /// FileFormat::hasOpenBoundaries tell them apart.
    std::vector<std::int32_t> openBoundaries;
};

} // namespace forefront
