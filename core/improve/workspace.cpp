#include "core/improve/workspace.hpp"

#include "core/geometry/predicates.hpp"
#include "core/mesh/edge_table.hpp"
#include "core/mesh/quality.hpp"

namespace forefront {

namespace {

ElementId elementId(HalfEdge h) {
    return ElementId{static_cast<std::uint32_t>(elementOf(h))};
}

/// Joins the elements of each edge; edges of the boundary, between regions and those that do not conform are held.
void joinElements(ImproveWorkspace &work, const EdgeTable &table) {
    const Mesh &mesh = work.mesh;
    table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        const bool simple = sides.size() == 2 && startOf(mesh, sides[0]) != startOf(mesh, sides[1]);
        if (simple) {
            work.neighbours[elementOf(sides[0])][sideOf(sides[0])] = elementId(sides[1]);
            work.neighbours[elementOf(sides[1])][sideOf(sides[1])] = elementId(sides[0]);
        }
        if (!simple || mesh.region(elementOf(sides[0])) != mesh.region(elementOf(sides[1]))) {
            work.fixed[index(a)] = work.fixed[index(b)] = 1;
            for (const HalfEdge h : sides) {
                work.locked[elementOf(h)] |= static_cast<std::uint8_t>(1U << sideOf(h));
            }
        }
    });
}

void holdTagged(ImproveWorkspace &work, const EdgeTable &table) {
    for (const TaggedEdge &edge : work.mesh.edges) {
        work.fixed[index(edge.a)] = work.fixed[index(edge.b)] = 1;
        for (const HalfEdge h : table.find(edge.a, edge.b)) {
            work.locked[elementOf(h)] |= static_cast<std::uint8_t>(1U << sideOf(h));
        }
    }
    for (const TaggedNode &point : work.mesh.points) {
        work.fixed[index(point.node)] = 1;
    }
}

} // namespace

ImproveWorkspace::ImproveWorkspace(Mesh &improved)
    : mesh(improved), neighbours(mesh.elements.size(), {kNoElement, kNoElement, kNoElement}),
      locked(mesh.elements.size(), 0), fixed(mesh.nodes.size(), 0), valence(mesh.nodes.size(), 0) {
    const EdgeTable table(mesh);
    joinElements(*this, table);
    holdTagged(*this, table);
    for (const Element &element : mesh.elements) {
        for (const NodeId n : element) {
            addValence(n, +1);
        }
    }
}

double alphaOf(const Mesh &mesh, std::size_t e) {
    const Element &n = mesh.elements[e];
    return shapeFactor(mesh.nodes[index(n[0])], mesh.nodes[index(n[1])], mesh.nodes[index(n[2])]);
}

bool surelyPositive(double alpha, Vec2 a, Vec2 b, Vec2 c) {
    return alpha > kCertainAlpha || (alpha > -kCertainAlpha && orientation(a, b, c) > 0);
}

} // namespace forefront
