#include "core/engine/mesh/verify.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/base/out_of_memory.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/coverage.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/fault_list.hpp"
#include "core/engine/mesh/open_lines.hpp"
#include "core/engine/mesh/orientation.hpp"
#include "core/engine/mesh/topology.hpp"
#include "core/engine/mesh/verify_cells.hpp"

#include <algorithm>

namespace forefront {

namespace {

std::uint32_t number(NodeId node) {
    return static_cast<std::uint32_t>(node);
}

/// Returns the half-edges of the boundary. Adds a fault for each edge with more than two elements, or with two on one
/// side.
std::vector<HalfEdge> checkEdges(const NumberedMesh &named, const EdgeTable &table, FaultList &faults) {
    const HalfEdges &halfEdges = table.halfEdges();
    std::vector<HalfEdge> boundary;
    table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        if (sides.size() == 1) {
            boundary.push_back(sides[0]);
        } else if (sides.size() > 2) {
            faults.add("non-conforming",
                       "edge " + named.edge(a, b) + " belongs to " + std::to_string(sides.size()) + " elements",
                       named.middle(a, b), {number(a), number(b)});
        } else if (halfEdges.startOf(sides[0]) == halfEdges.startOf(sides[1])) {
            faults.add("non-conforming", "edge " + named.edge(a, b) + " has two elements on the same side",
                       named.middle(a, b), {number(a), number(b)});
        }
    });
    return boundary;
}

/// Checks that no node in the middle of an edge or element has another use, and that both elements of an edge have the
/// same.
class MiddleNodes {
  public:
    MiddleNodes(const NumberedMesh &named, FaultList &faults)
        : named_(named), faults_(faults), uses_(named.mesh.nodes.size(), Use::None) {}

    void check(const EdgeTable &table) {
        for (const MeshView::Block &block : named_.mesh.blocks()) {
            for (std::size_t k = 0; k < block.size(); ++k) {
                for (const NodeId corner : block.nodesOf(k).first(block.traits().corners)) {
                    uses_[index(corner)] = Use::Corner;
                }
            }
        }
        table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
            const HalfEdges &halfEdges = table.halfEdges();
            const NodeId middle = halfEdges.middleOf(sides[0]);
            for (const HalfEdge side : sides.subspan(1)) {
                if (halfEdges.middleOf(side) != middle) {
                    faults_.add("middle-node",
                                "edge " + named_.edge(a, b) + " has " + nameOf(middle) + " in " +
                                    named_.element(halfEdges.elementOf(sides[0])) + " but " +
                                    nameOf(halfEdges.middleOf(side)) + " in " +
                                    named_.element(halfEdges.elementOf(side)) + "; expected the same in both",
                                named_.middle(a, b), {number(a), number(b)});
                }
            }
            if (middle != kNoNode) {
                claim(middle,
                      [&] { return "the middle node " + named_.node(middle) + " of edge " + named_.edge(a, b); });
            }
        });
        for (const MeshView::Block &block : named_.mesh.blocks()) {
            for (std::size_t k = 0; block.kind == CellKind::Quadrilateral9 && k < block.size(); ++k) {
                const NodeId centre = block.nodesOf(k).back();
                claim(centre, [&] {
                    return "the node " + named_.node(centre) + " in the centre of " + named_.element(block.first + k);
                });
            }
        }
    }

  private:
    enum class Use : std::uint8_t { None, Corner, Middle };

    std::string nameOf(NodeId middle) const {
        return middle == kNoNode ? "no middle node" : "the middle node " + named_.node(middle);
    }
    template <class Name>
    void claim(NodeId node, const Name &name) {
        if (uses_[index(node)] != Use::None) {
            faults_.add("middle-node",
                        name() + (uses_[index(node)] == Use::Corner ? " is a corner of an element, too"
                                                                    : " is in the middle of something else, too"),
                        named_.at(node), {number(node)});
        }
        uses_[index(node)] = Use::Middle;
    }

    const NumberedMesh &named_;
    FaultList &faults_;
    std::vector<Use> uses_; ///< per node
};

