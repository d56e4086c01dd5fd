#pragma once

#include "core/base/thread_pool.hpp"
#include "core/mesher/front_state.hpp"

#include <atomic>
#include <cstddef>
#include <vector>

namespace forefront {

/// Nodes and elements of the regions of a phase on their way into the whole, in the order of the regions. Most of the
/// cost is memory that is touched first. It can be paid while the last regions are still being advanced, by threads
/// that have none left.
class RegionResults {
  public:
    RegionResults(FrontState &whole, std::size_t regions);

    /// A region has its part of the whole and reads it no more.
    void begun() { begun_.fetch_add(1, std::memory_order_release); }
    /// Region k has been advanced to its end.
    void finished(std::size_t k, FrontState &state);

    /// Work for threads that have no region left: each of so many tasks does what can be done already, and returns. No
    /// task may be done by two threads at once.
    std::size_t earlyTasks() const { return 2 + finished_.size(); }
    void early(std::size_t task);
    /// Does the rest once all regions have finished; their arrays are then empty.
    void gather(ThreadPool &pool);

    /// What the ids of new nodes of region k grow by.
    std::uint32_t shift(std::size_t k) const { return static_cast<std::uint32_t>(offsetOf(k).nodes - first_.nodes); }
    std::uint32_t firstNew() const { return static_cast<std::uint32_t>(first_.nodes); }

  private:
    struct Count {
        std::size_t nodes = 0, elements = 0;
    };
    Count offsetOf(std::size_t k) const;
    void growEarly(bool nodes);
    void grow(const Count &to, bool nodes);
    void copyEarly(std::size_t k);
    void copy(std::size_t k, FrontState &from);

    FrontState &whole_;
    Count first_;               ///< in the whole before
    std::vector<Count> counts_; ///< of the regions that have finished
    std::vector<std::atomic<FrontState *>> finished_;
    std::vector<std::uint8_t> copied_; ///< each written by one task
    std::atomic<std::size_t> begun_ = 0;
    std::atomic<std::size_t> nodes_, elements_; ///< that the arrays of the whole have room for
};

} // namespace forefront
