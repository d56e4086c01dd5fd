#include "core/improve/repair.hpp"

#include "core/improve/swap.hpp"
#include "core/mesh/quality.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// A node with the ring of nodes around it, counter-clockwise; elements[i] is node, nodes[i], nodes[i+1].
struct Ring {
    NodeId node = kNoNode;
    std::vector<NodeId> nodes;
    std::vector<std::size_t> elements;
};

unsigned corner(const Element &e, NodeId n) {
    return e[0] == n ? 0U : e[1] == n ? 1U : 2U;
}

/// The ring around a node of an element; false where the node is not free or its ring is open.
bool walkRing(const ImproveWorkspace &work, std::size_t element, NodeId node, Ring &ring) {
    ring.node = node;
    ring.nodes.clear();
    ring.elements.clear();
    if (work.fixed[index(node)] != 0) {
        return false;
    }
    for (std::size_t e = element;;) {
        const Element &n = work.mesh.elements[e];
        const unsigned k = corner(n, node);
        ring.nodes.push_back(n[(k + 1) % 3]);
        ring.elements.push_back(e);
        const ElementId next = work.neighbours[e][(k + 2) % 3];
        if (next == kNoElement || ring.elements.size() > 64) {
            return false;
        }
        e = index(next);
        if (e == element) {
            return true;
        }
    }
}

/// Least α of the ring's elements with the node at p; negative where one is not positive.
double leastAlpha(const ImproveWorkspace &work, const Ring &ring, Vec2 p, double giveUpBelow) {
    double least = 2.0;
    for (std::size_t i = 0; i < ring.nodes.size(); ++i) {
        const Vec2 a = work.at(ring.nodes[i]);
        const Vec2 b = work.at(ring.nodes[i + 1 < ring.nodes.size() ? i + 1 : 0]);
        const double alpha = shapeFactor(p, a, b);
        if (!surelyPositive(alpha, p, a, b)) {
            return -1.0;
        }
        least = std::min(least, alpha);
        if (least <= giveUpBelow) {
            break;
        }
    }
    return least;
}

/// Moves the node where the least α around it is greatest, as far as a pattern of eight directions finds that.
bool searchBestPlace(ImproveWorkspace &work, const Ring &ring) {
    constexpr double kDiagonal = 0.7071067811865476;
    constexpr Vec2 kPattern[] = {{1, 0},
                                 {0, 1},
                                 {-1, 0},
                                 {0, -1},
                                 {kDiagonal, kDiagonal},
                                 {-kDiagonal, kDiagonal},
                                 {-kDiagonal, -kDiagonal},
                                 {kDiagonal, -kDiagonal}};
    constexpr int kTries = 40;
    constexpr double kSmallestStep = 0.004;
    const Vec2 start = work.at(ring.node);
    double reach = 0.0;
    for (const NodeId n : ring.nodes) {
        reach = std::max(reach, distance(start, work.at(n)));
    }
    Vec2 best = start;
    double bestAlpha = leastAlpha(work, ring, start, -2.0);
    double step = 0.25;
    for (int tries = 0; tries < kTries && step > kSmallestStep; ++tries) {
        const Vec2 from = best;
        for (const Vec2 direction : kPattern) {
            const Vec2 p = from + (step * reach) * direction;
            const double alpha = leastAlpha(work, ring, p, bestAlpha);
            if (alpha > bestAlpha) {
                bestAlpha = alpha;
                best = p;
            }
        }
        if (best == from) {
            step *= 0.5;
        }
    }
    work.mesh.nodes[index(ring.node)] = best;
    return !(best == start);
}

class Repair {
  public:
    Repair(ImproveWorkspace &work, double wanted) : work_(work), wanted_(wanted) {}

    RepairCounts run(const Progress &progress) {
        constexpr int kRounds = 5;
        std::vector<std::uint32_t> bad;
        for (std::size_t e = 0; e < work_.mesh.elements.size(); ++e) {
            if (alphaOf(work_.mesh, e) < wanted_) {
                bad.push_back(static_cast<std::uint32_t>(e));
            }
        }
        for (int round = 0; round < kRounds && !bad.empty() && !progress.cancelled(); ++round) {
            next_.clear();
            bool any = false;
            for (const std::uint32_t e : bad) {
                if (alphaOf(work_.mesh, e) < wanted_) {
                    any = mend(e, round > 0) || any;
                }
            }
            if (!any) {
                break;
            }
            std::sort(next_.begin(), next_.end());
            next_.erase(std::unique(next_.begin(), next_.end()), next_.end());
            bad.swap(next_);
        }
        return counts_;
    }

  private:
    void keepIfBad(std::size_t e) {
        if (alphaOf(work_.mesh, e) < wanted_) {
            next_.push_back(static_cast<std::uint32_t>(e));
        }
    }

    bool moveNode(std::size_t e, NodeId node) {
        if (!walkRing(work_, e, node, ring_) || !searchBestPlace(work_, ring_)) {
            return false;
        }
        ++counts_.moves;
        return true;
    }

    bool mend(std::size_t e, bool alsoAround) {
        bool changed = false;
        for (unsigned k = 0; k < 3; ++k) {
            const ElementId f = work_.neighbours[e][k];
            if (turnIfBetter(work_, e, k)) {
                ++counts_.swaps;
                changed = true;
                keepIfBad(index(f));
                break;
            }
        }
        const Element nodes = work_.mesh.elements[e];
        for (const NodeId n : nodes) {
            changed = moveNode(e, n) || changed;
        }
        if (alsoAround && alphaOf(work_.mesh, e) < wanted_) {
            changed = moveAround(e, nodes) || changed;
        }
        keepIfBad(e);
        return changed;
    }

    /// Gives the rings room: the nodes opposite the element's sides.
    bool moveAround(std::size_t e, const Element &nodes) {
        bool changed = false;
        for (const ElementId f : work_.neighbours[e]) {
            if (f == kNoElement) {
                continue;
            }
            for (const NodeId n : work_.mesh.elements[index(f)]) {
                if (std::find(nodes.begin(), nodes.end(), n) == nodes.end()) {
                    changed = moveNode(index(f), n) || changed;
                }
            }
        }
        for (const NodeId n : nodes) {
            changed = moveNode(e, n) || changed;
        }
        return changed;
    }

    ImproveWorkspace &work_;
    double wanted_;
    RepairCounts counts_;
    Ring ring_;
    std::vector<std::uint32_t> next_;
};

} // namespace

RepairCounts repairWorst(ImproveWorkspace &work, double wanted, const Progress &progress) {
    return Repair(work, wanted).run(progress);
}

} // namespace forefront
