#pragma once

#include "core/drawing/document/document.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>

namespace forefront {

/// A handle of a shape: see handlesOf().
struct NodeRef {
    std::uint32_t shape = 0; ///< Shape::id
    std::uint32_t node = 0;  ///< index of the handle

    friend auto operator<=>(const NodeRef &, const NodeRef &) = default;
};

/// A part of a shape that can have its own tag: a segment of a path, a side of a rectangle; 0 for a circle or an
/// ellipse.
struct SegmentRef {
    std::uint32_t shape = 0;
    std::uint32_t segment = 0;

    friend auto operator<=>(const SegmentRef &, const SegmentRef &) = default;
};

/// The order of places in a set.
struct PlaceOrder {
    bool operator()(Vec2 p, Vec2 q) const { return comesBefore(p, q); }
};

/// The selected items. Shapes are referred to by id, so a selection survives edits; prune() drops items that can no
/// longer be selected. A region is selected by its marker, a face without a marker by a place in it: see
/// selectedFaces().
struct Selection {
    std::set<std::uint32_t> shapes{};
    std::set<NodeRef> nodes{};
    std::set<SegmentRef> segments{};
    std::set<std::uint32_t> sources{};     ///< index into SpacingSpec::sources
    std::set<std::uint32_t> markers{};     ///< index into Document::regionMarkers
    std::set<std::uint32_t> constraints{}; ///< SketchConstraint::id
    /// The segments at which shapes in `shapes` were clicked: of several selected shapes, those that a dimension or a
    /// constraint is meant for.
    std::map<std::uint32_t, std::uint32_t> sides{};
    std::set<Vec2, PlaceOrder> faces{}; ///< places in faces without a region marker

    bool empty() const {
        return shapes.empty() && nodes.empty() && segments.empty() && sources.empty() && markers.empty() &&
               constraints.empty() && faces.empty();
    }
    void clear() { *this = {}; }
    /// Removes items that do not exist, and hidden and locked shapes with their nodes and segments.
    void prune(const Document &document);
    /// Returns true if a shape, or a node or segment of it, is selected.
    bool touches(std::uint32_t shape) const;
    /// Removes shapes with their nodes and segments.
    void drop(const std::set<std::uint32_t> &gone);
    /// Returns the number of selected items.
    std::size_t size() const {
        return shapes.size() + nodes.size() + segments.size() + sources.size() + markers.size() + constraints.size() +
               faces.size();
    }
    /// Returns true if regions and other faces are selected, and nothing else.
    bool onlyFaces() const { return !empty() && size() == markers.size() + faces.size(); }

    friend bool operator==(const Selection &, const Selection &) = default;
};

/// Returns the index in Document::shapes of the shape with an id; the number of shapes if there is none. O(log n)
/// where the shapes are in the order of their ids, as drawn, else O(n).
std::size_t positionOf(const Document &document, std::uint32_t id);
/// Returns the shape with an id, or null; see positionOf().
const Shape *findShape(const Document &document, std::uint32_t id);
/// Selects all shapes, also those that are hidden or locked, all sources and all region markers.
Selection everythingIn(const Document &document);
/// Selects all visible and unlocked shapes, all sources and all region markers.
Selection selectAll(const Document &document);
/// Selects the visible and unlocked shapes whose segments all have a boundary tag, and the segments of other such
/// shapes that have it.
Selection selectTag(const Document &document, std::int32_t tag);
/// Returns the box of the selected items; empty if there are none.
Box2 boundsOf(const Document &document, const Selection &selection);

} // namespace forefront
