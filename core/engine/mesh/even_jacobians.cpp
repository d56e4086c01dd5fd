#include "core/engine/mesh/even_jacobians.hpp"

#include "core/engine/geometry/compass.hpp"
#include "core/engine/mesh/jacobian.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/second_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace forefront {

namespace {

/// Scaled Jacobians of the corners that no move may go below: at first, and where elements are still worth a report.
constexpr double kKeptShape = 0.3, kKeptAtLast = 0.1;

/// The elements around the nodes of a mesh.
class ElementsAround {
  public:
    explicit ElementsAround(const MeshView &mesh) : first_(mesh.nodes.size() + 1, 0) {
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            for (const NodeId node : mesh.cornersOf(e)) {
                ++first_[index(node) + 1];
            }
        }
        for (std::size_t n = 1; n < first_.size(); ++n) {
            first_[n] += first_[n - 1];
        }
        elements_.resize(first_.back());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            for (const NodeId node : mesh.cornersOf(e)) {
                elements_[next[index(node)]++] = static_cast<std::uint32_t>(e);
            }
        }
    }

    std::span<const std::uint32_t> operator[](std::size_t node) const {
        return std::span(elements_).subspan(first_[node], first_[node + 1] - first_[node]);
    }

  private:
    std::vector<std::uint32_t> first_, elements_;
};

