#pragma once

#include "core/engine/mesh/log_product.hpp"
#include "core/engine/mesh/quality.hpp"

#include <limits>

namespace forefront {

/// Accumulates shape figures element by element: α, extreme angles, area.
class ShapeTally {
  public:
    /// Adds an element with these corners; its number is count().
    void add(Vec2 a, Vec2 b, Vec2 c);
    std::size_t count() const { return count_; }
    /// Sets the shape figures of `quality`; leaves them unchanged if no element was added.
    void into(MeshQuality &quality) const;

  private:
    /// The extreme angles, kept as cotangents, which fall as the angle grows.
    class AngleRange {
      public:
        void add(Vec2 a, Vec2 b, Vec2 c);
        double min() const; ///< degrees
        double max() const; ///< degrees

      private:
        double maxCot_ = -std::numeric_limits<double>::infinity();
        double minCot_ = std::numeric_limits<double>::infinity();
        bool flat_ = false;
    };

    std::size_t count_ = 0, flat_ = 0;
    LogProduct product_;
    AngleRange angles_;
    double sum_ = 0.0;
    double twiceArea_ = 0.0;
    double minAlpha_ = std::numeric_limits<double>::infinity();
    ElementId worst_ = kNoElement;
    bool allPositive_ = true;
    std::array<std::uint64_t, kHistogramBins> histogram_{};
};

} // namespace forefront
