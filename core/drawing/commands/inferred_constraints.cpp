#include "core/drawing/commands/inferred_constraints.hpp"

#include "core/drawing/constraints/carried_parts.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/same_place.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace forefront {
namespace {

/// Finds the parts of a path by their places.
class PathParts {
  public:
    PathParts(const Document &document, std::uint32_t shape)
        : shape_(findShape(document, shape)), near_(samePlaceDistance(document)) {}

    std::optional<SketchPart> node(Vec2 at) const {
        for (std::uint32_t k = 0; shape_ != nullptr && isPath(*shape_) && k < shape_->nodes.size(); ++k) {
            if (distance(shape_->nodes[k], at) <= near_) {
                return SketchPart{shape_->id, SketchPartKind::Node, k};
            }
        }
        return std::nullopt;
    }
    /// Returns the segment from one place to another, or the reverse.
    std::optional<SketchPart> segment(Vec2 a, Vec2 b) const {
        if (shape_ == nullptr || !isPath(*shape_)) {
            return std::nullopt;
        }
        const Outline outline = outlineOf(*shape_);
        std::optional<SketchPart> reverse;
        for (std::uint32_t k = 0; k < outline.segmentCount(); ++k) {
            const Vec2 from = outline.from(k), to = outline.to(k);
            const SketchPart part{shape_->id, SketchPartKind::Segment, k};
            if (distance(from, a) <= near_ && distance(to, b) <= near_) {
                return part;
            }
            if (!reverse && distance(from, b) <= near_ && distance(to, a) <= near_) {
                reverse = part;
            }
        }
        return reverse;
    }

    /// Returns the circle, or the arc of one, about a place and through another.
    std::optional<SketchPart> circle(Vec2 centre, Vec2 at) const {
        if (shape_ == nullptr) {
            return std::nullopt;
        }
        if (shape_->is<CircleForm>()) {
            return SketchPart{shape_->id, SketchPartKind::Segment, 0};
        }
        for (std::uint32_t k = 0; isPath(*shape_) && k < shape_->path().curves.size(); ++k) {
            const Curve &curve = shape_->path().curves[k];
            const std::array<double, 8> n = curve.numbers();
            const std::optional<double> radius = radiusOf(curve);
            if (radius && distance({n[0], n[1]}, centre) <= near_ &&
                std::fabs(*radius - distance(centre, at)) <= near_) {
                return SketchPart{shape_->id, SketchPartKind::Segment, k};
            }
        }
        return std::nullopt;
    }

