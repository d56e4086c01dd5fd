#include "core/improve/smooth.hpp"

#include "core/mesh/quality.hpp"

namespace forefront {

namespace {

bool free(const ImproveWorkspace &work, std::size_t n) {
    return work.fixed[n] == 0 && work.valence[n] > 0 && work.valence[n] != ImproveWorkspace::kManyElements;
}

/// Where the nodes would like to be. Around an inner node each neighbour is met in two elements; summing differences
/// keeps all digits far from the origin.
void meansOfNeighbours(const ImproveWorkspace &work, std::vector<Vec2> &targets) {
    const Mesh &mesh = work.mesh;
    targets.assign(mesh.nodes.size(), {});
    for (const Element &e : mesh.elements) {
        const std::size_t i = index(e[0]), j = index(e[1]), k = index(e[2]);
        const Vec2 a = mesh.nodes[i], b = mesh.nodes[j], c = mesh.nodes[k];
        const Vec2 ab = b - a, bc = c - b, ca = a - c;
        targets[i] += ab - ca;
        targets[j] += bc - ab;
        targets[k] += ca - bc;
    }
    for (std::size_t n = 0; n < targets.size(); ++n) {
        targets[n] = free(work, n) ? mesh.nodes[n] + (0.5 / work.valence[n]) * targets[n] : mesh.nodes[n];
    }
}

/// Puts nodes of spoilt elements back until none is spoilt: an element with all nodes back is as it was.
void putBackWhereSpoilt(const ImproveWorkspace &work, double floor, std::vector<Vec2> &targets) {
    const Mesh &mesh = work.mesh;
    enum : std::uint8_t { Quiet = 0, Now = 1, Next = 2 };
    std::vector<std::uint8_t> changed(mesh.nodes.size(), Now);
    for (bool again = true; again;) {
        again = false;
        for (const Element &e : mesh.elements) {
            const std::size_t i = index(e[0]), j = index(e[1]), k = index(e[2]);
            if (((changed[i] | changed[j] | changed[k]) & Now) == 0) {
                continue;
            }
            const double alpha = shapeFactor(targets[i], targets[j], targets[k]);
            if (alpha >= floor && alpha > kCertainAlpha) {
                continue;
            }
            const double before = shapeFactor(mesh.nodes[i], mesh.nodes[j], mesh.nodes[k]);
            if (alpha >= before && surelyPositive(alpha, targets[i], targets[j], targets[k])) {
                continue;
            }
            for (const std::size_t n : {i, j, k}) {
                if (!(targets[n] == mesh.nodes[n])) {
                    targets[n] = mesh.nodes[n];
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

} // namespace

std::size_t smoothNodes(ImproveWorkspace &work, double floor, std::vector<Vec2> &scratch) {
    meansOfNeighbours(work, scratch);
    putBackWhereSpoilt(work, floor, scratch);
    std::size_t moved = 0;
    for (std::size_t n = 0; n < scratch.size(); ++n) {
        moved += scratch[n] == work.mesh.nodes[n] ? 0U : 1U;
    }
    std::swap(work.mesh.nodes, scratch);
    return moved;
}

} // namespace forefront
