#include "ui/workspace/adaptation.hpp"

#include "core/adapt/mesh_outline.hpp"

#include <new>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

Result<AdaptOutcome> outcomeOf(const AdaptRequest &request, const Progress &progress, const AdaptReport &report) {
    const Result<Domain> domain = request.domain ? Result<Domain>(*request.domain) : outlineOf(request.mesh->mesh);
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

} // namespace

Adaptation::Adaptation(std::function<void()> wake) : wake_(std::move(wake)) {}

void Adaptation::start(AdaptRequest request) {
    if (now_.running) {
        return;
    }
    thread_ = {}; // has ended
    request_ = std::move(request);
    progress_ = {};
    progress_.running = true;
    now_ = progress_;
    selected = followed = 0;
    shown = 0;
    thread_ = std::jthread([this, copy = request_](const std::stop_token &stop) { work(copy, stop); });
}

void Adaptation::clear() {
    thread_ = {}; // stops within 100 ms
    progress_ = {};
    now_ = {};
    request_ = {};
    seen_ = version_.load();
    selected = followed = 0;
    shown = 0;
}

bool Adaptation::refresh() {
    if (!hasNews()) {
        return false;
    }
    const std::lock_guard lock(mutex_);
    seen_ = version_.load();
    now_ = progress_;
    return true;
}

void Adaptation::change(const std::function<void(AdaptProgress &)> &apply) {
    {
        const std::lock_guard lock(mutex_);
        apply(progress_);
        ++version_;
    }
    wake_();
}

void Adaptation::work(const AdaptRequest &request, const std::stop_token &stop) {
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
        Result<AdaptOutcome> outcome = outcomeOf(request, progress, report);
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

} // namespace forefront
