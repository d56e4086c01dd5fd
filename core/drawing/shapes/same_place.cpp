#include "core/drawing/shapes/same_place.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"

namespace forefront {

double samePlaceDistance(const Document &document) {
    Box2 lines, points;
    for (const auto &shape : document.shapes) {
        (shape->is<PointForm>() ? points : lines).add(boundsOf(*shape));
    }
    return document.shapes.empty() ? 0.0 : kSamePlace * length((lines.empty() ? points : lines).size());
}

} // namespace forefront
