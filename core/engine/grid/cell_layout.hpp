#pragma once

#include "core/engine/base/vec2.hpp"

#include <cmath>
#include <cstdint>

namespace forefront {

/// A box divided into columns x rows of equal cells. Points outside belong to the nearest cell, so nothing is lost at
/// the edges.
struct CellLayout {
    Vec2 origin;
    double cellWidth = 1.0;
    double cellHeight = 1.0;
    int columns = 1;
    int rows = 1;

    double perWidth = 1.0; ///< 1 / cellWidth
    double perHeight = 1.0;

    CellLayout() = default;
    /// `size`: width and height of a cell, in domain units.
    CellLayout(Vec2 low, Vec2 size, int columnCount, int rowCount)
        : origin(low), cellWidth(size.x), cellHeight(size.y), columns(columnCount), rows(rowCount),
          perWidth(1.0 / size.x), perHeight(1.0 / size.y) {}

    int column(double x) const { return clampIndex((x - origin.x) * perWidth, columns); }
    int row(double y) const { return clampIndex((y - origin.y) * perHeight, rows); }
    Box2 cellBox(int i, int j) const {
        return {{origin.x + i * cellWidth, origin.y + j * cellHeight},
                {origin.x + (i + 1) * cellWidth, origin.y + (j + 1) * cellHeight}};
    }

  private:
    static int clampIndex(double t, int count) {
        return t <= 0.0 ? 0 : t >= count ? count - 1 : std::min(static_cast<int>(t), count - 1);
    }
};

/// Returns the rounding slack of grid decisions about points in a box, in domain units: far above any rounding error of
/// coordinates of this size and far below any cell. It never falls as the box grows. Each part has a slack of its own:
/// where one node is 1e20 away, the slack of the whole domain would exceed all that is near the origin.
inline double gridSlack(const Box2 &box) {
    const double magnitude = std::max(std::max(std::abs(box.min.x), std::abs(box.max.x)),
                                      std::max(std::abs(box.min.y), std::abs(box.max.y)));
    return 64.0 * std::numeric_limits<double>::epsilon() * (magnitude + box.size().x + box.size().y);
}

/// Calls visit(i, j), in a fixed order, for every cell of the segment ab: those that its box, grown by `margin`, meets
/// and that are within `slack` of the segment, and possibly others of the grown box. `slack`: at least `margin`, and
/// above the rounding errors of the layout and the segment.
template <class Visit>
void forEachCrossedCell(const CellLayout &layout, Vec2 a, Vec2 b, double margin, double slack, Visit &&visit) {
    const int i0 = layout.column(std::min(a.x, b.x) - margin);
    const int i1 = layout.column(std::max(a.x, b.x) + margin);
    const int j0 = layout.row(std::min(a.y, b.y) - margin);
    const int j1 = layout.row(std::max(a.y, b.y) + margin);
    if (i0 == i1 || j0 == j1) {
        for (int j = j0; j <= j1; ++j) {
            for (int i = i0; i <= i1; ++i) {
                visit(i, j);
            }
        }
        return;
    }
    // The part of the segment in the band of each row; the bands of the first and last row are open to the outside.
    const double dy = b.y - a.y;
    for (int j = j0; j <= j1; ++j) {
        double from = std::min(a.x, b.x);
        double to = std::max(a.x, b.x);
        if (std::abs(dy) > 4.0 * slack) {
            const double low = j == j0 ? std::min(a.y, b.y) : layout.origin.y + j * layout.cellHeight - slack;
            const double high = j == j1 ? std::max(a.y, b.y) : layout.origin.y + (j + 1) * layout.cellHeight + slack;
            const double xLow = a.x + (b.x - a.x) * ((low - a.y) / dy);
            const double xHigh = a.x + (b.x - a.x) * ((high - a.y) / dy);
            from = std::max(from, std::min(xLow, xHigh));
            to = std::min(to, std::max(xLow, xHigh));
        }
        const int last = std::min(i1, layout.column(to + slack));
        for (int i = std::max(i0, layout.column(from - slack)); i <= last; ++i) {
            visit(i, j);
        }
    }
}

/// Returns true if the segment ab comes within a slack of the box: half of theirs, so that a grid which keeps all of
/// either misses none. This filter precedes every exact test and is the same for all grids.
inline bool segmentNearBox(Vec2 a, Vec2 b, const Box2 &box) {
    const Box2 ends = boxOf(a, b);
    const double slack = 0.5 * std::max(gridSlack(box), gridSlack(ends));
    if (!box.grown(slack).overlaps(ends)) {
        return false;
    }
    const Vec2 d = b - a;
    const Vec2 half = 0.5 * box.size();
    const double side = cross(d, box.centre() - a);
    return std::abs(side) <= (half.x + slack) * std::abs(d.y) + (half.y + slack) * std::abs(d.x);
}

} // namespace forefront
