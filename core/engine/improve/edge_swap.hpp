#pragma once

#include "core/engine/improve/improve_workspace.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace forefront {

/// The rule that selects edges to swap. An edge is swapped if that raises the lower α of its two elements.
struct SwapRule {
    bool improveValence = false; ///< also swap where that brings valences nearer to 6 and hardly lowers the lower α
    double floor = 0.0;          ///< elements below it may improve at the expense of valences; none falls below it
};

/// Swaps the edge of h for the other diagonal of its two elements, which must be positive. Updates neighbours, valences
/// and α; the caller must renew the rings of the four nodes.
void swapEdge(ImproveWorkspace &work, HalfEdge h);

/// Swaps an edge as swapEdge() does and renews the rings.
void swapEdgeAndRings(ImproveWorkspace &work, HalfEdge h);

/// Undoes a swap between two elements, including the order of their nodes, so that α is the same bit for bit.
void undoSwap(ImproveWorkspace &work, std::size_t e, std::size_t f, const std::array<Element, 2> &before);

/// Returns true if the edge of h has a partner and its four nodes may lose or gain an element.
bool canSwap(const ImproveWorkspace &work, HalfEdge h);

/// Returns true if the edge of h has a partner and the rule selects it. α must be up to date.
bool worthSwapping(const ImproveWorkspace &work, HalfEdge h, const SwapRule &rule);

/// Appends the edges of a range of elements that the rule selects, in the order of their half-edges. Some are found
/// from both sides.
void findWorthSwapping(const ImproveWorkspace &work, std::size_t begin, std::size_t end, const SwapRule &rule,
                       std::vector<HalfEdge> &found);

} // namespace forefront
