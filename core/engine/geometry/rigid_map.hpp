#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

namespace FOREFRONT_API forefront {

/// A motion of the plane: p becomes (c x - s y + shift.x, s x + c y + shift.y). A pure translation adds the shift and
/// does nothing else, so that a coordinate whose shift is 0 stays equal to the bit.
struct RigidMap {
    double c = 1.0; ///< cosine of the angle of rotation
    double s = 0.0; ///< sine
    Vec2 shift;

    bool translates() const { return c == 1.0 && s == 0.0; }
    Vec2 operator()(Vec2 p) const {
        return translates() ? p + shift : Vec2{c * p.x - s * p.y + shift.x, s * p.x + c * p.y + shift.y};
    }

    friend bool operator==(const RigidMap &, const RigidMap &) = default;
};

} // namespace forefront
