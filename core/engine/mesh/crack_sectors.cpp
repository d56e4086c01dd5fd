#include "core/engine/mesh/crack_sectors.hpp"

#include "core/engine/mesh/topology.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

CrackSectors::CrackSectors(const EdgeTable &table, const std::vector<bool> &cut, const std::vector<bool> &chosen)
    : parent_(table.halfEdges().count()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    const HalfEdges &sides = table.halfEdges();
    const std::vector<HalfEdge> opposite = oppositeHalfEdges(table);
    for (HalfEdge h = 0; h < sides.count(); ++h) {
        const HalfEdge other = opposite[h];
        if (other == kNoHalfEdge || other < h || cut[h]) {
            continue;
        }
        if (chosen[index(sides.startOf(h))]) {
            join(h, sides.next(other));
        }
        if (chosen[index(sides.endOf(h))]) {
            join(sides.next(h), other);
        }
    }
}

void CrackSectors::join(HalfEdge a, HalfEdge b) {
    a = sectorOf(a);
    b = sectorOf(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

} // namespace forefront
