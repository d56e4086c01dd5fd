#include "core/engine/quads/recombine.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/mesh_domain.hpp"
#include "core/engine/mesh/orientation.hpp"
#include "core/engine/mesh/triangulated.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/quads/quad_mesh.hpp"
#include "core/engine/quads/walk_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Pairs that are worse, by their scaled Jacobian, are left to the walks: corners of 170 degrees.
constexpr double kWorstPair = 0.17;

/// The elements of a mesh as cells, with the edges and nodes that must stay.
struct GivenCells {
    std::vector<QuadCell> cells;
    std::vector<std::uint32_t> faces;  ///< per cell: index into `regions`
    std::vector<std::int32_t> regions; ///< tags
    std::vector<std::array<std::uint32_t, 2>> kept;
    std::vector<std::uint32_t> fixed;
};

std::uint32_t number(NodeId node) {
    return static_cast<std::uint32_t>(node);
}

GivenCells cellsOf(const MeshView &mesh, const EdgeTable &table) {
    GivenCells given;
    std::map<std::int32_t, std::uint32_t> regions;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> corners = mesh.cornersOf(e);
        QuadCell cell = kNoCell;
        std::transform(corners.begin(), corners.end(), cell.begin(), number);
        given.cells.push_back(cell);
        const auto [region, isNew] =
            regions.try_emplace(mesh.region(e), static_cast<std::uint32_t>(given.regions.size()));
        if (isNew) {
            given.regions.push_back(mesh.region(e));
        }
        given.faces.push_back(region->second);
    }
    const HalfEdges &sides = table.halfEdges();
    table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> both) {
        if (both.size() == 1 || given.faces[sides.elementOf(both[0])] != given.faces[sides.elementOf(both[1])]) {
            given.kept.push_back({number(a), number(b)});
        }
    });
    for (const TaggedEdge &edge : mesh.edges) {
        given.kept.push_back({number(std::min(edge.a, edge.b)), number(std::max(edge.a, edge.b))});
    }
    std::sort(given.kept.begin(), given.kept.end());
    given.kept.erase(std::unique(given.kept.begin(), given.kept.end()), given.kept.end());
    for (const TaggedNode &point : mesh.points) {
        given.fixed.push_back(number(point.node));
    }
    return given;
}

/// A pair of triangles and the quadrilateral that they make.
struct TrianglePair {
    double shape; ///< scaled Jacobian
    std::uint32_t first, second;
    QuadCell cell;
};

/// Returns the pairs that are worth joining, the best ones first.
std::vector<TrianglePair> pairsOf(const MeshView &mesh, const EdgeTable &table, const GivenCells &given) {
    std::vector<TrianglePair> pairs;
    const HalfEdges &sides = table.halfEdges();
    table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> both) {
        const std::array<std::uint32_t, 2> ends = {number(a), number(b)};
        if (both.size() != 2 || std::binary_search(given.kept.begin(), given.kept.end(), ends)) {
            return;
        }
        const auto e = static_cast<std::uint32_t>(sides.elementOf(both[0])),
                   f = static_cast<std::uint32_t>(sides.elementOf(both[1]));
        if (!isTriangle(given.cells[e]) || !isTriangle(given.cells[f])) {
            return;
        }
        const HalfEdge next = sides.next(both[0]);
        const QuadCell cell = {number(sides.startOf(next)), number(sides.endOf(next)), number(sides.startOf(both[0])),
                               number(sides.endOf(sides.next(both[1])))};
        if (const double shape = scaledJacobian(cell, mesh.nodes); shape >= kWorstPair) {
            pairs.push_back({shape, e, f, cell});
        }
    });
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const TrianglePair &p, const TrianglePair &q) { return p.shape > q.shape; });
    return pairs;
}

