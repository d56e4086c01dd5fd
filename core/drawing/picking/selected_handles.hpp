#pragma once

#include "core/drawing/shapes/plane_map.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <map>
#include <set>

namespace forefront {

/// Returns the handles that move with a selection, by shape; shapes selected as a whole are not included.
std::map<std::uint32_t, std::set<std::uint32_t>> handlesToMove(const Document &document, const Selection &selection);

/// Maps handles of a shape. Fails with no-such-node if one does not exist.
Status mapHandles(Shape &shape, const std::set<std::uint32_t> &handles, const PlaneMap &map);

} // namespace forefront
