#include "core/engine/quads/square_places.hpp"

#include "core/engine/quads/coloured_search.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Minimum free angle at the ends of a corner that continues a row.
constexpr double kMinBeside = 69.0 * std::numbers::pi / 180.0;
// Minimum and maximum ratio of a side of a new square to the opposite side; more where a row opens.
constexpr double kMinToOpposite = 0.6, kMaxToOpposite = 1.6, kMaxOpening = 1.7;
// Minimum and maximum ratio of a side to what it was to be.
constexpr double kShortestSide = 0.55, kLongestSide = 1.5;

} // namespace

bool placeInRow(const GenerationFront &front, const SpacingField &spacing, Fan &fan, double &size) {
    const SlotId p = fan.slots[0], n = fan.slots[2];
    const double atP = freeAngle(front, p), atN = freeAngle(front, n);
    if (atP < kMinBeside || atN < kMinBeside) {
        return false;
    }
    const Vec2 placeP = fan.at[0], x = fan.at[1], placeN = fan.at[2];
    const double rhoP = front[p].rho, rhoN = front[n].rho;
    const Vec2 parallelogram = placeP + (placeN - x); // beside another corner, which is a row's end
    const auto seen = [&](double sideP, double sideN) {
        const Vec2 fromP = atP < kRowCorner ? parallelogram : placeP + sideP * sideDirection(front, p, true);
        const Vec2 fromN = atN < kRowCorner ? parallelogram : placeN + sideN * sideDirection(front, n, false);
        return midpoint(fromP, fromN);
    };
    const double mean = (rhoP + rhoN + front[fan.slots[1]].rho) / 3.0;
    const double rho = spacing.at(seen(mean, mean));
    const double oppositeP = distance(x, placeN), oppositeN = distance(x, placeP);
    const double sideP = std::clamp(0.5 * (rhoP + rho), kMinToOpposite * oppositeP, kMaxToOpposite * oppositeP);
    const double sideN = std::clamp(0.5 * (rhoN + rho), kMinToOpposite * oppositeN, kMaxToOpposite * oppositeN);
    const Vec2 c = seen(sideP, sideN);
    fan.apex = c;
    size = 0.5 * (sideP + sideN);
    const double gotP = distance(c, placeP), gotN = distance(c, placeN);
    return gotP >= kShortestSide * sideP && gotP <= kLongestSide * sideP && gotN >= kShortestSide * sideN &&
           gotN <= kLongestSide * sideN && turnsLeft(placeP, x, placeN) && turnsLeft(placeN, c, placeP);
}

bool placeOpening(const GenerationFront &front, const SpacingField &spacing, SlotId id, Fan &overB, Fan &overA,
                  double &size) {
    const SlotId end = front.next(id);
    const Vec2 a = front.start(id), b = front.start(end);
    const double l = front[id].length, rhoA = front[id].rho, rhoB = front[end].rho;
    const Vec2 alongA = sideDirection(front, id, true), alongB = sideDirection(front, end, false);
    const auto clamped = [l](double rho) { return std::clamp(rho, kMinToOpposite * l, kMaxOpening * l); };
    const double rhoD = spacing.at(a + clamped(rhoA) * alongA), rhoC = spacing.at(b + clamped(rhoB) * alongB);
    const double sideA = clamped(0.5 * (rhoA + rhoD)), sideB = clamped(0.5 * (rhoB + rhoC));
    Vec2 d = a + sideA * alongA, c = b + sideB * alongB;
    // The far side goes half-way to the spacing there.
    const double far = distance(d, c);
    const double wanted = std::clamp(0.5 * (rhoC + rhoD), kMinToOpposite * l, kMaxToOpposite * l);
    if (far > 0.0) {
        const Vec2 pull = 0.25 * (wanted / far - 1.0) * (c - d);
        d = d - pull;
        c = c + pull;
    }
    size = 0.5 * (sideA + sideB);
    overB.apex = c;
    overA.apex = d;
    const auto tooSmall = [&](Vec2 at) { return size < kSmallNode * spacing.at(at); };
    return turnsLeft(a, c, d) && !tooSmall(c) && !tooSmall(d);
}

} // namespace forefront