/// Joins the best pairs.
void joinPairs(const MeshView &mesh, const EdgeTable &table, GivenCells &given) {
    for (const TrianglePair &pair : pairsOf(mesh, table, given)) {
        QuadCell &first = given.cells[pair.first], &second = given.cells[pair.second];
        if (isAlive(first) && isTriangle(first) && isAlive(second) && isTriangle(second)) {
            first = pair.cell;
            second = kNoCell;
        }
    }
    std::size_t kept = 0;
    for (std::size_t c = 0; c < given.cells.size(); ++c) {
        if (isAlive(given.cells[c])) {
            given.cells[kept] = given.cells[c];
            given.faces[kept++] = given.faces[c];
        }
    }
    given.cells.resize(kept);
    given.faces.resize(kept);
}

/// Returns the node spacing of quadrilaterals as large as two triangles, from the mean area around each node.
Result<std::shared_ptr<const SpacingField>> spacingOfMesh(const Mesh &mesh) {
    const TriMesh triangles = takeTriangulated(Mesh(mesh)).mesh;
    auto background = std::make_shared<BackgroundMesh>();
    background->nodes = triangles.nodes;
    std::vector<double> areas(triangles.nodes.size(), 0.0);
    std::vector<std::uint32_t> counts(triangles.nodes.size(), 0);
    for (const Element &t : triangles.elements) {
        background->elements.push_back({number(t[0]), number(t[1]), number(t[2])});
        const Vec2 a = triangles.nodes[index(t[0])];
        const double twice = cross(triangles.nodes[index(t[1])] - a, triangles.nodes[index(t[2])] - a);
        for (const NodeId n : t) {
            areas[index(n)] += twice;
            ++counts[index(n)];
        }
    }
    const double any = mesh.bounds().diagonal();
    for (std::size_t n = 0; n < areas.size(); ++n) { // nodes of no element have no meaning
        background->values.push_back(counts[n] > 0 ? std::sqrt(areas[n] / counts[n]) : any);
    }
    const Result<MeshDomain> outline = domainOfMesh(mesh);
    if (!outline) {
        return outline.faults();
    }
    SpacingSpec spec;
    spec.background = std::move(background);
    return SpacingField::build(spec, outline->domain);
}

/// Divides quadrilaterals with a corner of 180 degrees or more, which lie between lines that must stay, into the better
/// triangles.
void divideNotConvex(QuadWorkspace &work) {
    const std::size_t count = work.cells.size();
    for (std::uint32_t c = 0; c < count; ++c) {
        const QuadCell q = work.cells[c];
        if (!isAlive(q) || isTriangle(q)) {
            continue;
        }
        const auto half = [&](unsigned k) { return QuadCell{q[k & 3], q[(k + 1) & 3], q[(k + 2) & 3], kNoIndex}; };
        const auto isLeft = [&](unsigned k) {
            return orientation(work.nodes[q[k & 3]], work.nodes[q[(k + 1) & 3]], work.nodes[q[(k + 2) & 3]]) > 0;
        };
        if (isLeft(0) && isLeft(1) && isLeft(2) && isLeft(3)) {
            continue;
        }
        const auto least = [&](unsigned k) {
            return isLeft(k) && isLeft(k + 2)
                       ? std::min(scaledJacobian(half(k), work.nodes), scaledJacobian(half(k + 2), work.nodes))
                       : -1.0;
        };
        const unsigned k = least(0) >= least(1) ? 0 : 1;
        const std::uint32_t face = work.faceOf(c), added = work.newCell();
        work.take(c);
        work.put(c, half(k), face);
        work.put(added, half(k + 2), face);
    }
}