void checkTagged(const NumberedMesh &named, const EdgeTable &table, FaultList &faults) {
    for (const TaggedEdge &edge : named.mesh.edges) {
        const std::span<const HalfEdge> sides = table.find(edge.a, edge.b);
        const auto name = [&] {
            return "tagged edge " + named.edge(edge.a, edge.b) + " (tag " + std::to_string(edge.tag) + ')';
        };
        if (sides.empty()) {
            faults.add("missing-tagged-edge", name() + " is not an edge of any element", named.middle(edge.a, edge.b),
                       {number(edge.a), number(edge.b)});
        } else if (edge.middle != kNoNode && table.halfEdges().middleOf(sides[0]) != edge.middle) {
            const NodeId middle = table.halfEdges().middleOf(sides[0]);
            faults.add("middle-node",
                       name() + " has the middle node " + named.node(edge.middle) + "; expected that of its element, " +
                           (middle == kNoNode ? "which has none" : "node " + named.node(middle)),
                       named.at(edge.middle), {number(edge.a), number(edge.b)});
        }
    }
}

void checkNodesUsed(const NumberedMesh &named, FaultList &faults) {
    std::vector<bool> used(named.mesh.nodes.size(), false);
    for (const MeshView::Block &block : named.mesh.blocks()) {
        for (const NodeId node : block.connectivity) {
            used[index(node)] = true;
        }
    }
    const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
    if (count > 0) {
        const NodeId first{static_cast<std::uint32_t>(std::find(used.begin(), used.end(), false) - used.begin())};
        faults.note("unreferenced-node",
                    count == 1
                        ? "node " + named.node(first) + " belongs to no element"
                        : std::to_string(count) + " nodes belong to no element, the first is node " + named.node(first),
                    named.at(first), {number(first)});
    }
}

void checkCoverage(const NumberedMesh &named, const HalfEdges &sides, const std::vector<HalfEdge> &boundary,
                   FaultList &faults) {
    const Coverage found = coverage(named.mesh, sides, boundary);
    for (const HangingNode &h : found.hanging) {
        faults.add("hanging-node", "node " + named.node(h.node) + " lies inside edge " + named.edge(h.edgeA, h.edgeB),
                   named.at(h.node), {number(h.node), number(h.edgeA), number(h.edgeB)});
    }
    if (found.overlap) {
        faults.add("overlapping", "elements overlap", *found.overlap);
    }
}

/// Notes the lines along which elements share no nodes although their edges coincide.
void noteOpenLines(const NumberedMesh &named, const EdgeTable &table, FaultList &faults) {
    for (const OpenLine &line : openLines(named.mesh, table)) {
        const auto name = [&](std::int32_t tag) { return boundaryName(named.mesh.boundaryNames, tag); };
        const std::string names = line.tag == 0     ? "without a name"
                                  : line.other == 0 ? "of " + name(line.tag)
                                                    : "of " + name(line.tag) + " and " + name(line.other);
        faults.note("open-line",
                    countText(line.edges, "edge") + ' ' + names + (line.edges == 1 ? " is" : " are") +
                        " double: the elements on both sides share no nodes there, as at a crack",
                    line.at, {});
    }
}

/// Counts the parts of the mesh that are connected across edges.
std::int64_t countParts(const MeshView &mesh, const HalfEdges &sides, const std::vector<HalfEdge> &opposite) {
    std::vector<bool> seen(mesh.elementCount(), false);
    std::vector<std::uint32_t> open;
    std::int64_t parts = 0;
    for (std::uint32_t first = 0; first < seen.size(); ++first) {
        if (seen[first]) {
            continue;
        }
        ++parts;
        seen[first] = true;
        open.push_back(first);
        while (!open.empty()) {
            const std::uint32_t e = open.back();
            open.pop_back();
            const HalfEdge begin = sides.of(e, 0), end = begin + sides.sidesOf(e);
            for (HalfEdge h = begin; h < end; ++h) {
                if (opposite[h] == kNoHalfEdge) {
                    continue;
                }
                const std::size_t f = sides.elementOf(opposite[h]);
                if (!seen[f]) {
                    seen[f] = true;
                    open.push_back(static_cast<std::uint32_t>(f));
                }
            }
        }
    }
    return parts;
}

/// Counts the closed loops of the boundary. At each node a loop turns through the elements around it.
std::int64_t countLoops(const HalfEdges &sides, const std::vector<HalfEdge> &boundary,
                        const std::vector<HalfEdge> &opposite) {
    std::vector<bool> walked(sides.count(), false);
    std::int64_t loops = 0;
    for (const HalfEdge first : boundary) {
        if (walked[first]) {
            continue;
        }
        ++loops;
        for (HalfEdge h = first; !walked[h];) {
            walked[h] = true;
            h = sides.next(h);
            while (opposite[h] != kNoHalfEdge) {
                h = sides.next(opposite[h]);
            }
        }
    }
    return loops;
}

