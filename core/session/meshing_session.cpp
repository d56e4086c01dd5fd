#include "core/session/meshing_session.hpp"

#include "core/session/session_worker.hpp"

namespace forefront {

struct MeshingSession::Worker : SessionWorker {
    using SessionWorker::SessionWorker;
};

MeshingSession::MeshingSession(std::function<void()> wake) : worker_(std::make_unique<Worker>(std::move(wake))) {}
MeshingSession::~MeshingSession() = default;

void MeshingSession::start(std::shared_ptr<const MeshingJob> job, bool runToEnd) {
    worker_->push(StartCommand{std::move(job), runToEnd});
}
void MeshingSession::finish() {
    worker_->push(FinishCommand{});
}
void MeshingSession::play(double advancesPerSecond) {
    worker_->push(PlayCommand{advancesPerSecond});
}
void MeshingSession::pause() {
    worker_->push(PauseCommand{});
}
void MeshingSession::step(Granularity granularity, std::int64_t n) {
    worker_->push(StepCommand{granularity, n});
}
void MeshingSession::seek(std::uint64_t advance) {
    worker_->push(SeekCommand{advance});
}
void MeshingSession::cancel() {
    worker_->push(CancelCommand{});
}
void MeshingSession::clear() {
    worker_->push(ClearCommand{});
}
void MeshingSession::want(SnapshotLayers layers) {
    worker_->push(WantCommand{layers});
}
std::shared_ptr<const SessionSnapshot> MeshingSession::latest() const {
    return worker_->latest();
}
bool MeshingSession::busy() const {
    return worker_->busy();
}

} // namespace forefront
