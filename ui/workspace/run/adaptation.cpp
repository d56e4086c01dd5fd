#include "ui/workspace/run/adaptation.hpp"

#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/adapt/mesh_outline.hpp"

#include <new>
#include <string_view>
#include <utility>

namespace forefront {

Result<AdaptOutcome> adaptedMesh(const AdaptRequest &request, const Progress &progress, const AdaptReport &report) {
    MeshingJob job;
    if (request.drawing) {
        job = jobOf(*request.drawing);
    } else if (Result<MeshDomain> outline = outlineOf(request.mesh->view(), progress); outline) {
        job.domain = std::move(outline->domain);
        job.cracks = std::move(outline->cracks);
        job.periodic = std::move(outline->periodic);
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

using AdaptTurn = LatestTurn<AdaptRequest, AdaptProgress>;

AdaptProgress runAdaptation(const AdaptTurn &turn, const Adaptation::Work &work) {
    AdaptProgress now{.running = true};
    Progress progress;
    progress.stop = turn.stop;
    progress.report = [&, last = std::pair<std::string, int>()](std::string_view stage, double fraction) mutable {
        const std::pair<std::string, int> next{stage, static_cast<int>(20.0 * fraction)};
        if (next != last) { // a frame for each report would cost more than the work
            last = next;
            now.stage = stage;
            now.fraction = fraction;
            turn.publish(now);
        }
    };
    const auto keep = [&](AdaptedMesh round) {
        now.rounds.push_back(std::make_shared<const AdaptedMesh>(std::move(round)));
        turn.publish(now);
    };
    const auto report = [&](std::size_t, const AdaptRound &round, const AdaptState &state) {
        keep({state.mesh, state.values, state.estimate.elements, round.error, state.spacing});
    };
    try {
        Result<AdaptOutcome> outcome = work(turn.request, progress, report);
        if (!outcome) {
            now.faults = outcome.faults();
        } else {
            if (turn.request.values) {
                keep({std::move(outcome->mesh), {}, {}, std::nullopt, std::move(outcome->spacing)});
            }
            now.met = outcome->met;
            now.stalled = outcome->stalled;
        }
    } catch (const std::bad_alloc &) {
        now.faults =
            error("out-of-memory", "not enough memory to adapt the mesh", "allow a larger error or set a minimum size");
    }
    now.running = false;
    return now;
}

} // namespace

Adaptation::Adaptation(BackgroundList &list, Work work)
    : worker_(list, [work = std::move(work)](const AdaptTurn &turn) { return runAdaptation(turn, work); }) {}

/// Drops the rounds and shows `now`.
void Adaptation::reset(AdaptProgress now) {
    worker_.clear(std::move(now));
    selected = followed = 0;
    shown = 0;
    compared_.reset();
}

void Adaptation::start(AdaptRequest request) {
    if (busy()) {
        return;
    }
    reset({.running = true});
    request_ = std::move(request);
    worker_.submit(request_);
}

void Adaptation::clear() {
    reset({});
    request_ = {};
}

KeptAdaptation Adaptation::exchange(KeptAdaptation other) {
    KeptAdaptation kept{now(), std::move(request_), selected, followed, shown, loads};
    kept.progress.running = false;
    reset(std::move(other.progress));
    request_ = std::move(other.request);
    selected = other.selected;
    followed = other.followed;
    shown = other.shown;
    loads = other.loads;
    return kept;
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
