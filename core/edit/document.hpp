#pragma once

#include "core/base/api.hpp"
#include "core/base/result.hpp"
#include "core/domain/domain.hpp"
#include "core/mesher/options.hpp"
#include "core/spacing/spec/spacing_spec.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

enum class ShapeKind : std::uint8_t {
    Polygon,   ///< closed, nodes in order
    Polyline,  ///< open
    Rectangle, ///< two opposite corners
    Circle,    ///< centre, point on the circle
    Point      ///< one node
};

/// What a shape does to the domain.
enum class ShapeUse : std::uint8_t {
    Boundary,  ///< even-odd: outermost is outside, nested is a hole, nested in a hole is an island
    Constraint ///< its segments (or point) must be in the mesh; a closed one bounds a region of its own
};

/// A drawn thing. Immutable once in a Document; edits replace it.
struct Shape {
    std::uint32_t id = 0; ///< unique in the document, never reused
    ShapeKind kind = ShapeKind::Polygon;
    ShapeUse use = ShapeUse::Boundary;
    std::vector<Vec2> nodes;
    std::int32_t tag = 1;                  ///< of its segments, >= 1
    std::vector<std::int32_t> segmentTags; ///< per segment where they differ; empty: all `tag`
    std::string name;                      ///< shown in lists; the name of the tag is in Document::boundaryNames

    friend bool operator==(const Shape &, const Shape &) = default;
};

/// What a user edits and saves: domain as drawn, spacing, options. Copies are cheap enough for unlimited undo: shapes
/// are shared.
struct Document {
    std::vector<std::shared_ptr<const Shape>> shapes;
    std::vector<RegionMarker> regionMarkers;
    std::map<std::int32_t, std::string> boundaryNames;
    std::map<std::int32_t, std::string> regionNames;
    SpacingSpec spacing;
    MeshingOptions options;
    double circleTolerance = 0.002; ///< greatest distance between a circle and its polygon, relative to its radius
    std::uint32_t nextId = 1;
};

/// Domain of a document: circles become polygons fine enough for the tolerance; coinciding nodes of different shapes
/// become one node.
Domain toDomain(const Document &document);

/// A document that shows an imported domain: segments chained to polygons and polylines, tags and names kept.
Document fromDomain(const Domain &domain);

} // namespace forefront
