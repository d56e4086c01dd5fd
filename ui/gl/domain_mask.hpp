#pragma once

#include "core/domain/domain.hpp"
#include "ui/canvas/camera.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Coverage of the domain (even-odd over its boundary segments) in the pixels of the viewport, row by row from the
/// bottom, 0..255. Exact along x, sampled at the middle of each row along y.
std::vector<std::uint8_t> rasteriseDomain(const Domain &domain, const Camera &camera, int width, int height);

} // namespace forefront
