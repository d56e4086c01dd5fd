#pragma once

#include "core/engine/improve/improve_workspace.hpp"

#include <cstddef>

namespace forefront {

/// Visits the nodes of an element and those across its sides: the cleanup of the element may move them if they are
/// free.
template <class Visit>
void forMovableNodes(const ImproveWorkspace &work, std::size_t e, const Visit &visit) {
    for (unsigned k = 0; k < 3; ++k) {
        const auto h = static_cast<HalfEdge>(3 * e + k);
        visit(work.from(h));
        if (const HalfEdge g = work.twin[h]; g != kNoHalfEdge) {
            visit(work.apex(g));
        }
    }
}

/// Visits, some of them repeatedly, the nodes whose positions the cleanup of an element may read: the corners of the
/// elements around all nodes that it may move.
template <class Visit>
void forReadNodes(const ImproveWorkspace &work, std::size_t e, const Visit &visit) {
    forMovableNodes(work, e, [&](NodeId n) {
        visit(n);
        if (work.isFree(n)) {
            work.aroundFree(n, [&](HalfEdge h) { visit(work.to(h)); });
        }
    });
}

} // namespace forefront
