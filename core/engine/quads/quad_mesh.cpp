#include "core/engine/quads/quad_mesh.hpp"

#include "core/engine/base/key_order.hpp"
#include "core/engine/geometry/flat.hpp"
#include "core/engine/grid/all_grids.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/quads/coloured_front.hpp"
#include "core/engine/quads/pairing.hpp"
#include "core/engine/quads/quad_cleanup.hpp"
#include "core/engine/quads/quad_smooth.hpp"
#include "core/engine/quads/walk_triangles.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {

namespace {

constexpr std::uint32_t kRowsBeforeLattice = 2;
constexpr double kCellPerLength = 12.0; ///< as of the fast method
/// Cost of a mesh that another front is not worth trying for.
constexpr double kGoodEnough = 0.02;
/// Quadrilaterals whose scaled Jacobian is lower are divided if triangles are allowed: a corner of 20 or 160 degrees.
constexpr double kDivideBelow = 0.35;

QuadEffort effortFor(ImproveLevel level) {
    return level == ImproveLevel::Best ? QuadEffort{4, 4, 4, 6, 4, true} : QuadEffort{};
}

/// Joins the triangles of a finished front.
QuadWorkspace joined(FrontState &&state, std::vector<std::uint8_t> colours, const QuadRequest &request) {
    TriMesh triangles;
    triangles.nodes = std::move(state.nodes);
    triangles.elements = std::move(state.elements);
    const DiscreteDomain &domain = request.boundary.domain;
    std::vector<std::uint64_t> kept;
    for (const std::uint32_t s : request.boundary.oneColoured) {
        const auto [a, b] = std::minmax(domain.segments[s].a, domain.segments[s].b);
        kept.push_back(pairKey(a, b));
    }
    std::sort(kept.begin(), kept.end());
    const bool mixed = request.options.elements == Elements::Mixed;
    PairedCells cells =
        pairTriangles(std::move(triangles), std::move(colours), std::move(state.elementFaces), kept, mixed);
    std::vector<std::array<std::uint32_t, 2>> tagged;
    tagged.reserve(domain.segments.size());
    for (const DiscreteSegment &s : domain.segments) {
        tagged.push_back({s.a, s.b});
    }
    std::vector<std::uint32_t> fixedNodes;
    for (const ConstraintPoint &point : domain.taggedPoints()) {
        fixedNodes.push_back(point.node);
    }
    QuadWorkspace mesh(std::move(cells.nodes), std::move(cells.cells), std::move(cells.faces), tagged, fixedNodes,
                       request.spacing);
    if (!mixed) {
        joinTriangles(mesh);
    }
    return mesh;
}

/// Returns the share of irregular nodes plus half of what the sides miss of the spacing. The second counts since rings
/// that shrink have few irregular nodes but the wrong size.
double costOf(const QuadWorkspace &mesh) {
    std::size_t nodes = 0, irregular = 0, sides = 0;
    double conformity = 0.0;
    for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
        if (mesh.valence(n) > 0) {
            ++nodes;
            irregular += mesh.isIrregular(n) ? 1U : 0U;
        }
    }
    for (const QuadCell &cell : mesh.cells) {
        for (unsigned k = 0; isAlive(cell) && k < cornersOf(cell); ++k) {
            const std::uint32_t a = cell[k], b = nextCorner(cell, k);
            conformity += spacingConformity(distance(mesh.nodes[a], mesh.nodes[b]),
                                            0.5 * (double{mesh.rho[a]} + double{mesh.rho[b]}));
            ++sides;
        }
    }
    const auto share = [](auto part, std::size_t whole) {
        return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
    };
    return share(irregular, nodes) + 0.5 * (1.0 - share(conformity, sides));
}

/// Runs one front. Returns false when cancelled or stopped.
template <class Grid>
bool runFront(const QuadRequest &request, std::uint32_t rows, QuadMesh &mesh, const Progress &progress, double from) {
    constexpr std::uint64_t kBatch = 4096;
    const MeshingOptions &options = request.options;
    ColouredFront<Grid> front(
        request.boundary, request.spacing,
        Grid::create({request.boundary.domain, request.spacing, options.gridColumns, options.gridRows, kCellPerLength}),
        rows);
    FrontState &state = front.state();
    const auto expected = static_cast<std::size_t>(Mesher::kReserve * request.estimatedElements) + 1024;
    state.elements.reserve(expected);
    state.nodes.reserve(state.nodes.size() + expected / 2);
    for (std::uint64_t count = 0; front.advance(); ++count) {
        const std::uint64_t batch = std::clamp<std::uint64_t>(10'000'000 / (state.front.segments() + 1), 16, kBatch);
        if (count % batch != 0) {
            continue;
        }
        if (progress.cancelled() || state.elements.size() / 2 > request.maxElements) {
            return false;
        }
        const double share = static_cast<double>(state.elements.size()) / (request.estimatedElements + 1.0);
        progress("advancing the front", from + 0.49 * std::min(1.0, share));
    }
    const ColouredWork &work = front.work();
    mesh.report.rows = work.rows;
    mesh.report.openings = work.openings;
    mesh.report.closings = work.closings;
    mesh.report.searched = work.searched;
    mesh.report.lattice = rows != FrontLayers::kAllRows;
    mesh.work = state.work;
    mesh.elements = joined(std::move(state), std::move(front.colours()), request);
    return true;
}

