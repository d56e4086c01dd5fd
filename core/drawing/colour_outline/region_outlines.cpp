#include "core/drawing/colour_outline/region_outlines.hpp"

#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace forefront {
namespace {

/// A side of a pixel of the region with the outside beyond it, passed with the pixel on the left: upwards on its right
/// side, to the left on its upper side, downwards on its left side, to the right on its lower one.
struct PixelSide {
    int column = 0, row = 0;
    int heading = 0; ///< quarter turns from upwards, counter-clockwise

    friend bool operator==(const PixelSide &, const PixelSide &) = default;
};

// Steps for a heading, in columns and rows, which count downwards: ahead, and to the outside on the right.
constexpr std::array<std::pair<int, int>, 4> kAhead{{{0, -1}, {-1, 0}, {0, 1}, {1, 0}}};
constexpr std::array<std::pair<int, int>, 4> kRight{{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};

class OutlineWalk {
  public:
    explicit OutlineWalk(const ColourRegion &region) : region_(region), walked_(region.inside.size(), 0) {}

    bool isSide(const PixelSide &side) const {
        const auto [right, down] = kRight[static_cast<std::size_t>(side.heading)];
        return region_.has(side.column, side.row) && !region_.has(side.column + right, side.row + down);
    }
    bool walked(const PixelSide &side) const { return (walked_[indexOf(side)] & bitOf(side)) != 0; }

    PixelLoop from(const PixelSide &start) {
        PixelLoop loop;
        PixelSide side = start;
        do {
            walked_[indexOf(side)] = static_cast<std::uint8_t>(walked_[indexOf(side)] | bitOf(side));
            loop.push_back(middleOf(side));
            side = after(side);
        } while (side != start);
        return loop;
    }

  private:
    std::size_t indexOf(const PixelSide &side) const {
        return static_cast<std::size_t>(side.row) * static_cast<std::size_t>(region_.columns) +
               static_cast<std::size_t>(side.column);
    }
    static unsigned bitOf(const PixelSide &side) { return 1U << static_cast<unsigned>(side.heading); }
    Vec2 middleOf(const PixelSide &side) const {
        const auto [right, down] = kRight[static_cast<std::size_t>(side.heading)];
        return {side.column + 0.5 + 0.5 * right, region_.rows - (side.row + 0.5 + 0.5 * down)};
    }
    /// Returns the next side of the loop: it stays with pixels that are connected by their sides.
    PixelSide after(const PixelSide &side) const {
        const auto [ahead, aheadRow] = kAhead[static_cast<std::size_t>(side.heading)];
        const auto [right, rightRow] = kRight[static_cast<std::size_t>(side.heading)];
        const PixelSide next{side.column + ahead, side.row + aheadRow, side.heading};
        if (!region_.has(next.column, next.row)) {
            return {side.column, side.row, (side.heading + 1) % 4};
        }
        const PixelSide turned{next.column + right, next.row + rightRow, (side.heading + 3) % 4};
        return region_.has(turned.column, turned.row) ? turned : next;
    }

    const ColourRegion &region_;
    std::vector<std::uint8_t> walked_; ///< per pixel: a bit for each heading
};

} // namespace

std::vector<PixelLoop> outlinesOf(const ColourRegion &region, const Progress &progress) {
    constexpr int kUp = 0, kDown = 2;
    OutlineWalk walk(region);
    std::vector<PixelLoop> loops;
    for (int row = 0; row < region.rows; ++row) {
        if (row % 64 == 0) {
            if (progress.cancelled()) {
                return {};
            }
            progress("following the outline", static_cast<double>(row) / region.rows);
        }
        // Every loop has sides to the left or right of a pixel.
        for (int column = 0; column < region.columns; ++column) {
            for (const int heading : {kDown, kUp}) {
                const PixelSide side{column, row, heading};
                if (walk.isSide(side) && !walk.walked(side)) {
                    loops.push_back(walk.from(side));
                }
            }
        }
    }
    const auto outer =
        std::find_if(loops.begin(), loops.end(), [](const PixelLoop &loop) { return signedArea(loop) > 0.0; });
    if (outer != loops.end()) {
        std::rotate(loops.begin(), outer, outer + 1);
    }
    return loops;
}

} // namespace forefront
