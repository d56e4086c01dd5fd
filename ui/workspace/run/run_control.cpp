#include "ui/workspace/run/run_control.hpp"

#include "core/drawing/document/equality.hpp"
#include "core/engine/session/whole_run.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/document/document_store.hpp"
#include "ui/workspace/mesh/element_words.hpp"
#include "ui/workspace/messages/message_log.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace forefront {

RunControl::RunControl(DocumentStore &document, MessageLog &log, BackgroundList &list)
    : BackgroundActivity(list, NewsPace::WithMesh), document_(document), log_(log), session_(list.wake()),
      snapshot_(session_.latest()), liveMeshing_(list, *this) {}

void RunControl::refresh() {
    const bool busy = session_.busy(); // read before the snapshot: an idle worker has delivered its last one
    snapshot_ = session_.latest();
    cancelling_ = cancelling_ && busy;
    const SessionSnapshot &s = *snapshot_;
    const auto last = starts_.find(lastStart_);
    const bool follows = s.run == lastStart_ || (last != starts_.end() && last->second.live);
    if (follows && s.state != RunState::Preparing && s.shownRun > 0) {
        starts_.erase(starts_.begin(), starts_.lower_bound(s.shownRun));
        shown_ = starts_[s.shownRun]; // an earlier run if the last one was refused
    }
    if (s.run != loggedRun_ || s.state != loggedState_) {
        log(s);
        loggedRun_ = s.run;
        loggedState_ = s.state;
    }
}

namespace {

std::string resultText(const SessionSnapshot &s) {
    const std::string counts = s.stepped && !s.order
                                   ? ui::format("%llu triangles", static_cast<unsigned long long>(s.quality.elements))
                                   : elementsInWords(s.quality.kinds);
    return counts + ui::format(", %llu nodes in %.3g s; minimum \xce\xb1 %.3f, mean %.3f",
                               static_cast<unsigned long long>(s.quality.nodes), s.secondsMesh + s.secondsImprove,
                               s.quality.alphaMin, s.quality.alphaMean);
}

/// Returns one note on all edges of second order that are straight though they lie along curves.
Diagnostics straightEdgesOf(const SessionSnapshot &s) {
    if (!s.order || s.order->straight.empty()) {
        return {};
    }
    const std::size_t count = s.order->straight.size();
    return {{.severity = Severity::Note,
             .code = "straight-edge",
             .message = (count == 1 ? std::string("1 edge along a curve is straight")
                                    : ui::count(count) + " edges along curves are straight") +
                        ", since the curve would fold an element or meet another edge",
             .advice = "choose smaller elements there to follow the curve",
             .at = s.order->straight.front().at}};
}

/// Returns the rules of the specified spacing, the curves that the mesh does not follow, and the places with
/// smaller angles than the least one.
Diagnostics notesOf(const SessionSnapshot &s) {
    Diagnostics notes = s.spacing ? s.spacing->notes() : Diagnostics();
    for (Diagnostic &note : straightEdgesOf(s)) {
        notes.push_back(std::move(note));
    }
    for (Diagnostic &note : s.leastAngle ? forcedAngles(*s.leastAngle) : Diagnostics()) {
        notes.push_back(std::move(note));
    }
    return notes;
}

std::string previewText(const SessionSnapshot &s) {
    return ui::format("Preview of %llu triangles; the full mesh will have about %.2g",
                      static_cast<unsigned long long>(s.quality.elements), s.requestedElements);
}

} // namespace

void RunControl::log(const SessionSnapshot &s) {
    const auto start = starts_.find(s.run);
    const bool isLive = start != starts_.end() && start->second.live;
    const bool refused = !s.diagnostics.empty() && (s.state == RunState::Failed || s.run != refusalLogged_);
    if (refused) {
        refusalLogged_ = s.run;
        if (isLive) {
            liveResult_ = {{}, s.diagnostics, start->second.revision};
        } else {
            log_.add(s.diagnostics, starts_[s.run].revision);
        }
    } else if (s.shownRun != s.run) {
        // The previous mesh is already in the log.
    } else if (s.state == RunState::Cancelled && loggedState_ != RunState::Cancelled) {
        log_.note(ui::format("Cancelled after %llu advances; you can step through the partial mesh",
                             static_cast<unsigned long long>(s.known)));
    } else if (s.state == RunState::Finished && s.run != resultLogged_) {
        resultLogged_ = s.run;
        if (s.coarsening > 1.0) {
            liveResult_ = {previewText(s), {}, start->second.revision};
        } else if (isLive) {
            liveResult_ = {resultText(s), notesOf(s), start->second.revision};
        } else {
            log_.note(resultText(s));
            logNotes(notesOf(s), starts_[s.run].revision);
        }
    }
}

