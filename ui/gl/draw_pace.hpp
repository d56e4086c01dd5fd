#pragma once

#include <algorithm>
#include <cstddef>

namespace forefront {

/// Divides the drawing of a layer with many elements into pieces of about equal time, by the speed of its last piece.
/// Times are in seconds.
class DrawPace {
  public:
    /// Call when a new picture begins: the view may be another, so its first piece is small again.
    void restart() { limit_ = kFirst; }
    /// Returns the number of elements of the next piece, which should fit into `left`.
    std::size_t next(double left) const {
        const double fitting = rate_ * std::clamp(left, 0.0, kPiece);
        return std::max(kFirst, std::min(limit_, static_cast<std::size_t>(std::min(fitting, 1e9))));
    }
    /// Records that a piece of `elements` took `seconds`.
    void record(std::size_t elements, double seconds) {
        if (elements >= kFirst / 2) { // others say nothing about the speed
            rate_ = static_cast<double>(elements) / std::max(seconds, 1e-6);
            limit_ = 4 * elements;
        }
    }

  private:
    static constexpr double kPiece = 0.01;
    static constexpr std::size_t kFirst = 8192;

    double rate_ = 1e6;          ///< elements per second
    std::size_t limit_ = kFirst; ///< of the next piece
};

} // namespace forefront
