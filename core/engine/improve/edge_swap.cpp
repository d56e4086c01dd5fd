#include "core/engine/improve/edge_swap.hpp"

#include "core/engine/mesh/quality.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// The two elements at an edge ab: abc on the left and bad on the right.
struct Diamond {
    Diamond(const ImproveWorkspace &work, HalfEdge side)
        : h(side), g(work.twin[side]), a(work.from(h)), b(work.to(h)), c(work.apex(h)), d(work.apex(g)) {}
    HalfEdge h, g;
    NodeId a, b, c, d;
};

struct Shapes {
    double before, after; ///< lower α of the two elements; `after` is negative if a new element is not positive
};

Shapes shapes(const ImproveWorkspace &work, const Diamond &q) {
    const Vec2 a = work.at(q.a), b = work.at(q.b), c = work.at(q.c), d = work.at(q.d);
    const double before = std::min(shapeFactor(a, b, c), shapeFactor(b, a, d));
    const double left = shapeFactor(a, d, c), right = shapeFactor(d, b, c);
    const bool positive = surelyPositive(left, a, d, c) && surelyPositive(right, d, b, c);
    return {before, positive ? std::min(left, right) : -1.0};
}

/// Returns the decrease of Σ(valence − 6)² over the free nodes by a swap.
int valenceGain(const ImproveWorkspace &work, const Diamond &q) {
    const auto change = [&work](NodeId n, int step) {
        if (!work.isFree(n)) {
            return 0;
        }
        const int off = static_cast<int>(work.valence[index(n)]) - 6;
        return off * off - (off + step) * (off + step);
    };
    return change(q.a, -1) + change(q.b, -1) + change(q.c, +1) + change(q.d, +1);
}

/// Minimum gain of a swap, so that rounding does not swap an edge back and forth.
constexpr double kGain = 1e-9;
/// A swap for the sake of valences may lower the lower α to this part of it.
constexpr double kNearlyAsGood = 0.6;
/// α of half a square. Where both elements are better, the other diagonal is worse.
constexpr float kHalfSquare = 0.8661F;

bool hasRoom(const ImproveWorkspace &work, const Diamond &q) {
    const auto full = [&work](NodeId n) {
        return work.isFree(n) && work.valence[index(n)] + 1U >= ImproveWorkspace::kMaxValence;
    };
    const auto poor = [&work](NodeId n) { return work.isFree(n) && work.valence[index(n)] <= 3; };
    return !full(q.c) && !full(q.d) && !poor(q.a) && !poor(q.b);
}

bool worthwhile(const ImproveWorkspace &work, HalfEdge h, const SwapRule &rule) {
    const bool good = std::min(work.alpha[elementOf(h)], work.alpha[elementOf(work.twin[h])]) > kHalfSquare;
    if (good && !rule.improveValence) {
        return false;
    }
    const Diamond q(work, h);
    const int gain = rule.improveValence ? valenceGain(work, q) : 0;
    if ((good && gain <= 0) || !hasRoom(work, q)) {
        return false;
    }
    const Shapes s = shapes(work, q);
    if (s.after <= 0.0) {
        return false;
    }
    return (s.after > s.before + kGain && (gain >= 0 || s.before < rule.floor)) ||
           (gain > 0 && s.after >= rule.floor && s.after > kNearlyAsGood * s.before);
}

/// Finds the sides of an element that are worth swapping. Most are ruled out by the element alone: where its α is good,
/// a swap must gain in valence (or be found from the other side). The gain is 2(a + b − c − d) − 4 in the excesses over
/// 6 of free nodes, and d is seldom below −2 unless α is poor. Fixed nodes have valence 0.
void inspect(const ImproveWorkspace &work, std::size_t e, const SwapRule &rule, std::vector<HalfEdge> &found) {
    const bool poor = work.alpha[e] <= kHalfSquare;
    if (!poor && !rule.improveValence) {
        return;
    }
    const Element &n = work.mesh.elements[e];
    const int valence[3] = {work.valence[index(n[0])], work.valence[index(n[1])], work.valence[index(n[2])]};
    const int sum = valence[0] + valence[1] + valence[2];
    const bool anyFixed = valence[0] == 0 || valence[1] == 0 || valence[2] == 0;
    for (unsigned k = 0; k < 3; ++k) {
        const auto h = static_cast<HalfEdge>(3 * e + k);
        const HalfEdge g = work.twin[h];
        const bool mayGain = anyFixed || sum - 2 * valence[(k + 2) % 3] > 6;
        if ((poor || (mayGain && h < g)) && g != kNoHalfEdge && worthwhile(work, h, rule)) {
            found.push_back(h);
        }
    }
}

