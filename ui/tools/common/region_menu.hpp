#pragma once

#include "core/engine/base/vec2.hpp"
#include "ui/parts/context_menu.hpp"

#include <cstdint>

namespace forefront {

/// Returns the commands on the region of the face at a place, below a heading with its name. Without a region there is
/// only the one that makes the face a region with the tag `next`, if `makes`. Empty outside all faces.
ContextGroup regionMenu(const Shell &context, Vec2 place, bool makes, std::int32_t next);

} // namespace forefront
