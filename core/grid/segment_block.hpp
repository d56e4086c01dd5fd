#pragma once

#include "core/base/ids.hpp"
#include "core/geometry/vec2.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace forefront {

/// Boxes in floats: coordinates relative to a domain's box, in units of its greater side, cut off well outside it.
class BoxScale {
  public:
    explicit BoxScale(const Box2 &domain)
        : origin_(domain.min),
          perSide_(std::min(1.0 / std::max(domain.size().x, domain.size().y), std::numeric_limits<double>::max())) {}

    struct Box {
        float minX, maxX, minY, maxY;
    };
    Box operator()(const Box2 &box) const {
        return {scaled(box.min.x - origin_.x), scaled(box.max.x - origin_.x), scaled(box.min.y - origin_.y),
                scaled(box.max.y - origin_.y)};
    }

    /// More than what the rounding of two coordinates may amount to, eight times over.
    static constexpr float kMargin = 1e-6F;

  private:
    float scaled(double fromOrigin) const {
        return std::min(std::max(static_cast<float>(fromOrigin * perSide_), -1.0F), 2.0F);
    }

    Vec2 origin_;
    double perSide_;
};

/// Up to eight segments with their boxes side by side, so that a few vector instructions compare them all. The boxes
/// are grown by more than what conversion to floats may have moved them and a box they are compared with.
struct alignas(64) SegmentBlock {
    static constexpr unsigned kWidth = 8;

    std::array<float, kWidth> minX, maxX, minY, maxY;
    std::array<SlotId, kWidth> slots;
    std::uint32_t next;

    void set(unsigned lane, SlotId slot, const BoxScale::Box &box) {
        minX[lane] = box.minX - BoxScale::kMargin;
        maxX[lane] = box.maxX + BoxScale::kMargin;
        minY[lane] = box.minY - BoxScale::kMargin;
        maxY[lane] = box.maxY + BoxScale::kMargin;
        slots[lane] = slot;
    }
    void copy(unsigned lane, const SegmentBlock &from, unsigned fromLane) {
        minX[lane] = from.minX[fromLane];
        maxX[lane] = from.maxX[fromLane];
        minY[lane] = from.minY[fromLane];
        maxY[lane] = from.maxY[fromLane];
        slots[lane] = from.slots[fromLane];
    }

    /// A bit per lane whose box overlaps the given one or cannot be compared; lanes that were never set count, too.
    unsigned overlapping(const BoxScale::Box &box) const;
    /// A bit per lane that holds the slot; lanes that were never set count, too.
    unsigned holding(SlotId slot) const;
};

#ifdef __SSE2__

inline unsigned SegmentBlock::overlapping(const BoxScale::Box &box) const {
    const __m128 minOfBoxX = _mm_set1_ps(box.minX), maxOfBoxX = _mm_set1_ps(box.maxX);
    const __m128 minOfBoxY = _mm_set1_ps(box.minY), maxOfBoxY = _mm_set1_ps(box.maxY);
    const auto four = [&](unsigned lane) {
        const __m128 x = _mm_and_ps(_mm_cmpngt_ps(_mm_load_ps(&minX[lane]), maxOfBoxX),
                                    _mm_cmpnlt_ps(_mm_load_ps(&maxX[lane]), minOfBoxX));
        const __m128 y = _mm_and_ps(_mm_cmpngt_ps(_mm_load_ps(&minY[lane]), maxOfBoxY),
                                    _mm_cmpnlt_ps(_mm_load_ps(&maxY[lane]), minOfBoxY));
        return static_cast<unsigned>(_mm_movemask_ps(_mm_and_ps(x, y)));
    };
    return four(0) | four(4) << 4U;
}

inline unsigned SegmentBlock::holding(SlotId slot) const {
    const __m128i wanted = _mm_set1_epi32(static_cast<int>(index(slot)));
    const auto four = [&](unsigned lane) {
        const __m128i slot4 = _mm_load_si128(reinterpret_cast<const __m128i *>(&slots[lane]));
        return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(slot4, wanted))));
    };
    return four(0) | four(4) << 4U;
}

#else

inline unsigned SegmentBlock::overlapping(const BoxScale::Box &box) const {
    unsigned lanes = 0;
    for (unsigned k = 0; k < kWidth; ++k) {
        lanes |= static_cast<unsigned>(!(minX[k] > box.maxX) & !(maxX[k] < box.minX) & !(minY[k] > box.maxY) &
                                       !(maxY[k] < box.minY))
                 << k;
    }
    return lanes;
}

inline unsigned SegmentBlock::holding(SlotId slot) const {
    unsigned lanes = 0;
    for (unsigned k = 0; k < kWidth; ++k) {
        lanes |= static_cast<unsigned>(slots[k] == slot) << k;
    }
    return lanes;
}

#endif

} // namespace forefront
