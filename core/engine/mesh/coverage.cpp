#include "core/engine/mesh/coverage.hpp"

#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <set>

namespace forefront {

namespace {

struct SweepEdge {
    Vec2 left, right; ///< ends in the order of the sweep
    NodeId leftNode = kNoNode, rightNode = kNoNode;
    int rise = 0;  ///< change of the winding number from below to above: +1 where the mesh lies above, else -1
    int below = 0; ///< winding number just below the edge
    int above() const { return below + rise; }
};

/// The order of the edges that the sweep line crosses, from below. Where collinear edges overlap, as on the two sides
/// of a slit or at a hanging node, the one with the mesh below it comes first.
class Below {
  public:
    using is_transparent = void;
    explicit Below(const std::vector<SweepEdge> &edges) : edges_(&edges) {}

    bool operator()(std::uint32_t i, std::uint32_t j) const {
        const SweepEdge &a = (*edges_)[i], &b = (*edges_)[j];
        int side; // of b seen from a
        if (a.left == b.left) {
            side = orientation(a.left, a.right, b.right);
        } else if (comesBefore(a.left, b.left)) {
            side = orientation(a.left, a.right, b.left);
            side = side != 0 ? side : orientation(a.left, a.right, b.right);
        } else {
            side = -orientation(b.left, b.right, a.left);
            side = side != 0 ? side : -orientation(b.left, b.right, a.right);
        }
        if (side != 0) {
            return side > 0;
        }
        return a.rise != b.rise ? a.rise < b.rise : i < j;
    }
    bool operator()(std::uint32_t i, Vec2 p) const { return orientation((*edges_)[i].left, (*edges_)[i].right, p) > 0; }
    bool operator()(Vec2 p, std::uint32_t i) const { return orientation((*edges_)[i].left, (*edges_)[i].right, p) < 0; }

  private:
    const std::vector<SweepEdge> *edges_;
};

class Sweep {
  public:
    Sweep(const MeshView &mesh, const HalfEdges &sides, const std::vector<HalfEdge> &boundary)
        : active_(Below(edges_)) {
        edges_.reserve(boundary.size());
        for (const HalfEdge h : boundary) {
            const NodeId a = sides.startOf(h), b = sides.endOf(h);
            const Vec2 pa = mesh.nodes[index(a)], pb = mesh.nodes[index(b)];
            if (comesBefore(pa, pb)) {
                edges_.push_back({pa, pb, a, b, +1, 0});
            } else if (comesBefore(pb, pa)) {
                edges_.push_back({pb, pa, b, a, -1, 0});
            }
        }
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            starts_.push_back(i);
            ends_.push_back(i);
        }
        std::sort(starts_.begin(), starts_.end(), [this](std::uint32_t i, std::uint32_t j) {
            return edges_[i].left == edges_[j].left ? i < j : comesBefore(edges_[i].left, edges_[j].left);
        });
        std::sort(ends_.begin(), ends_.end(), [this](std::uint32_t i, std::uint32_t j) {
            return edges_[i].right == edges_[j].right ? i < j : comesBefore(edges_[i].right, edges_[j].right);
        });
        places_.assign(edges_.size(), active_.end());
    }

    Coverage run() {
        std::size_t nextStart = 0;
        for (std::size_t nextEnd = 0; nextEnd < ends_.size() && !found_.overlap;) {
            const bool starting = nextStart < starts_.size() &&
                                  !comesBefore(edges_[ends_[nextEnd]].right, edges_[starts_[nextStart]].left);
            const Vec2 p = starting ? edges_[starts_[nextStart]].left : edges_[ends_[nextEnd]].right;
            NodeId node = kNoNode;
            for (; nextEnd < ends_.size() && edges_[ends_[nextEnd]].right == p; ++nextEnd) {
                node = edges_[ends_[nextEnd]].rightNode;
                active_.erase(places_[ends_[nextEnd]]);
            }
            for (; nextStart < starts_.size() && edges_[starts_[nextStart]].left == p; ++nextStart) {
                node = edges_[starts_[nextStart]].leftNode;
                places_[starts_[nextStart]] = active_.insert(starts_[nextStart]).first;
            }
            settle(p, node);
        }
        return std::move(found_);
    }

  private:
    using Active = std::set<std::uint32_t, Below>;

    /// Sets the winding numbers around p, where edges begin or end, and checks that edges already there agree.
    void settle(Vec2 p, NodeId node) {
        Active::iterator it = active_.lower_bound(p);
        int winding = it == active_.begin() ? 0 : edges_[*std::prev(it)].above();
        Active::iterator lower = it == active_.begin() ? active_.end() : std::prev(it);
        bool fits = true;
        bool first = true;
        for (; it != active_.end() && !Below(edges_)(p, *it); ++it) {
            SweepEdge &edge = edges_[*it];
            if (edge.left == p) {
                edge.below = winding;
            } else {
                found_.hanging.push_back({node, edge.leftNode, edge.rightNode});
                fits = fits && edge.below == winding;
            }
            winding = edge.above();
            fits = fits && (winding == 0 || winding == 1);
            if (first && lower != active_.end()) {
                checkCrossing(*lower, *it);
            }
            first = false;
            lower = it;
        }
        if (it != active_.end()) {
            fits = fits && edges_[*it].below == winding;
            if (lower != active_.end()) {
                checkCrossing(*lower, *it);
            }
        } else {
            fits = fits && winding == 0;
        }
        if (!fits && !found_.overlap) {
            found_.overlap = p;
        }
    }

    /// Records an overlap where two edges cross: the winding number of one of the four sectors between them is neither
    /// 0 nor 1.
    void checkCrossing(std::uint32_t i, std::uint32_t j) {
        const SweepEdge &a = edges_[i], &b = edges_[j];
        if (found_.overlap || meet(a.left, a.right, b.left, b.right) != SegmentMeeting::Crossing) {
            return;
        }
        const Vec2 da = a.right - a.left, db = b.right - b.left;
        const double denominator = cross(da, db);
        const double t = denominator != 0.0 ? cross(b.left - a.left, db) / denominator : 0.5;
        found_.overlap = lerp(a.left, a.right, std::clamp(t, 0.0, 1.0));
    }

    std::vector<SweepEdge> edges_;
    std::vector<std::uint32_t> starts_, ends_;
    Active active_;
    std::vector<Active::iterator> places_;
    Coverage found_;
};

} // namespace

Coverage coverage(const MeshView &mesh, const HalfEdges &sides, const std::vector<HalfEdge> &boundary) {
    return Sweep(mesh, sides, boundary).run();
}

} // namespace forefront
