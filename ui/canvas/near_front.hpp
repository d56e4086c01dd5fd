#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/session/snapshot.hpp"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

/// The segments of the front in a box, such as that around an advance. They are found by walking the front, once for
/// each front and box.
class NearFront {
  public:
    using Segments = std::vector<std::pair<Vec2, Vec2>>;

    /// Returns the segments whose boxes overlap a box. `front` is not null.
    const Segments &within(const std::shared_ptr<const std::vector<FrontSegmentView>> &front, const Box2 &box) {
        if (front != front_ || !(box.min == box_.min) || !(box.max == box_.max)) {
            front_ = front;
            box_ = box;
            segments_.clear();
            for (const FrontSegmentView &segment : *front) {
                Box2 around;
                around.add(segment.a);
                around.add(segment.b);
                if (around.overlaps(box)) {
                    segments_.emplace_back(segment.a, segment.b);
                }
            }
            ++walks_;
        }
        return segments_;
    }
    /// Returns how often a front was walked.
    std::size_t walks() const { return walks_; }

  private:
    std::shared_ptr<const std::vector<FrontSegmentView>> front_;
    Box2 box_;
    Segments segments_;
    std::size_t walks_ = 0;
};

} // namespace forefront
