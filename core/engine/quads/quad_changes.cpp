#include "core/engine/quads/quad_changes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront {

namespace {

constexpr std::uint32_t kMaxValence = 8; ///< of nodes after a change

/// Describes the changes around one node and keeps those that are worth a trial.
class ChangeFinder {
  public:
    ChangeFinder(const QuadWorkspace &mesh, std::uint32_t node, bool generous, std::vector<QuadChange> &changes)
        : mesh_(mesh), node_(node), generous_(generous), changes_(changes) {}

    void run() {
        const std::uint32_t v = mesh_.valence(node_), target = mesh_.target(node_);
        bool tooFew = v<target, tooMany = v> target;
        mesh_.forEachSector(node_, [&](std::uint32_t count, std::uint32_t wanted) {
            tooFew = tooFew || count < wanted;
            tooMany = tooMany || count > wanted;
        });
        keep(describeDoublet(mesh_, node_, change_));
        for (const std::uint32_t cell : mesh_.around[node_]) {
            if (isTriangle(mesh_.cells[cell])) {
                continue;
            }
            const QuadCell q = mesh_.cells[cell];
            const unsigned k = cornerAt(q, node_);
            const std::uint32_t a = q[(k + 1) & 3], c = q[(k + 2) & 3], b = q[(k + 3) & 3];
            collapse(cell, k);
            collapse(cell, (k + 1) & 3);
            if (tooFew) {
                rotate(a, c);
                rotate(c, b);
                if (mesh_.isFixed(node_)) {
                    raiseAll(cell, k);
                    insert(cell, k, true);
                    insert(cell, k, false);
                }
            }
            if (tooMany) {
                rotate(node_, a); // the element on the other side of the edge to b has that one
            }
        }
        if (!mesh_.isFixed(node_)) {
            splitAround();
        }
    }

  private:
    /// Changes that raise the irregularity more are rarely accepted: of 18,000 rotations that raised it by 2, 34 were.
    int limitFor(QuadChange::Kind kind) const {
        switch (kind) {
        case QuadChange::Kind::Rotate:
            return generous_ ? 2 : 0;
        case QuadChange::Kind::Split:
            return generous_ ? 2 : 1;
        case QuadChange::Kind::Raise:
        case QuadChange::Kind::Insert:
            return 8;
        default:
            return 2;
        }
    }

    void keep(bool described) {
        if (!described) {
            return;
        }
        change_.irregularity = irregularityChange();
        if (change_.irregularity <= limitFor(change_.kind)) {
            changes_.push_back(change_);
        }
    }

    int irregularityChange() const {
        std::array<std::uint32_t, 4 * QuadChange::kMost> nodes; // NOLINT(*-member-init): filled up to `count`
        std::array<int, 4 * QuadChange::kMost> growth;          // NOLINT(*-member-init)
        std::size_t count = 0;
        const auto grow = [&](const QuadCell &cell, int by) {
            for (unsigned k = 0; k < cornersOf(cell); ++k) {
                const auto end = nodes.begin() + static_cast<std::ptrdiff_t>(count);
                const auto at = static_cast<std::size_t>(std::find(nodes.begin(), end, cell[k]) - nodes.begin());
                if (at == count) {
                    nodes[count] = cell[k];
                    growth[count++] = 0;
                }
                growth[at] += by;
            }
        };
        for (unsigned i = 0; i < change_.removedCount; ++i) {
            grow(mesh_.cells[change_.removed[i]], -1);
        }
        for (unsigned i = 0; i < change_.addedCount; ++i) {
            grow(change_.added[i], 1);
        }
        int sum = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (nodes[i] > kNoIndex - 1 - QuadChange::kMaxNodes) {
                sum += (growth[i] - 4) * (growth[i] - 4);
                continue;
            }
            const int before = static_cast<int>(mesh_.valence(nodes[i])) - static_cast<int>(mesh_.target(nodes[i]));
            const int after = before + growth[i];
            sum += (nodes[i] == change_.killed ? 0 : after * after) - before * before;
        }
        return sum;
    }

