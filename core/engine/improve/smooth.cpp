#include "core/engine/improve/smooth.hpp"

#include "core/engine/improve/pull.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

NodeSmoother::NodeSmoother(ImproveWorkspace &work, const SpacingField *spacing, const std::stop_token &stop)
    : work_(work), spacing_(spacing), rho_(work.mesh.nodes.size()), now_(work.mesh.nodes.size()) {
    if (spacing_ != nullptr) {
        renewSpacing(stop);
    } else {
        meanLengths();
    }
}

void NodeSmoother::renewSpacing(const std::stop_token &stop) {
    if (spacing_ == nullptr) {
        return;
    }
    constexpr std::size_t kBlock = 1024;
    const std::vector<Vec2> &nodes = work_.mesh.nodes;
    work_.pool.forChunks(
        nodes.size(), kBlock,
        [&](std::size_t begin, std::size_t end, std::size_t) {
            std::array<double, kBlock> rho;
            spacing_->atMany({nodes.data() + begin, end - begin}, {rho.data(), end - begin});
            for (std::size_t n = begin; n < end; ++n) {
                rho_[n] = static_cast<float>(rho[n - begin]);
            }
        },
        stop);
}

/// Sets ρ to the mean length of the edges of each node. An inner edge counts twice, once for each of its elements.
void NodeSmoother::meanLengths() {
    const TriMesh &mesh = work_.mesh;
    std::fill(rho_.begin(), rho_.end(), 0.0F);
    std::vector<std::uint32_t> ends(mesh.nodes.size(), 0);
    for (const Element &e : mesh.elements) {
        for (unsigned k = 0; k < 3; ++k) {
            const std::size_t i = index(e[k]), j = index(e[(k + 1) % 3]);
            const auto edge = static_cast<float>(distance(mesh.nodes[i], mesh.nodes[j]));
            rho_[i] += edge;
            rho_[j] += edge;
            ++ends[i];
            ++ends[j];
        }
    }
    for (std::size_t n = 0; n < ends.size(); ++n) {
        rho_[n] /= static_cast<float>(ends[n] > 0 ? ends[n] : 1);
    }
}

/// Returns the move of a free node.
[[gnu::always_inline]] inline NodeSmoother::Move NodeSmoother::moveOf(const Vec2 *places, std::size_t n,
                                                                      const SmoothingAims &aims) const {
    const Vec2 p = places[n];
    const float rho = rho_[n], scale = 1.0F / rho; // lengths in units of ρ, whose powers stay in the range of float
    const auto spokeTo = [&](std::size_t m) {
        const Vec2 q = places[m];
        return Spoke{scale * static_cast<float>(q.x - p.x), scale * static_cast<float>(q.y - p.y),
                     0.5F + 0.5F * scale * rho_[m]};
    };
    Pull pull;
    const unsigned count = work_.valence[n];
    const ImproveWorkspace::Ring &ring = work_.rings[n];
    if (ring[0] != 0) {
        const auto place = [&](unsigned k) { return n + static_cast<std::size_t>(std::ptrdiff_t{ring[k]}); };
        const Spoke first = spokeTo(place(0));
        Spoke spoke = first;
        for (unsigned k = 1; k < count; ++k) {
            const Spoke next = spokeTo(place(k));
            pull.add(spoke, next);
            spoke = next;
        }
        pull.add(spoke, first);
    } else {
        work_.aroundFree(NodeId{static_cast<std::uint32_t>(n)},
                         [&](HalfEdge h) { pull.add(spokeTo(index(work_.to(h))), spokeTo(index(work_.apex(h)))); });
    }
    const float shape = rho * aims.shape / pull.weight;
    const float spacing = rho * aims.spacing / static_cast<float>(count);
    return {shape * pull.x + spacing * pull.springX, shape * pull.y + spacing * pull.springY};
}

/// Calls put(node, move) for all nodes. The move of a fixed node is zero.
template <class Put>
void NodeSmoother::moveAll(const Vec2 *places, const SmoothingAims &aims, const std::stop_token &stop,
                           const Put &put) const {
    constexpr Move kStay{-0.0F, -0.0F}; // changes nothing when added, not even the sign of a zero
    work_.pool.forChunks(
        now_.size(), ImproveWorkspace::kChunk,
        [&](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t n = begin; n < end; ++n) {
                put(n, work_.isFree(n) ? moveOf(places, n, aims) : kStay);
            }
        },
        stop);
}

/// Moves all nodes from their positions in the mesh.
void NodeSmoother::moveFirst(const SmoothingAims &aims, const std::stop_token &stop) {
    const Vec2 *from = work_.mesh.nodes.data();
    moveAll(from, aims, stop, [this, from](std::size_t n, Move move) {
        now_[n] = {from[n].x + static_cast<double>(move.x), from[n].y + static_cast<double>(move.y)};
    });
}