class JacobianSmoothing {
  public:
    JacobianSmoothing(const RaisedElements &elements, const std::vector<bool> &movable)
        : elements_(elements), view_(elements.mesh), free_(movable) {
        for (const TaggedEdge &edge : elements.mesh.edges) {
            free_[index(edge.a)] = free_[index(edge.b)] = false;
        }
        for (const TaggedNode &point : elements.mesh.points) {
            free_[index(point.node)] = false;
        }
        elements.table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
            if (sides.size() != 2) {
                free_[index(a)] = free_[index(b)] = false;
            }
        });
    }

    void run(const Progress &progress) {
        std::vector<std::uint32_t> poor = below(kSoughtUniformity);
        if (poor.empty()) {
            return;
        }
        around_.emplace(view_);
        improveAll(std::move(poor), progress);
        keptShape_ = kKeptAtLast;
        improveAll(below(kReportedUniformity), progress);
    }

    std::vector<MovedCorner> takeMoved() {
        std::stable_sort(moved_.begin(), moved_.end(),
                         [](const MovedCorner &x, const MovedCorner &y) { return x.node < y.node; });
        const auto end = std::unique(moved_.begin(), moved_.end(),
                                     [](const MovedCorner &x, const MovedCorner &y) { return x.node == y.node; });
        moved_.erase(end, moved_.end());
        return std::move(moved_);
    }

  private:
    /// Returns the elements whose uniformity is below a value.
    std::vector<std::uint32_t> below(double value) const {
        std::vector<std::uint32_t> found;
        for (std::size_t e = 0; e < view_.elementCount(); ++e) {
            if (uniformity(e) < value) {
                found.push_back(static_cast<std::uint32_t>(e));
            }
        }
        return found;
    }

    void improveAll(std::vector<std::uint32_t> poor, const Progress &progress) {
        constexpr unsigned kRounds = 24;
        for (unsigned round = 0; round < kRounds && !poor.empty(); ++round) {
            std::vector<std::uint32_t> changed;
            for (const std::uint32_t element : poor) {
                if (progress.cancelled()) {
                    return;
                }
                improve(element, changed);
            }
            poor.swap(changed);
            std::sort(poor.begin(), poor.end());
            poor.erase(std::unique(poor.begin(), poor.end()), poor.end());
            std::erase_if(poor, [&](std::uint32_t element) { return !isPoor(element); });
        }
    }

    Vec2 &placeOf(NodeId node) { return elements_.mesh.nodes[index(node)]; }
    bool isPoor(std::size_t element) const { return uniformity(element) < kSoughtUniformity; }
    std::uint32_t middleAt(std::size_t element, std::size_t side) const {
        return elements_.ofSide[elements_.table.halfEdges().of(element, side)];
    }

    /// Returns the minimum of the Jacobian determinant of an element over its maximum; not positive if it folds.
    double uniformity(std::size_t element) const {
        PlacedCell cell(view_, element);
        const std::size_t corners = cell.traits().corners;
        bool curved = false;
        for (std::size_t k = 0; k < corners; ++k) {
            curved = curved || elements_.curved[middleAt(element, k)];
        }
        if (!curved) {
            return straightUniformity(cell);
        }
        cell.kind = corners == 3 ? CellKind::Triangle6 : CellKind::Quadrilateral8;
        for (std::size_t k = 0; k < corners; ++k) {
            const std::uint32_t middle = middleAt(element, k);
            cell.nodes[corners + k] =
                elements_.curved[middle] ? elements_.middles[middle] : midpoint(cell.nodes[k], cell.cornerAfter(k));
        }
        return twiceArea(cell) > 0.0 ? jacobianUniformity(cell) : -1.0; // then its maximum is positive
    }

    /// Returns how far the elements around a node are from the uniformity sought; 0: none is below it. The fourth power
    /// makes the worst count most, yet lets neighbours share what they lack.
    double lossAround(NodeId node) const {
        double loss = 0.0;
        for (const std::uint32_t element : (*around_)[index(node)]) {
            const double missing = std::max(0.0, kSoughtUniformity - uniformity(element));
            loss += missing * missing * missing * missing;
        }
        return loss;
    }
    /// Notes for each element around a node the least shape that it may get: one that is worse already must not become
    /// worse still, and is no reason to let its neighbours do so.
    void noteLeastShapes(NodeId node) {
        leastShapes_.clear();
        for (const std::uint32_t element : (*around_)[index(node)]) {
            leastShapes_.push_back(std::min(scaledJacobian(PlacedCell(view_, element)), keptShape_));
        }
    }
    bool keepsShapes(NodeId node) const {
        const std::span<const std::uint32_t> elements = (*around_)[index(node)];
        for (std::size_t k = 0; k < elements.size(); ++k) {
            if (!(scaledJacobian(PlacedCell(view_, elements[k])) >= leastShapes_[k])) {
                return false;
            }
        }
        return true;
    }
    double meanEdgeAt(NodeId node) const {
        double sum = 0.0;
        std::size_t count = 0;
        for (const std::uint32_t element : (*around_)[index(node)]) {
            const PlacedCell cell(view_, element);
            for (std::size_t k = 0; k < cell.corners().size(); ++k, ++count) {
                sum += distance(cell.nodes[k], cell.cornerAfter(k));
            }
        }
        return sum / static_cast<double>(count);
    }

    /// Moves the corners of an element. Adds the elements around those that moved.
    void improve(std::uint32_t element, std::vector<std::uint32_t> &changed) {
        for (const NodeId corner : view_.cornersOf(element)) {
            if (!free_[index(corner)]) {
                continue;
            }
            const Vec2 from = placeOf(corner);
            if (!search(corner)) {
                continue;
            }
            moved_.push_back({corner, from});
            const std::span<const std::uint32_t> around = (*around_)[index(corner)];
            changed.insert(changed.end(), around.begin(), around.end());
            centreMiddles(corner);
        }
    }

    /// Searches a better place for a node by a pattern. Returns true if it moved.
    bool search(NodeId node) {
        constexpr unsigned kSteps = 16;
        constexpr double kFirstStep = 0.1; // in edges
        constexpr double kGain = 1e-6;     // relative
        noteLeastShapes(node);
        double best = lossAround(node), step = kFirstStep * meanEdgeAt(node);
        bool moved = false;
        for (unsigned t = 0; t < kSteps && best > 0.0; ++t) {
            const Vec2 start = placeOf(node);
            Vec2 place = start;
            for (const Vec2 direction : kCompass) {
                placeOf(node) = start + step * direction;
                if (const double loss = lossAround(node); loss < (1.0 - kGain) * best && keepsShapes(node)) {
                    best = loss;
                    place = placeOf(node);
                }
            }
            placeOf(node) = place;
            moved = moved || !(place == start);
            step *= place == start ? 0.5 : 1.0;
        }
        return moved;
    }

    /// Brings the middles of the straight edges at a node between their ends.
    void centreMiddles(NodeId node) {
        for (const std::uint32_t element : (*around_)[index(node)]) {
            const std::span<const NodeId> corners = view_.cornersOf(element);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const NodeId next = corners[(k + 1) % corners.size()];
                const std::uint32_t middle = middleAt(element, k);
                if ((corners[k] == node || next == node) && !elements_.curved[middle]) {
                    elements_.middles[middle] =
                        midpoint(placeOf(std::min(corners[k], next)), placeOf(std::max(corners[k], next)));
                }
            }
        }
    }

    RaisedElements elements_;
    MeshView view_;
    std::vector<bool> free_; ///< per node
    double keptShape_ = kKeptShape;
    std::vector<double> leastShapes_; ///< see noteLeastShapes()
    std::optional<ElementsAround> around_;
    std::vector<MovedCorner> moved_;
};

} // namespace

std::vector<MovedCorner> evenJacobians(const RaisedElements &elements, const std::vector<bool> &movable,
                                       const Progress &progress) {
    if (movable.empty()) {
        return {};
    }
    JacobianSmoothing smoothing(elements, movable);
    smoothing.run(progress);
    return smoothing.takeMoved();
}

} // namespace forefront