/// Replaces the elements of a mesh by those of a workspace, without nodes that nothing uses.
void replaceElements(Mesh &mesh, const QuadWorkspace &work, std::span<const std::int32_t> regions) {
    std::vector<std::uint8_t> used(work.nodes.size(), 0);
    const auto use = [&](NodeId n) { used[index(n)] = 1; };
    for (const TaggedEdge &edge : mesh.edges) {
        use(edge.a);
        use(edge.b);
    }
    for (const TaggedNode &point : mesh.points) {
        use(point.node);
    }
    std::vector<NodeId> numbers(work.nodes.size(), kNoNode);
    std::vector<Vec2> nodes;
    for (std::uint32_t n = 0; n < work.nodes.size(); ++n) {
        if (used[n] != 0 || work.valence(n) > 0) {
            numbers[n] = NodeId{static_cast<std::uint32_t>(nodes.size())};
            nodes.push_back(work.nodes[n]);
        }
    }
    mesh.nodes = std::move(nodes);
    mesh.blocks.clear();
    for (const bool triangles : {true, false}) {
        for (std::uint32_t c = 0; c < work.cells.size(); ++c) {
            const QuadCell &cell = work.cells[c];
            if (!isAlive(cell) || isTriangle(cell) != triangles) {
                continue;
            }
            std::array<NodeId, 4> corners{};
            for (unsigned k = 0; k < cornersOf(cell); ++k) {
                corners[k] = numbers[cell[k]];
            }
            CellBlock &block = mesh.block(triangles ? CellKind::Triangle3 : CellKind::Quadrilateral4);
            block.add(std::span(corners).first(cornersOf(cell)));
            block.regions.push_back(regions[work.faceOf(c)]);
        }
    }
    for (TaggedEdge &edge : mesh.edges) {
        edge.a = numbers[index(edge.a)];
        edge.b = numbers[index(edge.b)];
    }
    for (TaggedNode &point : mesh.points) {
        point.node = numbers[index(point.node)];
    }
}

void countCells(const QuadWorkspace &work, QuadReport &report) {
    for (const QuadCell &cell : work.cells) {
        report.triangles += isAlive(cell) && isTriangle(cell) ? 1U : 0U;
        report.quadrilaterals += isAlive(cell) && !isTriangle(cell) ? 1U : 0U;
    }
    for (std::uint32_t n = 0; n < work.nodes.size(); ++n) {
        if (work.valence(n) > 0 && !work.isFixed(n)) {
            ++report.innerNodes;
            report.irregularNodes += work.valence(n) != 4 ? 1U : 0U;
        }
    }
}

} // namespace

Result<QuadReport> recombine(Mesh &mesh, ImproveLevel improve, const Progress &progress) {
    if (MeshView(mesh).hasSecondOrder()) {
        return error("not-first-order", "the mesh has elements of second order; expected first order",
                     "split its elements into triangles of 3 nodes");
    }
    const auto goesOn = [&](double fraction) {
        progress("joining triangles", fraction);
        return !progress.cancelled();
    };
    if (Diagnostics faults = verify(mesh); hasErrors(faults)) {
        return faults;
    }
    if (!goesOn(0.2)) {
        return cancelled("recombining");
    }
    Mesh right = isClockwise(mesh) ? turned(mesh) : mesh;
    const Result<std::shared_ptr<const SpacingField>> spacing = spacingOfMesh(right);
    if (!spacing) {
        return spacing.faults();
    }
    if (!goesOn(0.5)) {
        return cancelled("recombining");
    }
    GivenCells given;
    {
        const EdgeTable table(right);
        given = cellsOf(right, table);
        if (!goesOn(0.7)) {
            return cancelled("recombining");
        }
        joinPairs(right, table, given);
    }
    QuadMesh quads;
    quads.elements =
        QuadWorkspace(right.nodes, std::move(given.cells), std::move(given.faces), given.kept, given.fixed, **spacing);
    if (!goesOn(0.9)) {
        return cancelled("recombining");
    }
    joinTriangles(quads.elements);
    MeshingOptions options;
    options.elements = Elements::Quads;
    options.improve = improve;
    if (improve != ImproveLevel::None) {
        cleanUp(quads, **spacing, options, progress);
    }
    if (progress.cancelled()) {
        return cancelled("recombining");
    }
    divideNotConvex(quads.elements);
    replaceElements(right, quads.elements, given.regions);
    countCells(quads.elements, quads.report);
    if (Diagnostics faults = verify(right); hasErrors(faults)) {
        Diagnostics failed =
            error("not-recombined", "no valid quadrilaterals were found at a place: " + faults.front().message,
                  "improve the triangles there, or keep them");
        failed.front().at = faults.front().at;
        return failed;
    }
    mesh = std::move(right);
    return quads.report;
}

} // namespace forefront
