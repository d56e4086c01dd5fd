#include "core/improve/swap.hpp"

#include "core/mesh/quality.hpp"

#include <algorithm>
#include <cstdlib>

namespace forefront {

namespace {

/// The two elements at an edge ab: abc on its left and bad on its right.
struct Diamond {
    Diamond(const ImproveWorkspace &work, std::size_t element, unsigned side) : e(element), k(side) {
        const Mesh &mesh = work.mesh;
        f = index(work.neighbours[e][k]);
        a = mesh.elements[e][k];
        b = mesh.elements[e][(k + 1) % 3];
        c = mesh.elements[e][(k + 2) % 3];
        const Element &other = mesh.elements[f];
        j = other[0] == b ? 0U : other[1] == b ? 1U : 2U; // side b -> a of f
        d = other[(j + 2) % 3];
    }
    std::size_t e, f;
    unsigned k, j;
    NodeId a, b, c, d;
};

struct Shapes {
    double before, after; ///< lesser α of the two elements; after: negative where a new element is not positive
};

Shapes shapes(const ImproveWorkspace &work, const Diamond &q) {
    const Vec2 a = work.at(q.a), b = work.at(q.b), c = work.at(q.c), d = work.at(q.d);
    const double before = std::min(shapeFactor(a, b, c), shapeFactor(b, a, d));
    const double left = shapeFactor(a, d, c), right = shapeFactor(d, b, c);
    const bool positive = surelyPositive(left, a, d, c) && surelyPositive(right, d, b, c);
    return {before, positive ? std::min(left, right) : -1.0};
}

/// What the swap gains in Σ(valence − wanted)², wanted being 6 inside; nodes that are held count nothing.
int valenceGain(const ImproveWorkspace &work, const Diamond &q) {
    const auto change = [&work](NodeId n, int step) {
        if (work.fixed[index(n)] != 0) {
            return 0;
        }
        const int off = static_cast<int>(work.valence[index(n)]) - 6;
        return off * off - (off + step) * (off + step);
    };
    return change(q.a, -1) + change(q.b, -1) + change(q.c, +1) + change(q.d, +1);
}

void turn(ImproveWorkspace &work, const Diamond &q) {
    const auto toSide = [&work](std::size_t element, ElementId from, ElementId to) {
        for (ElementId &n : work.neighbours[element]) {
            if (n == from) {
                n = to;
                return;
            }
        }
    };
    const unsigned bc = (q.k + 1) % 3, ca = (q.k + 2) % 3, ad = (q.j + 1) % 3, db = (q.j + 2) % 3;
    const auto e = ElementId{static_cast<std::uint32_t>(q.e)}, f = ElementId{static_cast<std::uint32_t>(q.f)};
    const ElementId acrossBc = work.neighbours[q.e][bc], acrossCa = work.neighbours[q.e][ca];
    const ElementId acrossAd = work.neighbours[q.f][ad], acrossDb = work.neighbours[q.f][db];
    const auto lock = [&work](std::size_t element, unsigned side) { return work.isLocked(element, side) ? 1U : 0U; };
    const unsigned lockBc = lock(q.e, bc), lockCa = lock(q.e, ca), lockAd = lock(q.f, ad), lockDb = lock(q.f, db);

    work.mesh.elements[q.e] = {q.a, q.d, q.c};
    work.mesh.elements[q.f] = {q.d, q.b, q.c};
    work.neighbours[q.e] = {acrossAd, f, acrossCa};
    work.neighbours[q.f] = {acrossDb, acrossBc, e};
    work.locked[q.e] = static_cast<std::uint8_t>(lockAd | (lockCa << 2U));
    work.locked[q.f] = static_cast<std::uint8_t>(lockDb | (lockBc << 1U));
    if (acrossAd != kNoElement) {
        toSide(index(acrossAd), f, e);
    }
    if (acrossBc != kNoElement) {
        toSide(index(acrossBc), e, f);
    }
    work.addValence(q.a, -1);
    work.addValence(q.b, -1);
    work.addValence(q.c, +1);
    work.addValence(q.d, +1);
}

/// Swaps must gain a little, lest rounding turns an edge to and fro.
constexpr double kGain = 1e-9;
/// A swap for the valences alone may lower the lesser α to this part of it.
constexpr double kNearlyAsGood = 0.6;

bool worthwhile(const ImproveWorkspace &work, const Diamond &q, bool mindValence) {
    const Shapes s = shapes(work, q);
    if (s.after <= 0.0) {
        return false;
    }
    if (!mindValence) {
        return s.after > s.before + kGain;
    }
    const int gain = valenceGain(work, q);
    return (s.after > s.before + kGain && (gain >= 0 || s.before < work.floor)) ||
           (gain > 0 && s.after >= work.floor && s.after > kNearlyAsGood * s.before);
}

} // namespace

void turnEdge(ImproveWorkspace &work, std::size_t element, unsigned side) {
    turn(work, Diamond(work, element, side));
}

bool turnIfBetter(ImproveWorkspace &work, std::size_t element, unsigned side) {
    if (!work.swappable(element, side)) {
        return false;
    }
    const Diamond q(work, element, side);
    if (!worthwhile(work, q, false)) {
        return false;
    }
    turn(work, q);
    return true;
}

std::size_t swapEdges(ImproveWorkspace &work, bool mindValence, const Progress &progress) {
    constexpr int kRounds = 6;
    const std::size_t count = work.mesh.elements.size();
    std::vector<std::uint8_t> open(count, 1); // 1: look in this round, 2: in the next
    std::size_t swaps = 0;
    for (int round = 0; round < kRounds; ++round) {
        std::size_t inRound = 0;
        for (std::size_t e = 0; e < count; ++e) {
            if ((e & 0xffffU) == 0 && progress.cancelled()) {
                return swaps;
            }
            if (open[e] == 0) {
                continue;
            }
            open[e] &= 2U;
            for (unsigned k = 0; k < 3; ++k) {
                if (!work.swappable(e, k)) {
                    continue;
                }
                const std::size_t f = index(work.neighbours[e][k]);
                if (round == 0 && f < e) {
                    continue; // seen from f
                }
                const Diamond q(work, e, k);
                if (worthwhile(work, q, mindValence)) {
                    turn(work, q);
                    ++inRound;
                    open[e] = open[f] = 2;
                    break;
                }
            }
        }
        swaps += inRound;
        if (inRound == 0) {
            break;
        }
        for (std::uint8_t &o : open) {
            o = static_cast<std::uint8_t>(o >> 1U);
        }
    }
    return swaps;
}

} // namespace forefront
