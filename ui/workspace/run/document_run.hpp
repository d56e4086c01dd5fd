#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/session/meshing_session.hpp"
#include "ui/workspace/mesh/file_fields.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

struct Document;

/// The extent of a run for live meshing: a preview, or the full mesh that the document asks for.
enum class RunExtent : std::uint8_t { Preview, Full };

/// The document revision and options that a run was started with.
struct RunStart {
    std::uint64_t revision = 0;
    Method method = Method::Fast;
    bool quads = false; ///< of quadrilaterals
    bool live = false;
    RunExtent extent = RunExtent::Full;
    LengthUnit unit = LengthUnit::None;
};

/// The result of a live run; logged when the gesture is over.
struct LiveResult {
    std::string note;        ///< empty: refused
    Diagnostics diagnostics; ///< why it was refused, or notes on the spacing
    std::uint64_t revision = 0;
};

/// How to make a mesh again that was dropped.
struct ResumedRun {
    std::optional<std::uint64_t> position;    ///< where the run rested; none: at its end
    std::shared_ptr<const Document> document; ///< that it was started with; null: it was cancelled, and is not resumed
};

/// The meshing run of one document and what is shown of it, for RunControl. While the document is in the background, a
/// run that was started goes on.
struct DocumentRun {
    DocumentRun(const std::function<void()> &wake, std::shared_ptr<RunNumbers> numbers)
        : session(wake, std::move(numbers)), snapshot(session.latest()) {}

    MeshingSession session;
    std::optional<SnapshotLayers> wanted; ///< snapshot layers last requested from the session
    Breakpoints breakpoints;
    std::shared_ptr<const SessionSnapshot> snapshot;
    std::shared_ptr<const SessionSnapshot> opened; ///< mesh of a file or of Adapt; null: the run's mesh is shown
    bool adapted = false;                          ///< `opened` was made by Adapt
    LengthUnit openedUnit = LengthUnit::None;
    std::shared_ptr<const FileFields> fields;    ///< values of that mesh; null: none
    std::map<std::uint64_t, RunStart> starts;    ///< by run number, from the one shown to the last
    std::uint64_t lastStart = 0;                 ///< number of the last run; 0: none
    std::shared_ptr<const Document> startedWith; ///< the document of the last run; null: none
    RunStart shown;
    std::uint64_t refusalLogged = 0; ///< run number
    std::string notesLogged;         ///< the last notes on the spacing, as text
    std::uint64_t followed = 0;      ///< newest revision that live meshing has started or skipped
    std::optional<LiveResult> liveResult;
    bool started = false;
    bool cancelling = false;
    std::shared_ptr<const Document> seen; ///< the document of the last call of RunControl::meshRevision()
    std::uint64_t seenRevision = 0, meshRevision = 0;
    std::map<std::uint64_t, std::uint64_t> meshRevisions; ///< by document revision
    std::uint64_t loggedRun = 0;
    std::uint64_t resultLogged = 0; ///< the last run whose result was logged
    RunState loggedState = RunState::Empty;
    std::optional<ResumedRun> resumes; ///< absent: the mesh is in memory, if there is one

    /// Lets live meshing know what it has started for another run of the same document.
    void takeRevisions(const DocumentRun &other) {
        followed = other.followed;
        seen = other.seen;
        seenRevision = other.seenRevision;
        meshRevision = other.meshRevision;
        meshRevisions = other.meshRevisions;
    }
    /// Returns the number of elements that the run has made so far and keeps in memory. Meshes that cannot be made
    /// again, those of files and of Adapt, do not count.
    std::size_t elements() const { return session.latest()->quality.elements; }
};

} // namespace forefront
