#include "core/improve/smooth.hpp"

#include "core/mesh/quality.hpp"
#include "core/spacing/spacing_field.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

/// Neighbours are worked on in blocks of so many, which compilers turn into vector instructions.
constexpr unsigned kLanes = 8;
constexpr unsigned kMostLanes = ImproveWorkspace::kMostValence + kLanes;

/// The nodes around a node, relative to it, the first again after the last; then copies of it to the end of a block.
struct Around {
    float x[kMostLanes], y[kMostLanes];
    float rest[kMostLanes]; ///< wanted length of the edge to each
    unsigned count;
};

struct Lanes {
    float used[kLanes], unused[kLanes]; ///< 1 and 0, and the reverse
};

constexpr std::array<Lanes, kLanes + 1> makeMasks() {
    std::array<Lanes, kLanes + 1> masks{};
    for (unsigned count = 0; count <= kLanes; ++count) {
        for (unsigned k = 0; k < kLanes; ++k) {
            masks[count].used[k] = k < count ? 1.0F : 0.0F;
            masks[count].unused[k] = k < count ? 0.0F : 1.0F;
        }
    }
    return masks;
}

constexpr std::array<Lanes, kLanes + 1> kMasks = makeMasks();

/// Always in the same order.
float sum(const float (&v)[kLanes]) {
    return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

/// Σ w·(p* − p), Σ w and the pull of the springs.
struct Pull {
    float x = 0.0F, y = 0.0F, weight = 0.0F, springX = 0.0F, springY = 0.0F;

    void add(const Around &around, unsigned begin) {
        constexpr float kHeight = 0.8660254F; // of the equilateral triangle
        const Lanes &lanes = kMasks[std::min(around.count - begin, kLanes)];
        const float *const qx = around.x + begin, *const qy = around.y + begin, *const rest = around.rest + begin;
        float w[kLanes], tx[kLanes], ty[kLanes], sx[kLanes], sy[kLanes];
        for (unsigned k = 0; k < kLanes; ++k) {
            const float ax = qx[k + 1] - qx[k], ay = qy[k + 1] - qy[k];
            w[k] = lanes.used[k] / (ax * ax + ay * ay + lanes.unused[k]);
            tx[k] = w[k] * (0.5F * (qx[k] + qx[k + 1]) - kHeight * ay);
            ty[k] = w[k] * (0.5F * (qy[k] + qy[k + 1]) + kHeight * ax);
            const float spring = lanes.used[k] * (1.0F - rest[k] / std::sqrt(qx[k] * qx[k] + qy[k] * qy[k]));
            sx[k] = spring * qx[k];
            sy[k] = spring * qy[k];
        }
        x += sum(tx);
        y += sum(ty);
        weight += sum(w);
        springX += sum(sx);
        springY += sum(sy);
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
        Around around;
        for (std::size_t n = begin; n < end; ++n) {
            const Vec2 p = nodes[n];
            if (!work_.isFree(n)) {
                to[n] = p;
                continue;
            }
            const float rho = rho_[n];
            unsigned count = 0;
            const auto take = [&](NodeId m) {
                const Vec2 q = nodes[index(m)];
                around.x[count] = static_cast<float>(q.x - p.x);
                around.y[count] = static_cast<float>(q.y - p.y);
                around.rest[count] = 0.5F * (rho + rho_[index(m)]);
                ++count;
            };
            const unsigned valence = work_.valence[n];
            if (valence <= ImproveWorkspace::kRingNodes) {
                const ImproveWorkspace::Ring &ring = work_.rings[n];
                while (count < valence) {
                    take(ring[count]);
                }
            } else {
                work_.aroundFree(NodeId{static_cast<std::uint32_t>(n)}, [&](HalfEdge h) { take(work_.to(h)); });
            }
            around.count = count;
            const unsigned lanes = (count + kLanes - 1) / kLanes * kLanes;
            for (unsigned k = count; k <= lanes; ++k) {
                around.x[k] = around.x[0];
                around.y[k] = around.y[0];
                around.rest[k] = 0.0F;
            }
            Pull pull;
            for (unsigned k = 0; k < count; k += kLanes) {
                pull.add(around, k);
            }
            const float shape = aims.shape / pull.weight, spacing = aims.spacing / static_cast<float>(count);
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
