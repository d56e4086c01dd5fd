#pragma once

#include "core/base/progress.hpp"
#include "core/improve/workspace.hpp"

#include <cstddef>

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

/// Turns edges wherever the rule says so, then again around the changes, a few times. α must be up to date and is
/// kept so. Looks at the edges in parallel and turns them one by one. Returns the number of swaps.
std::size_t swapEdges(ImproveWorkspace &work, const SwapRule &rule, const Progress &progress);

} // namespace forefront
