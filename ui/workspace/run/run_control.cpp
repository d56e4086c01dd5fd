#include "ui/workspace/run/run_control.hpp"

#include "core/drawing/document/equality.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/document/document_store.hpp"
#include "ui/workspace/messages/message_log.hpp"
#include "ui/workspace/run/run_words.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace forefront {

RunControl::RunControl(DocumentStore &document, MessageLog &log, BackgroundList &list)
    : BackgroundActivity(list, NewsPace::WithMesh), document_(document), log_(log),
      run_(std::make_unique<DocumentRun>(list.wake(), numbers_)), liveMeshing_(list, *this) {}

std::unique_ptr<DocumentRun> RunControl::exchange(std::unique_ptr<DocumentRun> other) {
    if (run_->session.latest()->playing) { // rather than as fast as possible
        run_->session.pause();
    }
    run_.swap(other);
    if (!run_) {
        run_ = std::make_unique<DocumentRun>(list().wake(), numbers_);
    }
    if (const auto resumed = std::exchange(run_->resumes, std::nullopt)) {
        resume(*resumed);
    }
    return other;
}

std::unique_ptr<DocumentRun> RunControl::withoutMesh(const DocumentRun &run) const {
    auto left = std::make_unique<DocumentRun>(list().wake(), numbers_);
    const std::shared_ptr<const SessionSnapshot> last = run.session.latest();
    const bool preview = last->coarsening > 1.0;
    if (run.started && last->shownRun > 0 && !preview) {
        const bool rests = last->state == RunState::Paused && !last->atEnd();
        left->resumes = ResumedRun{rests ? std::optional(last->position()) : std::nullopt,
                                   last->state == RunState::Cancelled ? nullptr : run.startedWith};
    }
    if (!preview) { // live meshing makes a preview again, and then the full mesh if that is not too large
        left->takeRevisions(run);
    }
    left->breakpoints = run.breakpoints;
    left->session.stopAt(run.breakpoints);
    left->opened = run.opened;
    left->adapted = run.adapted;
    left->openedUnit = run.openedUnit;
    left->fields = run.fields;
    return left;
}

void RunControl::drop(std::unique_ptr<DocumentRun> run) {
    run->session.clear(); // the destructor would wait until the worker has stopped and freed its mesh
    ending_.push_back(std::move(run));
}

bool RunControl::working() const {
    return busy() || std::any_of(ending_.begin(), ending_.end(), [](const auto &run) { return run->session.busy(); });
}

/// Makes the mesh of a document again that was dropped while another one was shown.
void RunControl::resume(const ResumedRun &resumed) {
    if (run_->opened) {
        return; // it is shown instead
    }
    if (!resumed.document) {
        log_.inform("The unfinished mesh of " + document_.title() + " was dropped to save memory; mesh it again");
    } else if (resumed.document != document_.current() && live) {
        run_->followed = 0; // the mesh of the drawing as it is now
    } else if (resumed.document != document_.current()) {
        log_.inform("The mesh of " + document_.title() +
                    " was dropped to save memory, and the drawing has changed since; mesh it again");
    } else if (resumed.position) {
        startAt(*resumed.position);
    } else {
        start(StartMode::RunQuiet);
    }
}

void RunControl::refresh() {
    std::erase_if(ending_, [](const auto &run) { return !run->session.busy(); });
    const bool busy = run_->session.busy(); // read before the snapshot: an idle worker has delivered its last one
    run_->snapshot = run_->session.latest();
    run_->cancelling = run_->cancelling && busy;
    const SessionSnapshot &s = *run_->snapshot;
    const auto last = run_->starts.find(run_->lastStart);
    const bool follows = s.run == run_->lastStart || (last != run_->starts.end() && last->second.live);
    if (follows && s.state != RunState::Preparing && s.shownRun > 0) {
        run_->starts.erase(run_->starts.begin(), run_->starts.lower_bound(s.shownRun));
        run_->shown = run_->starts[s.shownRun]; // an earlier run if the last one was refused
    }
    if (s.run != run_->loggedRun || s.state != run_->loggedState) {
        log(s);
        run_->loggedRun = s.run;
        run_->loggedState = s.state;
    }
}

