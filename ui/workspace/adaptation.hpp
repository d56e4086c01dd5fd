#pragma once

#include "core/adapt/adaptive_meshing.hpp"
#include "core/session/snapshot.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace forefront {

/// A request to adapt a mesh to a field.
struct AdaptRequest {
    std::shared_ptr<const MeshView> mesh;              ///< the first round; never null
    std::shared_ptr<const Domain> domain;              ///< to be meshed; null: the area of the mesh
    std::string field;                                 ///< an expression in x and y, or the name of `values`
    std::shared_ptr<const std::vector<double>> values; ///< of the field at the nodes of the mesh; null: an expression
    AdaptTarget target;
    int maxRounds = 8; ///< with an expression: maximum number of new meshes
    MeshingOptions options;
};

/// The mesh of a round.
struct AdaptedMesh {
    Mesh mesh;
    std::vector<double> values;  ///< of the field at the nodes; empty if unknown
    std::vector<double> errors;  ///< estimated for each element; empty if unknown
    std::optional<double> error; ///< ErrorEstimate::relative()
    SpacingSpec spacing;         ///< that the mesh was made with; empty for the given mesh
};

/// How far the adaptation of a mesh is.
struct AdaptProgress {
    std::vector<std::shared_ptr<const AdaptedMesh>> rounds;
    std::string stage; ///< "mesh 2: advancing the front"
    double fraction = 0.0;
    bool running = false, met = false, stalled = false;
    Diagnostics faults; ///< why it ended early
};

/// Adapts a mesh to a field in rounds on a separate thread, and keeps the mesh of each round. Call all members from one
/// thread; none of them waits.
class Adaptation {
  public:
    /// `wake` is called from that thread when there is news.
    explicit Adaptation(std::function<void()> wake);

    /// Starts an adaptation and drops the rounds of the previous one; does nothing while one is running.
    void start(AdaptRequest request);
    void cancel() { thread_.request_stop(); }
    /// Drops the rounds, and cancels the adaptation if it is running.
    void clear();
    /// Fetches the newest progress. Called once per frame; returns true if it has changed.
    bool refresh();
    bool hasNews() const { return version_.load() != seen_; }
    bool busy() const { return now_.running; }
    /// Returns the progress of this frame.
    const AdaptProgress &now() const { return now_; }
    /// Returns the request of the rounds.
    const AdaptRequest &request() const { return request_; }

    std::size_t selected = 0; ///< the round shown
    std::size_t followed = 0; ///< number of rounds that the window has taken notice of
    std::uint64_t shown = 0;  ///< version of the mesh view that shows it; 0: none
    std::uint64_t loads = 0;  ///< DocumentStore::loads() of the document that the rounds belong to

  private:
    void work(const AdaptRequest &request, const std::stop_token &stop);
    void change(const std::function<void(AdaptProgress &)> &apply);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    AdaptProgress progress_; ///< of the thread; guarded by the mutex
    std::atomic<std::uint64_t> version_ = 0;
    std::uint64_t seen_ = 0;
    AdaptProgress now_;
    AdaptRequest request_;
    std::jthread thread_; ///< last, so that it ends before what it uses
};

} // namespace forefront
