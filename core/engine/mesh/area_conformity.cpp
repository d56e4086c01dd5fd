#include "core/engine/mesh/area_conformity.hpp"

#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace forefront {

namespace {

/// Integrates the conformity over triangles: at their centres, and where that shows that a triangle is much larger or
/// smaller than the spacing, at the centres of its parts. Evaluates ρ in blocks.
class AreaIntegral {
  public:
    explicit AreaIntegral(const SpacingField &spacing) : spacing_(spacing) {}

    /// Adds a triangle that lies in an element of this size.
    void add(Vec2 a, Vec2 b, Vec2 c, double size) {
        waiting_.push_back({{a, b, c}, size, 0});
        while (waiting_.size() >= kBlock) {
            integrate();
        }
    }
    double mean() {
        while (!waiting_.empty()) {
            integrate();
        }
        return area_ > 0.0 ? sum_ / area_ : 0.0;
    }

  private:
    struct Part {
        std::array<Vec2, 3> corners;
        double size;
        int divisions;
    };
    static constexpr std::size_t kBlock = 512;
    // Where an element follows a graded spacing, its centre stands for all of it. One that does not is divided into up
    // to 64 parts.
    static constexpr double kFollows = 0.8;
    static constexpr int kMaxDivisions = 3;

    /// Takes the last parts that wait, and adds them up or divides them.
    void integrate() {
        const std::size_t count = std::min(waiting_.size(), kBlock);
        std::copy(waiting_.end() - static_cast<std::ptrdiff_t>(count), waiting_.end(), block_.begin());
        waiting_.resize(waiting_.size() - count);
        for (std::size_t k = 0; k < count; ++k) {
            const auto &[a, b, c] = block_[k].corners;
            centres_[k] = (1.0 / 3.0) * (a + b + c);
        }
        spacing_.atMany({centres_.data(), count}, {rho_.data(), count});
        for (std::size_t k = 0; k < count; ++k) {
            take(block_[k], spacingConformity(block_[k].size, rho_[k]));
        }
    }

    void take(const Part &part, double conformity) {
        const auto &[a, b, c] = part.corners;
        if (conformity < kFollows && part.divisions < kMaxDivisions) {
            const Vec2 ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
            for (const std::array<Vec2, 3> &corners :
                 {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}}) {
                waiting_.push_back({corners, part.size, part.divisions + 1});
            }
            return;
        }
        const double area = 0.5 * std::abs(cross(b - a, c - a));
        sum_ += area * conformity;
        area_ += area;
    }

    const SpacingField &spacing_;
    std::vector<Part> waiting_;
    std::array<Part, kBlock> block_;
    std::array<Vec2, kBlock> centres_;
    std::array<double, kBlock> rho_;
    double sum_ = 0.0, area_ = 0.0;
};

void addTriangles(const MeshView &mesh, const MeshView::Block &block, AreaIntegral &integral) {
    const NodeId *const end = block.connectivity.data() + block.connectivity.size();
    for (const NodeId *n = block.connectivity.data(); n != end; n += 3) {
        const Vec2 a = mesh.nodes[index(n[0])], b = mesh.nodes[index(n[1])], c = mesh.nodes[index(n[2])];
        if (const double twice = cross(b - a, c - a); twice > 0.0) {
            integral.add(a, b, c, std::sqrt(2.0 * twice / std::numbers::sqrt3));
        }
    }
}

/// Adds elements of any kind as the triangles of their corners.
void addCells(const MeshView &mesh, const MeshView::Block &block, AreaIntegral &integral) {
    for (std::size_t k = 0; k < block.size(); ++k) {
        const PlacedCell cell(block, k, mesh.nodes);
        const double twice = twiceArea(cell);
        if (!(twice > 0.0)) {
            continue;
        }
        const std::span<const Vec2> corners = cell.corners();
        const double size = std::sqrt(corners.size() == 3 ? 2.0 * twice / std::numbers::sqrt3 : 0.5 * twice);
        for (std::size_t i = 2; i < corners.size(); ++i) {
            integral.add(corners[0], corners[i - 1], corners[i], size);
        }
    }
}

} // namespace

double conformityOverArea(const MeshView &mesh, const SpacingField &spacing) {
    AreaIntegral integral(spacing);
    for (const MeshView::Block &block : mesh.blocks()) {
        block.kind == CellKind::Triangle3 ? addTriangles(mesh, block, integral) : addCells(mesh, block, integral);
    }
    return integral.mean();
}

} // namespace forefront
