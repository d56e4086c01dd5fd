#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/spacing/sites/site_words.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace forefront {

/// Painted tiles prepared for fast evaluation.
class PaintedPart {
  public:
    static constexpr std::size_t kMaxTiles = 65536; ///< 64 MB of paint

    /// Prepares the tiles that overlap the box. Errors: bad-paint (invalid origin or pitch, too many tiles, or, with a
    /// place, values that are negative or not finite).
    static Result<PaintedPart> build(const PaintedSpacing &paint, const Box2 &box, double minimum);

    /// Returns the painted spacing at p; infinity if nothing is painted there.
    double at(Vec2 p) const {
        const double u = (p.x - origin_.x) * perPitch_;
        const double v = (p.y - origin_.y) * perPitch_;
        if (!(u >= 0.0 && v >= 0.0 && u < spanX_ && v < spanY_)) {
            return std::numeric_limits<double>::infinity();
        }
        const auto i = static_cast<std::uint32_t>(u);
        const auto j = static_cast<std::uint32_t>(v);
        const std::uint32_t block = directory_[(j / kSpan) * columns_ + i / kSpan];
        if (block == kNoBlock) {
            return std::numeric_limits<double>::infinity();
        }
        const float *const node = blocks_[block].data() + (i % kSpan) + (j % kSpan) * kWidth;
        return valueIn(node[0], node[1], node[kWidth], node[kWidth + 1], u - i, v - j);
    }
    /// Returns the minimum painted value; infinity if the box has no paint.
    double minimum() const { return minimum_; }
    double maximum() const { return std::numeric_limits<double>::infinity(); }
    SpacingSample sample(Vec2 p, const SiteWords &) const { return {at(p), SpacingOrigin::Paint, 0, "painted"}; }

    /// Adds the places from which the paint's spacing grows by `gradation`: edges of the paint, and nodes where the
    /// paint is steeper.
    static void addSites(const PaintedSpacing &paint, double minimum, double gradation, SiteSet &sites);

    /// A place just beyond the paint, and the largest painted value next to it.
    struct Border {
        Vec2 at;
        double beside = 0.0;
    };
    /// Returns the unpainted nodes next to painted ones.
    static std::vector<Border> borderOf(const PaintedSpacing &paint);

  private:
    static constexpr std::uint32_t kSpan = PaintedSpacing::kTileSpan;
    static constexpr std::uint32_t kWidth = kSpan + 1;
    static constexpr std::uint32_t kNoBlock = 0xffffffffU;
    /// The nodes of a tile, including the nodes on its upper edges, which belong to the next tiles.
    using Block = std::array<float, kWidth * kWidth>;

    static double valueIn(float a, float b, float c, float d, double s, double t) {
        if (a > 0.0F && b > 0.0F && c > 0.0F && d > 0.0F) {
            const double low = a + s * (static_cast<double>(b) - a);
            const double high = c + s * (static_cast<double>(d) - c);
            return low + t * (high - low);
        }
        double minimum = std::numeric_limits<double>::infinity();
        for (const float value : {a, b, c, d}) {
            minimum = value > 0.0F ? std::min(minimum, static_cast<double>(value)) : minimum;
        }
        return minimum;
    }

    Vec2 origin_; ///< lower left node of the first tile of the directory
    double perPitch_ = 1.0;
    double spanX_ = 0.0; ///< of the directory, in pitches
    double spanY_ = 0.0;
    double minimum_ = std::numeric_limits<double>::infinity();
    std::uint32_t columns_ = 0;
    std::vector<std::uint32_t> directory_; ///< of tiles that overlap the box: index of the block
    std::vector<Block> blocks_;
};

} // namespace forefront