/// Limits, the background picture, guides, the unit and sketch constraints do not change the mesh, so a revision that
/// differs in nothing else counts as the one before.
std::uint64_t RunControl::meshRevision() const {
    const std::uint64_t revision = document_.revision();
    if (revision != seenRevision_) {
        const std::shared_ptr<const Document> document = document_.current();
        const auto known = meshRevisions_.find(revision);
        bool same = false;
        if (seen_ && !(seen_->limits == document->limits && seen_->picture == document->picture &&
                       seen_->guides == document->guides && seen_->unit == document->unit &&
                       seen_->constraints == document->constraints)) {
            Document before = *seen_;
            before.limits = document->limits;
            before.picture = document->picture;
            before.guides = document->guides;
            before.unit = document->unit;
            before.constraints = document->constraints; // what they move is in the shapes
            same = sameContent(before, *document);
        }
        meshRevision_ = known != meshRevisions_.end() ? known->second : same ? meshRevision_ : revision;
        meshRevisions_[revision] = meshRevision_;
        seen_ = document;
        seenRevision_ = revision;
    }
    return meshRevision_;
}

bool RunControl::liveMeshPending() const {
    return live && !opened_ && (followed_ != meshRevision() || needsFullMesh());
}

/// Returns true if the newest document has only a preview, or not even that because its boundary cannot be so coarse,
/// and there is no reason not to make the full mesh.
bool RunControl::needsFullMesh() const {
    const auto last = starts_.find(lastStart_);
    const bool previewed = last != starts_.end() && last->second.extent == Extent::Preview &&
                           last->second.revision == meshRevision() && snapshot_->run == lastStart_;
    const bool refused = !snapshot_->diagnostics.empty();
    const bool tooLarge = !refused && snapshot_->requestedElements > kLargestLive;
    return resting_ && previewed && (preview() || refused) && !tooLarge;
}

/// Returns true if the run in progress is not worth finishing once the document has changed: a full mesh that followed
/// a preview, or one large enough to show its progress.
bool RunControl::replaceable(const SessionSnapshot &newest, bool gestureOver) const {
    const auto last = starts_.find(lastStart_);
    const bool follows = last != starts_.end() && last->second.live && last->second.extent == Extent::Full;
    const bool large =
        newest.run == lastStart_ && (newest.state == RunState::Running || newest.state == RunState::Improving ||
                                     (newest.state == RunState::Preparing && !steps()));
    return follows || (large && gestureOver);
}

/// Returns true if the newest document differs from that of the run in the rules of the method alone, and the run rests
/// in its course.
bool RunControl::keepsPosition(const SessionSnapshot &newest) const {
    const bool underWay =
        newest.run == lastStart_ && newest.state == RunState::Paused && newest.known > 0 && !newest.atEnd();
    const Document &now = *document_.current();
    if (!underWay || !startedWith_ || startedWith_->options.rules == now.options.rules ||
        newest.requestedElements > liveBudget) {
        return false;
    }
    Document before = *startedWith_;
    before.options.rules = now.options.rules;
    before.limits = now.limits;
    before.picture = now.picture;
    return sameContent(before, now);
}

void RunControl::startLiveMesh() {
    if (const auto newest = session_.latest(); keepsPosition(*newest)) {
        startAt(newest->advance);
    } else if (followed_ == meshRevision()) {
        start(StartMode::RunQuiet, Extent::Full);
    } else if (!document_.current()->shapes.empty()) {
        start(StartMode::RunQuiet, Extent::Preview);
    }
    followed_ = meshRevision();
}

void RunControl::follow(bool gestureOver, bool faulty) {
    gestureOver_ = gestureOver;
    resting_ = gestureOver && !faulty;
    if (liveMeshPending() && (!session_.busy() || replaceable(*session_.latest(), gestureOver))) {
        startLiveMesh();
    }
    if (gestureOver && !session_.busy() && liveResult_ && liveResult_->revision == meshRevision()) {
        logLive(faulty);
    }
}

void RunControl::logLive(bool faulty) {
    const LiveResult result = *std::exchange(liveResult_, std::nullopt);
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
    if (text != notesLogged_) { // a live mesh would repeat them with every change
        log_.add(notes, revision);
        notesLogged_ = std::move(text);
    }
}

