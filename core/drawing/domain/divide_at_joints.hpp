#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/segment_elements.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A node of a domain that a shape is held by: a corner, an end or a point.
struct JointNode {
    std::uint32_t node = 0;  ///< index into Domain::nodes
    std::uint32_t shape = 0; ///< index into Document::shapes
};

/// A node that lies almost on a curve, and not on it.
struct NodeBesideCurve {
    std::uint32_t segment = 0; ///< chord of the curve
    std::uint32_t node = 0;
    double away = 0.0;
};

/// The segments of a domain that joints divide; the lists of segments are empty if none does.
struct DividedSegments {
    std::vector<DomainSegment> segments;
    std::vector<std::uint32_t> given;    ///< per segment: the index that it, or what it is a part of, had before
    std::vector<std::uint32_t> elements; ///< per segment: its number of elements if it is a part of a straight one
                                         ///< that has a number; else 0
    std::vector<ElementBias> biases;     ///< per segment: the bias of these
    double farthest = 0.0;               ///< greatest distance of a node from what it divides
    std::vector<NodeBesideCurve> beside; ///< within the tolerance of curves that they cannot divide
};

/// Returns the segments divided at the nodes of other shapes that lie on them, so that what is joined in a drawing is
/// joined in its mesh: within `tolerance` of straight segments, whose parts go through the nodes, and within it, but at
/// most 1e-9 of the domain's diagonal, of curves, which stay as they are. The parts of a straight segment with a number
/// of elements have those that lie in them, with their bias; such a segment stays whole if it has fewer elements than
/// there would be parts, or if a part could not keep its bias.
///
/// `shapes`: per segment, the shape that it comes from. `elements`: of the segments. `whole`: the segments that must
/// stay as they are.
DividedSegments divideAtJoints(const Domain &domain, std::span<const JointNode> nodes,
                               std::span<const std::uint32_t> shapes, const SegmentElements &elements,
                               const std::vector<bool> &whole, double tolerance);

} // namespace forefront
