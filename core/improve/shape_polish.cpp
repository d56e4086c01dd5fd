#include "core/improve/shape_polish.hpp"

#include "core/mesh/quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {

namespace {

/// The elements around a node, each between two neighbours that follow one another.
class Star {
  public:
    Star(const ImproveWorkspace &work, std::size_t n) : centre_(work.mesh.nodes[n]) {
        work.ringOfFree(n, [&](NodeId m) { ring_[count_++] = work.at(m); });
    }

    Vec2 centre() const { return centre_; }

    /// Returns the step that minimises a convex model of f(p) = −Σ log α at the node. With A the double area of an
    /// element and S the sum of its squared sides, −log α = log S − log A + const. The second derivatives of −log A are
    /// kept; of those of log S, which may be negative, the positive part.
    Vec2 newtonStep() const {
        Vec2 gradient{};
        double xx = 0.0, xy = 0.0, yy = 0.0;
        forElements([&](Vec2 q, Vec2 r) {
            const Vec2 u = q - centre_, v = r - centre_;
            const double area = cross(u, v), squares = lengthSquared(u) + lengthSquared(v) + lengthSquared(r - q);
            const Vec2 ofArea = (1.0 / area) * Vec2{q.y - r.y, r.x - q.x};
            const Vec2 ofSquares = (-2.0 / squares) * (u + v);
            gradient = gradient + (ofSquares - ofArea);
            xx += ofArea.x * ofArea.x + 4.0 / squares;
            xy += ofArea.x * ofArea.y;
            yy += ofArea.y * ofArea.y + 4.0 / squares;
        });
        const double determinant = xx * yy - xy * xy;
        return (-1.0 / determinant) * Vec2{yy * gradient.x - xy * gradient.y, xx * gradient.y - xy * gradient.x};
    }

    /// Returns the product of α with the node at a place, or 0 if an element falls below the floor and below its α at
    /// the centre.
    double productAt(Vec2 p, double floor) const {
        double product = 1.0;
        forElements([&](Vec2 q, Vec2 r) {
            const double alpha = shapeFactor(p, q, r);
            const bool allowed = alpha >= floor || alpha >= shapeFactor(centre_, q, r);
            product *= allowed && surelyPositive(alpha, p, q, r) ? alpha : 0.0;
        });
        return product;
    }

  private:
    template <class Visit>
    void forElements(const Visit &visit) const {
        for (unsigned k = 0; k < count_; ++k) {
            visit(ring_[k], ring_[k + 1 < count_ ? k + 1 : 0]);
        }
    }

    Vec2 centre_;
    std::array<Vec2, ImproveWorkspace::kMaxValence> ring_;
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
            moves += moved;
            first = k == 0 ? moved : first;
            if (static_cast<double>(moved) <= kFewMoves * static_cast<double>(first)) {
                break;
            }
        }
        return moves;
    }

  private:
    static constexpr std::size_t kFewestSweeps = 3, kMostSweeps = 50;
    static constexpr std::size_t kMostVisits = 2'000'000; ///< of nodes, in all sweeps; about a second
    static constexpr double kFewMoves = 0.01;             ///< as many as this fraction of the first sweep's end them
    static constexpr double kWorthwhile = 1e-6;           ///< relative gain of the product
    static constexpr int kHalvings = 3;                   ///< of a step that does not help
    static constexpr std::size_t kNodesAtOnce = 4096;     ///< between checks for cancellation

    std::size_t sweep() {
        std::size_t moved = 0;
        for (std::size_t n = 0; n < work_.mesh.nodes.size(); ++n) {
            if (n % kNodesAtOnce == 0 && progress_.cancelled()) {
                break;
            }
            moved += work_.isFree(n) && move(n) ? 1 : 0;
        }
        return moved;
    }

    bool move(std::size_t n) {
        const Star star(work_, n);
        const double before = star.productAt(star.centre(), floor_);
        Vec2 step = star.newtonStep();
        for (int halving = 0; halving <= kHalvings; ++halving, step = 0.5 * step) {
            const Vec2 p = star.centre() + step;
            if (star.productAt(p, floor_) > (1.0 + kWorthwhile) * before) {
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