    void start(QuadChange::Kind kind) {
        change_.kind = kind;
        change_.removedCount = change_.addedCount = change_.nodeCount = 0;
        change_.killed = change_.moved = kNoIndex;
    }

    /// Lets the corners k and k+2 of an element become one node.
    void collapse(std::uint32_t cell, unsigned k) {
        const QuadCell &q = mesh_.cells[cell];
        std::uint32_t a = q[k], c = q[(k + 2) & 3];
        if (mesh_.isFixed(c)) {
            std::swap(a, c);
        }
        if (mesh_.isFixed(c) || mesh_.valence(a) + mesh_.valence(c) > kMaxValence + 2) {
            return;
        }
        const std::uint32_t b = q[(k + 1) & 3], d = q[(k + 3) & 3];
        for (const std::uint32_t side : {b, d}) { // which lose an element
            if (mesh_.valence(side) < (mesh_.isFixed(side) ? 2U : 3U)) {
                return;
            }
        }
        start(QuadChange::Kind::Collapse);
        change_.remove(cell);
        for (const std::uint32_t other : mesh_.around[c]) {
            if (other == cell) {
                continue;
            }
            QuadCell x = mesh_.cells[other];
            const unsigned at = cornerAt(x, c);
            if (cornerAt(x, a) < 4) {
                return;
            }
            for (const std::uint32_t next : {nextCorner(x, at), previousCorner(x, at)}) {
                if (next != b && next != d && mesh_.areJoined(a, next)) {
                    return; // two edges between the same nodes
                }
            }
            x[at] = a;
            change_.remove(other);
            change_.add(x);
        }
        change_.killed = c;
        if (!mesh_.isFixed(a)) {
            change_.moved = a;
            change_.to = midpoint(mesh_.nodes[a], mesh_.nodes[c]);
        }
        keep(true);
    }

    /// Describes both rotations of the edge between a and b.
    void rotate(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t left = mesh_.cellWith(a, b), right = mesh_.cellWith(b, a);
        if (left == kNoIndex || right == kNoIndex || left == right || mesh_.isTagged(a, b)) {
            return;
        }
        const QuadCell &q = mesh_.cells[left], &r = mesh_.cells[right];
        if (isTriangle(q) || isTriangle(r) || mesh_.valence(a) < 3 - (mesh_.isFixed(a) ? 1U : 0U) ||
            mesh_.valence(b) < 3 - (mesh_.isFixed(b) ? 1U : 0U)) {
            return;
        }
        const unsigned i = cornerAt(q, a), j = cornerAt(r, b);
        const std::uint32_t c = q[(i + 2) & 3], d = q[(i + 3) & 3], e = r[(j + 2) & 3], f = r[(j + 3) & 3];
        if (c == e || c == f || d == e || d == f) {
            return;
        }
        const auto describe = [&](std::uint32_t u, std::uint32_t v, const QuadCell &x, const QuadCell &y) {
            if (mesh_.valence(u) >= kMaxValence || mesh_.valence(v) >= kMaxValence || mesh_.areJoined(u, v)) {
                return;
            }
            start(QuadChange::Kind::Rotate);
            change_.remove(left);
            change_.remove(right);
            change_.add(x);
            change_.add(y);
            keep(true);
        };
        describe(c, e, {c, d, a, e}, {e, f, b, c});
        describe(d, f, {d, a, e, f}, {f, b, c, d});
    }

    /// Opens a free node along its edges to the ring's nodes `from` and `to`.
    void split(std::uint32_t n, const QuadWorkspace::Ring &ring, std::size_t from, std::size_t to) {
        const std::uint32_t b = ring.nodes[from], d = ring.nodes[to];
        if (mesh_.valence(b) >= kMaxValence || mesh_.valence(d) >= kMaxValence) {
            return;
        }
        start(QuadChange::Kind::Split);
        Vec2 sum = mesh_.nodes[b] + mesh_.nodes[d];
        double count = 2.0;
        for (std::size_t i = from; i != to; i = (i + 1) % ring.count) {
            QuadCell x = mesh_.cells[ring.cells[i]];
            x[cornerAt(x, n)] = QuadChange::newNode(0);
            change_.remove(ring.cells[i]);
            change_.add(x);
            if (i != from) {
                sum += mesh_.nodes[ring.nodes[i]];
                count += 1.0;
            }
        }
        change_.add({n, b, QuadChange::newNode(0), d});
        change_.nodeCount = 1;
        const Vec2 place = mesh_.nodes[n];
        change_.places[0] = lerp(place, (1.0 / count) * sum, 0.5);
        change_.moved = n;
        change_.to = place + 0.3 * (place - change_.places[0]);
        keep(true);
    }

