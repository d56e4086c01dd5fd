#include "core/engine/session/lockstep.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace forefront {

std::string RunVariant::name() const {
    const std::string text(wordOf(method));
    return grid == GridKind::None ? text + ", no grid" : text + ", " + std::string(wordOf(grid)) + " grid";
}

std::vector<RunVariant> variantsBeside(const RunVariant &shown, Comparison comparison) {
    std::vector<RunVariant> variants;
    if (comparison == Comparison::Methods) {
        variants.push_back({shown.method == Method::Fast ? Method::Classic : Method::Fast, shown.grid});
        return variants;
    }
    for (const GridKind grid : valuesOf<GridKind>()) {
        if (grid != shown.grid) {
            variants.push_back({shown.method, grid});
        }
    }
    return variants;
}

RunFigures figuresOf(const SessionSnapshot &snapshot) {
    const WorkCounters &work = snapshot.work;
    const double elements = static_cast<double>(std::max<std::uint64_t>(work.elements, 1));
    return {.advances = snapshot.advance,
            .elements = work.elements,
            .front = work.frontMean(),
            .neighbours = work.neighboursMean(),
            .considered = work.consideredMean(),
            .tests = work.testsMean(),
            .cells = static_cast<double>(work.cellsVisited) / elements};
}

bool samePosition(const SessionSnapshot &a, const SessionSnapshot &b) {
    return a.advance == b.advance || (a.frontDone() && b.frontDone());
}

Lockstep::Lockstep(const MeshingJob &job, std::vector<RunVariant> variants, const std::function<void()> &wake) {
    for (const RunVariant &variant : variants) {
        auto own = std::make_shared<MeshingJob>(job);
        own->options.method = variant.method;
        own->options.grid = variant.grid;
        own->options.threads = 1;
        runs_.push_back({variant, std::make_unique<MeshingSession>(wake)});
        runs_.back().session->want({.mesh = true, .front = true, .cells = true, .explanation = true});
        runs_.back().session->start(std::move(own), StartMode::Pause, std::numeric_limits<double>::infinity(), 0,
                                    ImprovementPace::AtOnce);
    }
}

bool Lockstep::busy() const {
    return std::any_of(runs_.begin(), runs_.end(), [](const Run &run) { return run.session->busy(); });
}

void Lockstep::clear() {
    for (const Run &run : runs_) {
        run.session->clear();
    }
}

void Lockstep::wait() const {
    for (const Run &run : runs_) {
        run.session->wait();
    }
}

void Lockstep::follow(std::uint64_t advance, bool end) {
    for (Run &run : runs_) {
        if (run.session->busy() || (run.end == end && (end || run.advance == advance))) {
            continue;
        }
        run.advance = advance;
        run.end = end;
        if (!end) {
            run.session->seek(advance);
        } else {
            run.session->finish();
        }
    }
}

} // namespace forefront