  private:
    const Shape *shape_;
    double near_;
};

/// Returns the parts of a tangent of two segments of a path that meet where `relation` starts.
std::vector<SketchPart> partsOfTangent(const Document &document, const PathParts &parts, const SketchPart &other,
                                       const SketchPart &own, Vec2 joint) {
    const std::optional<SketchPart> at = parts.node(joint);
    if (!at || other.shape != own.shape) {
        return {other, own};
    }
    std::vector<SketchPart> pair = inOrder(document, {other, own});
    pair.insert(pair.end(), {*at, *at}); // not at the other ends of the two, where they may meet as well
    return pair;
}

/// Returns the parts that a relation ties; empty if one of them does not exist.
std::vector<SketchPart> partsOf(const Document &document, const PathParts &parts, const InferredNode &node,
                                const Inference &relation) {
    const std::optional<SketchPart> own = relation.ofRadius ? parts.circle(relation.start, node.at)
                                          : relation.ofLine ? parts.segment(relation.start, node.at)
                                                            : parts.node(node.at);
    if (!own) {
        return {};
    }
    const bool alone =
        relation.ofLine && (relation.kind == ConstraintKind::Horizontal || relation.kind == ConstraintKind::Vertical);
    if (alone) {
        return {*own};
    }
    std::optional<SketchPart> other = relation.with;
    if (relation.withOwn) {
        const std::size_t k = *relation.withOwn;
        const bool line = relation.ofLine && k + 1 < node.path.size();
        other = line                                       ? parts.segment(node.path[k], node.path[k + 1])
                : !relation.ofLine && k < node.path.size() ? parts.node(node.path[k])
                                                           : std::nullopt;
    }
    if (!other || *other == *own) {
        return {};
    }
    return relation.kind == ConstraintKind::Tangent ? partsOfTangent(document, parts, *other, *own, relation.start)
                                                    : std::vector<SketchPart>{*other, *own};
}

/// Returns nodes with their relations to parts of one document as relations to the parts that these are in another.
std::vector<InferredNode> carriedNodes(std::span<const InferredNode> nodes, const Document &found,
                                       const Document &document) {
    std::vector<InferredNode> carried(nodes.begin(), nodes.end());
    std::vector<SketchPart> others;
    for (const InferredNode &node : nodes) {
        for (const Inference &relation : node.relations) {
            if (relation.with) {
                others.push_back(*relation.with);
            }
        }
    }
    const CarriedParts parts(found, document, others);
    for (InferredNode &node : carried) {
        for (Inference &relation : node.relations) {
            if (relation.with) {
                const std::vector<SketchPart> images = parts.images(*relation.with);
                relation.with = images.empty() ? std::nullopt : std::optional(images.front());
            }
        }
    }
    return carried;
}

/// Returns true if two segments of a path meet without a corner, one of them an arc of a circle and none a Bézier
/// curve.
bool meetsSmoothly(const Curve &arriving, const Curve &leaving) {
    const auto isArc = [](const Curve &curve) { return radiusOf(curve).has_value(); };
    const auto fits = [&](const Curve &curve) { return isArc(curve) || curve.kind() == CurveKind::Line; };
    if (!fits(arriving) || !fits(leaving) || !(isArc(arriving) || isArc(leaving))) {
        return false;
    }
    constexpr double kWithoutCorner = 1e-9; // sine of the angle
    const Vec2 before = arriving.tangent(1.0), after = leaving.tangent(0.0);
    return dot(before, after) > 0.0 &&
           std::fabs(cross(before, after)) <= kWithoutCorner * length(before) * length(after);
}

} // namespace

std::vector<InferredNode> relationsOfPath(const Shape &path) {
    std::vector<InferredNode> nodes;
    const Outline outline = outlineOf(path);
    const std::size_t count = outline.segmentCount();
    if (!isPath(path) || count < 2) {
        return nodes;
    }
    for (std::size_t k = outline.closed ? 0 : 1; k < count; ++k) {
        const std::size_t before = (k + count - 1) % count;
        if (meetsSmoothly(outline.curve(before), outline.curve(k))) {
            Inference tangent{ConstraintKind::Tangent, true, outline.from(k)};
            tangent.withOwn = 0;
            nodes.push_back({outline.to(k), {std::move(tangent)}, {outline.from(before), outline.from(k)}});
        }
    }
    if (outline.closed && outline.curve(count - 1).kind() == CurveKind::Line) {
        InferenceQuery query;
        query.starts = {outline.from(count - 1)};
        nodes.push_back({outline.to(count - 1), relationsAt(query, outline.to(count - 1)), {}});
    }
    return nodes;
}

InferredConstraints addInferred(Document document, std::uint32_t shape, std::span<const InferredNode> nodes,
                                const Document &found) {
    const std::vector<InferredNode> carried = carriedNodes(nodes, found, document);
    InferredConstraints result{std::move(document)};
    for (const InferredNode &node : carried) {
        for (const Inference &relation : node.relations) {
            std::vector<SketchPart> parts = partsOf(result.document, PathParts(result.document, shape), node, relation);
            if (parts.empty()) {
                continue;
            }
            if (Result<Document> next = addConstraint(result.document, relation.kind, std::move(parts))) {
                result.document = *std::move(next);
                ++result.added;
            }
        }
    }
    return result;
}

} // namespace forefront
