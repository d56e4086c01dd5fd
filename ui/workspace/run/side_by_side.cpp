#include "ui/workspace/run/side_by_side.hpp"

#include "core/drawing/document/document.hpp"
#include "ui/workspace/run/run_control.hpp"

#include <utility>

namespace forefront {

bool SideBySide::hasNews() const {
    for (std::size_t k = 0; k < shown_.size(); ++k) {
        if (lockstep_->latest(k) != shown_[k]) {
            return true;
        }
    }
    return false;
}

void SideBySide::compareWith(std::string name, ComparedFile file) {
    mesh_ = std::make_unique<ComparedMesh>(list(), std::move(name), std::move(file), ++meshes_);
    visible = true;
}

void SideBySide::close() {
    visible = false;
    mesh_.reset();
}

bool SideBySide::follow(const RunControl &run, const Document &document) {
    const SessionSnapshot &main = run.now();
    if (!visible || mesh_ || !run.hasRun() || run.showsFile() || !main.mesh) {
        const bool had = lockstep_.has_value();
        lockstep_.reset();
        shown_.clear();
        return had;
    }
    const bool moved = main.shownRun != run_ || comparison != started_;
    if (run.outOfDate() && (!lockstep_ || main.shownRun != run_)) { // the run on the canvas is of an older document
        const bool had = lockstep_.has_value();                     // the runs beside it are of another one
        lockstep_.reset();
        shown_.clear();
        return had;
    }
    if (!lockstep_ || (moved && !run.outOfDate())) {
        run_ = main.shownRun;
        started_ = comparison;
        const std::vector<RunVariant> variants = variantsBeside({run.method(), document.options.grid}, comparison);
        lockstep_.reset();
        lockstep_.emplace(run.job(), variants, list().wake());
        shown_.assign(variants.size(), nullptr);
    }
    lockstep_->follow(main.advance, main.frontDone());
    bool news = false;
    for (std::size_t k = 0; k < shown_.size(); ++k) {
        const auto latest = lockstep_->latest(k);
        news = news || latest != shown_[k];
        shown_[k] = latest;
    }
    return news;
}

} // namespace forefront
