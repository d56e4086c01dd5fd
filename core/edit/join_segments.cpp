#include "core/edit/join_segments.hpp"

#include "core/edit/pick_index.hpp"
#include "core/edit/shape_commands.hpp"
#include "core/edit/shape_geometry.hpp"

#include <algorithm>
#include <tuple>

namespace forefront {
namespace {

bool isRound(const Shape &shape) {
    return shape.kind == ShapeKind::Circle || shape.kind == ShapeKind::Ellipse;
}

} // namespace

Document joinToSegments(const Document &document, std::uint32_t id) {
    const Shape *shape = findShape(document, id);
    const double reach = 1e-9 * boundsOf(document).diagonal();
    if (shape == nullptr || isRound(*shape) || !(reach > 0.0)) {
        return document;
    }
    const PickIndex index(std::make_shared<const Document>(document));
    const auto others = [&](const Shape &other) { return other.id != id && !isRound(other); };
    std::vector<std::tuple<SegmentRef, double, Vec2>> meetings;
    for (const Vec2 node : outlineOf(*shape).nodes) {
        const auto hit = index.segment(node, reach, others);
        if (hit && distance(node, hit->a) > reach && distance(node, hit->b) > reach) {
            meetings.emplace_back(hit->ref, hit->t, node);
        }
    }
    // From the last segment to the first, and backwards along each, so that insertions do not shift later places.
    std::sort(meetings.begin(), meetings.end(), [](const auto &a, const auto &b) {
        return std::tie(std::get<0>(b), std::get<1>(b)) < std::tie(std::get<0>(a), std::get<1>(a));
    });
    Document joined = document;
    for (const auto &[ref, t, node] : meetings) {
        if (Result<Document> next = insertNode(joined, ref, node)) {
            joined = *std::move(next);
        }
    }
    return joined;
}

} // namespace forefront
