#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <vector>

namespace FOREFRONT_API forefront {

/// A face of the domain that is filled by rows of elements from side to side, by transfinite interpolation. Its four
/// sides run between corners; opposite sides get equal numbers of elements. With three corners, the rows meet at the
/// first of them.
struct MappedSpec {
    std::int32_t region = 1; ///< tag; each face of the region is mapped
    /// Places of the corners, 3 or 4 for each face, in any order; empty: the four sharpest ones of each face.
    std::vector<Vec2> corners{};

    friend bool operator==(const MappedSpec &, const MappedSpec &) = default;
};

} // namespace forefront