void RunControl::want(SnapshotLayers layers) {
    if (wanted_ != layers) { // a command in every frame would keep the worker busy
        wanted_ = layers;
        session_.want(layers);
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
    fields_ = std::move(read.fields);
    read.view->version = (std::uint64_t{1} << 63) + ++openedCount_; // unlike those of runs
    auto opened = std::make_shared<SessionSnapshot>();
    opened->state = RunState::Finished;
    opened->complete = true;
    opened->quality = read.quality;
    opened->meshHash = read.hash;
    opened->mesh = std::move(read.view);
    opened_ = std::move(opened);
    adapted_ = false;
    openedUnit_ = LengthUnit::None;
}

void RunControl::showAdapted(MeshFields made) {
    showFile(std::move(made));
    adapted_ = true;
    openedUnit_ = document_.current()->unit;
}

MeshingJob RunControl::job() const {
    return *document_.sharedDomain()->job();
}

void RunControl::startAt(std::uint64_t advance) {
    startRun(StartMode::Pause,
             {meshRevision(), document_.current()->options.method, true, Extent::Full, document_.current()->unit},
             advance);
}

void RunControl::start(StartMode mode, Extent extent) {
    startRun(mode,
             {meshRevision(), document_.current()->options.method, mode == StartMode::RunQuiet, extent,
              document_.current()->unit},
             0);
}

void RunControl::startRun(StartMode mode, const Start &start, std::uint64_t advance) {
    opened_.reset();
    fields_.reset();
    cancelling_ = false;
    MeshingJob whole = job();
    whole.shared = document_.spacing();
    session_.start(std::make_shared<const MeshingJob>(std::move(whole)), mode,
                   start.extent == Extent::Preview ? liveBudget : std::numeric_limits<double>::infinity(), advance);
    started_ = true;
    followed_ = meshRevision();
    startedWith_ = document_.current();
    starts_[++lastStart_] = start;
    if (!start.live) {
        shown_ = start; // a live run keeps showing the previous mesh until it is finished
    }
}

bool RunControl::startIfNeeded() {
    if (hasRun() && !outOfDate()) {
        return false;
    }
    start(StartMode::Pause);
    return true;
}

bool RunControl::steps() const {
    return canStep(document_.current()->options);
}

bool RunControl::beginMove() {
    if (!steps()) {
        log_.refuse(kNotStepped);
        return false;
    }
    if (!hasRun() || !snapshot_->stepped) {
        start(StartMode::Pause);
    }
    return true;
}

void RunControl::mesh() {
    start(StartMode::Run);
}

void RunControl::togglePlay() {
    if (playing()) {
        session_.pause();
        return;
    }
    if (!steps()) {
        log_.refuse(kNotStepped);
        return;
    }
    startIfNeeded();
    session_.play(speed_ * kAdvancesPerSecond);
}

void RunControl::step(Granularity granularityOfStep, std::int64_t n) {
    if (!beginMove()) {
        return;
    }
    session_.step(granularityOfStep, n);
}

void RunControl::seek(std::uint64_t position) {
    if (!beginMove()) {
        return;
    }
    session_.seek(position);
}

void RunControl::seekEnd() {
    if (!beginMove()) {
        return;
    }
    session_.finish();
}

void RunControl::seekStop(bool forward) {
    if (!steps()) {
        log_.refuse(kNotStepped);
        return;
    }
    startIfNeeded();
    session_.seekStop(forward);
}

void RunControl::seekBirth(Vec2 place, double tolerance) {
    if (!steps()) {
        log_.refuse(kNotStepped);
        return;
    }
    startIfNeeded();
    session_.seekBirth(place, tolerance);
}

void RunControl::setBreakpoints(const Breakpoints &breakpoints) {
    if (!(breakpoints == breakpoints_)) {
        breakpoints_ = breakpoints;
        session_.stopAt(breakpoints_);
    }
}

void RunControl::cancel() {
    cancelling_ = session_.busy();
    session_.cancel();
}

void RunControl::clear() {
    session_.clear();
    seen_.reset(); // a document opened next is meshed even if it differs in nothing that the mesh depends on
    opened_.reset();
    fields_.reset();
    started_ = cancelling_ = false;
    liveResult_.reset();
}

bool RunControl::playing() const {
    return snapshot_->state == RunState::Running;
}

/// Returns true if the drawing has no shapes left, so that the mesh shows a deleted drawing.
bool RunControl::drawingIsEmpty() const {
    return document_.current()->shapes.empty();
}

bool RunControl::hasRun() const {
    return started_ && snapshot_->state != RunState::Failed && !drawingIsEmpty();
}

bool RunControl::outOfDate() const {
    const bool catchesUp = live && (liveMeshPending() || session_.busy() || hasNews() || (!gestureOver_ && preview()));
    return started_ && !drawingIsEmpty() && (shown_.revision != meshRevision() || preview()) && !catchesUp;
}

LengthUnit RunControl::shownUnit() const {
    // A unit chosen afterwards is that of the mesh, too, unless the drawing was scaled.
    return opened_ ? openedUnit_ : shown_.revision == meshRevision() ? document_.current()->unit : shown_.unit;
}

Method RunControl::method() const {
    return hasRun() ? shown_.method : document_.current()->options.method;
}

void RunControl::setSpeed(double factor) {
    speed_ = std::clamp(factor, kSlowest, kFastest);
    if (playing()) {
        session_.play(speed_ * kAdvancesPerSecond);
    }
}

} // namespace forefront
