#pragma once

#include "core/engine/session/meshing_session.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

/// A method and a background grid to compare with others.
struct RunVariant {
    Method method = Method::Fast;
    GridKind grid = GridKind::Hierarchical;

    /// Returns its name, such as "classic, uniform grid".
    std::string name() const;
    friend bool operator==(const RunVariant &, const RunVariant &) = default;
};

/// The kind of variants that the run on the canvas is compared with.
enum class Comparison : std::uint8_t { Grids, Methods };

/// Returns the variants to show beside a run: the other background grids, or the other method.
std::vector<RunVariant> variantsBeside(const RunVariant &shown, Comparison comparison);

/// The figures of a run at its position; counts of the grid's work are per element, as in the published tables.
struct RunFigures {
    std::uint64_t advances = 0, elements = 0;
    double front = 0.0;      ///< Nb: mean number of segments of the front per advance
    double neighbours = 0.0; ///< Nc: mean number of neighbouring segments delivered by the grid per element
    double considered = 0.0; ///< Ns: segments near enough to be considered per element, for each side
    double tests = 0.0;      ///< Nt: mean number of exact intersection tests per element
    double cells = 0.0;      ///< cells visited per element
};
RunFigures figuresOf(const SessionSnapshot &snapshot);
/// Returns true if the figures of two runs can be compared: both have made the same number of advances, or the fronts
/// of both are done.
bool samePosition(const SessionSnapshot &a, const SessionSnapshot &b);

/// Runs of one job with different methods or grids, kept at the same advance. Call all members from one thread; only
/// wait() blocks.
class Lockstep {
  public:
    /// Starts the runs, before the first advance. `wake` as for MeshingSession.
    Lockstep(const MeshingJob &job, std::vector<RunVariant> variants, const std::function<void()> &wake);

    std::size_t size() const { return runs_.size(); }
    const RunVariant &variant(std::size_t run) const { return runs_[run].variant; }
    std::shared_ptr<const SessionSnapshot> latest(std::size_t run) const { return runs_[run].session->latest(); }
    bool busy() const;
    /// Discards the runs. Once none is busy, destruction waits for no worker.
    void clear();
    /// Waits until none of the runs is busy.
    void wait() const;
    /// Moves every run to an advance, or to its own end, which is its improved mesh, with `end`. A run that is still
    /// moving catches up on a later call, so call it regularly with the latest position, such as once per frame.
    void follow(std::uint64_t advance, bool end);

  private:
    struct Run {
        RunVariant variant;
        std::unique_ptr<MeshingSession> session;
        std::uint64_t advance = 0; ///< last requested
        bool end = false;
    };
    std::vector<Run> runs_;
};

} // namespace forefront
