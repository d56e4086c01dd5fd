#include "core/drawing/domain/chain_shape.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

Shape shapeOf(ChainPath path) {
    Shape shape;
    shape.form = PathForm{path.closed, std::move(path.curves)};
    shape.nodes = std::move(path.nodes);
    shape.cuts = std::move(path.cuts);
    shape.tag = path.tags.front();
    if (std::any_of(path.tags.begin(), path.tags.end(), [&](std::int32_t tag) { return tag != shape.tag; })) {
        shape.segmentTags = std::move(path.tags);
    }
    if (!path.round.empty()) {
        shape.form = formOf(path.round.size() == 2 ? ShapeKind::Circle : ShapeKind::Ellipse);
        shape.nodes = std::move(path.round);
    }
    return shape;
}

} // namespace forefront
