#include "core/mesher/timeline.hpp"

#include <algorithm>

namespace forefront {

Timeline::Timeline(std::unique_ptr<Mesher> mesher)
    : mesher_(std::move(mesher)), complete_(mesher_->finished()), layerLeft_(mesher_->state().front.segments()),
      segmentsAtStart_(layerLeft_), segments_(layerLeft_) {}

std::uint64_t Timeline::forward(std::uint64_t count) {
    std::uint64_t done = 0;
    if (position_ < deltas_.size()) { // the same advances again, by determinism
        // Where the grid has split since, their work differs, and only the new deltas can be undone.
        again_.clear();
        done = mesher_->advance(std::min<std::uint64_t>(count, deltas_.size() - position_), &again_);
        std::copy(again_.begin(), again_.end(), deltas_.begin() + static_cast<std::ptrdiff_t>(position_));
        position_ += done;
    }
    if (done < count && !complete_) {
        const std::uint64_t from = deltas_.size();
        done += mesher_->advance(count - done, &deltas_);
        position_ = deltas_.size();
        complete_ = mesher_->finished();
        followLayers(from);
    }
    return done;
}

std::uint64_t Timeline::back(std::uint64_t count) {
    std::uint64_t done = 0;
    for (; done < count && position_ > 0; ++done) {
        mesher_->retreat(deltas_[--position_]);
    }
    return done;
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
