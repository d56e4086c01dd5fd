#include "core/engine/improve/cutout.hpp"

#include "core/engine/improve/pull.hpp"

#include <cmath>

namespace forefront {

namespace {

// The average loss of elements and edges in a smoothed mesh. Only the excess over it counts, so that a change in their
// numbers is no gain in itself.
constexpr float kUsualElementLoss = 0.013F, kUsualEdgeLoss = 0.047F;
/// The weight of 1 − δ of an edge against 1 − α of an element. Measured on graded meshes: from 0.15 to 0.4 δ rises by
/// 0.001 and α does not change; a higher weight makes new nodes more expensive.
constexpr float kEdgeWeight = 0.2F;

} // namespace

/// Returns the local number of a node and adds the node if it is new.
Cutout::Local Cutout::add(const ImproveWorkspace &work, std::span<const float> rho, NodeId id, Numbers &numbers) {
    std::size_t slot = (index(id) * 0x9e3779b1U >> 8U) % numbers.size();
    for (; numbers[slot] != kNone; slot = (slot + 1) % numbers.size()) {
        if (nodes_[numbers[slot]].id == id) {
            return numbers[slot];
        }
    }
    const auto n = static_cast<Local>(count_++);
    numbers[slot] = n;
    const Vec2 p = work.at(id) - origin_;
    nodes_[n].x = static_cast<float>(p.x / scale_);
    nodes_[n].y = static_cast<float>(p.y / scale_);
    nodes_[n].rho = static_cast<float>(static_cast<double>(rho[index(id)]) / scale_);
    nodes_[n].id = id;
    nodes_[n].valence = work.valence[index(id)];
    nodes_[n].size = 0;
    return n;
}

/// Makes a free node an inner node. Returns false if there is no room for its ring.
bool Cutout::addRing(const ImproveWorkspace &work, std::span<const float> rho, Local n, Numbers &numbers) {
    const unsigned valence = nodes_[n].valence;
    if (valence >= kRing || count_ + valence >= kNodes) { // leaves room for one more
        return false;
    }
    unsigned k = 0;
    work.ringOfFree(index(nodes_[n].id), [&](NodeId m) { nodes_[n].ring[k++] = add(work, rho, m, numbers); });
    nodes_[n].size = static_cast<std::uint8_t>(valence);
    return true;
}

bool Cutout::take(const ImproveWorkspace &work, std::span<const float> rho, NodeId centre) {
    count_ = 0;
    origin_ = work.at(centre);
    scale_ = static_cast<double>(rho[index(centre)]);
    Numbers numbers;
    numbers.fill(kNone);
    add(work, rho, centre, numbers);
    unsigned next = 0;
    for (int ring = 0; ring < 3; ++ring) {
        for (const unsigned end = count_; next < end; ++next) {
            const auto n = static_cast<Local>(next);
            if (nodes_[n].valence != 0 && !addRing(work, rho, n, numbers)) {
                return false;
            }
        }
    }
    return inner(0);
}

Cutout::Local Cutout::after(Local at, Local what) const {
    const Node &n = nodes_[at];
    for (unsigned k = 0; k < n.size; ++k) {
        if (n.ring[k] == what) {
            return n.ring[k + 1U < n.size ? k + 1U : 0U];
        }
    }
    return kNone;
}

Cutout::Local Cutout::before(Local at, Local what) const {
    const Node &n = nodes_[at];
    for (unsigned k = 0; k < n.size; ++k) {
        if (n.ring[k] == what) {
            return n.ring[k > 0 ? k - 1U : n.size - 1U];
        }
    }
    return kNone;
}

/// Inserts a neighbour into a ring. Returns true for nodes of the rim, which have no ring.
bool Cutout::insertAfter(Local at, Local before, Local what) {
    Node &n = nodes_[at];
    if (n.size == 0) {
        return true;
    }
    Local *const end = n.ring + n.size, *const found = std::find(n.ring, end, before);
    if (n.size == kRing || found == end) {
        return false;
    }
    std::copy_backward(found + 1, end, end + 1);
    found[1] = what;
    ++n.size;
    return true;
}

bool Cutout::drop(Local at, Local what) {
    Node &n = nodes_[at];
    if (n.size == 0) {
        return true;
    }
    Local *const end = n.ring + n.size, *const found = std::find(n.ring, end, what);
    if (n.size <= 3 || found == end) {
        return false;
    }
    std::copy(found + 1, end, found);
    --n.size;
    return true;
}

void Cutout::exchange(Local at, Local from, Local to) {
    Node &n = nodes_[at];
    std::replace(n.ring, n.ring + n.size, from, to);
}

/// Changes the valence of a node. Returns true for fixed nodes, which have no valence.
bool Cutout::changeValence(Local n, int by) {
    Node &node = nodes_[n];
    if (node.valence == 0) {
        return true;
    }
    const int now = node.valence + by;
    node.valence = static_cast<std::uint8_t>(now);
    return now >= 3 && now < static_cast<int>(kRing);
}

/// Finds c on the left of ab and d on the right. Returns false unless the cutout has both elements.
bool Cutout::apexes(Local a, Local b, Local &c, Local &d) const {
    if (inner(a)) {
        c = after(a, b);
        d = before(a, b);
    } else {
        c = before(b, a);
        d = after(b, a);
    }
    return c != kNone && d != kNone;
}

bool Cutout::swapEdge(Local a, Local b) {
    Local c, d;
    if (!apexes(a, b, c, d) || (!inner(c) && !inner(d)) || after(c, d) != kNone || after(d, c) != kNone) {
        return false;
    }
    return insertAfter(c, a, d) && insertAfter(d, b, c) && drop(a, b) && drop(b, a) && changeValence(a, -1) &&
           changeValence(b, -1) && changeValence(c, +1) && changeValence(d, +1);
}

/// Replaces a in the ring of b by the other neighbours of a, from one side of the edge ab round to the other.
bool Cutout::mergeRings(Local a, Local b, std::span<const Local> others) {
    const Node &removed = nodes_[a];
    Node &kept = nodes_[b];
    std::array<Local, 2 * kRing> merged;
    unsigned n = 0;
    for (unsigned k = 0; k < kept.size; ++k) {
        if (kept.ring[k] != a) {
            merged[n++] = kept.ring[k];
            continue;
        }
        for (std::size_t i = 1; i + 1 < others.size(); ++i) {
            if (after(b, others[i]) != kNone) {
                return false; // already joined
            }
            merged[n++] = others[i];
        }
    }
    if (n < 3 || n >= kRing) {
        return false;
    }
    std::copy_n(merged.begin(), n, kept.ring);
    kept.size = static_cast<std::uint8_t>(n);
    kept.x = 0.5F * (kept.x + removed.x);
    kept.y = 0.5F * (kept.y + removed.y);
    kept.rho = 0.5F * (kept.rho + removed.rho);
    return true;
}

bool Cutout::merge(Local a, Local b) {
    Local c, d;
    if (!inner(a) || !apexes(a, b, c, d)) {
        return false;
    }
    Node &removed = nodes_[a];
    std::array<Local, kRing> others; // c … d
    const auto at = static_cast<unsigned>(std::find(removed.ring, removed.ring + removed.size, b) - removed.ring);
    const unsigned count = removed.size - 1U;
    for (unsigned k = 0; k < count; ++k) {
        others[k] = removed.ring[(at + 1 + k) % removed.size];
    }
    if (inner(b)) {
        if (!mergeRings(a, b, {others.data(), count})) {
            return false;
        }
    } else if (count < 3 ||
               !std::all_of(others.begin() + 1, others.begin() + count - 1, [this](Local n) { return inner(n); })) {
        return false; // would leave an element without an inner node
    }
    for (unsigned k = 1; k + 1 < count; ++k) {
        exchange(others[k], a, b);
    }
    removed.size = 0;
    removed.valence = 0;
    return drop(c, a) && drop(d, a) && changeValence(b, static_cast<int>(count) - 3) && changeValence(c, -1) &&
           changeValence(d, -1);
}

bool Cutout::divide(Local a, unsigned first, unsigned taken) {
    const unsigned size = nodes_[a].size;
    if (count_ == kNodes || taken < 1 || taken + 2 > size || taken + 3 > kRing) {
        return false;
    }
    const auto m = static_cast<Local>(count_++);
    Node &old = nodes_[a], &fresh = nodes_[m];
    const auto at = [&](unsigned k) { return old.ring[(first + k) % size]; };
    const Local c = at(size - 1), d = at(taken);
    fresh.id = kNoNode;
    fresh.rho = old.rho;
    fresh.valence = fresh.size = static_cast<std::uint8_t>(taken + 3);
    fresh.ring[0] = a;
    fresh.ring[1] = c;
    float x = 0.0F, y = 0.0F; // direction of the nodes taken
    for (unsigned k = 0; k < taken; ++k) {
        fresh.ring[2 + k] = at(k);
        exchange(at(k), a, m);
        x += nodes_[at(k)].x - old.x;
        y += nodes_[at(k)].y - old.y;
    }
    fresh.ring[2 + taken] = d;
    if (!insertAfter(c, at(0), m) || !insertAfter(d, a, m) || !changeValence(c, +1) || !changeValence(d, +1)) {
        return false;
    }
    std::array<Local, kRing> left = {m};
    for (unsigned k = taken; k < size; ++k) {
        left[k - taken + 1] = at(k);
    }
    old.size = old.valence = static_cast<std::uint8_t>(size - taken + 1);
    std::copy_n(left.begin(), old.size, old.ring);
    const float part = 0.4F * old.rho / std::max(1e-6F, std::sqrt(x * x + y * y)); // puts the two nodes about ρ apart
    fresh.x = old.x + part * x;
    fresh.y = old.y + part * y;
    old.x -= part * x;
    old.y -= part * y;
    return true;
}

/// Returns the decrease of Σ(valence − 6)² when ab is swapped for cd.
int Cutout::gainOfSwap(Local a, Local b, Local c, Local d) const {
    const auto gain = [this](Local n, int step) {
        const int off = nodes_[n].valence - 6;
        return nodes_[n].valence == 0 ? 0 : off * off - (off + step) * (off + step);
    };
    return gain(a, -1) + gain(b, -1) + gain(c, +1) + gain(d, +1);
}

bool Cutout::balanceValences() {
    constexpr int kMaxSwaps = 6;
    for (int swaps = 0; swaps < kMaxSwaps; ++swaps) {
        int best = 0;
        Local from = kNone, to = kNone;
        for (unsigned i = 0; i < count_; ++i) {
            const Node &n = nodes_[i];
            for (unsigned k = 0; k < n.size && n.valence > 6; ++k) {
                const Local j = n.ring[k];
                const Local c = n.ring[k + 1U < n.size ? k + 1U : 0U], d = n.ring[k > 0 ? k - 1U : n.size - 1U];
                const int gain = gainOfSwap(static_cast<Local>(i), j, c, d);
                if (gain > best && nodes_[j].valence != 3 && (inner(c) || inner(d)) && after(c, d) == kNone) {
                    best = gain;
                    from = static_cast<Local>(i);
                    to = j;
                }
            }
        }
        if (from == kNone) {
            return true;
        }
        if (!swapEdge(from, to)) {
            return false;
        }
    }
    return true;
}

void Cutout::balance(Node &n, const SmoothingAims &aims) const {
    const auto spokeTo = [&](Local m) {
        const Node &to = nodes_[m];
        return Spoke{to.x - n.x, to.y - n.y, 0.5F * (n.rho + to.rho)};
    };
    Pull pull;
    Spoke spoke = spokeTo(n.ring[n.size - 1U]);
    for (unsigned k = 0; k < n.size; ++k) {
        const Spoke next = spokeTo(n.ring[k]);
        pull.add(spoke, next);
        spoke = next;
    }
    const float shape = aims.shape / pull.weight, spacing = aims.spacing / static_cast<float>(n.size);
    n.x += shape * pull.x + spacing * pull.springX;
    n.y += shape * pull.y + spacing * pull.springY;
}

void Cutout::relax(int sweeps, const SmoothingAims &aims) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (unsigned i = 0; i < count_; ++i) {
            if (nodes_[i].size != 0) {
                balance(nodes_[i], aims);
            }
        }
    }
}

