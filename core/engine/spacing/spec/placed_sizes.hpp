#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/domain/segment_elements.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// The spacing on a part of the boundary: size at its segments, growing by `growth` per unit of distance from them.
struct PartSize {
    double size = 1.0;   ///< > 0
    double growth = 0.2; ///< >= 0

    friend bool operator==(const PartSize &, const PartSize &) = default;
};

/// An element size at a node, growing by `growth` per unit of distance.
struct NodeSize {
    Vec2 at;             ///< place of the node
    double size = 1.0;   ///< > 0
    double growth = 0.2; ///< >= 0
    std::string name{};  ///< of the node, such as "node 3 of quay"

    friend bool operator==(const NodeSize &, const NodeSize &) = default;
};

/// Limits of the elements in the face that contains a point. Of several in one face, the smallest size and the smallest
/// area count.
struct RegionSize {
    Vec2 at; ///< any point inside the face, such as RegionMarker::at; one outside all faces has no effect
    /// Maximum area of an element in the face, in domain units squared; 0: no limit. The mean is about half of it;
    /// single elements may exceed it by up to an eighth, or where a minimum size or kept segments ask for larger ones;
    /// see largeElements().
    double maxArea{};
    /// Size of the elements in the face, in domain units, which grows by `growth` per unit of distance outside it; 0:
    /// none is given.
    double size{};
    double growth{0.2}; ///< >= 0

    friend bool operator==(const RegionSize &, const RegionSize &) = default;
};

/// The regions whose elements are quadrilaterals, by tag: at the same spacing, these have more than twice the area of
/// triangles.
struct QuadRegions {
    bool byDefault = false;             ///< regions that are not listed have quadrilaterals
    std::vector<std::int32_t> others{}; ///< tags of regions where it is the other way

    bool has(std::int32_t tag) const {
        return (std::find(others.begin(), others.end(), tag) != others.end()) != byDefault;
    }
    friend bool operator==(const QuadRegions &, const QuadRegions &) = default;
};

/// The sizes that belong to places of one domain, as opposed to rules that hold for any.
///
/// Nodes and regions are addressed by their places, which validation, repair and reordering keep, so that these sizes
/// need no care when the numbers of nodes, segments or markers change. Numbers of elements and sizes along segments are
/// addressed by segment: carryElements() takes them along through a repair, and a list for another number of segments
/// is refused.
struct PlacedSizes {
    std::vector<NodeSize> nodes;
    std::vector<RegionSize> regions;
    QuadRegions quads; ///< where a maximum area is one of quadrilaterals; runs set it by the shapes of their elements
    /// Number of elements along the whole line or curve that a segment is a part of, by index into Domain::segments; 0:
    /// as the spacing asks. Empty: 0 for all. Takes precedence over the spacing and the tolerance of curves.
    std::vector<std::uint32_t> elements;
    /// Bias of the elements along a line or curve with a number of them, by index into Domain::segments; the same for
    /// all segments of a curve that run in one direction. The count and the lengths are exact, unless parts of the
    /// boundary would meet. Empty: none.
    std::vector<ElementBias> biases;
    /// Sizes along segments, by index into Domain::segments, in place of SpacingSpec::partSizes of their tags; a size
    /// of 0: none is given. Empty: none for all.
    std::vector<PartSize> segments;

    /// Returns the numbers of elements with their biases.
    SegmentElements counts() const { return {elements, biases}; }

    friend bool operator==(const PlacedSizes &, const PlacedSizes &) = default;
};

} // namespace forefront