void join(ImproveWorkspace &work, HalfEdge h, HalfEdge g) {
    work.twin[h] = g;
    if (g != kNoHalfEdge) {
        work.twin[g] = h;
    }
}

} // namespace

void swapEdge(ImproveWorkspace &work, HalfEdge h) {
    const Diamond q(work, h);
    const HalfEdge bc = work.twin[nextSide(q.h)], ca = work.twin[previousSide(q.h)];
    const HalfEdge ad = work.twin[nextSide(q.g)], db = work.twin[previousSide(q.g)];
    const std::size_t e = elementOf(q.h), f = elementOf(q.g);
    const auto e0 = static_cast<HalfEdge>(3 * e), f0 = static_cast<HalfEdge>(3 * f);
    work.mesh.elements[e] = {q.a, q.d, q.c};
    work.mesh.elements[f] = {q.d, q.b, q.c};
    join(work, e0, ad);
    join(work, e0 + 1, f0 + 2);
    join(work, e0 + 2, ca);
    join(work, f0, db);
    join(work, f0 + 1, bc);
    work.start[index(q.a)] = e0;
    work.start[index(q.d)] = e0 + 1;
    work.start[index(q.c)] = e0 + 2;
    work.start[index(q.b)] = f0 + 1;
    work.addValence(q.a, -1);
    work.addValence(q.b, -1);
    work.addValence(q.c, +1);
    work.addValence(q.d, +1);
    work.alpha[e] = static_cast<float>(work.alphaOf(e));
    work.alpha[f] = static_cast<float>(work.alphaOf(f));
}

bool canSwap(const ImproveWorkspace &work, HalfEdge h) {
    return work.twin[h] != kNoHalfEdge && hasRoom(work, Diamond(work, h));
}

void swapEdgeAndRings(ImproveWorkspace &work, HalfEdge h) {
    const Diamond q(work, h);
    swapEdge(work, h);
    for (const NodeId n : {q.a, q.b, q.c, q.d}) {
        if (work.isFree(n)) {
            work.renewRing(n);
        }
    }
}

void undoSwap(ImproveWorkspace &work, std::size_t e, std::size_t f, const std::array<Element, 2> &before) {
    const auto rotateTo = [&work](std::size_t element, const Element &nodes) {
        const auto h = static_cast<HalfEdge>(3 * element);
        while (work.mesh.elements[element] != nodes) {
            const Element &n = work.mesh.elements[element];
            work.mesh.elements[element] = {n[1], n[2], n[0]};
            const std::array<HalfEdge, 3> across = {work.twin[h + 1], work.twin[h + 2], work.twin[h]};
            for (unsigned k = 0; k < 3; ++k) {
                join(work, h + k, across[k]);
            }
        }
        for (unsigned k = 0; k < 3; ++k) {
            work.start[index(nodes[k])] = h + k;
        }
    };
    // A swap puts the new diagonal at side 1 of the first element; four swaps restore each element.
    for (int swap = 0; swap < 3; ++swap) {
        swapEdge(work, static_cast<HalfEdge>(3 * e + 1));
    }
    rotateTo(e, before[0]);
    rotateTo(f, before[1]);
    work.alpha[e] = static_cast<float>(work.alphaOf(e));
    work.alpha[f] = static_cast<float>(work.alphaOf(f));
    for (const Element &element : before) {
        for (const NodeId n : element) {
            if (work.isFree(n)) {
                work.renewRing(n);
            }
        }
    }
}

bool worthSwapping(const ImproveWorkspace &work, HalfEdge h, const SwapRule &rule) {
    return work.twin[h] != kNoHalfEdge && worthwhile(work, h, rule);
}

void findWorthSwapping(const ImproveWorkspace &work, std::size_t begin, std::size_t end, const SwapRule &rule,
                       std::vector<HalfEdge> &found) {
    for (std::size_t e = begin; e < end; ++e) {
        inspect(work, e, rule, found);
    }
}

} // namespace forefront