Cutout::Loss Cutout::loss() const {
    float elements = 0.0F, edges = 0.0F, stretch = 0.0F;
    unsigned counted = 0;
    Loss loss;
    for (unsigned i = 0; i < count_; ++i) {
        const Node &n = nodes_[i];
        for (unsigned k = 0; k < n.size; ++k) {
            const Local j = n.ring[k], l = n.ring[k + 1U < n.size ? k + 1U : 0U];
            if (j < i && inner(j)) {
                continue;
            }
            const Node &b = nodes_[j];
            const float bx = b.x - n.x, by = b.y - n.y, bb = bx * bx + by * by;
            const float ratio = 2.0F * std::sqrt(bb) / (n.rho + b.rho);
            edges += 1.0F - std::min(ratio, 1.0F / ratio) - kUsualEdgeLoss;
            stretch += ratio - 1.0F;
            ++counted;
            if (l > i || !inner(l)) {
                const Node &c = nodes_[l];
                const float cx = c.x - n.x, cy = c.y - n.y, ax = cx - bx, ay = cy - by;
                const float alpha = 3.4641016F * (bx * cy - by * cx) / (bb + cx * cx + cy * cy + ax * ax + ay * ay);
                loss.minAlpha = std::min(loss.minAlpha, alpha);
                elements += 1.0F - alpha - kUsualElementLoss;
            }
        }
    }
    loss.sum = elements + kEdgeWeight * edges;
    loss.stretch = counted > 0 ? stretch / static_cast<float>(counted) : 0.0F;
    return loss;
}

} // namespace forefront
