#include "core/engine/mesher/timeline.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Slots of Γ to copy per advance between checkpoints: about 3 % of the time of an advance.
constexpr std::uint64_t kSlotsPerAdvance = 4;

/// Adds or, unless `forward`, subtracts the part of the work that depends on the state of the grid.
void addGridWork(WorkCounters &work, const AdvanceDelta &delta, bool forward) {
    const auto add = [forward](std::uint64_t &sum, std::uint64_t value) { sum = forward ? sum + value : sum - value; };
    add(work.delivered, delta.delivered);
    add(work.tested, delta.tested);
    add(work.cellsVisited, delta.cells);
}

} // namespace

Timeline::Timeline(std::unique_ptr<Mesher> mesher, std::uint64_t stride)
    : mesher_(std::move(mesher)), stride_(stride), complete_(mesher_->finished()),
      layerLeft_(mesher_->state().front.segments()), segmentsAtStart_(layerLeft_), segments_(layerLeft_) {
    made_.add(mesher_->state());
}

std::uint64_t Timeline::forward(std::uint64_t count) {
    std::uint64_t done = repeat(count);
    while (done < count && !complete_) {
        done += continueRun(count - done);
    }
    return done;
}

/// Repeats known advances. They are the same by determinism, but where the grid has split since, their work differs:
/// the counters keep the work done the first time.
std::uint64_t Timeline::repeat(std::uint64_t count) {
    count = std::min<std::uint64_t>(count, deltas_.size() - position_);
    if (count == 0) {
        return 0;
    }
    again_.clear();
    const std::uint64_t done = mesher_->advance(count, &again_);
    WorkCounters work = mesher_->state().work;
    for (std::uint64_t i = 0; i < done; ++i) {
        addGridWork(work, again_[i], false);
        addGridWork(work, deltas_[position_ + i], true);
    }
    mesher_->setWork(work);
    position_ += done;
    return done;
}

/// Advances beyond the known end, as far as the next checkpoint at most.
std::uint64_t Timeline::continueRun(std::uint64_t count) {
    if (checkpoints_.empty() || position_ >= nextCheckpoint()) {
        keepCheckpoint();
    }
    const std::uint64_t from = deltas_.size();
    const std::uint64_t done = mesher_->advance(std::min(count, nextCheckpoint() - position_), &deltas_);
    position_ = deltas_.size();
    complete_ = mesher_->finished();
    made_.add(mesher_->state());
    followLayers(from);
    return done;
}

std::uint64_t Timeline::back(std::uint64_t count) {
    count = std::min(count, position_);
    const std::uint64_t target = position_ - count;
    while (position_ > target) {
        if (position_ > floor_) {
            mesher_->retreat(deltas_[--position_]);
        } else {
            restore(checkpointBefore(position_ - 1));
            repeat(std::max(target, position_) - position_);
        }
    }
    return count;
}

std::uint64_t Timeline::nextCheckpoint() const {
    const std::uint64_t copying = mesher_->state().front.capacity() / kSlotsPerAdvance;
    return checkpoints_.back().position + std::max(stride_, copying);
}

void Timeline::keepCheckpoint() {
    checkpoints_.push_back({position_, mesher_->checkpoint()});
    checkpointBytes_ += checkpoints_.back().state.bytes();
    if (checkpoints_.size() > kMaxCheckpoints || checkpointBytes_ > kMaxCheckpointBytes) {
        thinCheckpoints();
    }
}

/// Drops every second checkpoint and doubles their distance. Keeps the first, and the last if it is the second of a
/// pair, since the next ones follow at a distance from it.
void Timeline::thinCheckpoints() {
    stride_ *= 2;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < checkpoints_.size(); i += 2) {
        if (kept != i) {
            checkpoints_[kept] = std::move(checkpoints_[i]);
        }
        ++kept;
    }
    checkpoints_.erase(checkpoints_.begin() + static_cast<std::ptrdiff_t>(kept), checkpoints_.end());
    checkpointBytes_ = 0;
    for (const Kept &checkpoint : checkpoints_) {
        checkpointBytes_ += checkpoint.state.bytes();
    }
}

const Timeline::Kept &Timeline::checkpointBefore(std::uint64_t position) const {
    const auto after =
        std::upper_bound(checkpoints_.begin(), checkpoints_.end(), position,
                         [](std::uint64_t p, const Kept &checkpoint) { return p < checkpoint.position; });
    return *(after - 1);
}

void Timeline::restore(const Kept &checkpoint) {
    mesher_->restore(checkpoint.state, made_);
    position_ = floor_ = checkpoint.position;
}

void Timeline::approach(std::uint64_t target) {
    target = std::min(target, known());
    if (checkpoints_.empty() || target == position_) {
        return;
    }
    const Kept &checkpoint = checkpointBefore(target);
    // A step back takes about half as long as a step forward.
    const std::uint64_t fromThere = target - checkpoint.position;
    const bool sooner = target > position_ ? checkpoint.position > position_ : 2 * fromThere < position_ - target;
    if (sooner || target < floor_) {
        restore(checkpoint);
    }
}

void Timeline::followLayers(std::uint64_t from) {
    for (std::uint64_t p = from; p < deltas_.size(); ++p) {
        segments_ = static_cast<std::uint64_t>(static_cast<std::int64_t>(segments_) + deltas_[p].growth());
        if (--layerLeft_ == 0 || segments_ == 0) {
            layerEnds_.push_back(p + 1);
            layerLeft_ = segments_;
        }
    }
}

} // namespace forefront
