#pragma once

#include "core/mesh/quality.hpp"

#include <limits>

namespace forefront {

/// The shape figures of elements, counted one by one: α, extreme angles, area. A copy is the tally of a moment.
class ShapeTally {
  public:
    /// Counts an element with these corners as number count().
    void add(Vec2 a, Vec2 b, Vec2 c);
    std::size_t count() const { return count_; }
    /// Writes what has been counted into `quality`, which keeps its other figures. Nothing counted: nothing written.
    void into(MeshQuality &quality) const;

  private:
    /// Product of many factors in (0, 1] by its logarithm, with few calls of log.
    class LogProduct {
      public:
        void multiply(double factor);
        double logarithm() const;

      private:
        double product_ = 1.0;
        double sum_ = 0.0;
    };

    /// Extreme angles by their cotangents, which fall as the angle grows.
    class AngleRange {
      public:
        void add(Vec2 a, Vec2 b, Vec2 c);
        double least() const;    ///< degrees
        double greatest() const; ///< degrees

      private:
        double greatestCot_ = -std::numeric_limits<double>::infinity();
        double leastCot_ = std::numeric_limits<double>::infinity();
        bool flat_ = false;
    };

    std::size_t count_ = 0;
    LogProduct product_;
    AngleRange angles_;
    double sum_ = 0.0;
    double twiceArea_ = 0.0;
    double least_ = std::numeric_limits<double>::infinity();
    ElementId worst_ = kNoElement;
    bool allPositive_ = true;
    std::array<std::uint64_t, kHistogramBins> histogram_{};
};

} // namespace forefront
