#include "core/drawing/commands/mesh_constraints.hpp"

#include "core/drawing/commands/join_segments.hpp"
#include "core/drawing/picking/pick_index.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_commands.hpp"

#include <memory>
#include <utility>

namespace forefront {

Result<Document> pinNode(const Document &document, Vec2 at, std::int32_t tag) {
    const double reach = samePlaceDistance(document);
    const PickIndex index(std::make_shared<const Document>(document));
    const auto hit = index.segment(at, reach, [](const Shape &) { return true; });
    if (hit && (distance(at, hit->a) <= reach || distance(at, hit->b) <= reach)) {
        return error("not-possible", "the drawing already has a node there");
    }
    if (hit) {
        return insertNode(document, hit->ref, at);
    }
    Shape point;
    point.form = PointForm{};
    point.use = ShapeUse::Constraint;
    point.nodes = {at};
    point.tag = tag;
    return addShape(document, std::move(point));
}

Result<Document> keepEdge(const Document &document, Vec2 a, Vec2 b, std::int32_t tag) {
    Shape edge;
    edge.form = PathForm{.closed = false};
    edge.use = ShapeUse::Constraint;
    edge.nodes = {a, b};
    edge.tag = tag;
    const std::uint32_t id = document.nextId;
    Result<Document> next = addShape(document, std::move(edge));
    return next ? joinToSegments(*next, id) : next;
}

} // namespace forefront
