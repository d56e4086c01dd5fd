#include "core/engine/domain/curved_bounds.hpp"

#include <cmath>

namespace forefront {

Box2 curvedBounds(const Domain &domain) {
    Box2 box = domain.bounds();
    for (const DomainSegment &segment : domain.segments) {
        const CurveStretch &stretch = segment.stretch;
        const bool sound =
            stretch.curve < domain.curves.size() && std::isfinite(stretch.t0) && std::isfinite(stretch.t1);
        if (!stretch.follows() || !sound) {
            continue;
        }
        const Box2 part = domain.curves[stretch.curve].bounds(stretch.t0, stretch.t1);
        if (isFinite(part.min) && isFinite(part.max)) {
            box.add(part);
        }
    }
    return box;
}

} // namespace forefront
