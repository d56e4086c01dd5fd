#include "core/engine/session/meshing_session.hpp"

#include "core/engine/session/session_worker.hpp"

namespace forefront {

struct MeshingSession::Worker : SessionWorker {
    using SessionWorker::SessionWorker;
};

MeshingSession::MeshingSession(std::function<void()> wake, std::shared_ptr<RunNumbers> numbers)
    : numbers_(std::move(numbers)), worker_(std::make_unique<Worker>(std::move(wake))) {}
MeshingSession::~MeshingSession() = default;

void MeshingSession::start(std::shared_ptr<const MeshingJob> job, StartMode mode, double budget, std::uint64_t position,
                           ImprovementPace improvement) {
    worker_->mailbox().push(StartCommand{std::move(job), mode, budget, position, improvement, ++numbers_->last});
}
void MeshingSession::finish() {
    worker_->mailbox().push(FinishCommand{});
}
void MeshingSession::play(double advancesPerSecond) {
    worker_->mailbox().push(PlayCommand{advancesPerSecond});
}
void MeshingSession::pause() {
    worker_->mailbox().push(PauseCommand{});
}
void MeshingSession::step(Granularity granularity, std::int64_t n) {
    worker_->mailbox().push(StepCommand{granularity, n});
}
void MeshingSession::seek(std::uint64_t advance) {
    worker_->mailbox().push(SeekCommand{advance});
}
void MeshingSession::stopAt(const Breakpoints &breakpoints) {
    worker_->mailbox().push(BreakpointsCommand{breakpoints});
}
void MeshingSession::seekStop(bool forward) {
    worker_->mailbox().push(SeekStopCommand{forward});
}
void MeshingSession::seekBirth(Vec2 place, double tolerance) {
    worker_->mailbox().push(SeekBirthCommand{place, tolerance});
}
void MeshingSession::cancel() {
    worker_->mailbox().push(CancelCommand{});
}
void MeshingSession::clear() {
    worker_->mailbox().push(ClearCommand{});
}
void MeshingSession::want(SnapshotLayers layers) {
    worker_->mailbox().push(LayersCommand{layers});
}
std::shared_ptr<const SessionSnapshot> MeshingSession::latest() const {
    return worker_->mailbox().latest();
}
bool MeshingSession::busy() const {
    return worker_->mailbox().busy();
}
std::shared_ptr<const SessionSnapshot> MeshingSession::wait() const {
    return worker_->mailbox().wait({});
}
std::shared_ptr<const SessionSnapshot> MeshingSession::waitForNews(std::uint64_t sequence) const {
    return worker_->mailbox().wait(sequence);
}

} // namespace forefront
