#include "core/engine/boundary/coverage_cell.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// The range of fractions at which a segment is inside a box; empty if first > last.
struct Clip {
    double first = 0.0;
    double last = 1.0;
};

void clipAxis(double from, double along, double low, double high, Clip &clip) {
    if (along == 0.0) {
        if (from < low || from > high) {
            clip = {1.0, 0.0};
        }
        return;
    }
    const double s = (low - from) / along, t = (high - from) / along;
    clip.first = std::max(clip.first, std::min(s, t));
    clip.last = std::min(clip.last, std::max(s, t));
}

/// Clips by the method of Y.-D. Liang and B. A. Barsky, A new concept and method for line clipping (1984).
Clip clipped(const BoundaryPiece &piece, const Box2 &box) {
    const Vec2 along = piece.b - piece.a;
    Clip clip;
    clipAxis(piece.a.x, along.x, box.min.x, box.max.x, clip);
    clipAxis(piece.a.y, along.y, box.min.y, box.max.y, clip);
    return clip;
}

double heightAt(const BoundaryPiece &piece, double x) {
    return piece.a.y + (piece.b.y - piece.a.y) * ((x - piece.a.x) / (piece.b.x - piece.a.x));
}

bool crossesVertical(const BoundaryPiece &piece, double x) {
    return (piece.a.x <= x) != (piece.b.x <= x);
}

/// Returns the signed area of the box beyond a part of a piece from p to q, as seen from the vertical line through the
/// middle of the box, which the part does not cross.
double areaBeyond(Vec2 p, Vec2 q, double middle, const Box2 &box) {
    const double x = 0.5 * (p.x + q.x);
    return (x > middle ? x - box.max.x : x - box.min.x) * (q.y - p.y);
}

} // namespace

// Most pieces are short compared with the boxes; these are decided without divisions.
bool meetsBox(const BoundaryPiece &piece, const Box2 &box) {
    if (box.contains(piece.a) || box.contains(piece.b)) {
        return true;
    }
    if (!box.overlaps(boxOf(piece.a, piece.b))) {
        return false;
    }
    const Clip clip = clipped(piece, box);
    return clip.first <= clip.last;
}

BoundaryPiece partWithin(const BoundaryPiece &piece, const Box2 &box) {
    if (box.contains(piece.a) && box.contains(piece.b)) {
        return piece;
    }
    const Clip clip = clipped(piece, box);
    return {lerp(piece.a, piece.b, clip.first), lerp(piece.a, piece.b, clip.last)};
}

// Reach each point of the box from the centre by going up or down, then sideways. Each piece crossed on the way
// switches between inside and outside, so in the integral over all points a piece counts with the area beyond it.
double CoverageCell::coveredArea(std::span<const BoundaryPiece> all) const {
    const Vec2 size = box.size(), centre = box.centre();
    double area = centreInside ? size.x * size.y : 0.0;
    for (const std::uint32_t i : pieces) {
        const BoundaryPiece &piece = all[i];
        if (!meetsBox(piece, box)) {
            continue;
        }
        const auto [p, q] = partWithin(piece, box);
        if (!crossesVertical(piece, centre.x)) {
            area += areaBeyond(p, q, centre.x, box);
            continue;
        }
        const double y = heightAt(piece, centre.x);
        if ((p.x <= centre.x) == (q.x <= centre.x) || y < box.min.y || y > box.max.y) {
            area += areaBeyond(p, q, centre.x, box); // crosses the line beyond the box
            continue;
        }
        area += areaBeyond(p, {centre.x, y}, centre.x, box) + areaBeyond({centre.x, y}, q, centre.x, box);
        const double beyond = size.x * (y > centre.y ? box.max.y - y : box.min.y - y);
        area += piece.b.x > piece.a.x ? beyond : -beyond;
    }
    return std::clamp(area, 0.0, size.x * size.y);
}

// Go from the centre of the cell to that of a quarter, first up or down, then level: each piece on the way switches
// between inside and outside. Most pieces lie on none of the four ways, and meet one quarter.
std::array<CoverageCell, 4> CoverageCell::quarters(std::span<const BoundaryPiece> all) const {
    const Vec2 centre = box.centre();
    std::array<CoverageCell, 4> result;
    for (unsigned k = 0; k < 4; ++k) {
        result[k].box.min = {k % 2 != 0 ? centre.x : box.min.x, k / 2 != 0 ? centre.y : box.min.y};
        result[k].box.max = {k % 2 != 0 ? box.max.x : centre.x, k / 2 != 0 ? box.max.y : centre.y};
        result[k].centreInside = centreInside;
    }
    const std::array<Vec2, 2> diagonal{result[0].box.centre(), result[3].box.centre()};
    const auto crossIf = [&result](unsigned k, bool crossed) { result[k].centreInside ^= crossed; };
    for (const std::uint32_t i : pieces) {
        const BoundaryPiece &piece = all[i];
        if (crossesVertical(piece, centre.x)) {
            const double y = heightAt(piece, centre.x);
            for (unsigned k = 0; k < 4; ++k) {
                crossIf(k, (y <= centre.y) != (y <= diagonal[k / 2].y));
            }
        }
        for (unsigned row = 0; row < 2; ++row) {
            const double y = diagonal[row].y;
            if ((piece.a.y <= y) != (piece.b.y <= y)) {
                const double x = piece.a.x + (piece.b.x - piece.a.x) * ((y - piece.a.y) / (piece.b.y - piece.a.y));
                crossIf(2 * row, (x <= centre.x) != (x <= diagonal[0].x));
                crossIf(2 * row + 1, (x <= centre.x) != (x <= diagonal[1].x));
            }
        }
        const Box2 around = boxOf(piece.a, piece.b);
        for (unsigned k = 0; k < 4; ++k) {
            const bool besideX = k % 2 != 0 ? around.max.x < centre.x : around.min.x > centre.x;
            const bool besideY = k / 2 != 0 ? around.max.y < centre.y : around.min.y > centre.y;
            if (!besideX && !besideY && meetsBox(piece, result[k].box)) {
                result[k].pieces.push_back(i);
            }
        }
    }
    return result;
}

} // namespace forefront
