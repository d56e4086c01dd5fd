#include "core/engine/improve/growth_limit.hpp"

#include "core/engine/geometry/unit_vector.hpp"
#include "core/engine/mesh/quality.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr std::size_t kMostSweeps = 20;
constexpr std::array kSteps = {0.12, 0.05, 0.02}; ///< in mean lengths of the edges at a node
constexpr int kDirections = 12;
constexpr double kWorthwhileMove = 0.98; ///< the excess that a move leaves, relative to the excess before

double twiceArea(Vec2 a, Vec2 b, Vec2 c) {
    return cross(b - a, c - a);
}

double ratioOf(double a, double b) {
    return std::max(a, b) / std::min(a, b);
}

/// Returns the cosine of the minimum angle of a triangle.
double cosineOfMinAngle(Vec2 a, Vec2 b, Vec2 c) {
    const auto cosine = [](Vec2 tip, Vec2 p, Vec2 q) {
        return dot(p - tip, q - tip) / (distance(tip, p) * distance(tip, q));
    };
    return std::max({cosine(a, b, c), cosine(b, c, a), cosine(c, a, b)});
}

double areaOf(const ImproveWorkspace &work, std::size_t e) {
    const Element &n = work.mesh.elements[e];
    return twiceArea(work.at(n[0]), work.at(n[1]), work.at(n[2]));
}

/// Returns the half-edge across each, as in the workspace, but also across tagged edges.
RawVector<HalfEdge> acrossAllEdges(const ImproveWorkspace &work) {
    RawVector<HalfEdge> across = work.twin;
    std::vector<std::pair<std::pair<NodeId, NodeId>, HalfEdge>> open;
    for (HalfEdge h = 0; h < static_cast<HalfEdge>(across.size()); ++h) {
        if (across[h] == kNoHalfEdge) {
            open.emplace_back(std::minmax(work.from(h), work.to(h)), h);
        }
    }
    std::sort(open.begin(), open.end());
    for (std::size_t k = 1; k < open.size(); ++k) {
        if (open[k].first == open[k - 1].first) {
            across[open[k].second] = open[k - 1].second;
            across[open[k - 1].second] = open[k].second;
        }
    }
    return across;
}

double growthOf(const ImproveWorkspace &work, const RawVector<HalfEdge> &across) {
    double growth = 1.0;
    for (HalfEdge h = 0; h < static_cast<HalfEdge>(across.size()); ++h) {
        if (across[h] != kNoHalfEdge && across[h] > h) {
            growth = std::max(growth, ratioOf(areaOf(work, elementOf(h)), areaOf(work, elementOf(across[h]))));
        }
    }
    return growth;
}

/// How far the areas around a node are from the goal.
struct Excess {
    double sum = 0.0;   ///< of the squares of what ratios exceed the goal by, relative to it
    double worst = 1.0; ///< ratio

    void add(double ratio, double goal) {
        worst = std::max(worst, ratio);
        if (ratio > goal) {
            const double excess = ratio / goal - 1.0;
            sum += excess * excess;
        }
    }
};

/// The elements around a free node, and those across from it.
class AreaStar {
  public:
    AreaStar(const ImproveWorkspace &work, const RawVector<HalfEdge> &across, const GrowthGoal &goal, NodeId n)
        : goal_(goal), centre_(work.at(n)) {
        work.aroundFree(n, [&](HalfEdge h) {
            Petal &petal = petals_[count_++];
            petal.element = elementOf(h);
            petal.q = work.at(work.to(h));
            petal.r = work.at(work.apex(h));
            petal.alpha = shapeFactor(centre_, petal.q, petal.r);
            petal.cosine = cosineOfMinAngle(centre_, petal.q, petal.r);
            if (const HalfEdge outer = across[nextSide(h)]; outer != kNoHalfEdge) {
                petal.across = areaOf(work, elementOf(outer));
            }
            reach_ += distance(centre_, petal.q);
        });
        reach_ /= count_;
    }

    Vec2 centre() const { return centre_; }
    double reach() const { return reach_; } ///< mean length of the edges at the node

    Excess excessAt(Vec2 p) const {
        Excess excess;
        double last = twiceArea(p, petals_[count_ - 1].q, petals_[count_ - 1].r);
        for (unsigned k = 0; k < count_; ++k) {
            const Petal &petal = petals_[k];
            const double area = twiceArea(p, petal.q, petal.r);
            excess.add(ratioOf(area, last), goal_.growth);
            if (petal.across > 0.0) {
                excess.add(ratioOf(area, petal.across), goal_.growth);
            }
            last = area;
        }
        return excess;
    }

