#include "core/edit/curve_crossings.hpp"

#include "core/geometry/curve_contacts.hpp"

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
            for (const double u : {b.t0, b.t1}) {
                const double t = first.nearest(second.point(u), a.t0, a.t1);
                if (distance(first.point(t), second.point(u)) <= tolerance) {
                    found.push_back({t, u, first.point(t)});
                }
            }
            for (const double t : {a.t0, a.t1}) {
                const double u = second.nearest(first.point(t), b.t0, b.t1);
                if (distance(first.point(t), second.point(u)) <= tolerance) {
                    found.push_back({t, u, first.point(t)});
                }
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
