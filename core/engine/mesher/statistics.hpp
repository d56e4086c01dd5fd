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
    /// Σ segments near enough to be considered: those delivered that reach into the search region, without AB. Lo's Ns,
    /// which is the same with and without a grid; see consideredMean().
    std::uint64_t considered = 0;
    std::uint64_t tested = 0; ///< Σ exact segment tests; with the classic method the same for every grid
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
    /// Returns Ns, the segments near enough to be considered per element. Lo's tables give 7 to 11, which fits this
    /// count and not that of exact tests.
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
