#include "core/engine/improve/shape_polish.hpp"

#include "core/engine/mesh/quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {

namespace {

/// The elements around a node.
class Star {
  public:
    Star(const ImproveWorkspace &work, std::size_t n) : centre_(work.mesh.nodes[n]) {
        work.aroundFree(NodeId{static_cast<std::uint32_t>(n)}, [&](HalfEdge h) {
            Corner &corner = corners_[count_++];
            corner = {work.at(work.to(h)), work.at(work.apex(h)), sideOf(h), 0.0};
            corner.before = alphaAt(centre_, corner);
        });
    }

    Vec2 centre() const { return centre_; }

    /// Returns the step that minimises a convex model of −Σ log α. With A the double area of an element and S the sum
    /// of its squared sides, −log α = log S − log A + const. The model has the second derivatives of −log A and the
    /// positive part of those of log S. Works in units of the first edge.
    Vec2 newtonStep() const {
        const double unit = distance(corners_[0].q, centre_), inverse = 1.0 / unit;
        Vec2 gradient;
        double xx = 0.0, xy = 0.0, yy = 0.0;
        for (unsigned k = 0; k < count_; ++k) {
            const Vec2 u = inverse * (corners_[k].q - centre_), v = inverse * (corners_[k].r - centre_);
            const double area = cross(u, v), squares = lengthSquared(u) + lengthSquared(v) + lengthSquared(v - u);
            const Vec2 ofArea = (1.0 / area) * Vec2{u.y - v.y, v.x - u.x};
            const Vec2 ofSquares = (-2.0 / squares) * (u + v);
            gradient = gradient + (ofSquares - ofArea);
            xx += ofArea.x * ofArea.x + 4.0 / squares;
            xy += ofArea.x * ofArea.y;
            yy += ofArea.y * ofArea.y + 4.0 / squares;
        }
        return (-unit / (xx * yy - xy * xy)) *
               Vec2{yy * gradient.x - xy * gradient.y, xx * gradient.y - xy * gradient.x};
    }

    /// Returns the factor by which the product of α grows if the node moves to a place, or 0 if an element would fall
    /// below the floor and below its present α.
    double gainAt(Vec2 p, double floor) const {
        double gain = 1.0;
        for (unsigned k = 0; k < count_; ++k) {
            const Corner &corner = corners_[k];
            const double alpha = alphaAt(p, corner);
            const bool allowed = alpha >= std::min(floor, corner.before);
            gain *= allowed && surelyPositive(alpha, p, corner.q, corner.r) ? alpha / corner.before : 0.0;
        }
        return gain;
    }

  private:
    /// An element with the node at one of its corners.
    struct Corner {
        Vec2 q, r;           ///< its other nodes, counter-clockwise
        unsigned side = 0;   ///< position of the node in it
        double before = 0.0; ///< α
    };

    /// Returns α exactly as for the element in the mesh: its rounding depends on the order of the nodes.
    static double alphaAt(Vec2 p, const Corner &c) {
        return c.side == 0   ? shapeFactor(p, c.q, c.r)
               : c.side == 1 ? shapeFactor(c.r, p, c.q)
                             : shapeFactor(c.q, c.r, p);
    }

    Vec2 centre_;
    std::array<Corner, ImproveWorkspace::kMaxValence> corners_;
    unsigned count_ = 0;
};

class Polish {
  public:
    Polish(ImproveWorkspace &work, double floor, const Progress &progress)
        : work_(work), floor_(floor), progress_(progress) {}

    std::size_t run() {
        const std::size_t nodes = work_.mesh.nodes.size();
        const std::size_t sweeps = std::clamp(kMostVisits / (nodes + 1), kFewestSweeps, kMostSweeps);
        std::size_t moves = 0, first = 0;
        for (std::size_t k = 0; k < sweeps && !progress_.cancelled(); ++k) {
            const std::size_t moved = sweep();
            work_.report(ImproveChange::Polish);
            moves += moved;
            first = k == 0 ? moved : first;
            if (static_cast<double>(moved) <= kFewMoves * static_cast<double>(first)) {
                break;
            }
        }
        return moves;
    }

  private:
    static constexpr std::size_t kFewestSweeps = 1, kMostSweeps = 50;
    static constexpr std::size_t kMostVisits = 2'000'000; ///< of nodes, if one sweep does not take more; half a second
    static constexpr double kFewMoves = 0.01;             ///< The sweeps end after one with this fraction of the first.
    static constexpr double kWorthwhile = 1e-6;           ///< relative gain of the product
    static constexpr int kHalvings = 3;                   ///< of a step that does not help
    static constexpr std::size_t kNodesAtOnce = 4096;     ///< between checks for cancellation

    std::size_t sweep() {
        std::size_t moved = 0;
        for (std::size_t n = 0; n < work_.mesh.nodes.size(); ++n) {
            if (n % kNodesAtOnce == 0 && progress_.cancelled()) {
                break;
            }
            moved += work_.isFree(n) && work_.valence[n] <= ImproveWorkspace::kMaxValence && move(n) ? 1 : 0;
        }
        return moved;
    }

    bool move(std::size_t n) {
        const Star star(work_, n);
        Vec2 step = star.newtonStep();
        for (int halving = 0; halving <= kHalvings; ++halving, step = 0.5 * step) {
            const Vec2 p = star.centre() + step;
            if (star.gainAt(p, floor_) > 1.0 + kWorthwhile) {
                work_.mesh.nodes[n] = p;
                return true;
            }
        }
        return false;
    }

    ImproveWorkspace &work_;
    double floor_;
    const Progress &progress_;
};

} // namespace

std::size_t polishShapes(ImproveWorkspace &work, double floor, const Progress &progress) {
    return Polish(work, floor, progress).run();
}

} // namespace forefront
