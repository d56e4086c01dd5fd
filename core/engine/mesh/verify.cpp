#include "core/engine/mesh/verify.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/base/out_of_memory.hpp"
#include "core/engine/geometry/flat.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mesh/coverage.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/fault_list.hpp"
#include "core/engine/mesh/orientation.hpp"
#include "core/engine/mesh/topology.hpp"

#include <algorithm>

namespace forefront {

namespace {

std::uint32_t number(NodeId node) {
    return static_cast<std::uint32_t>(node);
}

/// A mesh with the numbers that messages use.
struct NumberedMesh {
    const TriMesh &mesh;
    const MeshNumbers &numbers;

    std::string node(NodeId n) const { return std::to_string(numbers.nodes.of(index(n))); }
    std::string edge(NodeId a, NodeId b) const { return node(a) + '-' + node(b); }
    std::string element(std::size_t e) const { return "element " + std::to_string(numbers.elements.of(e)); }
};
Vec2 centroid(const TriMesh &mesh, const Element &e) {
    const Vec2 a = mesh.nodes[index(e[0])];
    return a + (1.0 / 3.0) * ((mesh.nodes[index(e[1])] - a) + (mesh.nodes[index(e[2])] - a));
}
Vec2 middle(const TriMesh &mesh, NodeId a, NodeId b) {
    return midpoint(mesh.nodes[index(a)], mesh.nodes[index(b)]);
}

void checkIndices(const NumberedMesh &named, FaultList &faults) {
    const TriMesh &mesh = named.mesh;
    const std::size_t n = mesh.nodes.size();
    if (mesh.elements.size() > kNoIndex / 3U || n >= kNoIndex) {
        faults.add("bad-index", "the mesh has more nodes or elements than can be numbered");
        return;
    }
    if (!mesh.regions.empty() && mesh.regions.size() != mesh.elements.size()) {
        faults.add("bad-index", "the mesh has " + std::to_string(mesh.elements.size()) + " elements but " +
                                    std::to_string(mesh.regions.size()) + " region tags");
    }
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        for (const NodeId node : mesh.elements[e]) {
            if (index(node) >= n) {
                faults.add("bad-index", named.element(e) + " refers to node " + std::to_string(index(node)) +
                                            ", which does not exist");
            }
        }
    }
    for (const TaggedEdge &edge : mesh.edges) {
        if (index(edge.a) >= n || index(edge.b) >= n) {
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
    const TriMesh &mesh = named.mesh;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (!isFinite(mesh.nodes[n])) {
            faults.add("non-finite",
                       "node " + named.node(NodeId{static_cast<std::uint32_t>(n)}) +
                           " has a coordinate that is not finite",
                       mesh.nodes[n], {static_cast<std::uint32_t>(n)});
        }
    }
}

/// Adds a fault for each element that refers to a node twice, since its sides cannot be followed. Returns false if
/// there are any.
bool checkNodesDistinct(const NumberedMesh &named, FaultList &faults) {
    const TriMesh &mesh = named.mesh;
    const std::size_t before = faults.errors();
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element &n = mesh.elements[e];
        if (n[0] == n[1] || n[1] == n[2] || n[2] == n[0]) {
            const NodeId twice = n[0] == n[1] ? n[0] : n[2];
            faults.add("repeated-node",
                       named.element(e) + " refers to node " + named.node(twice) +
                           " twice; expected three different nodes",
                       mesh.nodes[index(twice)], {static_cast<std::uint32_t>(e)});
        }
    }
    return faults.errors() == before;
}

void checkAreas(const NumberedMesh &named, FaultList &faults) {
    const TriMesh &mesh = named.mesh;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element &n = mesh.elements[e];
        const Vec2 a = mesh.nodes[index(n[0])], b = mesh.nodes[index(n[1])], c = mesh.nodes[index(n[2])];
        if (!isFlat(a, b, c)) {
            continue;
        }
        const auto id = static_cast<std::uint32_t>(e);
        const int sign = orientation(a, b, c);
        if (sign < 0) {
            faults.add("inverted-element", named.element(e) + " is clockwise", centroid(mesh, n), {id});
        } else if (sign == 0) {
            faults.add("zero-area", named.element(e) + " has zero area", centroid(mesh, n), {id});
        } else {
            faults.warn("flat-element",
                        named.element(e) + " is flat: its area is not larger than what rounding its nodes changes",
                        centroid(mesh, n), {id});
        }
    }
}

