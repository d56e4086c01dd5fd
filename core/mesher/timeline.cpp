#include "core/mesher/timeline.hpp"

#include <algorithm>

namespace forefront {

Timeline::Timeline(std::unique_ptr<Mesher> mesher) : mesher_(std::move(mesher)), complete_(mesher_->finished()) {
    segments_ = mesher_->state().front.segments();
    serialsUsed_ = mesher_->state().front.nextSerial();
    beginLayer();
}

std::uint64_t Timeline::forward(std::uint64_t count) {
    std::uint64_t done = 0;
    if (position_ < deltas_.size()) { // known ground: the same advances again, by determinism
        done = mesher_->advance(std::min<std::uint64_t>(count, deltas_.size() - position_));
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

void Timeline::beginLayer() {
    layerSerials_ = serialsUsed_;
    layerOfDeferred_ = segments_ == deferred_;
    layerLeft_ = layerOfDeferred_ ? segments_ : segments_ - deferred_;
}

void Timeline::followLayers(std::uint64_t from) {
    for (std::uint64_t p = from; p < deltas_.size(); ++p) {
        followLayer(deltas_[p]);
        if (layerLeft_ == 0 || (complete_ && p + 1 == deltas_.size())) {
            layerEnds_.push_back(p + 1);
            beginLayer();
        }
    }
}

/// Counts the segments of the present layer down as they leave Γ or are deferred for the first time.
void Timeline::followLayer(const AdvanceDelta &delta) {
    using Kind = AdvanceDelta::Kind;
    const auto dealWith = [&](SegmentMark mark) {
        const bool wasDeferred = mark.failureClass > 0;
        deferred_ -= wasDeferred;
        if (mark.serial < layerSerials_ && wasDeferred == layerOfDeferred_) {
            --layerLeft_;
        }
    };
    dealWith(delta.markA);
    switch (delta.kind) {
    case Kind::Deferral:
        ++deferred_;
        break;
    case Kind::NewNode:
    case Kind::Connection:
        segments_ += 1;
        serialsUsed_ += 2;
        break;
    case Kind::Previous:
        dealWith(delta.markS);
        segments_ -= 1;
        serialsUsed_ += 1;
        break;
    case Kind::Next:
        dealWith(delta.markB);
        segments_ -= 1;
        serialsUsed_ += 1;
        break;
    case Kind::Loop:
        dealWith(delta.markB);
        dealWith(delta.markS);
        segments_ -= 3;
        break;
    }
}

} // namespace forefront
