#include "core/engine/improve/cleanup.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/improve/cleanup_batches.hpp"
#include "core/engine/improve/edge_swap.hpp"
#include "core/engine/improve/pattern_search.hpp"
#include "core/engine/improve/shape_measure.hpp"
#include "core/engine/improve/vain_attempts.hpp"
#include "core/engine/mesh/quality.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace forefront {

namespace {

/// Cleans up single elements. Each thread has its own.
class ElementCleanup {
  public:
    ElementCleanup(ImproveWorkspace &work, const ShapeMeasure &measure, double minAlpha)
        : work_(work), measure_(measure), minAlpha_(minAlpha), search_(measure) {}

    /// Returns true if an element misses the goal.
    bool misses(std::size_t e) const {
        if (work_.alpha[e] >= measure_.surelyGood()) {
            return false;
        }
        return of(work_.mesh.elements[e]) < 1.0;
    }

    /// Cleans up an element and, if `alsoAround`, its surroundings. Returns true if something changed.
    bool cleanUp(std::size_t e, bool alsoAround) {
        thorough_ = alsoAround;
        touchedNodes_.clear();
        touchedElements_.clear();
        const bool swapped = swapBestSide(e);
        bool changed = swapped;
        const Element nodes = work_.mesh.elements[e];
        for (const NodeId n : nodes) {
            changed = move(n) || changed;
        }
        // After a swap, the nodes across are not those that the batch claimed; the rest follows in the next round.
        if (!alsoAround || swapped || !misses(e)) {
            return changed;
        }
        for (unsigned k = 0; k < 3; ++k) {
            if (swapAndMove(static_cast<HalfEdge>(3 * e + k))) {
                return true;
            }
        }
        if (misses(e)) {
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge g = work_.twin[3 * e + k];
                if (g != kNoHalfEdge) {
                    changed = move(work_.apex(g)) || changed;
                }
            }
            for (const NodeId n : nodes) {
                changed = move(n) || changed;
            }
        }
        return changed;
    }

    CleanupCounts counts;

    /// Returns the nodes and elements that the last cleanup may have changed.
    ChangedParts changed() const { return {.all = false, .nodes = touchedNodes_, .elements = touchedElements_}; }

  private:
    void touchBoth(HalfEdge h) {
        for (const HalfEdge side : {h, work_.twin[h]}) {
            touchedElements_.push_back(static_cast<std::uint32_t>(elementOf(side)));
        }
    }

    double of(const Element &n) const { return measure_(work_.at(n[0]), work_.at(n[1]), work_.at(n[2])); }

    /// Swaps the side with the largest gain, if any gains. Returns true if one was swapped.
    bool swapBestSide(std::size_t e) {
        HalfEdge best = kNoHalfEdge;
        double bestGain = 1e-6;
        for (unsigned k = 0; k < 3; ++k) {
            const auto h = static_cast<HalfEdge>(3 * e + k);
            const HalfEdge g = work_.twin[h];
            if (g == kNoHalfEdge || !canSwap(work_, h)) {
                continue;
            }
            const NodeId a = work_.from(h), b = work_.to(h), c = work_.apex(h), d = work_.apex(g);
            const double before = std::min(of({a, b, c}), of({b, a, d}));
            const double after = std::min(of({a, d, c}), of({d, b, c}));
            if (after - before > bestGain && staysAbove(std::min(alpha(a, d, c), alpha(d, b, c)), e, elementOf(g))) {
                best = h;
                bestGain = after - before;
            }
        }
        if (best == kNoHalfEdge) {
            return false;
        }
        touchBoth(best);
        swapEdgeAndRings(work_, best);
        ++counts.swaps;
        return true;
    }

    /// Swaps an edge although that alone gains nothing, and moves its nodes to their best positions. Undoes everything
    /// if the result is no better.
    bool swapAndMove(HalfEdge h) {
        if (!canSwap(work_, h)) {
            return false;
        }
        const HalfEdge g = work_.twin[h];
        const std::array<NodeId, 4> nodes = {work_.from(h), work_.to(h), work_.apex(h), work_.apex(g)};
        const std::size_t e = elementOf(h), f = elementOf(g);
        if (!(std::min(alpha(nodes[0], nodes[3], nodes[2]), alpha(nodes[3], nodes[1], nodes[2])) > kMinAlphaOnTheWay)) {
            return false;
        }
        std::array<Vec2, 4> places;
        for (std::size_t i = 0; i < 4; ++i) {
            places[i] = work_.at(nodes[i]);
        }
        const std::array<Element, 2> before = {work_.mesh.elements[e], work_.mesh.elements[f]};
        const CleanupCounts countsBefore = counts;
        const auto [measure, alphaBefore] = worstAround(nodes, e, f);
        touchBoth(h);
        swapEdgeAndRings(work_, h);
        for (int pass = 0; pass < kPasses; ++pass) {
            for (const NodeId n : {nodes[2], nodes[3], nodes[0], nodes[1]}) {
                move(n);
            }
        }
        const auto [measureAfter, alphaAfter] = worstAround(nodes, e, f);
        if (measureAfter > measure + 1e-3 && alphaAfter >= std::min(alphaBefore, minAlpha_)) {
            ++counts.swaps;
            return true;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            work_.mesh.nodes[index(nodes[i])] = places[i];
        }
        undoSwap(work_, e, f, before);
        for (const NodeId n : nodes) {
            if (work_.isFree(n)) {
                work_.aroundFree(n, [&](HalfEdge k) { renewAlpha(elementOf(k)); });
            }
        }
        counts = countsBefore;
        return false;
    }

