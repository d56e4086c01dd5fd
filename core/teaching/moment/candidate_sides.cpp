#include "core/teaching/moment/candidate_sides.hpp"

#include <algorithm>

namespace forefront {

std::vector<PlacedSide> sidesOf(const AdvanceExplanation &advance, const CandidateTrace &candidate) {
    const CandidateTrace &c = candidate;
    switch (c.square) {
    case SquareKind::Row:
        return {{c.over.front(), c.position}, {c.position, c.over.back()}};
    case SquareKind::Opening:
        return {{c.over.front(), c.second}, {c.second, c.position}, {c.position, c.over.back()}};
    case SquareKind::Closing:
        return {{c.second, c.position}};
    case SquareKind::None:
        break;
    }
    std::vector<PlacedSide> sides;
    for (const Vec2 from : c.over.empty() ? std::vector<Vec2>{advance.a, advance.b} : c.over) {
        sides.push_back({from, c.position});
    }
    return sides;
}

std::vector<PlacedSide> newSidesOf(const AdvanceExplanation &advance) {
    std::vector<PlacedSide> sides;
    for (const auto &[p, q, r] : advance.made) {
        sides.push_back({q, r});
        sides.push_back({r, p});
    }
    if (advance.square == SquareKind::None || advance.made.size() != 2) {
        return sides;
    }
    std::erase_if(sides, [&](const PlacedSide &side) {
        const auto has = [&](std::size_t half, Vec2 node) {
            return std::ranges::find(advance.made[half], node) != advance.made[half].end();
        };
        return has(0, side[0]) && has(0, side[1]) && has(1, side[0]) && has(1, side[1]);
    });
    return sides;
}

} // namespace forefront
