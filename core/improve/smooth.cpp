#include "core/improve/smooth.hpp"

#include "core/mesh/quality.hpp"

namespace forefront {

namespace {

bool isFree(const ImproveWorkspace &work, std::size_t n) {
    return work.fixed[n] == 0 && work.valence[n] > 0 && work.valence[n] != ImproveWorkspace::kManyElements;
}

/// Part of the pull that springs take back.
constexpr double kSpring = 0.5;
/// Way gone along the mean pull; more than 1 because the springs weaken it.
constexpr double kStep = 1.4;

} // namespace

NodeSmoother::NodeSmoother(ImproveWorkspace &work)
    : work_(work), lengths_(work.mesh.nodes.size(), 0.0F), targets_(work.mesh.nodes.size()) {
    const Mesh &mesh = work.mesh;
    // An inner edge is met from both of its elements, so each node meets twice as many ends of edges as elements.
    std::vector<std::uint32_t> ends(mesh.nodes.size(), 0);
    for (const Element &e : mesh.elements) {
        for (unsigned k = 0; k < 3; ++k) {
            const std::size_t i = index(e[k]), j = index(e[(k + 1) % 3]);
            const auto edge = static_cast<float>(distance(mesh.nodes[i], mesh.nodes[j]));
            lengths_[i] += edge;
            lengths_[j] += edge;
            ++ends[i];
            ++ends[j];
        }
    }
    for (std::size_t n = 0; n < ends.size(); ++n) {
        lengths_[n] /= static_cast<float>(ends[n] > 0 ? ends[n] : 1);
    }
}

/// Sums differences of coordinates, which keep all their digits far from the origin.
void NodeSmoother::findTargets() {
    const Mesh &mesh = work_.mesh;
    targets_.assign(mesh.nodes.size(), {});
    const auto pull = [&](std::size_t from, std::size_t to) {
        const Vec2 edge = mesh.nodes[to] - mesh.nodes[from];
        const double rest = 0.5 * static_cast<double>(lengths_[from] + lengths_[to]);
        return (1.0 - kSpring * rest / length(edge)) * edge;
    };
    for (const Element &e : mesh.elements) {
        const std::size_t i = index(e[0]), j = index(e[1]), k = index(e[2]);
        const Vec2 ij = pull(i, j), jk = pull(j, k), ki = pull(k, i);
        targets_[i] += ij - ki;
        targets_[j] += jk - ij;
        targets_[k] += ki - jk;
    }
    for (std::size_t n = 0; n < targets_.size(); ++n) {
        const double share = isFree(work_, n) ? kStep / (2.0 * work_.valence[n]) : 0.0;
        targets_[n] = share > 0.0 ? mesh.nodes[n] + share * targets_[n] : mesh.nodes[n];
    }
}

/// Puts nodes of spoilt elements back until none is spoilt: an element with all nodes back is as it was.
void NodeSmoother::putBackWhereSpoilt(double floor) {
    const Mesh &mesh = work_.mesh;
    enum : std::uint8_t { Now = 1, Next = 2 };
    std::vector<std::uint8_t> changed(mesh.nodes.size(), Now);
    for (bool again = true; again;) {
        again = false;
        for (const Element &e : mesh.elements) {
            const std::size_t i = index(e[0]), j = index(e[1]), k = index(e[2]);
            if (((changed[i] | changed[j] | changed[k]) & Now) == 0) {
                continue;
            }
            const double alpha = shapeFactor(targets_[i], targets_[j], targets_[k]);
            if (alpha >= floor && alpha > kCertainAlpha) {
                continue;
            }
            const double before = shapeFactor(mesh.nodes[i], mesh.nodes[j], mesh.nodes[k]);
            if (alpha >= before && surelyPositive(alpha, targets_[i], targets_[j], targets_[k])) {
                continue;
            }
            for (const std::size_t n : {i, j, k}) {
                if (!(targets_[n] == mesh.nodes[n])) {
                    targets_[n] = mesh.nodes[n];
                    changed[n] |= Next;
                    again = true;
                }
            }
        }
        for (std::uint8_t &c : changed) {
            c = static_cast<std::uint8_t>(c >> 1U);
        }
    }
}

std::size_t NodeSmoother::sweep(double floor) {
    findTargets();
    putBackWhereSpoilt(floor);
    std::size_t moved = 0;
    for (std::size_t n = 0; n < targets_.size(); ++n) {
        moved += targets_[n] == work_.mesh.nodes[n] ? 0U : 1U;
    }
    std::swap(work_.mesh.nodes, targets_);
    return moved;
}

} // namespace forefront
