#include "ui/editor/run_control.hpp"

#include "ui/editor/document_store.hpp"
#include "ui/editor/message_log.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>

namespace forefront {

RunControl::RunControl(DocumentStore &document, MessageLog &log, std::function<void()> wake)
    : document_(document), log_(log), session_(std::move(wake)), snapshot_(session_.latest()) {}

void RunControl::refresh() {
    const bool busy = session_.busy(); // asked first: what it does not promise any more has been delivered
    snapshot_ = session_.latest();
    cancelling_ = cancelling_ && busy;
    const SessionSnapshot &s = *snapshot_;
    if (s.run == lastStart_ && s.state != RunState::Preparing && s.shownRun > 0) {
        starts_.erase(starts_.begin(), starts_.lower_bound(s.shownRun));
        shown_ = starts_[s.shownRun]; // of an earlier run where the last was refused
    }
    if (s.run == loggedRun_ && s.state == loggedState_) {
        return;
    }
    const bool news = s.run != loggedRun_ || s.state == RunState::Failed || s.state == RunState::Finished ||
                      s.state == RunState::Cancelled;
    const bool refused = !s.diagnostics.empty() && (s.state == RunState::Failed || s.run != refusalTold_);
    if (refused) {
        log_.add(s.diagnostics, starts_[s.run].revision);
        refusalTold_ = s.run;
    } else if (s.shownRun != s.run) {
        // The mesh before was told of in its time.
    } else if (news && s.state == RunState::Cancelled && loggedState_ != RunState::Cancelled) {
        log_.note(ui::format("Cancelled after %llu advances; the partial mesh can be stepped through",
                             static_cast<unsigned long long>(s.known)));
    } else if (news && s.state == RunState::Finished && loggedState_ != RunState::Paused) {
        log_.note(ui::format("%llu triangles, %llu nodes in %.3g s; least \xce\xb1 %.3f, mean %.3f",
                             static_cast<unsigned long long>(s.quality.elements),
                             static_cast<unsigned long long>(s.quality.nodes), s.secondsMesh + s.secondsImprove,
                             s.quality.alphaMin, s.quality.alphaMean));
    }
    loggedRun_ = s.run;
    loggedState_ = s.state;
}

void RunControl::want(SnapshotLayers layers) {
    session_.want(layers);
}

void RunControl::start(bool runToEnd) {
    cancelling_ = false;
    const std::shared_ptr<const Document> document = document_.current();
    auto job = std::make_shared<MeshingJob>();
    job->domain = toDomain(*document);
    job->spacing = document->spacing;
    job->options = document->options;
    session_.start(std::move(job), runToEnd);
    started_ = true;
    shown_ = starts_[++lastStart_] = {document_.revision(), document->options.method};
}

bool RunControl::startIfNeeded() {
    if (hasRun() && !outOfDate()) {
        return false;
    }
    start(false);
    return true;
}

void RunControl::mesh() {
    start(true);
}

void RunControl::togglePlay() {
    if (playing()) {
        session_.pause();
        return;
    }
    startIfNeeded();
    session_.play(speed_ * kAdvancesPerSecond);
}

void RunControl::step(Granularity granularityOfStep, std::int64_t n) {
    if (!hasRun()) {
        start(false);
    }
    session_.step(granularityOfStep, n);
}

void RunControl::seek(std::uint64_t advance) {
    if (!hasRun()) {
        start(false);
    }
    session_.seek(advance);
}

void RunControl::seekEnd() {
    if (!hasRun()) {
        start(false);
    }
    if (snapshot_->complete) {
        session_.seek(snapshot_->known);
    } else {
        session_.finish();
    }
}

void RunControl::cancel() {
    cancelling_ = session_.busy();
    session_.cancel();
}

void RunControl::clear() {
    session_.clear();
    started_ = cancelling_ = false;
}

bool RunControl::playing() const {
    return snapshot_->state == RunState::Running;
}

bool RunControl::hasRun() const {
    return started_ && snapshot_->state != RunState::Failed;
}

bool RunControl::outOfDate() const {
    return started_ && shown_.revision != document_.revision();
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
