#pragma once

#include "core/base/progress.hpp"
#include "core/improve/workspace.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace forefront {

class SpacingField;

/// How much the two aims of smoothing count. Their sum is the part of the way that a node goes in one sweep; above 1.4
/// neighbours begin to chase each other.
struct SmoothingAims {
    float shape = 0.6F;   ///< equilateral elements
    float spacing = 0.8F; ///< edges of length ρ
};

/// Moves free nodes to where the elements around them have the best shapes and their edges the wanted lengths.
///
/// Shape: near its best place p* over a side of length l (the apex of the equilateral triangle) the node loses 1 − α ≈
/// ⅔|p − p*|²/l², so the sum over the elements is least at the mean of all p*, weighted with 1/l². (With equal weights
/// this mean is the centre of the nodes around, Laplace's smoothing, which shrinks the small elements of a graded
/// mesh.) Spacing: springs with rest length ρ. On a mesh of size ratio 500: Laplace alone α .9863, conformity .932;
/// shape alone .9876, .937; both as above .9866, .9535.
///
/// All nodes move at once from the places of the sweep before, so the result is the same in any order.
class NodeSmoother {
  public:
    /// Evaluates ρ at the nodes; without a field ρ is the mean length of a node's edges.
    NodeSmoother(ImproveWorkspace &work, const SpacingField *spacing, const std::stop_token &stop = {});

    /// So many sweeps; then nodes of elements that have fallen below `floor` and have lost go back to where they were
    /// before all, until there is no such element. α is then up to date. Returns the number of nodes moved. When
    /// cancelled, none is, and α is lost.
    std::size_t sweep(int count, const SmoothingAims &aims, double floor, const Progress &progress);

    /// ρ at the places where the nodes are now.
    void renewSpacing(const std::stop_token &stop = {});
    /// ρ at the nodes, for other uses; the smoother is of no more use then.
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
    bool spoilt(std::size_t e, double alpha, double floor) const;
    std::vector<std::uint32_t> findSpoilt(double floor, const std::stop_token &stop);
    std::size_t putBack(std::vector<std::uint32_t> list, double floor, const std::stop_token &stop);
    void finish();

    ImproveWorkspace &work_;
    const SpacingField *spacing_;
    RawVector<float> rho_;
    RawVector<Vec2> now_; ///< places of all nodes while they are swept; those in the mesh stay until the end
};

} // namespace forefront
