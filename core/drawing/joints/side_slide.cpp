#include "core/drawing/joints/side_slide.hpp"

#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace forefront {
namespace {

/// The straight sides of a shape as a way for nodes.
class SideWay {
  public:
    explicit SideWay(const Shape &shape)
        : shape_(shape), handles_(handlesOf(shape)), sides_(sideCount(shape)), closed_(sides_ == handles_.size()) {}

    /// Returns the parameter of the point of the line through a side that is nearest to a place; below 0 or above 1
    /// beyond its ends.
    double along(std::size_t side, Vec2 place) const {
        const Vec2 a = handles_[side], way = endOf(side) - a;
        return lengthSquared(way) > 0.0 ? dot(place - a, way) / lengthSquared(way) : 0.0;
    }

    Vec2 at(std::size_t side, double t) const {
        const Vec2 a = handles_[side], b = endOf(side);
        return t <= 0.0 ? a : t >= 1.0 ? b : a + t * (b - a);
    }

    /// Returns the straight side beyond the end, or the start, of one.
    std::optional<std::size_t> next(std::size_t side, bool forward) const {
        if (!closed_ && side + (forward ? 1 : 0) == (forward ? sides_ : 0)) {
            return std::nullopt;
        }
        const std::size_t beyond = (side + (forward ? 1 : sides_ - 1)) % sides_;
        return isStraightSide(shape_, beyond) ? std::optional(beyond) : std::nullopt;
    }

    std::size_t sides() const { return sides_; }

  private:
    Vec2 endOf(std::size_t side) const { return handles_[(side + 1) % handles_.size()]; }

    const Shape &shape_;
    std::vector<Vec2> handles_;
    std::size_t sides_;
    bool closed_;
};

} // namespace

Vec2 slideAlongSides(const Shape &shape, std::size_t side, Vec2 to) {
    const SideWay way(shape);
    double t = way.along(side, to);
    const bool forward = t > 1.0;
    for (std::size_t k = 0; k < way.sides() && (forward ? t > 1.0 : t < 0.0); ++k) {
        const std::optional<std::size_t> next = way.next(side, forward);
        const double beyond = next ? way.along(*next, to) : 0.0;
        if (!next || (forward ? beyond <= 0.0 : beyond >= 1.0)) {
            break; // the corner is nearest
        }
        side = *next;
        t = beyond;
    }
    return way.at(side, t);
}

} // namespace forefront
