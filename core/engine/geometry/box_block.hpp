#pragma once

#include "core/engine/base/vec2.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace forefront {

/// A box in 65,534ths of a whole. The smallest and the largest number are left for lanes without a box.
struct StepBox {
    std::int16_t minX = 0, minY = 0, maxX = 0, maxY = 0;
};

/// Converts boxes to steps of a whole. Boxes that overlap still do so after conversion: every operation is monotone, so
/// neither rounding nor clipping can separate them.
class StepScale {
  public:
    StepScale() = default;
    explicit StepScale(const Box2 &whole)
        : origin_(whole.min), perX_(perUnit(whole.max.x - whole.min.x)), perY_(perUnit(whole.max.y - whole.min.y)) {}

    StepBox operator()(const Box2 &box) const {
        return {step((box.min.x - origin_.x) * perX_), step((box.min.y - origin_.y) * perY_),
                step((box.max.x - origin_.x) * perX_), step((box.max.y - origin_.y) * perY_)};
    }

  private:
    static constexpr double kSteps = 65534.0;

    /// 0, with all boxes alike, if the extent is 0, too small, infinite or not a number.
    static double perUnit(double extent) {
        return extent > 0.0 && kSteps / extent < std::numeric_limits<double>::infinity() ? kSteps / extent : 0.0;
    }
    /// A NaN goes to the first step, as all numbers do where the scale is 0.
    static std::int16_t step(double t) {
        constexpr int kMiddle = 32767;
        return static_cast<std::int16_t>(static_cast<int>(std::min(t > 0.0 ? t : 0.0, kSteps - 1.0)) - kMiddle);
    }

    Vec2 origin_;
    double perX_ = 0.0, perY_ = 0.0;
};

/// Up to eight boxes side by side, so that a few vector instructions compare them all. A block fills a cache line.
struct alignas(64) BoxBlock {
    static constexpr std::size_t kWidth = 8;

    std::array<std::int16_t, kWidth> minX, minY, maxX, maxY;

    /// Holds no box: no lane overlaps anything.
    BoxBlock() {
        for (auto *const low : {&minX, &minY}) {
            low->fill(std::numeric_limits<std::int16_t>::max());
        }
        for (auto *const high : {&maxX, &maxY}) {
            high->fill(std::numeric_limits<std::int16_t>::min());
        }
    }

    void set(std::size_t lane, const StepBox &box) {
        minX[lane] = box.minX;
        minY[lane] = box.minY;
        maxX[lane] = box.maxX;
        maxY[lane] = box.maxY;
    }

    /// Returns a bit per lane whose box overlaps the given one.
    unsigned overlapping(const StepBox &box) const;
    /// The same for any processor.
    unsigned overlappingOneByOne(const StepBox &box) const {
        unsigned lanes = 0;
        for (unsigned k = 0; k < kWidth; ++k) {
            const bool overlaps =
                minX[k] <= box.maxX && maxX[k] >= box.minX && minY[k] <= box.maxY && maxY[k] >= box.minY;
            lanes |= static_cast<unsigned>(overlaps) << k;
        }
        return lanes;
    }
};

inline unsigned BoxBlock::overlapping(const StepBox &box) const {
#ifdef __SSE2__
    const auto lanes = [](const std::array<std::int16_t, kWidth> &values) {
        return _mm_load_si128(reinterpret_cast<const __m128i *>(values.data()));
    };
    const __m128i apart = _mm_or_si128(_mm_or_si128(_mm_cmpgt_epi16(lanes(minX), _mm_set1_epi16(box.maxX)),
                                                    _mm_cmpgt_epi16(_mm_set1_epi16(box.minX), lanes(maxX))),
                                       _mm_or_si128(_mm_cmpgt_epi16(lanes(minY), _mm_set1_epi16(box.maxY)),
                                                    _mm_cmpgt_epi16(_mm_set1_epi16(box.minY), lanes(maxY))));
    return ~static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(apart, _mm_setzero_si128()))) & 0xffU;
#else
    return overlappingOneByOne(box);
#endif
}

} // namespace forefront