void RunControl::log(const SessionSnapshot &s) {
    const auto start = run_->starts.find(s.run);
    const bool isLive = start != run_->starts.end() && start->second.live;
    const bool refused = !s.diagnostics.empty() && (s.state == RunState::Failed || s.run != run_->refusalLogged);
    if (refused) {
        run_->refusalLogged = s.run;
        if (isLive) {
            run_->liveResult = {{}, s.diagnostics, start->second.revision};
        } else {
            log_.add(s.diagnostics, run_->starts[s.run].revision);
        }
    } else if (s.shownRun != s.run) {
        // The previous mesh is already in the log.
    } else if (s.state == RunState::Cancelled && run_->loggedState != RunState::Cancelled) {
        log_.note(ui::format("Cancelled after %llu advances; you can step through the partial mesh",
                             static_cast<unsigned long long>(s.known)));
    } else if (s.state == RunState::Finished && s.run != run_->resultLogged) {
        run_->resultLogged = s.run;
        if (s.coarsening > 1.0) {
            run_->liveResult = {previewText(s), {}, start->second.revision};
        } else if (isLive) {
            run_->liveResult = {resultText(s), notesOf(s), start->second.revision};
        } else {
            log_.note(resultText(s));
            logNotes(notesOf(s), run_->starts[s.run].revision);
        }
    }
}

/// A revision that has the same mesh as the one before counts as that one.
std::uint64_t RunControl::meshRevision() const {
    const std::uint64_t revision = document_.revision();
    if (revision != run_->seenRevision) {
        const std::shared_ptr<const Document> document = document_.current();
        const auto known = run_->meshRevisions.find(revision);
        // A command that changes only what the mesher looks at need not be compared as a whole.
        const bool other =
            run_->seen && !(run_->seen->limits == document->limits && run_->seen->picture == document->picture &&
                            run_->seen->guides == document->guides && run_->seen->unit == document->unit &&
                            run_->seen->constraints == document->constraints);
        const bool same = other && sameForMesher(*run_->seen, *document);
        run_->meshRevision = known != run_->meshRevisions.end() ? known->second : same ? run_->meshRevision : revision;
        run_->meshRevisions[revision] = run_->meshRevision;
        run_->seen = document;
        run_->seenRevision = revision;
    }
    return run_->meshRevision;
}

bool RunControl::liveMeshPending() const {
    return live && !run_->opened && (run_->followed != meshRevision() || needsFullMesh());
}

/// Returns true if the newest document has only a preview, or not even that because its boundary cannot be so coarse,
/// and there is no reason not to make the full mesh.
bool RunControl::needsFullMesh() const {
    const auto last = run_->starts.find(run_->lastStart);
    const bool previewed = last != run_->starts.end() && last->second.extent == RunExtent::Preview &&
                           last->second.revision == meshRevision() && run_->snapshot->run == run_->lastStart;
    const bool refused = !run_->snapshot->diagnostics.empty();
    const bool tooLarge = !refused && run_->snapshot->requestedElements > kLargestLive;
    return resting_ && previewed && (preview() || refused) && !tooLarge;
}

/// Returns true if the run in progress is not worth finishing once the document has changed: a full mesh that followed
/// a preview, or one large enough to show its progress.
bool RunControl::replaceable(const SessionSnapshot &newest, bool gestureOver) const {
    const auto last = run_->starts.find(run_->lastStart);
    const bool follows = last != run_->starts.end() && last->second.live && last->second.extent == RunExtent::Full;
    const bool large =
        newest.run == run_->lastStart && (newest.state == RunState::Running || newest.state == RunState::Improving ||
                                          (newest.state == RunState::Preparing && makesQuads()));
    return follows || (large && gestureOver);
}

