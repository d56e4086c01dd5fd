#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/session/snapshot.hpp"
#include "ui/background/latest.hpp"
#include "ui/workspace/mesh/file_fields.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// The mesh that adapting began with, and the values of its file.
struct AdaptSource {
    std::shared_ptr<const MeshSnapshot> mesh;
    std::shared_ptr<const FileFields> fields; ///< null: none
};

/// A request to adapt a mesh to a field.
struct AdaptRequest {
    std::shared_ptr<const MeshSnapshot> mesh;          ///< the first round; never null
    std::shared_ptr<const Document> drawing;           ///< to be meshed; null: the area of the mesh
    std::string field;                                 ///< an expression in x and y, or the name of `values`
    std::shared_ptr<const std::vector<double>> values; ///< of the field at the nodes of the mesh; null: an expression
    AdaptTarget target;
    int maxRounds = 8; ///< with an expression: maximum number of new meshes
    MeshingOptions options;
    AdaptSource source; ///< kept with the rounds, so that its values can be used again
};

/// The mesh of a round.
struct AdaptedMesh {
    TriMesh mesh;
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

/// The rounds of a document that is in the background.
struct KeptAdaptation {
    AdaptProgress progress;
    AdaptRequest request;
    std::size_t selected = 0, followed = 0;
    std::uint64_t shown = 0, loads = 0;
};

/// Adapts the mesh of a request.
Result<AdaptOutcome> adaptedMesh(const AdaptRequest &request, const Progress &progress, const AdaptReport &report);

/// Adapts a mesh to a field in rounds on a separate thread, and keeps the mesh of each round. Call all members from one
/// thread; none of them waits, except the destructor.
class Adaptation {
  public:
    using Work = std::function<Result<AdaptOutcome>(const AdaptRequest &, const Progress &, const AdaptReport &)>;

    /// `work` adapts the mesh; tests pass their own.
    explicit Adaptation(BackgroundList &list, Work work = adaptedMesh);

    /// Starts an adaptation and drops the rounds of the previous one; does nothing while one is running.
    void start(AdaptRequest request);
    void cancel() { worker_.requestStop(); }
    /// Drops the rounds, and cancels the adaptation if it is running.
    void clear();
    /// Shows the rounds of another document, and returns those shown until now; an adaptation that is running ends with
    /// the rounds that it has made.
    KeptAdaptation exchange(KeptAdaptation other);
    /// Fetches the newest progress. Called once per frame; returns true if it has changed.
    bool refresh() { return worker_.refresh(); }
    bool busy() const { return now().running; }
    /// Returns the progress of this frame.
    const AdaptProgress &now() const { return worker_.now(); }
    /// Returns the request of the rounds.
    const AdaptRequest &request() const { return request_; }
    /// Returns true if the rounds are of the domain that `drawing` has now, or of the mesh of a file.
    bool fits(const std::shared_ptr<const Document> &drawing) const;

    std::size_t selected = 0; ///< the round shown
    std::size_t followed = 0; ///< number of rounds that the window has taken notice of
    std::uint64_t shown = 0;  ///< version of the mesh view with that round; until it is shown, of the view it replaces
    std::uint64_t loads = 0;  ///< DocumentStore::loads() of the document that the rounds belong to

  private:
    void reset(AdaptProgress now);

    Latest<AdaptRequest, AdaptProgress> worker_;
    AdaptRequest request_;
    mutable std::shared_ptr<const Document> compared_; ///< the last drawing that fits() was called with
    mutable bool fits_ = false;
};

} // namespace forefront
