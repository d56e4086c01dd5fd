#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/grid/cell_layout.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace forefront {

/// A box in 256ths of a cell, relative to its lower corner and clipped to the cell. All edges belong to the box.
struct CellBox {
    std::uint8_t minX, minY, maxX, maxY;
};

/// Converts boxes to the coordinates of a cell. Boxes that overlap still do so after conversion: every step is
/// monotone, so neither rounding nor clipping can separate them.
class CellScale {
  public:
    CellScale(const CellLayout &layout, int i, int j)
        : origin_(layout.cellBox(i, j).min), perX_(kSteps * layout.perWidth), perY_(kSteps * layout.perHeight) {}

    CellBox operator()(const Box2 &box) const {
        return {step((box.min.x - origin_.x) * perX_), step((box.min.y - origin_.y) * perY_),
                step((box.max.x - origin_.x) * perX_), step((box.max.y - origin_.y) * perY_)};
    }

    static constexpr double kSteps = 256.0;

  private:
    static std::uint8_t step(double t) {
        return static_cast<std::uint8_t>(static_cast<int>(std::min(std::max(t, 0.0), kSteps - 1.0)));
    }

    Vec2 origin_;
    double perX_, perY_;
};

/// Up to eight segments of a cell with their boxes side by side, so that a few vector instructions compare them all. A
/// block fills a cache line: a large front does not fit in the caches, so a search costs as much as the memory it
/// fetches.
struct alignas(64) SegmentBlock {
    static constexpr unsigned kWidth = 8;

    std::array<std::uint8_t, kWidth> minX, minY, maxX, maxY; // in this order: they are loaded in pairs
    std::array<SlotId, kWidth> slots;

    void set(unsigned lane, SlotId slot, const CellBox &box) {
        minX[lane] = box.minX;
        minY[lane] = box.minY;
        maxX[lane] = box.maxX;
        maxY[lane] = box.maxY;
        slots[lane] = slot;
    }
    void copy(unsigned lane, const SegmentBlock &from, unsigned fromLane) {
        set(lane, from.slots[fromLane],
            {from.minX[fromLane], from.minY[fromLane], from.maxX[fromLane], from.maxY[fromLane]});
    }

    /// Returns a bit per lane whose box overlaps the given one. Bits of lanes that were never set are undefined.
    unsigned overlapping(const CellBox &box) const;
    /// Returns a bit per lane that contains the slot. Bits of lanes that were never set are undefined.
    unsigned holding(SlotId slot) const;
};
static_assert(sizeof(SegmentBlock) == 64 && offsetof(SegmentBlock, minY) == 8 && offsetof(SegmentBlock, maxX) == 16 &&
              offsetof(SegmentBlock, maxY) == 24);

#ifdef __SSE2__

inline unsigned SegmentBlock::overlapping(const CellBox &box) const {
    const auto pair = [](std::uint8_t x, std::uint8_t y) {
        return _mm_unpacklo_epi64(_mm_set1_epi8(static_cast<char>(x)), _mm_set1_epi8(static_cast<char>(y)));
    };
    const __m128i low = _mm_load_si128(reinterpret_cast<const __m128i *>(minX.data()));
    const __m128i high = _mm_load_si128(reinterpret_cast<const __m128i *>(maxX.data()));
    const __m128i apart =
        _mm_or_si128(_mm_subs_epu8(low, pair(box.maxX, box.maxY)), _mm_subs_epu8(pair(box.minX, box.minY), high));
    const auto both = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(apart, _mm_setzero_si128())));
    return both & both >> kWidth;
}

inline unsigned SegmentBlock::holding(SlotId slot) const {
    const __m128i sought = _mm_set1_epi32(static_cast<int>(index(slot)));
    const auto four = [&](unsigned lane) {
        const __m128i slot4 = _mm_load_si128(reinterpret_cast<const __m128i *>(&slots[lane]));
        return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(slot4, sought))));
    };
    return four(0) | four(4) << 4U;
}

#else

inline unsigned SegmentBlock::overlapping(const CellBox &box) const {
    unsigned lanes = 0;
    for (unsigned k = 0; k < kWidth; ++k) {
        const bool overlaps = minX[k] <= box.maxX && maxX[k] >= box.minX && minY[k] <= box.maxY && maxY[k] >= box.minY;
        lanes |= static_cast<unsigned>(overlaps) << k;
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