bool runFrontOn(GridKind grid, const QuadRequest &request, std::uint32_t rows, QuadMesh &mesh, const Progress &progress,
                double from) {
#define FOREFRONT_RUN_ON(unused, Grid)                                                                                 \
    case Grid::kKind:                                                                                                  \
        return runFront<Grid>(request, rows, mesh, progress, from);
    switch (grid) { FOREFRONT_FOR_EACH_GRID(FOREFRONT_RUN_ON, ) }
#undef FOREFRONT_RUN_ON
    return false;
}

/// Divides poor quadrilaterals by the diagonal that makes the better triangles.
void dividePoor(QuadWorkspace &mesh) {
    const std::size_t count = mesh.cells.size();
    for (std::uint32_t c = 0; c < count; ++c) {
        const QuadCell q = mesh.cells[c];
        if (!isAlive(q) || isTriangle(q) || mesh.shapeOf(c) >= kDivideBelow) {
            continue;
        }
        const auto half = [&](unsigned k) { return QuadCell{q[k], q[(k + 1) & 3], q[(k + 2) & 3], kNoIndex}; };
        const auto least = [&](unsigned k) {
            return std::min(scaledJacobian(half(k), mesh.nodes), scaledJacobian(half((k + 2) & 3), mesh.nodes));
        };
        const unsigned k = least(0) >= least(1) ? 0 : 1;
        if (least(k) <= 0.0) {
            continue;
        }
        const std::uint32_t face = mesh.faceOf(c), added = mesh.newCell();
        mesh.take(c);
        mesh.put(c, half(k), face);
        mesh.put(added, half((k + 2) & 3), face);
    }
}

/// Lists the quadrilaterals with a flat or reflex corner, within rounding.
void listNotConvex(const QuadWorkspace &mesh, QuadReport &report) {
    report.notConvexAt.clear();
    for (const QuadCell &cell : mesh.cells) {
        for (unsigned k = 0; isAlive(cell) && !isTriangle(cell) && k < 4; ++k) {
            if (isFlat(mesh.nodes[cell[(k + 3) & 3]], mesh.nodes[cell[k]], mesh.nodes[cell[(k + 1) & 3]])) {
                report.notConvexAt.push_back(mesh.nodes[cell[k]]);
                break;
            }
        }
    }
    report.notConvex = report.notConvexAt.size();
}

void countNodes(const QuadWorkspace &mesh, QuadReport &report) {
    report.innerNodes = report.irregularNodes = 0;
    for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
        if (mesh.valence(n) > 0 && !mesh.isFixed(n)) {
            ++report.innerNodes;
            report.irregularNodes += mesh.valence(n) != 4 ? 1U : 0U;
        }
    }
}

} // namespace

bool advanceColoured(const QuadRequest &request, QuadMesh &mesh, const Progress &progress) {
    const GridKind grid = request.options.grid;
    if (!runFrontOn(grid, request, FrontLayers::kAllRows, mesh, progress, 0.0)) {
        return false;
    }
    if (const double cost = costOf(mesh.elements); cost > kGoodEnough) {
        QuadMesh other;
        if (!runFrontOn(grid, request, kRowsBeforeLattice, other, progress, 0.5)) {
            return false;
        }
        if (costOf(other.elements) < cost) {
            mesh = std::move(other);
        }
    }
    mesh.report.addedNodes = request.boundary.added;
    mesh.report.oddEdges = request.boundary.oneColoured.size();
    return true;
}

bool cleanUp(QuadMesh &mesh, const SpacingField &spacing, const MeshingOptions &options, const Progress &progress) {
    QuadCleanup cleanup(mesh.elements, spacing, effortFor(options.improve));
    const bool done = cleanup.run(progress);
    mesh.report.changes = cleanup.changes();
    if (options.elements == Elements::Mixed) {
        dividePoor(mesh.elements);
    }
    return done;
}

Mesh toMesh(QuadMesh &&mesh, const DiscreteDomain &boundary, QuadReport &report) {
    QuadWorkspace &work = mesh.elements;
    report = mesh.report;
    countNodes(work, report);
    listNotConvex(work, report);
    TriMesh tags;
    addTags(tags, boundary, {});
    tags.regions.clear();
    // Nodes of the boundary keep their numbers.
    std::vector<std::uint32_t> numbers(work.nodes.size(), kNoIndex);
    for (std::uint32_t n = 0; n < work.nodes.size(); ++n) {
        if (n < boundary.nodes.size() || work.valence(n) > 0) {
            numbers[n] = static_cast<std::uint32_t>(tags.nodes.size());
            tags.nodes.push_back(work.nodes[n]);
        }
    }
    Mesh result(std::move(tags));
    result.blocks.clear();
    CellBlock triangles(CellKind::Triangle3), quads(CellKind::Quadrilateral4);
    for (std::uint32_t c = 0; c < work.cells.size(); ++c) {
        const QuadCell &cell = work.cells[c];
        if (!isAlive(cell)) {
            continue;
        }
        std::array<NodeId, 4> nodes{};
        for (unsigned k = 0; k < cornersOf(cell); ++k) {
            nodes[k] = NodeId{numbers[cell[k]]};
        }
        CellBlock &block = isTriangle(cell) ? triangles : quads;
        block.add(std::span(nodes).first(cornersOf(cell)));
        block.regions.push_back(boundary.regions.empty() ? 1 : boundary.regions[work.faceOf(c)].tag);
    }
    report.triangles = triangles.size();
    report.quadrilaterals = quads.size();
    for (CellBlock *block : {&triangles, &quads}) {
        if (block->size() > 0) {
            result.blocks.push_back(std::move(*block));
        }
    }
    return result;
}

} // namespace forefront
