#pragma once

#include "core/engine/mesher/front_state.hpp"

#include <cstddef>
#include <mutex>
#include <vector>

namespace forefront {

/// Merges the nodes and elements of the strips of a phase into the whole, in the order of the strips. Each strip is
/// merged as soon as all strips before it have been, while others are still advancing, and its memory is released.
class StripResults {
  public:
    /// Takes over the nodes and elements of `whole`: only this object may change them from now on.
    StripResults(FrontState &whole, std::size_t strips);

    /// Reports that strip k has advanced to its end. This call, or another thread's, merges and empties its arrays once
    /// all strips before it are merged. May be called from any thread, once for each strip.
    void finished(std::size_t k, FrontState &state);

    /// Returns the number of nodes before the phase; ids from here on belong to new nodes.
    std::uint32_t firstNew() const { return firstNew_; }
    /// Returns the offset added to the ids of new nodes of strip k. Strips up to k must have finished.
    std::uint32_t shift(std::size_t k) const { return shifts_[k]; }

  private:
    void take(std::size_t k, FrontState &from);

    FrontState &whole_;
    std::uint32_t firstNew_;
    std::vector<std::uint32_t> shifts_; ///< of the merged strips
    std::mutex mutex_;
    std::vector<FrontState *> finished_; ///< null until finished; guarded
    std::size_t next_ = 0;               ///< the next strip to merge; guarded
    bool taking_ = false;                ///< a thread is merging; guarded
};

} // namespace forefront