    /// Splits a node of many elements, or the neighbours of one of three so that it gets another.
    void splitAround() {
        const QuadWorkspace::Ring ring = mesh_.ringOf(node_);
        if (ring.count >= 5) {
            for (std::size_t i = 0; i < ring.count; ++i) {
                for (std::size_t step = 2; 2 * step <= ring.count; ++step) {
                    split(node_, ring, i, (i + step) % ring.count);
                }
            }
        } else if (ring.count == 3) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t x = ring.nodes[i];
                if (mesh_.isFixed(x) || mesh_.valence(x) < 4) {
                    continue;
                }
                const QuadWorkspace::Ring other = mesh_.ringOf(x);
                const std::size_t at = other.find(node_);
                for (std::size_t step = 2; at < other.count && step + 2 <= other.count; ++step) {
                    split(x, other, at, (at + step) % other.count);
                }
            }
        }
    }

    void raiseAll(std::uint32_t cell, unsigned k) {
        const std::uint32_t c = mesh_.cells[cell][(k + 2) & 3];
        if (mesh_.isFixed(c)) {
            return;
        }
        const QuadWorkspace::Ring ring = mesh_.ringOf(c);
        for (std::size_t i = 0; i < ring.count; ++i) {
            raise(cell, k, ring, i);
        }
    }

    /// A new node between the corner k of an element and the opposite one, which opens towards the ring's node `at`:
    /// what was missing at the boundary becomes a pair of irregular nodes inside.
    void raise(std::uint32_t cell, unsigned k, const QuadWorkspace::Ring &ring, std::size_t at) {
        const QuadCell &q = mesh_.cells[cell];
        const std::uint32_t n = q[k], a = q[(k + 1) & 3], c = q[(k + 2) & 3], b = q[(k + 3) & 3], x = ring.nodes[at];
        const std::size_t toB = ring.find(b);
        if (x == a || x == b || toB == ring.count || mesh_.valence(x) >= kMaxValence) {
            return;
        }
        start(QuadChange::Kind::Raise);
        const std::uint32_t m = QuadChange::newNode(0), opened = QuadChange::newNode(1);
        change_.remove(cell);
        for (std::size_t i = at; i != toB; i = (i + 1) % ring.count) {
            if (ring.cells[i] == cell) {
                return; // x lies on the other side of the element
            }
            QuadCell y = mesh_.cells[ring.cells[i]];
            y[cornerAt(y, c)] = opened;
            change_.remove(ring.cells[i]);
            change_.add(y);
        }
        change_.add({n, a, c, m});
        change_.add({n, m, opened, b});
        change_.add({m, c, x, opened});
        change_.nodeCount = 2;
        const Vec2 p = mesh_.nodes[n], r = mesh_.nodes[c];
        change_.places[0] = lerp(p, r, 0.6);
        change_.places[1] = lerp(r, mesh_.nodes[b], 0.3);
        change_.moved = c;
        change_.to = lerp(r, mesh_.nodes[a], 0.3);
        keep(true);
    }

    /// A new node in the hexagon of an element and its neighbour beyond the side from corner k+1 (or k+2) on, joined to
    /// the corner k and every second one.
    void insert(std::uint32_t cell, unsigned k, bool first) {
        const QuadCell &q = mesh_.cells[cell];
        const std::uint32_t u = q[(k + (first ? 1 : 2)) & 3], v = q[(k + (first ? 2 : 3)) & 3];
        const std::uint32_t other = mesh_.cellWith(v, u);
        if (other == kNoIndex || isTriangle(mesh_.cells[other]) || mesh_.isTagged(u, v)) {
            return;
        }
        const QuadCell &r = mesh_.cells[other];
        const unsigned j = cornerAt(r, u);
        const std::uint32_t x = r[(j + 1) & 3], y = r[(j + 2) & 3];
        const std::uint32_t n = q[k], a = q[(k + 1) & 3], c = q[(k + 2) & 3], b = q[(k + 3) & 3];
        const std::array<std::uint32_t, 6> hexagon =
            first ? std::array{n, a, x, y, c, b} : std::array{n, a, c, x, y, b};
        start(QuadChange::Kind::Insert);
        change_.remove(cell);
        change_.remove(other);
        const std::uint32_t m = QuadChange::newNode(0);
        Vec2 sum;
        for (std::size_t i = 0; i < 6; i += 2) {
            change_.add({m, hexagon[i], hexagon[i + 1], hexagon[(i + 2) % 6]});
        }
        for (const std::uint32_t corner : hexagon) {
            sum += mesh_.nodes[corner];
        }
        change_.nodeCount = 1;
        change_.places[0] = (1.0 / 6.0) * sum;
        keep(true);
    }

    const QuadWorkspace &mesh_;
    std::uint32_t node_;
    bool generous_;
    std::vector<QuadChange> &changes_;
    QuadChange change_;
};

} // namespace