/// Returns true if the newest document differs from that of the run in the rules of the method alone, and the run rests
/// in its course.
bool RunControl::keepsPosition(const SessionSnapshot &newest) const {
    const bool underWay =
        newest.run == run_->lastStart && newest.state == RunState::Paused && newest.known > 0 && !newest.atEnd();
    const Document &now = *document_.current();
    if (!underWay || !run_->startedWith || run_->startedWith->options.rules == now.options.rules ||
        newest.requestedElements > liveBudget) {
        return false;
    }
    Document before = *run_->startedWith;
    before.options.rules = now.options.rules;
    return sameForMesher(before, now);
}

void RunControl::startLiveMesh() {
    if (const auto newest = run_->session.latest(); keepsPosition(*newest)) {
        startAt(newest->advance);
    } else if (run_->followed == meshRevision()) {
        start(StartMode::RunQuiet, RunExtent::Full);
    } else if (!document_.current()->shapes.empty()) {
        start(StartMode::RunQuiet, RunExtent::Preview);
    }
    run_->followed = meshRevision();
}

void RunControl::follow(bool gestureOver, bool faulty) {
    gestureOver_ = gestureOver;
    resting_ = gestureOver && !faulty;
    if (liveMeshPending() && (!run_->session.busy() || replaceable(*run_->session.latest(), gestureOver))) {
        startLiveMesh();
    }
    if (gestureOver && !run_->session.busy() && run_->liveResult && run_->liveResult->revision == meshRevision()) {
        logLive(faulty);
    }
}

void RunControl::logLive(bool faulty) {
    const LiveResult result = *std::exchange(run_->liveResult, std::nullopt);
    if (!result.note.empty()) {
        log_.note(result.note, "live mesh of step " + document_.step());
        logNotes(result.diagnostics, result.revision);
    } else if (!faulty) {
        log_.add(result.diagnostics, result.revision);
    }
}

void RunControl::logNotes(const Diagnostics &notes, std::uint64_t revision) {
    std::string text;
    for (const Diagnostic &note : notes) {
        text += toString(note) + '\n';
    }
    if (text != run_->notesLogged) { // a live mesh would repeat them with every change
        log_.add(notes, revision);
        run_->notesLogged = std::move(text);
    }
}

void RunControl::want(SnapshotLayers layers) {
    if (run_->wanted != layers) { // a command in every frame would keep the worker busy
        run_->wanted = layers;
        run_->session.want(layers);
    }
}

FileMesh takeMesh(MeshFields read) {
    FileMesh file;
    file.fields = takeFields(read);
    file.view = snapshotOf(std::move(read.mesh));
    return file;
}

void measureMesh(FileMesh &file) {
    const MeshView mesh = file.view->view();
    file.quality = measureQuality(mesh, nullptr);
    file.hash = meshHash(mesh);
}

FileMesh fileMeshOf(MeshFields read) {
    FileMesh file = takeMesh(std::move(read));
    measureMesh(file);
    return file;
}

void RunControl::showFile(FileMesh read) {
    clear();
    run_->fields = std::move(read.fields);
    read.view->version = (std::uint64_t{1} << 63) + ++openedCount_; // unlike those of runs
    auto opened = std::make_shared<SessionSnapshot>();
    opened->state = RunState::Finished;
    opened->complete = true;
    opened->quality = read.quality;
    opened->meshHash = read.hash;
    opened->mesh = std::move(read.view);
    run_->opened = std::move(opened);
    run_->adapted = false;
    run_->openedUnit = LengthUnit::None;
}

void RunControl::showAdapted(MeshFields made) {
    showFile(std::move(made));
    run_->adapted = true;
    run_->openedUnit = document_.current()->unit;
}

MeshingJob RunControl::job() const {
    return *document_.sharedDomain()->job();
}

void RunControl::startAt(std::uint64_t advance) {
    startRun(StartMode::Pause,
             {meshRevision(), document_.current()->options.method, makesQuads(), true, RunExtent::Full,
              document_.current()->unit},
             advance);
}

void RunControl::start(StartMode mode, RunExtent extent) {
    startRun(mode,
             {meshRevision(), document_.current()->options.method, makesQuads(), mode == StartMode::RunQuiet, extent,
              document_.current()->unit},
             0);
}

