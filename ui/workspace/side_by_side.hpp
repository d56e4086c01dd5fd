#pragma once

#include "core/session/lockstep.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace forefront {

struct Document;
class RunControl;

/// Runs with other grids or the other method, shown beside the run of the document at the same advance.
class SideBySide {
  public:
    /// Maximum number of runs beside that of the document.
    static constexpr std::size_t kMost = 2;

    bool visible = false;
    Comparison comparison = Comparison::Grids;

    /// Starts the runs of a new mesh, moves them to the position of the run shown and fetches their snapshots. Called
    /// once per frame; `wake` as for MeshingSession. Returns true if there is a new snapshot.
    bool follow(const RunControl &run, const Document &document, const std::function<void()> &wake);
    /// Returns true while a run is on its way to the position of the run shown.
    bool busy() const { return lockstep_ && lockstep_->busy(); }
    bool hasNews() const;
    /// Returns the number of runs beside the one shown.
    std::size_t size() const { return shown_.size(); }
    const RunVariant &variant(std::size_t run) const { return lockstep_->variant(run); }
    const SessionSnapshot &now(std::size_t run) const { return *shown_[run]; }

  private:
    std::optional<Lockstep> lockstep_; ///< not set: nothing to compare
    std::vector<std::shared_ptr<const SessionSnapshot>> shown_;
    std::uint64_t run_ = 0; ///< number of the run that it was started beside
    Comparison started_ = Comparison::Grids;
};

} // namespace forefront
