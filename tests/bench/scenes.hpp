#pragma once

#include "core/engine/mesher/options.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace forefront::bench {

/// A named case of a stated size.
struct Scene {
    std::string name;
    MeshingJob job;
};

/// "square", "disc": uniform, about `size` triangles. "graded": rectangle [0,60]x[0,40], ρ = max(r,
/// 0.232·||p-(30,20)|-12|) with r = size. "ramp": ρ grows by 1e4 across a rectangle, about `size` triangles. "islands":
/// a coast with 300 islands, `size` sets the open water. "coast": a fractal coast with 40 islands, `size` segments,
/// automatic spacing. Returns std::nullopt for any other name.
std::optional<Scene> makeScene(std::string_view name, double size);

} // namespace forefront::bench