    void renewAlpha(std::size_t e) { work_.alpha[e] = static_cast<float>(work_.alphaOf(e)); }

    struct Worst {
        double measure, alpha;
    };
    /// Returns the worst measure and α of two elements and of those around four nodes.
    Worst worstAround(const std::array<NodeId, 4> &nodes, std::size_t e, std::size_t f) const {
        Worst worst{1e300, 1e300};
        const auto look = [&](std::size_t element) {
            worst.measure = std::min(worst.measure, of(work_.mesh.elements[element]));
            worst.alpha = std::min(worst.alpha, work_.alphaOf(element));
        };
        look(e);
        look(f);
        for (const NodeId n : nodes) {
            if (work_.isFree(n)) {
                work_.aroundFree(n, [&](HalfEdge h) { look(elementOf(h)); });
            }
        }
        return worst;
    }

    double alpha(NodeId a, NodeId b, NodeId c) const { return shapeFactor(work_.at(a), work_.at(b), work_.at(c)); }
    bool staysAbove(double after, std::size_t e, std::size_t f) const {
        return after > kCertainAlpha && (after >= minAlpha_ || after > std::min(work_.alphaOf(e), work_.alphaOf(f)));
    }

    /// Moves a free node so that the worst element around it gets better. Returns true if it moved.
    bool move(NodeId node) {
        if (!work_.isFree(node)) {
            return false;
        }
        const Vec2 by = search_.bestMove(work_, node, thorough_ ? kThorough : kQuick);
        return !(by == Vec2{}) && place(node, by);
    }

    /// Moves the node unless that makes an α, as shapeFactor computes it, fall too low. Returns true if it moved.
    bool place(NodeId node, Vec2 by) {
        const Vec2 before = work_.at(node);
        const std::span<const std::uint32_t> elements = search_.elements();
        std::array<double, ImproveWorkspace::kMaxValence> oldAlpha;
        for (std::size_t i = 0; i < elements.size(); ++i) {
            oldAlpha[i] = work_.alphaOf(elements[i]);
        }
        work_.mesh.nodes[index(node)] = before + by;
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const double alpha = work_.alphaOf(elements[i]);
            if (!(alpha > kCertainAlpha) || (alpha < minAlpha_ && alpha < oldAlpha[i])) {
                work_.mesh.nodes[index(node)] = before;
                return false;
            }
        }
        for (const std::uint32_t e : elements) {
            renewAlpha(e);
        }
        touchedNodes_.push_back(node);
        ++counts.moves;
        return true;
    }

    static constexpr PatternSearch::Limits kQuick{24, 0.008}, kThorough{60, 0.0005};
    static constexpr int kPasses = 2;
    /// Minimum α of elements, even between two steps of a change.
    static constexpr double kMinAlphaOnTheWay = 0.05;

    ImproveWorkspace &work_;
    const ShapeMeasure &measure_;
    double minAlpha_;
    PatternSearch search_;
    bool thorough_ = false; ///< search with smaller steps
    std::vector<NodeId> touchedNodes_;
    std::vector<std::uint32_t> touchedElements_;
};

class Cleanup {
  public:
    Cleanup(ImproveWorkspace &work, const ShapeGoal &goal, double minAlpha)
        : work_(work), measure_(goal), rounds_(goal.rounds) {
        for (unsigned thread = 0; thread < work.pool.threads(); ++thread) {
            cleanups_.emplace_back(work, measure_, minAlpha);
        }
    }

    CleanupCounts run(const Progress &progress) {
        std::vector<std::uint32_t> bad = findBad();
        std::optional<VainAttempts> vain; // from the second round on; these rounds make the same attempts
        for (int round = 0; round < rounds_ && !bad.empty() && !progress.cancelled(); ++round) {
            if (round == 1) {
                vain.emplace(work_);
            }
            const std::size_t before = bad.size();
            bad = stillBad(bad, cleanUpOnce(bad, vain, progress));
            if (vain && isHopeless(before, bad.size())) {
                break;
            }
        }
        CleanupCounts counts;
        for (const ElementCleanup &mender : cleanups_) {
            counts.swaps += mender.counts.swaps;
            counts.moves += mender.counts.moves;
            counts.attempts += mender.counts.attempts;
        }
        counts.left = bad.size();
        return counts;
    }

