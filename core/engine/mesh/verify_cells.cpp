#include "core/engine/mesh/verify_cells.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/coordinate_range.hpp"
#include "core/engine/geometry/flat.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mesh/jacobian.hpp"
#include "core/engine/mesh/orientation.hpp"

#include <algorithm>
#include <array>

namespace forefront {

namespace {

void checkCounts(const MeshView &mesh, FaultList &faults) {
    std::size_t sides = 0;
    for (const MeshView::Block &block : mesh.blocks()) {
        sides += block.traits().corners * block.size();
        if (!block.regions.empty() && block.regions.size() != block.size()) {
            const std::string parts = mesh.blocks().size() == 1 ? "elements" : block.traits().plural;
            faults.add("bad-index", "the mesh has " + std::to_string(block.size()) + ' ' + parts + " but " +
                                        std::to_string(block.regions.size()) + " region tags");
        }
    }
    if (sides >= kNoIndex || mesh.nodes.size() >= kNoIndex) {
        faults.add("bad-index", "the mesh has more nodes or elements than can be numbered");
    }
}

/// Returns the first node that an element refers to twice, or kNoNode.
NodeId nodeTwice(std::span<const NodeId> nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (std::size_t j = i + 1; j < nodes.size(); ++j) {
            if (nodes[i] == nodes[j]) {
                return nodes[i];
            }
        }
    }
    return kNoNode;
}

const char *numberWord(std::size_t number) {
    constexpr std::array<const char *, kMaxCellNodes + 1> kWords = {"no",   "one", "two",   "three", "four",
                                                                    "five", "six", "seven", "eight", "nine"};
    return kWords[number];
}

/// Returns true if a corner of an element is flat within rounding, or not convex.
bool hasFlatCorner(const PlacedCell &cell) {
    const auto &n = cell.nodes;
    if (cell.traits().corners == 3) {
        return isFlat(n[0], n[1], n[2]);
    }
    return isFlat(n[0], n[1], n[2]) || isFlat(n[1], n[2], n[3]) || isFlat(n[2], n[3], n[0]) || isFlat(n[3], n[0], n[1]);
}

/// Checks the shape of one element after the other.
class ShapeCheck {
  public:
    ShapeCheck(const NumberedMesh &named, FaultList &faults) : named_(named), faults_(faults) {}

    void check(const PlacedCell &cell, std::size_t e) {
        const bool curved = cell.traits().order == 2 && !cell.isStraight();
        if (hasFlatCorner(cell) && !checkSigns(cell, e, curved)) {
            return;
        }
        if (!curved) {
            return;
        }
        if (const std::optional<Vec2> fold = foldIn(cell)) {
            faults_.add("folded-element",
                        named_.element(e) + " is folded: the Jacobian determinant of its map is not positive at " +
                            placeText(*fold) + "; move its middle nodes towards the middles of its edges",
                        *fold, {static_cast<std::uint32_t>(e)});
        }
    }

  private:
    /// Checks an element by the exact signs of its corners. Returns false if it has a fault.
    bool checkSigns(const PlacedCell &cell, std::size_t e, bool curved) {
        const std::span<const NodeId> corners = named_.mesh.cornersOf(e);
        const CornerSigns signs = cornerSigns(named_.mesh.nodes, corners);
        const auto id = static_cast<std::uint32_t>(e);
        if (signs.ofArea() < 0) {
            faults_.add("inverted-element", named_.element(e) + " is clockwise", cell.centre(), {id});
        } else if (signs.ofArea() == 0 && signs.positive < 2) {
            faults_.add("zero-area", named_.element(e) + " has zero area", cell.centre(), {id});
        } else if (signs.ofArea() == 0) {
            faults_.add("concave-element",
                        named_.element(e) + " crosses itself; expected its corners in order around it", cell.centre(),
                        {id});
        } else if (signs.positive < static_cast<int>(corners.size()) && !curved) {
            addConcave(corners, e);
        } else {
            if (!curved || corners.size() == 3) {
                faults_.warn("flat-element",
                             named_.element(e) +
                                 (corners.size() == 3
                                      ? " is flat: its area is within the rounding error of its nodes"
                                      : " is flat at a corner: its angle is 180 degrees within the rounding error of "
                                        "its nodes"),
                             cell.centre(), {id});
            }
            return true;
        }
        return false;
    }

    void addConcave(std::span<const NodeId> corners, std::size_t e) {
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const NodeId before = corners[(k + corners.size() - 1) % corners.size()],
                         after = corners[(k + 1) % corners.size()];
            const int sign = orientation(named_.at(before), named_.at(corners[k]), named_.at(after));
            if (sign <= 0) {
                faults_.add("concave-element",
                            named_.element(e) + " is not convex: its corner at node " + named_.node(corners[k]) +
                                (sign == 0 ? " is flat" : " is reflex") + "; expected angles below 180 degrees",
                            named_.at(corners[k]), {static_cast<std::uint32_t>(e)});
                return;
            }
        }
    }

    const NumberedMesh &named_;
    FaultList &faults_;
};

} // namespace

void checkIndices(const NumberedMesh &named, FaultList &faults) {
    const MeshView &mesh = named.mesh;
    const std::size_t n = mesh.nodes.size();
    checkCounts(mesh, faults);
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t i = 0; i < block.connectivity.size(); ++i) {
            if (index(block.connectivity[i]) >= n) {
                faults.add("bad-index", named.element(block.first + i / block.traits().nodes) + " refers to node " +
                                            std::to_string(index(block.connectivity[i])) + ", which does not exist");
            }
        }
    }
    for (const TaggedEdge &edge : mesh.edges) {
        if (index(edge.a) >= n || index(edge.b) >= n || (edge.middle != kNoNode && index(edge.middle) >= n)) {
            faults.add("bad-index",
                       "tagged edge " + named.edge(edge.a, edge.b) + " refers to a node that does not exist");
        }
    }
    for (const TaggedNode &point : mesh.points) {
        if (index(point.node) >= n) {
            faults.add("bad-index",
                       "tagged point " + std::to_string(index(point.node)) + " refers to a node that does not exist");
        }
    }
}

void checkFinite(const NumberedMesh &named, FaultList &faults) {
    const MeshView &mesh = named.mesh;
    for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
        if (!isFinite(mesh.nodes[n])) {
            faults.add("non-finite", "node " + named.node(NodeId{n}) + " has a coordinate that is not finite",
                       mesh.nodes[n], {n});
        } else if (tooLarge(mesh.nodes[n])) {
            faults.add("out-of-range", "node " + named.node(NodeId{n}) + " has a coordinate beyond 1e60 in magnitude",
                       mesh.nodes[n], {n});
        }
    }
}

bool checkNodesDistinct(const NumberedMesh &named, FaultList &faults) {
    const std::size_t before = faults.errors();
    for (const MeshView::Block &block : named.mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            const NodeId twice = nodeTwice(block.nodesOf(k));
            if (twice != kNoNode) {
                const std::size_t e = block.first + k;
                faults.add("repeated-node",
                           named.element(e) + " refers to node " + named.node(twice) + " twice; expected " +
                               numberWord(block.traits().nodes) + " different nodes",
                           named.at(twice), {static_cast<std::uint32_t>(e)});
            }
        }
    }
    return faults.errors() == before;
}

void checkShapes(const NumberedMesh &named, FaultList &faults) {
    ShapeCheck shapes(named, faults);
    forEachCell(named.mesh, [&](const PlacedCell &cell, std::size_t e) { shapes.check(cell, e); });
}

} // namespace forefront
