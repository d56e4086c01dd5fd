#include "core/improve/smooth.hpp"

#include "core/mesh/quality.hpp"
#include "core/spacing/spacing_field.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

/// A node beside one that may move, relative to it.
struct Spoke {
    float x, y;
    float rest; ///< wanted length of the edge to it
};

/// Σ w·(p* − p), Σ w and the pull of the springs.
struct Pull {
    float x = 0.0F, y = 0.0F, weight = 0.0F, springX = 0.0F, springY = 0.0F;

    /// The element between a spoke and the next, and the spoke's spring.
    void add(const Spoke &spoke, const Spoke &next) {
        constexpr float kHeight = 0.8660254F; // of the equilateral triangle
        const float ax = next.x - spoke.x, ay = next.y - spoke.y;
        const float side = ax * ax + ay * ay; // squared
        const float length = std::sqrt(spoke.x * spoke.x + spoke.y * spoke.y);
        const float inverse = 1.0F / (side * length); // one division for two
        const float w = inverse * length;
        x += w * (0.5F * (spoke.x + next.x) - kHeight * ay);
        y += w * (0.5F * (spoke.y + next.y) + kHeight * ax);
        weight += w;
        const float spring = 1.0F - spoke.rest * (inverse * side);
        springX += spring * spoke.x;
        springY += spring * spoke.y;
    }
};

} // namespace

NodeSmoother::NodeSmoother(ImproveWorkspace &work, const SpacingField *spacing)
    : work_(work), spacing_(spacing), rho_(work.mesh.nodes.size(), 0.0F), next_(work.mesh.nodes.size()) {
    if (spacing_ != nullptr) {
        renewSpacing();
    } else {
        meanLengths();
    }
}

void NodeSmoother::renewSpacing() {
    if (spacing_ == nullptr) {
        return;
    }
    constexpr std::size_t kBlock = 1024;
    const std::vector<Vec2> &nodes = work_.mesh.nodes;
    work_.pool.forChunks(nodes.size(), kBlock, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::array<double, kBlock> rho;
        spacing_->atMany({nodes.data() + begin, end - begin}, {rho.data(), end - begin});
        for (std::size_t n = begin; n < end; ++n) {
            rho_[n] = static_cast<float>(rho[n - begin]);
        }
    });
}

/// An inner edge is met from both of its elements.
void NodeSmoother::meanLengths() {
    const Mesh &mesh = work_.mesh;
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

void NodeSmoother::moveAll(const SmoothingAims &aims, std::vector<Vec2> &to) const {
    const std::vector<Vec2> &nodes = work_.mesh.nodes;
    work_.pool.forChunks(nodes.size(), ImproveWorkspace::kChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t n = begin; n < end; ++n) {
            const Vec2 p = nodes[n];
            if (!work_.isFree(n)) {
                to[n] = p;
                continue;
            }
            const float rho = rho_[n], scale = 1.0F / rho; // lengths in ρ, whose powers stay in the range of floats
            const auto spokeTo = [&](NodeId m) {
                const Vec2 q = nodes[index(m)];
                return Spoke{scale * static_cast<float>(q.x - p.x), scale * static_cast<float>(q.y - p.y),
                             0.5F + 0.5F * scale * rho_[index(m)]};
            };
            Pull pull;
            const unsigned count = work_.valence[n];
            if (count <= ImproveWorkspace::kRingNodes) {
                const ImproveWorkspace::Ring &ring = work_.rings[n];
                const Spoke first = spokeTo(ring[0]);
                Spoke spoke = first;
                for (unsigned k = 1; k < count; ++k) {
                    const Spoke next = spokeTo(ring[k]);
                    pull.add(spoke, next);
                    spoke = next;
                }
                pull.add(spoke, first);
            } else {
                work_.aroundFree(NodeId{static_cast<std::uint32_t>(n)},
                                 [&](HalfEdge h) { pull.add(spokeTo(work_.to(h)), spokeTo(work_.apex(h))); });
            }
            const float shape = rho * aims.shape / pull.weight;
            const float spacing = rho * aims.spacing / static_cast<float>(count);
            to[n] = {p.x + static_cast<double>(shape * pull.x + spacing * pull.springX),
                     p.y + static_cast<double>(shape * pull.y + spacing * pull.springY)};
        }
    });
}

/// An element with all nodes back is as it was, and not spoilt.
bool NodeSmoother::spoilt(std::size_t e, double alpha, double floor) const {
    if (alpha >= floor && alpha > kCertainAlpha) {
        return false;
    }
    const Element &n = work_.mesh.elements[e];
    const double was = shapeFactor(before_[index(n[0])], before_[index(n[1])], before_[index(n[2])]);
    return !(alpha >= was && surelyPositive(alpha, work_.at(n[0]), work_.at(n[1]), work_.at(n[2])));
}

std::size_t NodeSmoother::putBackWhereSpoilt(double floor) {
    const std::size_t count = work_.mesh.elements.size();
    std::vector<std::vector<std::uint32_t>> found((count + ImproveWorkspace::kChunk - 1) / ImproveWorkspace::kChunk);
    work_.pool.forChunks(count, ImproveWorkspace::kChunk, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t e = begin; e < end; ++e) {
            const double alpha = work_.alphaOf(e);
            work_.alpha[e] = static_cast<float>(alpha);
            if (spoilt(e, alpha, floor)) {
                found[chunk].push_back(static_cast<std::uint32_t>(e));
            }
        }
    });
    std::size_t back = 0;
    std::vector<std::uint32_t> list;
    for (const std::vector<std::uint32_t> &some : found) {
        list.insert(list.end(), some.begin(), some.end());
    }
    while (!list.empty()) {
        const std::uint32_t e = list.back();
        list.pop_back();
        const double alpha = work_.alphaOf(e);
        work_.alpha[e] = static_cast<float>(alpha);
        if (!spoilt(e, alpha, floor)) {
            continue;
        }
        for (const NodeId n : work_.mesh.elements[e]) {
            if (work_.isFree(n) && !(work_.at(n) == before_[index(n)])) {
                work_.mesh.nodes[index(n)] = before_[index(n)];
                ++back;
                work_.aroundFree(n, [&](HalfEdge h) { list.push_back(static_cast<std::uint32_t>(elementOf(h))); });
            }
        }
    }
    return back;
}

std::size_t NodeSmoother::sweep(int count, const SmoothingAims &aims, double floor, const Progress &progress) {
    std::vector<Vec2> &nodes = work_.mesh.nodes;
    before_.resize(nodes.size());
    for (int i = 0; i < count; ++i) {
        moveAll(aims, next_);
        if (i == 0) {
            before_.swap(nodes);
        }
        nodes.swap(next_);
        if (progress.cancelled()) {
            nodes = before_;
            return 0;
        }
    }
    const auto free = static_cast<std::size_t>(std::count(work_.fixed.begin(), work_.fixed.end(), std::uint8_t{0}));
    return count > 0 ? free - putBackWhereSpoilt(floor) : 0;
}

} // namespace forefront