/// Returns the half-edges of the boundary. Adds a fault for each edge with more than two elements, or with two on one
/// side.
std::vector<HalfEdge> checkEdges(const NumberedMesh &named, const EdgeTable &table, FaultList &faults) {
    const TriMesh &mesh = named.mesh;
    std::vector<HalfEdge> boundary;
    table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        if (sides.size() == 1) {
            boundary.push_back(sides[0]);
        } else if (sides.size() > 2) {
            faults.add("non-conforming",
                       "edge " + named.edge(a, b) + " belongs to " + std::to_string(sides.size()) + " elements",
                       middle(mesh, a, b), {number(a), number(b)});
        } else if (startOf(mesh, sides[0]) == startOf(mesh, sides[1])) {
            faults.add("non-conforming", "edge " + named.edge(a, b) + " has two elements on the same side",
                       middle(mesh, a, b), {number(a), number(b)});
        }
    });
    return boundary;
}

void checkTagged(const NumberedMesh &named, const EdgeTable &table, FaultList &faults) {
    const TriMesh &mesh = named.mesh;
    for (const TaggedEdge &edge : mesh.edges) {
        if (table.find(edge.a, edge.b).empty()) {
            faults.add("missing-tagged-edge",
                       "tagged edge " + named.edge(edge.a, edge.b) + " (tag " + std::to_string(edge.tag) +
                           ") is not an edge of any element",
                       middle(mesh, edge.a, edge.b), {number(edge.a), number(edge.b)});
        }
    }
}

void checkNodesUsed(const NumberedMesh &named, FaultList &faults) {
    const TriMesh &mesh = named.mesh;
    std::vector<bool> used(mesh.nodes.size(), false);
    for (const Element &element : mesh.elements) {
        for (const NodeId node : element) {
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
                    mesh.nodes[index(first)], {number(first)});
    }
}

void checkCoverage(const NumberedMesh &named, const std::vector<HalfEdge> &boundary, FaultList &faults) {
    const TriMesh &mesh = named.mesh;
    const Coverage found = coverage(mesh, boundary);
    for (const HangingNode &h : found.hanging) {
        faults.add("hanging-node", "node " + named.node(h.node) + " lies inside edge " + named.edge(h.edgeA, h.edgeB),
                   mesh.nodes[index(h.node)], {number(h.node), number(h.edgeA), number(h.edgeB)});
    }
    if (found.overlap) {
        faults.add("overlapping", "elements overlap", *found.overlap);
    }
}

/// Counts the parts of the mesh that are connected across edges.
std::int64_t countParts(const TriMesh &mesh, const std::vector<std::array<ElementId, 3>> &neighbours) {
    std::vector<bool> seen(mesh.elements.size(), false);
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
            for (const ElementId f : neighbours[e]) {
                if (f != kNoElement && !seen[index(f)]) {
                    seen[index(f)] = true;
                    open.push_back(static_cast<std::uint32_t>(f));
                }
            }
        }
    }
    return parts;
}