    /// Returns true if the node may move to p: no shape falls below both the goal and its previous value.
    bool allows(Vec2 p) const {
        constexpr double kMaxLoss = 0.01; // of the mean α around the node
        const double maxCosine = unitVector(goal_.angle).x;
        double gain = kMaxLoss * count_;
        for (unsigned k = 0; k < count_; ++k) {
            gain += shapeFactor(p, petals_[k].q, petals_[k].r) - petals_[k].alpha;
        }
        if (!(gain >= 0.0)) {
            return false;
        }
        return std::all_of(petals_.begin(), petals_.begin() + count_, [&](const Petal &petal) {
            const double alpha = shapeFactor(p, petal.q, petal.r);
            return alpha >= std::min(goal_.alpha, petal.alpha) && surelyPositive(alpha, p, petal.q, petal.r) &&
                   cosineOfMinAngle(p, petal.q, petal.r) <= std::max(maxCosine, petal.cosine);
        });
    }

    template <class Visit>
    void forEachElement(const Visit &visit) const {
        for (unsigned k = 0; k < count_; ++k) {
            visit(petals_[k].element);
        }
    }

  private:
    struct Petal {
        std::size_t element = 0;
        Vec2 q, r;                        ///< its other nodes, counter-clockwise
        double alpha = 0.0, cosine = 0.0; ///< before the move
        double across = 0.0;              ///< twice the area of the element across; 0: none
    };

    const GrowthGoal &goal_;
    Vec2 centre_;
    double reach_ = 0.0;
    std::array<Petal, ImproveWorkspace::kMaxValence> petals_;
    unsigned count_ = 0;
};

class GrowthLimiter {
  public:
    GrowthLimiter(ImproveWorkspace &work, const GrowthGoal &goal, const Progress &progress)
        : work_(work), goal_(goal), progress_(progress), across_(acrossAllEdges(work)) {}

    std::size_t run() {
        std::size_t moves = 0;
        for (std::size_t k = 0; k < kMostSweeps && !progress_.cancelled(); ++k) {
            const std::size_t moved = sweep();
            moves += moved;
            if (moved == 0) {
                break;
            }
        }
        return moves;
    }

  private:
    std::size_t sweep() {
        std::size_t moved = 0;
        const auto edges = static_cast<HalfEdge>(3 * work_.mesh.elements.size());
        for (HalfEdge h = 0; h < edges; ++h) {
            const HalfEdge across = across_[h];
            if (across == kNoHalfEdge || across < h ||
                !(ratioOf(areaOf(work_, elementOf(h)), areaOf(work_, elementOf(across))) > goal_.growth)) {
                continue;
            }
            for (const NodeId n : {work_.apex(h), work_.apex(across), work_.from(h), work_.to(h)}) {
                moved += work_.isFree(n) && work_.valence[index(n)] <= ImproveWorkspace::kMaxValence && move(n) ? 1 : 0;
            }
        }
        return moved;
    }

    bool move(NodeId n) {
        const AreaStar star(work_, across_, goal_, n);
        const Excess before = star.excessAt(star.centre());
        if (!(before.sum > 0.0)) {
            return false;
        }
        Vec2 best = star.centre();
        double least = kWorthwhileMove * before.sum;
        for (const double step : kSteps) {
            const Vec2 from = best;
            for (int k = 0; k < kDirections; ++k) {
                const Vec2 p = from + step * star.reach() * unitVector(360.0 * k / kDirections);
                const Excess after = star.allows(p) ? star.excessAt(p) : before;
                if (after.sum < least && after.worst <= before.worst) {
                    least = after.sum;
                    best = p;
                }
            }
        }
        if (best == star.centre()) {
            return false;
        }
        work_.mesh.nodes[index(n)] = best;
        star.forEachElement([&](std::size_t e) {
            const Element &c = work_.mesh.elements[e];
            work_.alpha[e] = static_cast<float>(shapeFactor(work_.at(c[0]), work_.at(c[1]), work_.at(c[2])));
        });
        return true;
    }

    ImproveWorkspace &work_;
    const GrowthGoal &goal_;
    const Progress &progress_;
    const RawVector<HalfEdge> across_; ///< nodes move, edges stay
};

} // namespace

double growthOf(const ImproveWorkspace &work) {
    return growthOf(work, acrossAllEdges(work));
}

std::size_t limitGrowth(ImproveWorkspace &work, const GrowthGoal &goal, const Progress &progress) {
    return GrowthLimiter(work, goal, progress).run();
}

} // namespace forefront
