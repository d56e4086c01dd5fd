#pragma once

#include "core/engine/base/api.hpp"

#include <cstdint>

namespace FOREFRONT_API forefront {

/// Work counters of a run, all of them sums.
struct WorkCounters {
    std::uint64_t advances = 0; ///< elements made plus deferrals
    std::uint64_t elements = 0;
    std::uint64_t frontSum = 0;  ///< Σ segments of Γ before each advance: mean Nb = frontSum / advances
    std::uint64_t delivered = 0; ///< Σ segments delivered by the grid: Nc
    /// Σ segments near enough to be considered, for each candidate side: those delivered that reach into the search
    /// region, without AB: Ns. With the classic method the same for every grid; the fast one stops at an obstacle.
    std::uint64_t considered = 0;
    /// Σ exact tests, a part of those considered: Nt. With the classic method the same for every grid.
    std::uint64_t tested = 0;
    std::uint64_t cellsVisited = 0;
    std::uint64_t candidates = 0;
    std::uint64_t newNodes = 0;
    std::uint64_t deferrals = 0; ///< advances without an element
    std::uint64_t forced = 0;    ///< elements made by the closing stage, from existing nodes alone

    void add(const WorkCounters &other) {
        advances += other.advances;
        elements += other.elements;
        frontSum += other.frontSum;
        delivered += other.delivered;
        considered += other.considered;
        tested += other.tested;
        cellsVisited += other.cellsVisited;
        candidates += other.candidates;
        newNodes += other.newNodes;
        deferrals += other.deferrals;
        forced += other.forced;
    }

    /// Returns Nb, the mean number of segments of Γ per advance.
    double frontMean() const { return mean(frontSum, advances); }
    /// Returns Nc, the segments delivered by the grid per element.
    double neighboursMean() const { return mean(delivered, elements); }
    /// Returns Ns, the segments near enough to be considered per element, counted for AC and for CB. Lo's tables have 7
    /// to 11 and do not say how they count; this count is 5.6 in cases like his, that of exact tests less than 0.1.
    double consideredMean() const { return mean(considered, elements); }
    /// Returns Nt, the exact segment tests per element: segments of Γ whose box overlaps that of a candidate side and
    /// that share no end with it.
    double testsMean() const { return mean(tested, elements); }

  private:
    static double mean(std::uint64_t sum, std::uint64_t count) {
        return count == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(count);
    }
};

} // namespace forefront