void RunControl::startRun(StartMode mode, const RunStart &start, std::uint64_t advance) {
    run_->opened.reset();
    run_->fields.reset();
    run_->cancelling = false;
    MeshingJob whole = job();
    whole.shared = document_.spacing();
    run_->session.start(std::make_shared<const MeshingJob>(std::move(whole)), mode,
                        start.extent == RunExtent::Preview ? liveBudget : std::numeric_limits<double>::infinity(),
                        advance);
    run_->started = true;
    run_->followed = meshRevision();
    run_->startedWith = document_.current();
    run_->lastStart = numbers_->last;
    run_->starts[run_->lastStart] = start;
    if (!start.live) {
        run_->shown = start; // a live run keeps showing the previous mesh until it is finished
    }
}

bool RunControl::startIfNeeded() {
    if (hasRun() && !outOfDate()) {
        return false;
    }
    start(StartMode::Pause);
    return true;
}

bool RunControl::makesQuads() const {
    return forefront::makesQuads(document_.current()->options);
}

void RunControl::beginMove() {
    if (!hasRun()) {
        start(StartMode::Pause);
    }
}

void RunControl::mesh() {
    start(StartMode::Run);
}

void RunControl::togglePlay() {
    if (playing()) {
        run_->session.pause();
        return;
    }
    startIfNeeded();
    run_->session.play(speed_ * kAdvancesPerSecond);
}

void RunControl::step(Granularity granularityOfStep, std::int64_t n) {
    beginMove();
    run_->session.step(granularityOfStep, n);
}

void RunControl::seek(std::uint64_t position) {
    beginMove();
    run_->session.seek(position);
}

void RunControl::seekEnd() {
    beginMove();
    run_->session.finish();
}

void RunControl::seekStop(bool forward) {
    startIfNeeded();
    run_->session.seekStop(forward);
}

void RunControl::seekBirth(Vec2 place, double tolerance) {
    startIfNeeded();
    run_->session.seekBirth(place, tolerance);
}

void RunControl::setBreakpoints(const Breakpoints &breakpoints) {
    if (!(breakpoints == run_->breakpoints)) {
        run_->breakpoints = breakpoints;
        run_->session.stopAt(run_->breakpoints);
    }
}

void RunControl::cancel() {
    run_->cancelling = run_->session.busy();
    run_->session.cancel();
}

void RunControl::clear() {
    run_->session.clear();
    run_->seen.reset(); // a document opened next is meshed even if it differs in nothing that the mesh depends on
    run_->opened.reset();
    run_->fields.reset();
    run_->started = run_->cancelling = false;
    run_->liveResult.reset();
}

bool RunControl::playing() const {
    return run_->snapshot->state == RunState::Running;
}

/// Returns true if the drawing has no shapes left, so that the mesh shows a deleted drawing.
bool RunControl::drawingIsEmpty() const {
    return document_.current()->shapes.empty();
}

bool RunControl::hasRun() const {
    return run_->started && run_->snapshot->state != RunState::Failed && !drawingIsEmpty();
}

bool RunControl::outOfDate() const {
    const bool catchesUp =
        live && (liveMeshPending() || run_->session.busy() || hasNews() || (!gestureOver_ && preview()));
    return run_->started && !drawingIsEmpty() && (run_->shown.revision != meshRevision() || preview()) && !catchesUp;
}

LengthUnit RunControl::shownUnit() const {
    // A unit chosen afterwards is that of the mesh, too, unless the drawing was scaled.
    return run_->opened                             ? run_->openedUnit
           : run_->shown.revision == meshRevision() ? document_.current()->unit
                                                    : run_->shown.unit;
}

Method RunControl::method() const {
    return hasRun() ? run_->shown.method : document_.current()->options.method;
}

bool RunControl::showsQuads() const {
    return hasRun() ? run_->shown.quads : makesQuads();
}

void RunControl::setSpeed(double factor) {
    speed_ = std::clamp(factor, kSlowest, kFastest);
    if (playing()) {
        run_->session.play(speed_ * kAdvancesPerSecond);
    }
}

} // namespace forefront
