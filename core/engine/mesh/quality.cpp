#include "core/engine/mesh/quality.hpp"

#include "core/engine/mesh/area_conformity.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/shape_tally.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

namespace forefront {

double shapeFactor(Vec2 a, Vec2 b, Vec2 c) {
    const Vec2 ab = b - a, ac = c - a, bc = c - b;
    const double sum = lengthSquared(ab) + lengthSquared(ac) + lengthSquared(bc);
    return sum > 0.0 ? 2.0 * std::numbers::sqrt3 * cross(ab, ac) / sum : 0.0;
}

double spacingConformity(double segmentLength, double rho) {
    return segmentLength < rho ? segmentLength / rho : rho / segmentLength;
}

std::vector<float> shapeFactors(const MeshView &mesh) {
    std::vector<float> alpha(mesh.elementCount());
    const Vec2 *const places = mesh.nodes.data();
    for (const MeshView::Block &block : mesh.blocks()) {
        float *value = alpha.data() + block.first;
        if (block.kind == CellKind::Triangle3) {
            const NodeId *const end = block.connectivity.data() + block.connectivity.size();
            for (const NodeId *n = block.connectivity.data(); n != end; n += 3) {
                *value++ =
                    static_cast<float>(shapeFactor(places[index(n[0])], places[index(n[1])], places[index(n[2])]));
            }
        } else {
            for (std::size_t k = 0; k < block.size(); ++k) {
                *value++ = static_cast<float>(shapeFactor(PlacedCell(block, k, mesh.nodes)));
            }
        }
    }
    return alpha;
}

namespace {

/// Accumulates the mean of δ over segments and evaluates ρ in blocks.
class ConformityMean {
  public:
    explicit ConformityMean(const SpacingField &spacing) : spacing_(spacing) {}
    void add(Vec2 a, Vec2 b) {
        middles_[used_] = midpoint(a, b);
        lengths_[used_] = distance(a, b);
        if (++used_ == kBlock) {
            flush();
        }
    }
    double mean() {
        flush();
        return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_);
    }

  private:
    static constexpr std::size_t kBlock = 512;

    void flush() {
        std::array<double, kBlock> rho;
        spacing_.atMany({middles_.data(), used_}, {rho.data(), used_});
        for (std::size_t i = 0; i < used_; ++i) {
            sum_ += spacingConformity(lengths_[i], rho[i]);
        }
        count_ += used_;
        used_ = 0;
    }

    const SpacingField &spacing_;
    std::array<Vec2, kBlock> middles_;
    std::array<double, kBlock> lengths_;
    std::size_t used_ = 0, count_ = 0;
    double sum_ = 0.0;
};

void measureShapes(const MeshView &mesh, MeshQuality &quality) {
    ShapeTally tally;
    const Vec2 *const places = mesh.nodes.data();
    for (const MeshView::Block &block : mesh.blocks()) {
        if (block.kind == CellKind::Triangle3) {
            const NodeId *const end = block.connectivity.data() + block.connectivity.size();
            for (const NodeId *n = block.connectivity.data(); n != end; n += 3) {
                tally.add(places[index(n[0])], places[index(n[1])], places[index(n[2])]);
            }
        } else {
            for (std::size_t k = 0; k < block.size(); ++k) {
                tally.add(PlacedCell(block, k, mesh.nodes));
            }
        }
    }
    tally.into(quality);
}

void measurePercentiles(const MeshView &mesh, MeshQuality &quality) {
    std::vector<float> alpha = shapeFactors(mesh);
    quality.alpha50 = percentile(alpha, 0.50);
    quality.alpha5 = percentile(alpha, 0.05);
    quality.alpha1 = percentile(alpha, 0.01);
}

/// Counts the elements of a block at their corners.
template <std::size_t Corners>
void countCorners(const MeshView::Block &block, std::vector<std::uint32_t> &counts) {
    const std::size_t step = block.traits().nodes;
    for (const NodeId *n = block.connectivity.data(), *end = n + block.connectivity.size(); n != end; n += step) {
        for (std::size_t k = 0; k < Corners; ++k) {
            ++counts[index(n[k])];
        }
    }
}

void measureEdges(const MeshView &mesh, const SpacingField *spacing, MeshQuality &quality) {
    std::optional<ConformityMean> conformity;
    if (spacing != nullptr) {
        conformity.emplace(*spacing);
    }
    std::vector<bool> onBoundary(mesh.nodes.size(), false);
    EdgeTable(mesh).forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        ++quality.edges;
        if (sides.size() == 1) {
            onBoundary[index(a)] = onBoundary[index(b)] = true;
        }
        if (conformity) {
            conformity->add(mesh.nodes[index(a)], mesh.nodes[index(b)]);
        }
    });
    quality.deltaMean = conformity ? conformity->mean() : 0.0;

    std::vector<std::uint32_t> elementsAt(mesh.nodes.size(), 0);
    for (const MeshView::Block &block : mesh.blocks()) {
        block.traits().corners == 3 ? countCorners<3>(block, elementsAt) : countCorners<4>(block, elementsAt);
    }
    for (std::size_t n = 0; n < elementsAt.size(); ++n) {
        if (!onBoundary[n] && elementsAt[n] > 0) {
            ++quality.valence[std::min<std::size_t>(elementsAt[n], quality.valence.size() - 1)];
        }
    }
}

} // namespace

MeshQuality measureQuality(const MeshView &mesh, const SpacingField *spacing) {
    MeshQuality quality;
    quality.nodes = mesh.nodes.size();
    quality.elements = mesh.elementCount();
    if (mesh.elementCount() == 0) {
        return quality;
    }
    measureShapes(mesh, quality);
    measurePercentiles(mesh, quality);
    measureEdges(mesh, spacing, quality);
    quality.deltaAreaMean = spacing != nullptr ? conformityOverArea(mesh, *spacing) : 0.0;
    return quality;
}

} // namespace forefront
