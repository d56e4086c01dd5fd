#include "ui/workspace/run/adaptation.hpp"

#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/adapt/mesh_outline.hpp"

#include <new>
#include <stop_token>
#include <string_view>
#include <utility>

namespace forefront {

Result<AdaptOutcome> adaptedMesh(const AdaptRequest &request, const Progress &progress, const AdaptReport &report) {
    MeshingJob job;
    if (request.drawing) {
        job = jobOf(*request.drawing);
    } else if (Result<Domain> outline = outlineOf(request.mesh->view(), progress); outline) {
        job.domain = std::move(*outline);
    } else {
        return outline.faults();
    }
    job.options = request.options;
    if (request.values) {
        return adaptMeshOnce(job, request.mesh->mesh, *request.values, request.target, progress, report);
    }
    const Result<NodalField> field = expressionField(request.field);
    if (!field) {
        return field.faults();
    }
    return adaptMesh(job, request.mesh->mesh, *field, request.target, request.maxRounds, progress, report);
}

namespace {

using AdaptWorker = WorkerState<AdaptProgress>;

template <class Apply>
void changeProgress(AdaptWorker &worker, Apply apply) {
    worker.change([&](AdaptProgress &progress) {
        apply(progress);
        return true;
    });
}

void runAdaptation(AdaptWorker &worker, const Adaptation::Work &work, const AdaptRequest &request,
                   const std::stop_token &stop) {
    Progress progress;
    progress.stop = stop;
    progress.report = [&worker, last = std::pair<std::string, int>()](std::string_view stage, double fraction) mutable {
        const std::pair<std::string, int> next{stage, static_cast<int>(20.0 * fraction)};
        if (next != last) { // a frame for each report would cost more than the work
            last = next;
            changeProgress(worker, [&](AdaptProgress &p) {
                p.stage = stage;
                p.fraction = fraction;
            });
        }
    };
    const auto keep = [&worker](AdaptedMesh round) {
        auto kept = std::make_shared<const AdaptedMesh>(std::move(round));
        changeProgress(worker, [&](AdaptProgress &p) { p.rounds.push_back(std::move(kept)); });
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
    changeProgress(worker, [&](AdaptProgress &p) {
        p.running = false;
        p.faults = std::move(faults);
        p.met = met;
        p.stalled = stalled;
    });
}

} // namespace

Adaptation::Adaptation(std::function<void()> wake, Work work) : wake_(std::move(wake)), work_(std::move(work)) {}

void Adaptation::retire() {
    worker_.retire();
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
    worker_.start(now_, wake_, [work = work_, copy = request_](AdaptWorker &worker, const std::stop_token &stop) {
        runAdaptation(worker, work, copy, stop);
    });
}

void Adaptation::clear() {
    retire();
    now_ = {};
    request_ = {};
}

bool Adaptation::refresh() {
    std::optional<AdaptProgress> newest = worker_.refresh();
    if (newest) {
        now_ = std::move(*newest);
    }
    return newest.has_value();
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
