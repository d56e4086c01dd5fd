#include "ui/workspace/adaptation.hpp"

#include "core/adapt/mesh_outline.hpp"
#include "core/edit/equality.hpp"

#include <atomic>
#include <mutex>
#include <new>
#include <stop_token>
#include <string_view>
#include <thread>
#include <utility>

namespace forefront {

Result<AdaptOutcome> adaptedMesh(const AdaptRequest &request, const Progress &progress, const AdaptReport &report) {
    const Result<Domain> domain =
        request.drawing ? Result<Domain>(toDomain(*request.drawing)) : outlineOf(request.mesh->mesh, progress);
    if (!domain) {
        return domain.faults();
    }
    if (request.values) {
        return adaptOnce(*domain, request.mesh->mesh, *request.values, request.target, request.options, progress,
                         report);
    }
    const Result<NodalField> field = expressionField(request.field);
    if (!field) {
        return field.faults();
    }
    return adapt(*domain, request.mesh->mesh, *field, request.target, request.maxRounds, request.options, progress,
                 report);
}

/// Serves one request on its own thread.
class Adaptation::Worker {
  public:
    Worker(const Work &work, AdaptRequest request, std::function<void()> wake)
        : wake_(std::move(wake)), thread_([this, work, copy = std::move(request)](const std::stop_token &stop) {
              run(work, copy, stop);
              ended_ = true;
          }) {}

    void stop() { thread_.request_stop(); }
    /// Returns true once the destructor no longer has to wait.
    bool ended() const { return ended_; }
    std::uint64_t version() const { return version_; }
    AdaptProgress progress() const {
        const std::lock_guard lock(mutex_);
        return progress_;
    }

  private:
    void run(const Work &work, const AdaptRequest &request, const std::stop_token &stop);
    template <class Apply>
    void change(Apply apply) {
        {
            const std::lock_guard lock(mutex_);
            apply(progress_);
            ++version_;
        }
        wake_();
    }

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    AdaptProgress progress_{.running = true}; ///< guarded by the mutex
    std::atomic<std::uint64_t> version_ = 0;
    std::atomic<bool> ended_ = false;
    std::jthread thread_; ///< last, so that it ends before what it uses
};

void Adaptation::Worker::run(const Work &work, const AdaptRequest &request, const std::stop_token &stop) {
    Progress progress;
    progress.stop = stop;
    progress.report = [this, last = std::pair<std::string, int>()](std::string_view stage, double fraction) mutable {
        const std::pair<std::string, int> next{stage, static_cast<int>(20.0 * fraction)};
        if (next != last) { // a frame for each report would cost more than the work
            last = next;
            change([&](AdaptProgress &p) {
                p.stage = stage;
                p.fraction = fraction;
            });
        }
    };
    const auto keep = [this](AdaptedMesh round) {
        auto kept = std::make_shared<const AdaptedMesh>(std::move(round));
        change([&](AdaptProgress &p) { p.rounds.push_back(std::move(kept)); });
    };
    const auto report = [&](std::size_t, const AdaptRound &round, const AdaptState &state) {
        keep({state.mesh, state.values, state.estimate.elements, round.error, state.spacing});
    };
    Diagnostics faults;
    bool met = false, stalled = false;
    try {
        Result<AdaptOutcome> outcome = work(request, progress, report);
        if (!outcome) {
            faults = outcome.faults();
        } else {
            met = outcome->met;
            stalled = outcome->stalled;
            if (request.values) {
                keep({std::move(outcome->mesh), {}, {}, std::nullopt, std::move(outcome->spacing)});
            }
        }
    } catch (const std::bad_alloc &) {
        faults =
            error("out-of-memory", "not enough memory to adapt the mesh", "allow a larger error or set a minimum size");
    }
    change([&](AdaptProgress &p) {
        p.running = false;
        p.faults = std::move(faults);
        p.met = met;
        p.stalled = stalled;
    });
}

Adaptation::Adaptation(std::function<void()> wake, Work work) : wake_(std::move(wake)), work_(std::move(work)) {}

Adaptation::~Adaptation() = default;

/// Lets the worker end by itself, since joining its thread could take a while.
void Adaptation::retire() {
    if (worker_) {
        worker_->stop();
        retired_.push_back(std::move(worker_));
    }
    seen_ = 0;
    selected = followed = 0;
    shown = 0;
    compared_.reset();
}

void Adaptation::start(AdaptRequest request) {
    if (now_.running) {
        return;
    }
    retire();
    request_ = std::move(request);
    now_ = {.running = true};
    worker_ = std::make_unique<Worker>(work_, request_, wake_);
}

void Adaptation::cancel() {
    if (worker_) {
        worker_->stop();
    }
}

void Adaptation::clear() {
    retire();
    now_ = {};
    request_ = {};
}

bool Adaptation::hasNews() const {
    return worker_ && worker_->version() != seen_;
}

bool Adaptation::refresh() {
    std::erase_if(retired_, [](const std::unique_ptr<Worker> &worker) { return worker->ended(); });
    if (!hasNews()) {
        return false;
    }
    seen_ = worker_->version(); // before the progress, which may be newer
    now_ = worker_->progress();
    return true;
}

bool Adaptation::fits(const std::shared_ptr<const Document> &drawing) const {
    if (!request_.drawing) {
        return true;
    }
    if (compared_ != drawing) {
        compared_ = drawing;
        fits_ = sameDomain(*request_.drawing, *drawing);
    }
    return fits_;
}

} // namespace forefront
