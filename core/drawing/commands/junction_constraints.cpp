#include "core/drawing/commands/junction_constraints.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Maximum turn of a path at a smooth junction, radians.
constexpr double kSmoothTurn = 1e-6;

/// A node where two segments of a path, not both straight, meet smoothly.
struct Junction {
    Vec2 at;
    std::uint32_t before = 0, after = 0; ///< segments
};

std::vector<Junction> junctionsOf(const Shape &shape) {
    std::vector<Junction> junctions;
    if (!isPath(shape)) {
        return junctions;
    }
    const Outline outline = outlineOf(shape);
    const auto count = static_cast<std::uint32_t>(outline.segmentCount());
    for (std::uint32_t k = outline.closed ? 0 : 1; k < count; ++k) {
        const std::uint32_t earlier = k == 0 ? count - 1 : k - 1;
        if (earlier == k || (!outline.isCurved(earlier) && !outline.isCurved(k))) {
            continue;
        }
        const Vec2 in = outline.curve(earlier).tangent(1.0), out = outline.curve(k).tangent(0.0);
        if (std::fabs(std::atan2(cross(in, out), dot(in, out))) < kSmoothTurn) {
            junctions.push_back({outline.from(k), earlier, k});
        }
    }
    return junctions;
}

/// Returns the segments and nodes of a shape that constraints name.
std::set<SketchPart> constrainedParts(const Document &document, std::uint32_t shape) {
    std::set<SketchPart> parts;
    for (const auto &constraint : document.constraints) {
        for (const SketchPart &part : constraint->parts) {
            if (part.shape == shape) {
                parts.insert(part);
            }
        }
    }
    return parts;
}

/// Returns true if a segment of a path or one of its ends is among some parts.
bool touchesParts(const std::set<SketchPart> &parts, const Shape &shape, std::uint32_t segment) {
    const auto end = (segment + 1) % static_cast<std::uint32_t>(shape.nodes.size());
    return parts.contains({shape.id, SketchPartKind::Segment, segment}) ||
           parts.contains({shape.id, SketchPartKind::Node, segment}) ||
           parts.contains({shape.id, SketchPartKind::Node, end});
}

} // namespace

Document constrainJunctions(const Document &before, const Document &after) {
    Document next = after;
    const double near = samePlaceDistance(after);
    for (const auto &shape : after.shapes) {
        const Shape *const earlier = findShape(before, shape->id);
        const std::set<SketchPart> parts = constrainedParts(after, shape->id);
        if (parts.empty() || earlier == nullptr || earlier == shape.get()) {
            continue;
        }
        const std::vector<Junction> known = junctionsOf(*earlier);
        for (const Junction &junction : junctionsOf(*shape)) {
            const bool old = std::any_of(known.begin(), known.end(), [&](const Junction &other) {
                return distance(other.at, junction.at) <= near;
            });
            if (old || !(touchesParts(parts, *shape, junction.before) || touchesParts(parts, *shape, junction.after))) {
                continue;
            }
            // Refused where the other constraints imply it, or curves of these kinds cannot be tied.
            if (Result<Document> tied = addConstraint(next, ConstraintKind::Tangent,
                                                      {{shape->id, SketchPartKind::Segment, junction.before},
                                                       {shape->id, SketchPartKind::Segment, junction.after}})) {
                next.constraints = std::move(tied->constraints);
                next.nextId = tied->nextId;
            }
        }
    }
    return next;
}

} // namespace forefront
