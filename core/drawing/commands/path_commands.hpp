#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/result.hpp"

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace forefront {

// Commands on the nodes and curves of paths (polygons and polylines). Errors: see shape_commands.hpp.

/// One of the two control points of a cubic segment.
struct ControlRef {
    std::uint32_t shape = 0;   ///< Shape::id
    std::uint32_t segment = 0; ///< of a path
    bool atEnd = false;        ///< the control point next to the segment's second node

    friend auto operator<=>(const ControlRef &, const ControlRef &) = default;
};

/// A control point and the node that it belongs to.
struct Control {
    ControlRef ref;
    Vec2 at;
    Vec2 node;
};

/// The way a path runs through a node. It follows from the control points, and is not stored.
enum class NodeKind : std::uint8_t {
    Corner,   ///< anything else
    Smooth,   ///< the curves on both sides have the same tangent
    Symmetric ///< smooth, and the control points are equally far away
};

template <>
struct EnumWords<NodeKind> {
    static constexpr auto kLast = NodeKind::Symmetric;
    static constexpr std::array<std::string_view, 3> kList = {"corner", "smooth", "symmetric"};
};

/// Returns the control points of the cubic segments that begin or end at a selected node, or are selected.
std::vector<Control> controlsOf(const Document &document, const Selection &selection);

/// Returns the kind of a node; Corner at the ends of an open path and beside straight segments.
NodeKind nodeKind(const Shape &shape, std::uint32_t node);

/// Moves a control point. At a smooth node the opposite control point turns with it and keeps its distance, unless the
/// node is symmetric; `alone` leaves it where it is, so that the node becomes a corner.
Result<Document> moveControl(const Document &document, const ControlRef &control, Vec2 to, bool alone = false);

/// Makes nodes corners (their control points collapse onto them) or smooth: segments beside them become cubics whose
/// tangent is parallel to the line between the neighbours of the node.
Result<Document> setNodeKind(const Document &document, const std::set<NodeRef> &nodes, NodeKind kind);

/// Makes segments of paths straight, or turns them into cubics: a straight segment becomes one cubic, an arc one for
/// each quarter turn, with nodes between them; cubics are unchanged.
Result<Document> setCurved(const Document &document, const std::set<SegmentRef> &segments, bool curved);

/// Opens a closed path at a node, or divides an open one into two paths; the second part gets a new id.
Result<Document> splitPath(const Document &document, NodeRef node);

/// Joins two ends of one or two open paths by a straight segment, or directly if the ends coincide. The joined path
/// keeps the id of the first one.
Result<Document> joinEnds(const Document &document, NodeRef first, NodeRef second);

} // namespace forefront
