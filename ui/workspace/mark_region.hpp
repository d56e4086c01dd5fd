#pragma once

#include "core/engine/base/vec2.hpp"

#include <cstdint>

namespace forefront {

struct Document;
struct Workspace;

/// Returns the tag that the next new region gets: a free one, and not 1, which faces without a region have.
std::int32_t tagOfNewRegion(const Document &document);

/// Makes the face at a place a region and selects it. Returns false, and says why, if that is not possible.
bool markRegion(Workspace &context, Vec2 place, std::int32_t tag);

} // namespace forefront
