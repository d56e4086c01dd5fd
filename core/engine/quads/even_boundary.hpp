#pragma once

#include "core/engine/boundary/discretise.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// A discretised boundary whose nodes have one of two colours, such that its edges join nodes of different colours.
/// Only then does each face have an even number of edges, as quadrilaterals need.
struct ColouredBoundary {
    DiscreteDomain domain;
    std::vector<std::uint8_t> colours;      ///< per node of `domain`: 0 or 1
    std::size_t added = 0;                  ///< nodes added to make cycles of edges even
    std::vector<std::uint32_t> oneColoured; ///< segments that join two nodes of one colour, ascending
};

/// Which edges of a boundary may be divided to make its cycles even.
struct EvenRules {
    const Domain *domain = nullptr; ///< that the boundary was discretised from; its nodes stay where they are
    SegmentElements elements;       ///< lines and curves with a number of elements keep it
    bool divide = true;             ///< false: no edge may be divided
};

/// Colours a boundary, and adds nodes where that needs them.
///
/// A spanning forest of the graph of all edges, which takes the longest edges relative to the spacing last, colours the
/// nodes. An edge left over closes a cycle; if that is odd, the part of a line or curve between two other nodes that
/// the edge belongs to gets one more edge, with its inner nodes at equal fractions of what they were spaced by; a part
/// of one edge is halved. So outer boundaries, holes, interfaces and constraints are treated alike, and there is at
/// most one new node for each independent cycle. Where no edge of the cycle may be divided, or new edges would meet
/// others, an edge that joins two nodes of one colour is left.
ColouredBoundary colourBoundary(const DiscreteDomain &boundary, const SpacingField &spacing, const EvenRules &rules);

} // namespace forefront
