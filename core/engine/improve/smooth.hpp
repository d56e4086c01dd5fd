#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/improve/improve_workspace.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace forefront {

class SpacingField;

/// The weights of the two aims of smoothing. Their sum is the part of the way that a node moves in one sweep; above 1.4
/// neighbouring nodes begin to oscillate.
struct SmoothingAims {
    float shape = 0.6F;   ///< equilateral elements
    float spacing = 0.8F; ///< edges of length ρ
};

/// Moves free nodes so that the elements around them get better shapes and their edges the target lengths.
///
/// Shape: near its best place p* over a side of length l (the apex of the equilateral triangle) the node loses 1 − α ≈
/// ⅔|p − p*|²/l², so the sum over the elements is minimal at the mean of all p*, weighted with 1/l². (With equal
/// weights this mean is the centre of the nodes around, Laplace's smoothing, which shrinks the small elements of a
/// graded mesh.) Spacing: springs with rest length ρ. On a mesh of size ratio 500: Laplace alone α .9863, conformity
/// .932; shape alone .9876, .937; both as above .9866, .9535.
///
/// All nodes move at once from their positions after the previous sweep, so the order does not matter.
class NodeSmoother {
  public:
    /// Evaluates ρ at the nodes. Without a field, ρ is the mean length of a node's edges.
    NodeSmoother(ImproveWorkspace &work, const SpacingField *spacing, const std::stop_token &stop = {});

    /// Smooths in `count` sweeps. Nodes of elements that got worse and fell below `floor` then return to where they
    /// were before the first sweep, until no such element is left. Updates α and returns the number of moved nodes.
    /// When cancelled, no node moves and α is undefined.
    std::size_t sweep(int count, const SmoothingAims &aims, double floor, const Progress &progress);

    /// Evaluates ρ at the current positions of the nodes.
    void renewSpacing(const std::stop_token &stop = {});
    /// Moves out the values of ρ at the nodes; the smoother is then unusable.
    RawVector<float> takeSpacing() && { return std::move(rho_); }

  private:
    struct Move {
        float x, y;
    };
    void meanLengths();
    Vec2 now(NodeId n) const { return now_[index(n)]; }
    double alphaNow(const Element &n) const;
    Move moveOf(const Vec2 *places, std::size_t n, const SmoothingAims &aims) const;
    template <class Put>
    void moveAll(const Vec2 *places, const SmoothingAims &aims, const std::stop_token &stop, const Put &put) const;
    void moveFirst(const SmoothingAims &aims, const std::stop_token &stop);
    void moveAgain(const SmoothingAims &aims, const std::stop_token &stop);
    bool degraded(std::size_t e, double alpha, double floor) const;
    std::vector<std::uint32_t> findDegraded(double floor, const std::stop_token &stop);
    std::size_t restoreDegraded(std::vector<std::uint32_t> list, double floor, const std::stop_token &stop);
    void report(ImproveChange change) const;
    void finish();

    ImproveWorkspace &work_;
    const SpacingField *spacing_;
    RawVector<float> rho_;
    RawVector<Vec2> now_; ///< positions during the sweeps; the mesh changes at the end
};

} // namespace forefront
