#include "core/drawing/shapes/curve_crossings.hpp"

#include "core/engine/geometry/curve_contacts.hpp"

#include <algorithm>

namespace forefront {
namespace {

/// Adds the part of a curve between two parameters, in pieces that bend little.
void addFlatPieces(const Curve &curve, double t0, double t1, int depth, std::vector<CurvePart> &pieces) {
    constexpr int kMaxDepth = 12; // cusps bend however short the piece is
    const CurvePart part(curve, t0, t1);
    if (part.turn <= kMaxContactTurn || depth == kMaxDepth) {
        pieces.push_back(part);
        return;
    }
    const double middle = 0.5 * (t0 + t1);
    addFlatPieces(curve, t0, middle, depth + 1, pieces);
    addFlatPieces(curve, middle, t1, depth + 1, pieces);
}

std::vector<CurvePart> piecesOf(const Curve &curve) {
    std::vector<CurvePart> pieces;
    if (curve.finite()) {
        addFlatPieces(curve, 0.0, 1.0, 0, pieces);
    }
    return pieces;
}

/// Returns true if one curve runs along another on one side of a parameter at least. `step` is a small part of the
/// curve's parameter range.
bool runsAlong(const Curve &curve, double t, double step, const Curve &other, double tolerance) {
    const auto meets = [&](double at) {
        if (at < 0.0 || at > 1.0) {
            return false;
        }
        const Vec2 place = curve.point(at);
        return distance(other.point(other.nearest(place)), place) <= tolerance;
    };
    return (meets(t - step) && meets(t - 0.25 * step)) || (meets(t + step) && meets(t + 0.25 * step));
}

bool isCurveEnd(double t) {
    return t == 0.0 || t == 1.0;
}

/// Adds the ends of piece `b` of `second` that lie on piece `a` of `first`. Curves that cross where a piece ends have
/// no contact between its ends. If they run along each other there, the end of a piece is just a place between others.
void addEnds(const Curve &first, const CurvePart &a, const Curve &second, const CurvePart &b, double tolerance,
             std::vector<CurveCrossing> &found) {
    constexpr double kStep = 1.0 / 16.0;
    Box2 around;
    for (const Vec2 corner : a.hull()) {
        around.add(corner);
    }
    around = around.grown(tolerance + a.noise);
    for (const double u : {b.t0, b.t1}) {
        const Vec2 place = second.point(u);
        if (!around.contains(place)) {
            continue;
        }
        const double t = first.nearest(place, a.t0, a.t1);
        if (distance(first.point(t), place) <= tolerance &&
            (isCurveEnd(u) || isCurveEnd(t) || !runsAlong(second, u, kStep * (b.t1 - b.t0), first, tolerance))) {
            found.push_back({t, u, first.point(t)});
        }
    }
}

} // namespace

std::vector<CurveCrossing> crossingsOf(const Curve &first, const Curve &second, double tolerance) {
    const std::vector<CurvePart> mine = piecesOf(first), others = piecesOf(second);
    std::vector<CurveCrossing> found;
    for (const CurvePart &a : mine) {
        for (const CurvePart &b : others) {
            if (apart(a, b, tolerance)) {
                continue;
            }
            if (a.turn <= kMaxContactTurn && b.turn <= kMaxContactTurn) {
                for (const CurveContact &contact : curveContacts(a, b, tolerance)) {
                    found.push_back({contact.first, contact.second, contact.onFirst});
                }
            }
            addEnds(first, a, second, b, tolerance, found);
            std::vector<CurveCrossing> swapped;
            addEnds(second, b, first, a, tolerance, swapped);
            for (const CurveCrossing &end : swapped) {
                found.push_back({end.second, end.first, first.point(end.second)});
            }
        }
    }
    std::sort(found.begin(), found.end(),
              [](const CurveCrossing &a, const CurveCrossing &b) { return a.first < b.first; });
    const auto same = [&](const CurveCrossing &a, const CurveCrossing &b) {
        return distance(a.at, b.at) <= 4.0 * tolerance && b.first - a.first < 0.5; // a closed curve ends at its start
    };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    return found;
}

} // namespace forefront
