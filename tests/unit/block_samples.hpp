#pragma once

#include "core/engine/mesh/mesh.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace forefront::samples {

/// Makes meshes of any kinds of cells from their corners. The middle node of an edge is made once, in the middle of its
/// chord, and is shared by all cells and tagged edges that have it; so is no node between a cell of first order and one
/// of second order, which therefore must not share an edge.
class BlockMaker {
  public:
    explicit BlockMaker(std::vector<Vec2> corners) { mesh.nodes = std::move(corners); }

    /// Adds a cell. `corners`: 3 or 4 of them, counter-clockwise, as the kind has.
    void add(CellKind kind, const std::vector<NodeId> &corners, std::int32_t region = 1) {
        std::vector<NodeId> nodes = corners;
        const CellTraits &traits = traitsOf(kind);
        if (traits.order == 2) {
            for (std::size_t k = 0; k < corners.size(); ++k) {
                nodes.push_back(middleOf(corners[k], corners[(k + 1) % corners.size()]));
            }
        }
        if (traits.nodes > nodes.size()) {
            Vec2 sum;
            for (const NodeId corner : corners) {
                sum += mesh.nodes[index(corner)];
            }
            nodes.push_back(node(mesh.nodes.size()));
            mesh.nodes.push_back((1.0 / static_cast<double>(corners.size())) * sum);
        }
        CellBlock &block = mesh.block(kind);
        block.add(nodes);
        block.regions.push_back(region);
    }
    /// Adds a tagged edge, of 3 nodes if the cells beside it are of second order. They must have been added before.
    void tag(NodeId a, NodeId b, std::int32_t tag) {
        const auto middle = middles_.find(std::minmax(a, b));
        mesh.edges.push_back({a, b, tag, middle == middles_.end() ? kNoNode : middle->second});
    }

    Mesh mesh;

  private:
    NodeId middleOf(NodeId a, NodeId b) {
        const auto [place, isNew] = middles_.try_emplace(std::minmax(a, b), node(mesh.nodes.size()));
        if (isNew) {
            const Vec2 from = mesh.nodes[index(a)], to = mesh.nodes[index(b)];
            mesh.nodes.push_back(midpoint(from, to));
        }
        return place->second;
    }

    std::map<std::pair<NodeId, NodeId>, NodeId> middles_;
};

/// Returns the nodes of a grid of `columns` x `rows` cells over [0,1]² moved by `offset`, row by row; inner nodes
/// displaced by up to `jitter` cells (below 0.25 nothing folds).
inline std::vector<Vec2> gridNodes(std::size_t columns, std::size_t rows, double jitter = 0.0, Vec2 offset = {},
                                   std::uint64_t seed = 1) {
    return square(columns, rows, jitter, offset, seed).nodes;
}

/// Returns the square [0,1]² as columns x rows cells, each of them a quadrilateral or two triangles. Regions: 1 "left"
/// below half the columns, 2 "right" beyond. Boundary edges: 1 "bottom", 2 "right", 3 "top", 4 "left"; the interface
/// between the regions has the tag 5, and two corners are tagged points. `kindOf(i, j)` returns the kind of the cell in
/// column i and row j.
template <class KindOf>
Mesh gridOfCells(std::size_t columns, std::size_t rows, KindOf &&kindOf, double jitter = 0.0, Vec2 offset = {},
                 std::uint64_t seed = 1) {
    BlockMaker maker(gridNodes(columns, rows, jitter, offset, seed));
    const auto at = [columns](std::size_t i, std::size_t j) { return node(j * (columns + 1) + i); };
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            const NodeId a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            const CellKind kind = kindOf(i, j);
            const std::int32_t region = 2 * i < columns ? 1 : 2;
            if (traitsOf(kind).corners == 4) {
                maker.add(kind, {a, b, c, d}, region);
            } else if ((i + j) % 2 == 0) {
                maker.add(kind, {a, b, c}, region);
                maker.add(kind, {a, c, d}, region);
            } else {
                maker.add(kind, {a, b, d}, region);
                maker.add(kind, {b, c, d}, region);
            }
        }
    }
    for (std::size_t i = 0; i < columns; ++i) {
        maker.tag(at(i, 0), at(i + 1, 0), 1);
        maker.tag(at(i + 1, rows), at(i, rows), 3);
    }
    for (std::size_t j = 0; j < rows; ++j) {
        maker.tag(at(columns, j), at(columns, j + 1), 2);
        maker.tag(at(0, j + 1), at(0, j), 4);
        if (columns > 1) {
            maker.tag(at((columns + 1) / 2, j), at((columns + 1) / 2, j + 1), 5);
        }
    }
    maker.mesh.points = {{at(0, 0), 7}, {at(columns, rows), 8}};
    maker.mesh.boundaryNames = {{1, "bottom"}, {2, "right"}, {3, "top"}, {4, "left"}, {5, "interface"}};
    maker.mesh.regionNames = {{1, "left half"}, {2, "right half"}};
    return std::move(maker.mesh);
}

