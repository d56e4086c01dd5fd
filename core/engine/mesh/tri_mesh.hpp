#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/curve.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// The nodes of an element, counter-clockwise.
using Element = std::array<NodeId, 3>;

/// An edge of the mesh that carries a tag: boundary, interface between regions, or constraint.
struct TaggedEdge {
    NodeId a = kNoNode;
    NodeId b = kNoNode;
    std::int32_t tag = 1;
    NodeId middle = kNoNode; ///< of an edge of 3 nodes
};

/// A node of the mesh that carries a tag: a constraint point.
struct TaggedNode {
    NodeId node = kNoNode;
    std::int32_t tag = 1;
};

/// A mesh of triangles of 3 nodes with tags, as the mesher and the improvement use it. Edge k of an element joins its
/// nodes k and (k+1)%3.
struct TriMesh {
    std::vector<Vec2> nodes;
    std::vector<Element> elements;
    /// Region tag per element. The library always fills it in; in a mesh made by hand it may be empty: all 1.
    std::vector<std::int32_t> regions;
    std::vector<TaggedEdge> edges;  ///< boundary and constraint edges
    std::vector<TaggedNode> points; ///< constraint points
    std::vector<Curve> curves;      ///< those that tagged edges are chords of
    /// Per tagged edge, the part of a curve that it is a chord of; empty if the domain had no curves. Known only for
    /// meshes made by this library, since no file format keeps it.
    std::vector<CurveStretch> edgeStretches;
    std::map<std::int32_t, std::string> boundaryNames;
    std::map<std::int32_t, std::string> regionNames;

    std::int32_t region(std::size_t element) const { return regions.empty() ? 1 : regions[element]; }
    Box2 bounds() const;
};

} // namespace forefront
