#include "core/engine/domain/faces.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/rows.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace forefront {

namespace {

/// Half-edge 2e runs from a to b of edge e, half-edge 2e + 1 in the opposite direction.
class FaceFinder {
  public:
    FaceFinder(std::span<const Vec2> points, std::span<const PlaneEdge> edges, const PlaneSweepResult &sweep)
        : points_(points), edges_(edges), sweep_(sweep), face_(2 * edges.size(), kNoIndex) {}

    Faces run() {
        collectStars();
        linkBoundaries();
        findComponents();
        for (const std::uint32_t point : sweep_.order) {
            visit(point);
        }
        result_.left.resize(edges_.size());
        result_.right.resize(edges_.size());
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            result_.left[e] = face_[2 * e];
            result_.right[e] = face_[2 * e + 1];
        }
        return std::move(result_);
    }

  private:
    std::uint32_t origin(std::uint32_t half) const {
        const PlaneEdge &edge = edges_[half / 2];
        return sweep_.canonical[half % 2 == 0 ? edge.a : edge.b];
    }
    Vec2 target(std::uint32_t half) const { return points_[origin(half ^ 1U)]; }
    /// Returns true if the half-edge leads to a point that comes later in the sweep.
    bool rightward(std::uint32_t half) const {
        const Vec2 from = points_[origin(half)], to = target(half);
        return comesBefore(from, to);
    }

    /// Sorts the half-edges by origin, then counter-clockwise starting straight down.
    void collectStars() {
        stars_ = Rows<std::uint32_t>(points_.size(), [this](const auto &add) {
            for (std::uint32_t half = 0; half < face_.size(); ++half) {
                add(origin(half), half);
            }
        });
        for (std::size_t point = 0; point < points_.size(); ++point) {
            const std::span<std::uint32_t> star = stars_[point];
            if (star.size() > 1) {
                std::sort(star.begin(), star.end(), [&](std::uint32_t g, std::uint32_t h) {
                    const bool gRight = rightward(g), hRight = rightward(h);
                    return gRight != hRight ? gRight : orientation(points_[point], target(g), target(h)) > 0;
                });
            }
        }
    }

    /// Sets next_: the half-edge that follows along the boundary of the face to the left.
    void linkBoundaries() {
        next_.resize(face_.size());
        for (std::size_t point = 0; point < points_.size(); ++point) {
            const std::span<const std::uint32_t> star = stars_[point];
            for (std::size_t i = 0; i < star.size(); ++i) {
                next_[star[i] ^ 1U] = star[i == 0 ? star.size() - 1 : i - 1];
            }
        }
    }

    void findComponents() {
        root_.resize(points_.size());
        std::iota(root_.begin(), root_.end(), 0U);
        for (const PlaneEdge &edge : edges_) {
            const std::uint32_t a = rootOf(sweep_.canonical[edge.a]), b = rootOf(sweep_.canonical[edge.b]);
            root_[std::max(a, b)] = std::min(a, b);
        }
        reached_.assign(points_.size(), 0);
    }
    std::uint32_t rootOf(std::uint32_t point) {
        while (root_[point] != point) {
            point = root_[point] = root_[root_[point]];
        }
        return point;
    }

    /// Returns the face around a point: the one above the edge below it, which earlier points have labelled.
    std::uint32_t faceAround(std::uint32_t point) const {
        const std::uint32_t below = sweep_.below[point];
        if (below == kNoIndex) {
            return 0;
        }
        const std::uint32_t half = 2 * below;
        return face_[rightward(half) ? half : half + 1];
    }

    void visit(std::uint32_t point) {
        const std::span<const std::uint32_t> star = stars_[point];
        if (star.empty()) {
            result_.ofPoint.resize(points_.size(), kNoIndex);
            if (sweep_.on[point] == kNoIndex) {
                result_.ofPoint[point] = faceAround(point);
            }
            return;
        }
        std::uint8_t &reached = reached_[rootOf(point)];
        if (reached == 0) {
            // The leftmost point of its component: all its edges lead to the right, and the face around it lies left of
            // the uppermost one.
            reached = 1;
            label(star.back(), faceAround(point));
        }
        for (std::size_t i = 0; i < star.size() && rightward(star[i]); ++i) {
            if (face_[star[i]] == kNoIndex) {
                label(star[i], result_.count++);
            }
        }
    }

    void label(std::uint32_t half, std::uint32_t face) {
        FOREFRONT_ASSERT(face != kNoIndex);
        for (; face_[half] == kNoIndex; half = next_[half]) {
            face_[half] = face;
        }
    }

    std::span<const Vec2> points_;
    std::span<const PlaneEdge> edges_;
    const PlaneSweepResult &sweep_;
    Rows<std::uint32_t> stars_; ///< half-edges by origin
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> face_; // per half-edge
    std::vector<std::uint32_t> root_; // union-find over canonical points
    std::vector<std::uint8_t> reached_;
    Faces result_;
};

} // namespace

Faces findFaces(std::span<const Vec2> points, std::span<const PlaneEdge> edges, const PlaneSweepResult &sweep) {
    FOREFRONT_ASSERT(sweep.droppedCount == 0);
    Faces faces = FaceFinder(points, edges, sweep).run();
    faces.ofPoint.resize(points.size(), kNoIndex);
    for (std::size_t point = 0; point < points.size(); ++point) { // duplicates get the face of the first one
        faces.ofPoint[point] = faces.ofPoint[sweep.canonical[point]];
    }
    return faces;
}

} // namespace forefront