/// Moves all nodes at once from their current positions. The moves are kept in the memory of α.
void NodeSmoother::moveAgain(const SmoothingAims &aims, const std::stop_token &stop) {
    RawVector<float> &moves = work_.alpha;
    moves.resize(2 * now_.size());
    moveAll(now_.data(), aims, stop, [to = moves.data()](std::size_t n, Move move) {
        to[2 * n] = move.x;
        to[2 * n + 1] = move.y;
    });
    work_.pool.forChunks(
        now_.size(), ImproveWorkspace::kChunk,
        [&](std::size_t begin, std::size_t end, std::size_t) {
            const float *move = moves.data() + 2 * begin;
            for (Vec2 *p = now_.data() + begin; p != now_.data() + end; ++p, move += 2) {
                p->x += static_cast<double>(move[0]);
                p->y += static_cast<double>(move[1]);
            }
        },
        stop);
    moves.resize(work_.mesh.elements.size());
}

double NodeSmoother::alphaNow(const Element &n) const {
    return shapeFactor(now(n[0]), now(n[1]), now(n[2]));
}

/// Returns true if an element fell below the floor and got worse. An element whose nodes are all back is not degraded.
bool NodeSmoother::degraded(std::size_t e, double alpha, double floor) const {
    if (alpha >= floor && alpha > kCertainAlpha) {
        return false;
    }
    const Element &n = work_.mesh.elements[e];
    return !(alpha >= work_.alphaOf(e) && surelyPositive(alpha, now(n[0]), now(n[1]), now(n[2])));
}

/// Finds the degraded elements and updates α.
std::vector<std::uint32_t> NodeSmoother::findDegraded(double floor, const std::stop_token &stop) {
    const std::size_t count = work_.mesh.elements.size();
    std::vector<std::vector<std::uint32_t>> found((count + ImproveWorkspace::kChunk - 1) / ImproveWorkspace::kChunk);
    work_.pool.forChunks(
        count, ImproveWorkspace::kChunk,
        [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t e = begin; e < end; ++e) {
                const double alpha = alphaNow(work_.mesh.elements[e]);
                work_.alpha[e] = static_cast<float>(alpha);
                if (degraded(e, alpha, floor)) {
                    found[chunk].push_back(static_cast<std::uint32_t>(e));
                }
            }
        },
        stop);
    std::vector<std::uint32_t> list;
    for (const std::vector<std::uint32_t> &some : found) {
        list.insert(list.end(), some.begin(), some.end());
    }
    return list;
}

std::size_t NodeSmoother::restoreDegraded(std::vector<std::uint32_t> list, double floor, const std::stop_token &stop) {
    std::size_t back = 0;
    while (!list.empty() && !stop.stop_requested()) {
        const std::uint32_t e = list.back();
        list.pop_back();
        const double alpha = alphaNow(work_.mesh.elements[e]);
        work_.alpha[e] = static_cast<float>(alpha);
        if (!degraded(e, alpha, floor)) {
            continue;
        }
        for (const NodeId n : work_.mesh.elements[e]) {
            if (work_.isFree(n) && !(now(n) == work_.at(n))) {
                now_[index(n)] = work_.at(n);
                ++back;
                work_.aroundFree(n, [&](HalfEdge h) { list.push_back(static_cast<std::uint32_t>(elementOf(h))); });
            }
        }
    }
    return back;
}

void NodeSmoother::report(ImproveChange change) const {
    if (work_.watch != nullptr) {
        work_.watch->changed(change, work_.mesh, {now_.data(), now_.size()}, {});
    }
}

void NodeSmoother::finish() {
    work_.pool.forChunks(now_.size(), ImproveWorkspace::kChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::copy(now_.data() + begin, now_.data() + end, work_.mesh.nodes.data() + begin);
    });
}

std::size_t NodeSmoother::sweep(int count, const SmoothingAims &aims, double floor, const Progress &progress) {
    for (int i = 0; i < count && !progress.cancelled(); ++i) {
        if (i == 0) {
            moveFirst(aims, progress.stop);
        } else {
            moveAgain(aims, progress.stop);
        }
        if (!progress.cancelled()) {
            report(ImproveChange::Sweep);
        }
    }
    if (count <= 0 || progress.cancelled()) {
        return 0;
    }
    const std::size_t back = restoreDegraded(findDegraded(floor, progress.stop), floor, progress.stop);
    if (progress.cancelled()) {
        return 0;
    }
    report(ImproveChange::Restore);
    finish();
    return static_cast<std::size_t>(std::count(work_.fixed.begin(), work_.fixed.end(), std::uint8_t{0})) - back;
}

} // namespace forefront