  private:
    /// Returns true if many elements miss the goal after a round that hardly lowered their number. The mesh is too
    /// coarse for its boundary then: on a map with a size far above its segments, further rounds took 4 of 5.6 s and
    /// raised the geometric mean of α from .603 to .607.
    bool isHopeless(std::size_t before, std::size_t after) const {
        constexpr std::size_t kMany = 2000;          // cleaned up in a tenth of a second
        constexpr double kManyFraction = 0.1;        // many for the number of elements
        constexpr double kHardlyFewerFraction = 0.9; // hardly fewer than before
        const double left = static_cast<double>(after);
        return after > kMany && left > kManyFraction * static_cast<double>(work_.mesh.elements.size()) &&
               left > kHardlyFewerFraction * static_cast<double>(before);
    }

    /// Cleans up elements, and their surroundings if `vain` is given. Returns 1 for each that changed something.
    std::vector<std::uint8_t> cleanUpOnce(const std::vector<std::uint32_t> &bad, std::optional<VainAttempts> &vain,
                                          const Progress &progress) {
        std::vector<std::uint8_t> changed(bad.size(), 0);
        CleanupBatches batches(work_, bad);
        for (auto batch = batches.next(); !batch.empty() && !progress.cancelled(); batch = batches.next()) {
            constexpr std::size_t kAtATime = 64;
            const std::size_t atOnce = work_.watch == nullptr ? kAtATime : batch.size(); // a watch needs one thread
            work_.pool.run((batch.size() + atOnce - 1) / atOnce, [&](std::size_t task, unsigned thread) {
                ElementCleanup &cleanup = cleanups_[thread];
                for (std::size_t i = task * atOnce;
                     i < std::min(batch.size(), (task + 1) * atOnce) && !progress.cancelled(); ++i) {
                    const std::uint32_t e = bad[batch[i]];
                    if (!cleanup.misses(e)) {
                        continue;
                    }
                    if (vain && vain->isVain(e)) {
                        FOREFRONT_ASSERT(!cleanup.cleanUp(e, true));
                        continue;
                    }
                    changed[batch[i]] = cleanup.cleanUp(e, vain.has_value()) ? 1 : 0;
                    ++cleanup.counts.attempts;
                    if (changed[batch[i]] != 0) {
                        work_.report(ImproveChange::Cleanup, cleanup.changed());
                    }
                }
            });
            if (vain) {
                vain->record(batch, bad, changed);
            }
        }
        return changed;
    }

    std::vector<std::uint32_t> findBad() {
        const std::size_t count = work_.mesh.elements.size();
        std::vector<std::vector<std::uint32_t>> found((count + ImproveWorkspace::kChunk - 1) /
                                                      ImproveWorkspace::kChunk);
        work_.pool.forChunks(count, ImproveWorkspace::kChunk,
                             [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                                 for (std::size_t e = begin; e < end; ++e) {
                                     if (cleanups_.front().misses(e)) {
                                         found[chunk].push_back(static_cast<std::uint32_t>(e));
                                     }
                                 }
                             });
        std::vector<std::uint32_t> all;
        for (const auto &some : found) {
            all.insert(all.end(), some.begin(), some.end());
        }
        return all;
    }

    /// Returns the elements that miss the goal, of those cleaned up and, where something changed, of those around the
    /// nodes that may have moved.
    std::vector<std::uint32_t> stillBad(const std::vector<std::uint32_t> &bad,
                                        const std::vector<std::uint8_t> &changed) {
        std::vector<std::uint32_t> next;
        const auto keep = [&](std::size_t e) {
            if (cleanups_.front().misses(e)) {
                next.push_back(static_cast<std::uint32_t>(e));
            }
        };
        const auto keepAround = [&](NodeId n) {
            if (work_.isFree(n)) {
                work_.aroundFree(n, [&](HalfEdge h) { keep(elementOf(h)); });
            }
        };
        for (std::size_t i = 0; i < bad.size(); ++i) {
            keep(bad[i]);
            for (unsigned k = 0; k < 3 && changed[i] != 0; ++k) {
                const HalfEdge h = 3 * bad[i] + k, g = work_.twin[h];
                keepAround(work_.from(h));
                if (g != kNoHalfEdge) {
                    keepAround(work_.apex(g));
                    keep(elementOf(g));
                }
            }
        }
        std::sort(next.begin(), next.end());
        next.erase(std::unique(next.begin(), next.end()), next.end());
        return next;
    }

    ImproveWorkspace &work_;
    ShapeMeasure measure_;
    int rounds_;
    std::vector<ElementCleanup> cleanups_;
};

} // namespace

CleanupCounts cleanUpWorst(ImproveWorkspace &work, const ShapeGoal &goal, double minAlpha, const Progress &progress) {
    return Cleanup(work, goal, minAlpha).run(progress);
}

} // namespace forefront
