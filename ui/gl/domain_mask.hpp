#pragma once

#include "core/domain/domain.hpp"
#include "ui/canvas/camera.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Returns the coverage of the pixels of the viewport by the domain (even-odd over its boundary segments), 0 to 255,
/// row by row from the bottom. Exact along x, sampled at the middle of each row along y.
std::vector<std::uint8_t> rasteriseDomain(const Domain &domain, const Camera &camera, int width, int height);

} // namespace forefront
