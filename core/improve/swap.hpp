#pragma once

#include "core/improve/workspace.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace forefront {

/// When an edge is turned.
struct SwapRule {
    bool mindValence =
        false;          ///< also where that brings the valences nearer to 6 and the lesser α stays nearly as it is
    double floor = 0.0; ///< an element below may be mended at the cost of valences; none falls below
};

/// Turns the edge of h to the other diagonal of its two elements, which must be positive. Neighbours, valences and α
/// follow; the rings of the four nodes are left to the caller.
void turnEdge(ImproveWorkspace &work, HalfEdge h);

/// The same and renews the rings.
void turnWithRings(ImproveWorkspace &work, HalfEdge h);

/// Takes a turn of the edge between two elements back, to the order of their nodes: α is then the same to the last bit.
void turnBack(ImproveWorkspace &work, std::size_t e, std::size_t f, const std::array<Element, 2> &before);

/// True when the edge of h has elements on both sides that may be joined and its nodes can lose and take an element.
bool mayTurn(const ImproveWorkspace &work, HalfEdge h);

/// True when the edge of h has elements on both sides and the rule says that it be turned. α must be up to date.
bool worthTurning(const ImproveWorkspace &work, HalfEdge h, const SwapRule &rule);

/// Adds the edges of some elements that are worth turning, in the order of their half-edges; some from both sides.
void findWorthTurning(const ImproveWorkspace &work, std::size_t begin, std::size_t end, const SwapRule &rule,
                      std::vector<HalfEdge> &found);

} // namespace forefront