void findChanges(const QuadWorkspace &mesh, std::uint32_t node, bool generous, std::vector<QuadChange> &changes) {
    ChangeFinder(mesh, node, generous, changes).run();
    std::stable_sort(changes.begin(), changes.end(),
                     [](const QuadChange &p, const QuadChange &q) { return p.irregularity < q.irregularity; });
}

bool describeDoublet(const QuadWorkspace &mesh, std::uint32_t node, QuadChange &change) {
    if (mesh.isFixed(node) || mesh.valence(node) != 2) {
        return false;
    }
    const std::uint32_t x = mesh.around[node][0], y = mesh.around[node][1];
    const QuadCell &q = mesh.cells[x], &r = mesh.cells[y];
    if (isTriangle(q) || isTriangle(r)) {
        return false;
    }
    const unsigned i = cornerAt(q, node), j = cornerAt(r, node);
    if (q[(i + 2) & 3] == r[(j + 2) & 3]) {
        return false;
    }
    change = {};
    change.kind = QuadChange::Kind::Doublet;
    change.remove(x);
    change.remove(y);
    change.add({q[(i + 1) & 3], q[(i + 2) & 3], q[(i + 3) & 3], r[(j + 2) & 3]});
    change.killed = node;
    return true;
}

bool describeInset(const QuadWorkspace &mesh, std::uint32_t cell, QuadChange &change) {
    const QuadCell &q = mesh.cells[cell];
    if (isTriangle(q)) {
        return false;
    }
    change = {};
    change.kind = QuadChange::Kind::Inset;
    change.remove(cell);
    // The middle of the diagonal from the widest corner lies inside, even if that is reflex.
    const auto turn = [&](unsigned k) {
        const Vec2 p = mesh.nodes[q[k]], u = mesh.nodes[q[(k + 1) & 3]] - p, v = mesh.nodes[q[(k + 3) & 3]] - p;
        const double angle = std::atan2(cross(u, v), dot(u, v));
        return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
    };
    unsigned widest = 0;
    for (unsigned k = 1; k < 4; ++k) {
        widest = turn(k) > turn(widest) ? k : widest;
    }
    const Vec2 middle = midpoint(mesh.nodes[q[widest]], mesh.nodes[q[(widest + 2) & 3]]);
    for (unsigned k = 0; k < 4; ++k) {
        const unsigned next = (k + 1) & 3;
        change.add({q[k], q[next], QuadChange::newNode(next), QuadChange::newNode(k)});
        change.places[k] = lerp(mesh.nodes[q[k]], middle, 0.5);
    }
    change.add({QuadChange::newNode(0), QuadChange::newNode(1), QuadChange::newNode(2), QuadChange::newNode(3)});
    change.nodeCount = 4;
    return true;
}

} // namespace forefront
