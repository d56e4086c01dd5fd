#include "core/drawing/document/shape.hpp"

namespace forefront {

ShapeForm formOf(ShapeKind kind) {
    switch (kind) {
    case ShapeKind::Polygon:
        break;
    case ShapeKind::Polyline:
        return PathForm{.closed = false};
    case ShapeKind::Rectangle:
        return RectangleForm{};
    case ShapeKind::Circle:
        return CircleForm{};
    case ShapeKind::Point:
        return PointForm{};
    case ShapeKind::Ellipse:
        return EllipseForm{};
    case ShapeKind::Slot:
        return SlotForm{};
    }
    return PathForm{};
}

} // namespace forefront
