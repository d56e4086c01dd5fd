#include "core/files/gmsh/msh_periodic.hpp"

namespace forefront {

std::array<double, 16> affineOf(const RigidMap &map) {
    return {map.c, 0.0 - map.s, 0.0, map.shift.x, map.s, map.c, 0.0, map.shift.y,
            0.0,   0.0,         1.0, 0.0,         0.0,   0.0,   0.0, 1.0};
}

} // namespace forefront