/// Counts the closed loops of the boundary. At each node a loop turns through the elements around it.
std::int64_t countLoops(const TriMesh &mesh, const std::vector<HalfEdge> &boundary,
                        const std::vector<std::array<ElementId, 3>> &neighbours) {
    std::vector<bool> walked(3 * mesh.elements.size(), false);
    std::int64_t loops = 0;
    for (const HalfEdge first : boundary) {
        if (walked[first]) {
            continue;
        }
        ++loops;
        for (HalfEdge h = first; !walked[h];) {
            walked[h] = true;
            const NodeId turn = endOf(mesh, h);
            std::size_t e = elementOf(h);
            unsigned k = (sideOf(h) + 1U) % 3U;
            while (neighbours[e][k] != kNoElement) {
                e = index(neighbours[e][k]);
                k = mesh.elements[e][0] == turn ? 0U : mesh.elements[e][1] == turn ? 1U : 2U;
            }
            h = static_cast<HalfEdge>(3 * e + k);
        }
    }
    return loops;
}

/// Checks Euler's formula for a planar mesh, V - E + T = 2·parts - boundary loops, where a node at which the boundary
/// meets itself counts once for each visit. The formula fails for a mesh with handles or pinched at an inner node.
void checkEuler(const TriMesh &mesh, const EdgeTable &table, const std::vector<HalfEdge> &boundary, FaultList &faults) {
    std::vector<std::uint32_t> visits(mesh.nodes.size(), 0);
    for (const HalfEdge h : boundary) {
        ++visits[index(startOf(mesh, h))];
    }
    std::vector<bool> used(mesh.nodes.size(), false);
    for (const Element &element : mesh.elements) {
        for (const NodeId node : element) {
            used[index(node)] = true;
        }
    }
    std::int64_t nodes = 0, edges = 0;
    for (std::size_t n = 0; n < used.size(); ++n) {
        nodes += used[n] ? std::max<std::int64_t>(1, visits[n]) : 0;
    }
    table.forEach([&edges](NodeId, NodeId, std::span<const HalfEdge>) { ++edges; });
    const std::vector<std::array<ElementId, 3>> neighbours = elementNeighbours(mesh);
    const std::int64_t is = nodes - edges + static_cast<std::int64_t>(mesh.elements.size());
    const std::int64_t must = 2 * countParts(mesh, neighbours) - countLoops(mesh, boundary, neighbours);
    if (is != must) {
        faults.add("euler",
                   "nodes - edges + elements is " + std::to_string(is) + "; Euler's formula gives " +
                       std::to_string(must),
                   mesh.bounds().centre());
    }
}

/// Checks a mesh whose nodes exist, are finite, and of which each element has three.
void checkSound(const NumberedMesh &named, FaultList &faults) {
    const TriMesh &mesh = named.mesh;
    checkAreas(named, faults);
    const EdgeTable table(mesh);
    const std::size_t before = faults.errors();
    const std::vector<HalfEdge> boundary = checkEdges(named, table, faults);
    const bool conforming = faults.errors() == before;
    checkTagged(named, table, faults);
    if (conforming) {
        checkCoverage(named, boundary, faults);
        checkEuler(mesh, table, boundary, faults);
    }
    checkNodesUsed(named, faults);
}

Diagnostics verifyAlone(const TriMesh &mesh, std::size_t limit, const MeshNumbers &numbers) {
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
    const std::size_t count = mesh.elements.size();
    Diagnostic turnedMesh;
    turnedMesh.severity = Severity::Warning;
    turnedMesh.code = "clockwise";
    turnedMesh.message = "the mesh is turned the other way: its " + countText(count, "element") +
                         (count == 1 ? " is" : " are all") + " clockwise; expected counter-clockwise";
    turnedMesh.advice = "reverse the order of the nodes of each element, or mirror the mesh";
    const TriMesh other = turned(mesh);
    checkSound({other, numbers}, faults);
    Diagnostics found = faults.take();
    found.insert(found.begin(), std::move(turnedMesh));
    return found;
}

} // namespace

Diagnostics verify(const TriMesh &mesh, std::size_t limit, const MeshNumbers &numbers) {
    return orOutOfMemory("to check the mesh", [&] { return verifyAlone(mesh, limit, numbers); });
}

} // namespace forefront
