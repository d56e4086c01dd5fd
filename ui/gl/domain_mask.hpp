#pragma once

#include "core/engine/domain/domain.hpp"
#include "ui/canvas/camera.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Returns how much of each pixel of the viewport the domain covers (even-odd over its boundary segments), 0 to 255,
/// row by row from the bottom. Exact along x, sampled at the middle of each row along y.
std::vector<std::uint8_t> rasteriseDomain(const Domain &domain, const Camera &camera, int width, int height);

} // namespace forefront
