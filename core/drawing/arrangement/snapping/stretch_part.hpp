#pragma once

#include "core/drawing/arrangement/snapping/snap_lines.hpp"
#include "core/engine/geometry/curve.hpp"

#include <algorithm>
#include <span>

namespace forefront {

/// Returns the part of a stretch that belongs to the piece from `from` to `to` of its chord. At the ends of the chord
/// the parameters equal the stretch's own exactly, so that its neighbours continue there.
inline CurveStretch stretchAlong(const CurveStretch &stretch, std::span<const Curve> curves, const SnapLine &chord,
                                 Vec2 from, Vec2 to) {
    const Vec2 along = chord.b - chord.a;
    const auto parameter = [&](Vec2 p) {
        const double part = dot(p - chord.a, along) / lengthSquared(along);
        if (part <= 0.0 || part >= 1.0) {
            return part <= 0.0 ? stretch.t0 : stretch.t1;
        }
        return stretch.curve < curves.size() ? curves[stretch.curve].nearest(p, stretch.t0, stretch.t1) : 0.0;
    };
    return {stretch.curve, parameter(from), parameter(to)};
}

} // namespace forefront