/// Checks Euler's formula for a planar mesh, V - E + T = 2·parts - boundary loops, where a node at which the boundary
/// meets itself counts once for each visit, and only corners count. The formula fails for a mesh with handles or
/// pinched at an inner node.
void checkEuler(const MeshView &mesh, const EdgeTable &table, const std::vector<HalfEdge> &boundary,
                FaultList &faults) {
    const HalfEdges &halfEdges = table.halfEdges();
    std::vector<std::uint32_t> visits(mesh.nodes.size(), 0);
    for (const HalfEdge h : boundary) {
        ++visits[index(halfEdges.startOf(h))];
    }
    std::vector<bool> used(mesh.nodes.size(), false);
    for (HalfEdge h = 0; h < halfEdges.count(); ++h) {
        used[index(halfEdges.startOf(h))] = true;
    }
    std::int64_t nodes = 0, edges = 0;
    for (std::size_t n = 0; n < used.size(); ++n) {
        nodes += used[n] ? std::max<std::int64_t>(1, visits[n]) : 0;
    }
    table.forEach([&edges](NodeId, NodeId, std::span<const HalfEdge>) { ++edges; });
    const std::vector<HalfEdge> opposite = oppositeHalfEdges(table);
    const std::int64_t is = nodes - edges + static_cast<std::int64_t>(mesh.elementCount());
    const std::int64_t must = 2 * countParts(mesh, halfEdges, opposite) - countLoops(halfEdges, boundary, opposite);
    if (is != must) {
        faults.add("euler",
                   "nodes - edges + elements is " + std::to_string(is) + "; Euler's formula gives " +
                       std::to_string(must),
                   mesh.bounds().centre());
    }
}

/// Checks a mesh whose nodes exist and are finite, and of which no element has one twice.
void checkSound(const NumberedMesh &named, FaultList &faults) {
    checkShapes(named, faults);
    const EdgeTable table(named.mesh);
    const std::size_t before = faults.errors();
    const std::vector<HalfEdge> boundary = checkEdges(named, table, faults);
    const bool conforming = faults.errors() == before;
    if (named.mesh.hasSecondOrder()) {
        MiddleNodes(named, faults).check(table);
    }
    checkTagged(named, table, faults);
    if (conforming) {
        checkCoverage(named, table.halfEdges(), boundary, faults);
        checkEuler(named.mesh, table, boundary, faults);
        noteOpenLines(named, table, faults);
    }
    checkNodesUsed(named, faults);
}

Diagnostics verifyAlone(const MeshView &mesh, std::size_t limit, const MeshNumbers &numbers) {
    FaultList faults(limit);
    const NumberedMesh named{mesh, numbers};
    checkIndices(named, faults);
    if (!faults.clean()) {
        return faults.take();
    }
    checkFinite(named, faults);
    if (!faults.clean()) {
        return faults.take();
    }
    if (!checkNodesDistinct(named, faults)) {
        return faults.take(); // walks around nodes would not end
    }
    if (!isClockwise(mesh)) {
        checkSound(named, faults);
        return faults.take();
    }
    const std::size_t count = mesh.elementCount();
    Diagnostic turnedMesh;
    turnedMesh.severity = Severity::Warning;
    turnedMesh.code = "clockwise";
    turnedMesh.message = "the mesh is turned the other way: its " + countText(count, "element") +
                         (count == 1 ? " is" : " are all") + " clockwise; expected counter-clockwise";
    turnedMesh.advice = "reverse the order of the nodes of each element, or mirror the mesh";
    const Mesh other = turned(copyOf(mesh));
    const MeshView otherView(other);
    checkSound({otherView, numbers}, faults);
    Diagnostics found = faults.take();
    found.insert(found.begin(), std::move(turnedMesh));
    return found;
}

} // namespace

Diagnostics verify(const MeshView &mesh, std::size_t limit, const MeshNumbers &numbers) {
    return orOutOfMemory("to check the mesh", [&] { return verifyAlone(mesh, limit, numbers); });
}

} // namespace forefront
