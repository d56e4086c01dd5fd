#include "core/files/source/picture_sizes.hpp"

#include <algorithm>

namespace forefront {

Box2 pictureBoxAround(const Box2 &box, double columns, double rows) {
    const Vec2 extent = box.empty() ? Vec2{} : box.size();
    const double pixel = std::max(extent.x / columns, extent.y / rows);
    const double side = pixel > 0.0 ? pixel : 1.0 / rows;
    const Vec2 size{side * columns, side * rows};
    const Vec2 low = (box.empty() ? Vec2{0.5 * size.x, 0.5 * size.y} : box.centre()) - 0.5 * size;
    return {low, low + size};
}

} // namespace forefront
