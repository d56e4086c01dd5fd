#pragma once

#include "core/mesher/front_state.hpp"

#include <cstddef>
#include <mutex>
#include <vector>

namespace forefront {

/// Nodes and elements of the regions of a phase on their way into the whole, in the order of the regions. Each is taken
/// over as soon as all before it have been, while others are still being advanced, and its memory serves the next.
class RegionResults {
  public:
    /// From now on nodes and elements of the whole belong to this.
    RegionResults(FrontState &whole, std::size_t regions);

    /// Region k has been advanced to its end. By this call or one that another thread is in, its arrays are emptied
    /// once those of all regions before it have been. Any thread, once for each region.
    void finished(std::size_t k, FrontState &state);

    /// Number of nodes before the phase: ids from here on are of new ones.
    std::uint32_t firstNew() const { return firstNew_; }
    /// What the ids of new nodes of region k grow by. It and all before it must have finished.
    std::uint32_t shift(std::size_t k) const { return shifts_[k]; }

  private:
    void take(std::size_t k, FrontState &from);

    FrontState &whole_;
    std::uint32_t firstNew_;
    std::vector<std::uint32_t> shifts_; ///< of the regions taken over
    std::mutex mutex_;
    std::vector<FrontState *> finished_; ///< null until then; guarded
    std::size_t next_ = 0;               ///< to be taken over; guarded
    bool taking_ = false;                ///< a thread is at it; guarded
};

} // namespace forefront
