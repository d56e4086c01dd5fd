#include "core/engine/quads/walk_triangles.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace forefront {

namespace {

class TriangleWalk {
  public:
    TriangleWalk(QuadWorkspace &mesh, QuadWatch *watch)
        : mesh_(mesh), watch_(watch), from_(mesh.cells.size(), kNoIndex) {}

    /// Joins this triangle to the nearest other one, or leaves it where its way ends.
    void join(std::uint32_t triangle) {
        if (!findPath(triangle)) {
            return;
        }
        walk();
        if (watch_ != nullptr) { // what a walk changes that ends early is part of the mesh, too
            watch_->changed(ImproveChange::Walk, mesh_, {false, {}, path_});
        }
    }

  private:
    /// Takes the triangle along the path, as far as it goes, and joins it to the one at its end.
    void walk() {
        std::uint32_t at = path_[0];
        for (std::size_t i = 1; i + 1 < path_.size(); ++i) {
            const std::optional<std::uint32_t> next = step(at, path_[i], path_[i + 1]);
            if (!next) {
                return;
            }
            at = *next;
        }
        merge(at, path_.back());
    }

    /// Finds the shortest way to another triangle, breadth first.
    bool findPath(std::uint32_t triangle) {
        for (const std::uint32_t cell : seen_) { // not all of them: most searches are short
            from_[cell] = kNoIndex;
        }
        seen_.assign(1, triangle);
        std::vector<std::uint32_t> &queue = seen_;
        from_[triangle] = triangle;
        for (std::size_t i = 0; i < queue.size(); ++i) {
            const QuadCell cell = mesh_.cells[queue[i]];
            for (unsigned k = 0; k < cornersOf(cell); ++k) {
                const std::uint32_t a = cell[k], b = nextCorner(cell, k), other = mesh_.cellWith(b, a);
                if (other == kNoIndex || from_[other] != kNoIndex || haveLineBetween(queue[i], other)) {
                    continue;
                }
                from_[other] = queue[i];
                queue.push_back(other);
                if (isTriangle(mesh_.cells[other])) {
                    path_.assign(1, other);
                    while (path_.back() != triangle) {
                        path_.push_back(from_[path_.back()]);
                    }
                    std::reverse(path_.begin(), path_.end());
                    return true;
                }
            }
        }
        return false;
    }

    /// Returns true if a tagged edge lies between two elements. Around the free end of an inner line they may have
    /// another side in common, too; no way leads over it, since what joins them there would take the edge away.
    bool haveLineBetween(std::uint32_t cell, std::uint32_t other) const {
        const QuadCell &q = mesh_.cells[cell];
        for (unsigned k = 0; k < cornersOf(q); ++k) {
            if (mesh_.isTagged(q[k], nextCorner(q, k)) && mesh_.cellWith(nextCorner(q, k), q[k]) == other) {
                return true;
            }
        }
        return false;
    }

    /// Returns the corner of `cell` where its common side with `other` begins; 4: none.
    unsigned commonSide(std::uint32_t cell, std::uint32_t other) const {
        const QuadCell &q = mesh_.cells[cell];
        for (unsigned k = 0; k < cornersOf(q) && !haveLineBetween(cell, other); ++k) {
            if (mesh_.cellWith(nextCorner(q, k), q[k]) == other) {
                return k;
            }
        }
        return 4;
    }

    /// Divides the pentagon of a triangle and a quadrilateral so that the triangle has the side towards `beyond`.
    /// Returns the element that is now the triangle.
    std::optional<std::uint32_t> step(std::uint32_t triangle, std::uint32_t quad, std::uint32_t beyond) {
        const unsigned k = commonSide(triangle, quad), out = commonSide(quad, beyond);
        if (k == 4 || out == 4) {
            return std::nullopt;
        }
        const QuadCell t = mesh_.cells[triangle], q = mesh_.cells[quad];
        const std::uint32_t exit = q[out];
        const unsigned j = cornerAt(q, t[k]); // the quadrilateral has the side (b, a): b at j - 1, a at j
        const std::array<std::uint32_t, 5> ring = {previousCorner(t, k), q[j], q[(j + 1) & 3], q[(j + 2) & 3],
                                                   q[(j + 3) & 3]};
        const auto at = static_cast<std::size_t>(std::find(ring.begin(), ring.end(), exit) - ring.begin());
        QuadCell bestTriangle = kNoCell, bestQuad = kNoCell;
        double best = -3.0;
        for (const std::size_t first : {at + 4, at}) { // the triangle's first corner
            const auto corner = [&](std::size_t i) { return ring[(first + i) % 5]; };
            const QuadCell tri = {corner(0), corner(1), corner(2), kNoIndex};
            const QuadCell rest = {corner(2), corner(3), corner(4), corner(0)};
            const double least = std::min(scaledJacobian(tri, mesh_.nodes), scaledJacobian(rest, mesh_.nodes));
            const bool repeats = mesh_.areJoined(corner(0), corner(2)) &&
                                 !(corner(0) == t[k] && corner(2) == nextCorner(t, k)) &&
                                 !(corner(2) == t[k] && corner(0) == nextCorner(t, k));
            if (!repeats && least > best) {
                best = least;
                bestTriangle = tri;
                bestQuad = rest;
            }
        }
        if (!isAlive(bestTriangle)) {
            return std::nullopt;
        }
        const std::uint32_t face = mesh_.faceOf(quad);
        mesh_.take(triangle);
        mesh_.take(quad);
        mesh_.put(triangle, bestTriangle, face);
        mesh_.put(quad, bestQuad, face);
        return triangle;
    }

    void merge(std::uint32_t first, std::uint32_t second) {
        const unsigned k = commonSide(first, second);
        if (k == 4) {
            return;
        }
        const QuadCell t = mesh_.cells[first], u = mesh_.cells[second];
        const unsigned j = cornerAt(u, t[k]);
        const std::uint32_t face = mesh_.faceOf(first);
        mesh_.take(first);
        mesh_.take(second);
        mesh_.put(first, {previousCorner(t, k), t[k], nextCorner(u, j), nextCorner(t, k)}, face);
        mesh_.release(second);
    }

    QuadWorkspace &mesh_;
    QuadWatch *watch_;
    std::vector<std::uint32_t> from_; ///< per element: the one before it on the way
    std::vector<std::uint32_t> seen_; ///< elements of the last search, in its order
    std::vector<std::uint32_t> path_;
};

} // namespace

std::size_t joinTriangles(QuadWorkspace &mesh, QuadWatch *watch) {
    std::size_t left = 0;
    TriangleWalk walk(mesh, watch);
    for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell) {
        if (isAlive(mesh.cells[cell]) && isTriangle(mesh.cells[cell])) {
            walk.join(cell);
        }
    }
    for (const QuadCell &cell : mesh.cells) {
        left += isAlive(cell) && isTriangle(cell) ? 1U : 0U;
    }
    return left;
}

} // namespace forefront
