#include "ui/workspace/run/side_by_side.hpp"

#include "core/drawing/document/document.hpp"
#include "ui/workspace/run/run_control.hpp"

#include <algorithm>
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

bool SideBySide::working() const {
    return (lockstep_ && lockstep_->busy()) ||
           std::any_of(ending_.begin(), ending_.end(), [](const Lockstep &runs) { return runs.busy(); });
}

bool SideBySide::drop() {
    shown_.clear();
    if (!lockstep_) {
        return false;
    }
    lockstep_->clear();
    ending_.push_back(*std::move(lockstep_));
    lockstep_.reset();
    return true;
}

bool SideBySide::follow(const RunControl &run, const Document &document) {
    std::erase_if(ending_, [](const Lockstep &runs) { return !runs.busy(); });
    const SessionSnapshot &main = run.now();
    if (!visible || mesh_ || !run.hasRun() || run.showsFile() || !main.mesh) {
        return drop();
    }
    const bool moved = main.shownRun != run_ || comparison != started_;
    if (run.outOfDate() && (!lockstep_ || main.shownRun != run_)) {
        return drop(); // the run on the canvas is of an older document, the runs beside it are of another one
    }
    if (!lockstep_ || (moved && !run.outOfDate())) {
        run_ = main.shownRun;
        started_ = comparison;
        const std::vector<RunVariant> variants = variantsBeside({run.method(), document.options.grid}, comparison);
        drop();
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