/// Returns a valid mesh of one kind of cells, of 4 x 3 cells as in gridOfCells, its edges straight.
inline Mesh sampleMesh(CellKind kind) {
    return gridOfCells(
        4, 3, [kind](std::size_t, std::size_t) { return kind; }, 0.15);
}

/// Returns a valid mesh of triangles and quadrilaterals of 4 nodes, of 4 x 3 cells as in gridOfCells.
inline Mesh mixedSample() {
    return gridOfCells(
        4, 3,
        [](std::size_t i, std::size_t j) {
            return (i + 2 * j) % 3 == 0 ? CellKind::Triangle3 : CellKind::Quadrilateral4;
        },
        0.15);
}

/// Returns a valid mesh of triangles of 6 nodes and quadrilaterals of 8 and 9, of 4 x 3 cells as in gridOfCells, its
/// edges straight.
inline Mesh secondOrderSample() {
    return gridOfCells(
        4, 3,
        [](std::size_t i, std::size_t j) {
            return (i + 2 * j) % 3 == 0   ? CellKind::Triangle6
                   : (i + 2 * j) % 3 == 1 ? CellKind::Quadrilateral8
                                          : CellKind::Quadrilateral9;
        },
        0.15);
}

/// Returns a mesh with all its nodes, those in the middles of edges too, moved by a smooth map that bends straight
/// lines: by up to `amount` times the sine of π times the other coordinate. Below 0.2 a square stays well shaped.
inline Mesh bent(Mesh mesh, double amount) {
    constexpr double kPi = 3.14159265358979323846;
    for (Vec2 &p : mesh.nodes) {
        p = {p.x + amount * std::sin(kPi * p.y), p.y - amount * std::sin(kPi * p.x)};
    }
    return mesh;
}

/// Returns one mesh of several, which share no nodes. Tags and names of later ones add to those of earlier ones.
inline Mesh joined(const std::vector<Mesh> &parts) {
    Mesh all;
    for (const Mesh &part : parts) {
        const std::size_t shift = all.nodes.size();
        const auto moved = [shift](NodeId id) { return id == kNoNode ? id : node(index(id) + shift); };
        all.nodes.insert(all.nodes.end(), part.nodes.begin(), part.nodes.end());
        for (const CellBlock &from : part.blocks) {
            CellBlock &to = all.block(from.kind());
            for (std::size_t e = 0; e < from.size(); ++e) {
                std::vector<NodeId> nodes;
                for (const NodeId id : from.nodesOf(e)) {
                    nodes.push_back(moved(id));
                }
                to.add(nodes);
                to.regions.push_back(from.regions.empty() ? 1 : from.regions[e]);
            }
        }
        for (const TaggedEdge &edge : part.edges) {
            all.edges.push_back({moved(edge.a), moved(edge.b), edge.tag, moved(edge.middle)});
        }
        for (const TaggedNode &point : part.points) {
            all.points.push_back({moved(point.node), point.tag});
        }
        all.boundaryNames.insert(part.boundaryNames.begin(), part.boundaryNames.end());
        all.regionNames.insert(part.regionNames.begin(), part.regionNames.end());
    }
    return all;
}

/// Returns a valid mesh with cells of all kinds: that of mixedSample() and, bent and two units to the right of it, that
/// of secondOrderSample().
inline Mesh allKindsSample() {
    Mesh second = bent(secondOrderSample(), 0.1);
    for (Vec2 &p : second.nodes) {
        p += {2.0, 0.0};
    }
    return joined({mixedSample(), second});
}

} // namespace forefront::samples
