#include "core/engine/session/mesh_stepper.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/session/stepped_run.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

namespace forefront {

struct MeshStepper::Run : SteppedRun {
    using SteppedRun::SteppedRun;

    /// Completes a move. Returns false if it was cancelled, which leaves the run at rest where it is.
    bool complete(TimelineTravel::Outcome outcome, const Progress &progress) {
        while (outcome != TimelineTravel::Outcome::Arrived) {
            if (progress.cancelled() || !excess().empty()) {
                travel().rest();
                return false;
            }
            if (outcome == TimelineTravel::Outcome::FrontDone && !improve(progress).empty()) {
                travel().rest();
                return false;
            }
            report(progress);
            outcome = travel().work();
        }
        return true;
    }

  private:
    void report(const Progress &progress) const {
        const double done = static_cast<double>(travel().timeline().mesher().state().elements.size());
        progress("advancing the front", std::min(0.99, done / (prepared().estimatedElements + 1.0)));
    }
};

namespace {

/// Does a piece of work on a run and discards the run if that throws, since an advance may then be half done.
template <class Run, class Work>
auto guarded(std::unique_ptr<Run> &run, const Work &work) {
    FOREFRONT_ASSERT(run != nullptr);
    try {
        return work(*run);
    } catch (...) {
        run.reset();
        throw;
    }
}

} // namespace

MeshStepper::MeshStepper(std::unique_ptr<Run> run) : run_(std::move(run)) {}
MeshStepper::MeshStepper(MeshStepper &&) noexcept = default;
MeshStepper &MeshStepper::operator=(MeshStepper &&) noexcept = default;
MeshStepper::~MeshStepper() = default;

Result<MeshStepper> MeshStepper::create(MeshingJob job, const Progress &progress, double budget) {
    try {
        auto shared = std::make_shared<const MeshingJob>(std::move(job));
        Result<SteppedJob> prepared = prepareStepped(*shared, progress, budget);
        if (!prepared) {
            return prepared.faults();
        }
        return MeshStepper(std::make_unique<Run>(std::move(shared), *std::move(prepared), 1));
    } catch (const std::bad_alloc &) {
        return outOfMemory();
    }
}

bool MeshStepper::empty() const {
    return run_ == nullptr;
}

std::uint64_t MeshStepper::position() const {
    return run_->travel().timeline().position();
}

std::uint64_t MeshStepper::known() const {
    return run_->travel().timeline().known();
}

bool MeshStepper::complete() const {
    return run_->travel().timeline().complete();
}

bool MeshStepper::atEnd() const {
    return run_->travel().atEnd();
}

std::uint64_t MeshStepper::advance(std::uint64_t count) {
    const std::uint64_t before = position();
    seek(before + std::min(count, std::numeric_limits<std::uint64_t>::max() - before));
    return position() - before;
}

std::uint64_t MeshStepper::retreat(std::uint64_t count) {
    const std::uint64_t before = position();
    seek(before - std::min(count, before));
    return before - position();
}

bool MeshStepper::seek(std::uint64_t position, const Progress &progress) {
    return guarded(run_, [&](Run &run) { return run.complete(run.travel().reach(position), progress); });
}

void MeshStepper::stepImprovement() {
    run_->stepImprovement();
}

bool MeshStepper::finish(const Progress &progress) {
    return guarded(run_, [&](Run &run) {
        return run.complete(run.travel().reachEnd(), progress) && (run.improved() || run.improve(progress).empty());
    });
}

void MeshStepper::step(Granularity granularity, std::int64_t n) {
    if (n != 0) {
        guarded(run_, [&](Run &run) { return run.complete(run.travel().step(granularity, n), {}); });
    }
}

void MeshStepper::stopAt(const Breakpoints &breakpoints) {
    run_->travel().setBreakpoints(breakpoints);
}

std::optional<Stop> MeshStepper::seekStop(bool forward, const Progress &progress) {
    return guarded(run_, [&](Run &run) {
        return run.complete(run.travel().reachStop(forward), progress) ? run.travel().stop() : std::nullopt;
    });
}

std::optional<Birth> MeshStepper::seekBirth(Vec2 place, double tolerance, const Progress &progress) {
    return guarded(run_, [&](Run &run) {
        return run.complete(run.travel().reachBirth(place, tolerance), progress) ? run.travel().birth() : std::nullopt;
    });
}

std::vector<FrontSegmentView> MeshStepper::front() {
    SessionSnapshot snapshot;
    run_->fill(snapshot, {.mesh = false, .front = true}, false);
    return *snapshot.front;
}

Mesh MeshStepper::mesh() {
    SessionSnapshot snapshot;
    run_->fill(snapshot, {.mesh = true, .front = false}, false);
    return copyOf(snapshot.mesh->view());
}

FrontTriangles MeshStepper::triangles() const {
    const Mesher &mesher = run_->travel().timeline().mesher();
    FrontTriangles made{mesher.state().nodes, mesher.state().elements, {}};
    if (const std::vector<std::uint8_t> *colours = mesher.colours()) {
        made.colours = *colours;
    }
    return made;
}

std::shared_ptr<const AdvanceExplanation> MeshStepper::explanation() {
    return guarded(run_, [](Run &run) { return run.travel().explain().advance; });
}

const WorkCounters &MeshStepper::statistics() const {
    return run_->travel().timeline().mesher().state().work;
}

std::shared_ptr<const SessionSnapshot> MeshStepper::snapshot(SnapshotLayers layers) {
    auto snapshot = std::make_shared<SessionSnapshot>();
    snapshot->run = snapshot->shownRun = 1;
    snapshot->state = run_->improved() && atEnd() ? RunState::Finished : RunState::Paused;
    snapshot->stage = "advancing the front";
    guarded(run_, [&](Run &run) { run.fill(*snapshot, layers, true); });
    snapshot->progress = complete() ? 1.0 : 0.0;
    return snapshot;
}

} // namespace forefront
