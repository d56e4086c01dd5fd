#include "core/drawing/constraints/moved_parts.hpp"

#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <cstdint>

namespace forefront {
namespace {

void addMoved(const Document &before, const Shape &old, const Document &next, const Shape &shape,
              std::vector<SketchPart> &moved) {
    const std::vector<Vec2> from = handlesOf(old), to = handlesOf(shape);
    if (from.size() != to.size()) {
        return;
    }
    for (std::uint32_t k = 0; k < to.size(); ++k) {
        if (from[k] != to[k]) {
            moved.push_back({shape.id, SketchPartKind::Node, k});
        }
    }
    if (!isPath(shape)) {
        return;
    }
    for (std::uint32_t k = 0; k < shape.path().curves.size() && k < old.path().curves.size(); ++k) {
        const SketchPart arc{shape.id, SketchPartKind::Segment, k};
        if (old.path().curves[k] != shape.path().curves[k] && formOfPart(next, arc) == PartForm::Circle &&
            formOfPart(before, arc) == PartForm::Circle) {
            moved.push_back(arc);
        }
    }
}

} // namespace

std::vector<SketchPart> movedParts(const Document &before, const Document &next) {
    std::vector<SketchPart> moved;
    for (const auto &shape : next.shapes) {
        const Shape *const old = findShape(before, shape->id);
        if (old != nullptr && old != shape.get() && canJoin(*shape) && old->form.index() == shape->form.index()) {
            addMoved(before, *old, next, *shape, moved);
        }
    }
    return moved;
}

} // namespace forefront
