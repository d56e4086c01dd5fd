#include "core/engine/quads/quad_mesh.hpp"

#include "core/engine/geometry/flat.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/quads/front_layers.hpp"
#include "core/engine/quads/pairing.hpp"
#include "core/engine/quads/quad_blocks.hpp"
#include "core/engine/quads/quad_cleanup.hpp"
#include "core/engine/quads/quad_refill.hpp"
#include "core/engine/quads/quad_smooth.hpp"
#include "core/engine/quads/walk_triangles.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {

namespace {

/// Cost of a mesh that another front is not worth trying for.
constexpr double kGoodEnough = 0.02;
/// Quadrilaterals whose scaled Jacobian is lower are divided if triangles are allowed: a corner of 20 or 160 degrees.
constexpr double kDivideBelow = 0.35;

QuadEffort effortFor(ImproveLevel level) {
    return level == ImproveLevel::Best ? QuadEffort{4, 4, 4, 6, 4, true} : QuadEffort{};
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
bool runFront(const QuadRequest &request, bool lattice, QuadMesh &mesh, const Progress &progress, double from) {
    constexpr std::uint64_t kBatch = 4096;
    const std::shared_ptr<void> none; // the request outlives the front
    const std::unique_ptr<ColouredMesher> front = ColouredMesher::create(
        std::shared_ptr<const ColouredBoundary>(none, &request.boundary),
        std::shared_ptr<const SpacingField>(none, &request.spacing), request.options, rowsOfFront(lattice));
    front->reserve(static_cast<std::uint64_t>(Mesher::kReserve * request.estimatedElements) + 1024);
    const FrontState &state = front->state();
    do {
        if (progress.cancelled() || state.elements.size() / 2 > request.maxElements) {
            return false;
        }
        const double share = static_cast<double>(state.elements.size()) / (request.estimatedElements + 1.0);
        progress("advancing the front", from + 0.49 * std::min(1.0, share));
    } while (front->advance(std::clamp<std::uint64_t>(10'000'000 / (state.front.segments() + 1), 16, kBatch)) > 0);
    mesh = joinFront(front->takeTriangles(), *front, request.options, nullptr);
    mesh.report.lattice = lattice;
    return true;
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

std::uint32_t rowsOfFront(bool lattice) {
    constexpr std::uint32_t kRowsBeforeLattice = 2;
    return lattice ? kRowsBeforeLattice : FrontLayers::kAllRows;
}

bool advanceColoured(const QuadRequest &request, QuadMesh &mesh, const Progress &progress) {
    if (!runFront(request, false, mesh, progress, 0.0)) {
        return false;
    }
    if (const double cost = costOf(mesh.elements); cost > kGoodEnough) {
        QuadMesh other;
        if (!runFront(request, true, other, progress, 0.5)) {
            return false;
        }
        if (costOf(other.elements) < cost) {
            mesh = std::move(other);
        }
    }
    return true;
}

QuadMesh joinFront(ColouredTriangles triangles, const ColouredMesher &front, const MeshingOptions &options,
                   QuadWatch *watch) {
    const DiscreteDomain &domain = front.boundary();
    const bool mixed = options.elements == Elements::Mixed;
    PairedCells cells = pairTriangles(std::move(triangles), oneColouredEdges(front.colouredBoundary()),
                                      mixed ? OneColoured::Join : OneColoured::Divide);
    std::vector<std::array<std::uint32_t, 2>> tagged;
    tagged.reserve(domain.segments.size());
    for (const DiscreteSegment &s : domain.segments) {
        tagged.push_back({s.a, s.b});
    }
    std::vector<std::uint32_t> fixedNodes;
    for (const ConstraintPoint &point : domain.taggedPoints()) {
        fixedNodes.push_back(point.node);
    }
    QuadMesh mesh;
    mesh.elements = QuadWorkspace(std::move(cells.nodes), std::move(cells.cells), std::move(cells.faces), tagged,
                                  fixedNodes, front.spacing());
    if (watch != nullptr) {
        watch->changed(ImproveChange::Pair, mesh.elements, {});
    }
    if (!mixed) {
        joinTriangles(mesh.elements, watch);
        if (watch != nullptr) {
            watch->changed(ImproveChange::Walk, mesh.elements, {});
        }
    }
    const ColouredWork &work = front.squares();
    mesh.report.rows = work.rows;
    mesh.report.openings = work.openings;
    mesh.report.closings = work.closings;
    mesh.report.searched = work.searched;
    mesh.report.addedNodes = front.colouredBoundary().added;
    mesh.report.oddEdges = front.colouredBoundary().oneColoured.size();
    mesh.work = front.state().work;
    return mesh;
}

bool cleanUp(QuadMesh &mesh, const SpacingField &spacing, const MeshingOptions &options, const Progress &progress,
             QuadWatch *watch) {
    QuadCleanup cleanup(mesh.elements, spacing, effortFor(options.improve), watch);
    const bool done = cleanup.run(progress);
    mesh.report.changes = cleanup.changes();
    mesh.report.trianglesAt = refillPockets(mesh.elements, options.elements, progress, watch);
    if (options.elements == Elements::Mixed) {
        dividePoor(mesh.elements);
        if (watch != nullptr) {
            watch->changed(ImproveChange::DividePoor, mesh.elements, {});
        }
    }
    if (watch != nullptr) {
        watch->changed(ImproveChange::Remainder, mesh.elements, {});
    }
    return done;
}

Mesh toMesh(QuadMesh &&mesh, const DiscreteDomain &boundary, QuadReport &report) {
    QuadWorkspace &work = mesh.elements;
    report = mesh.report;
    countNodes(work, report);
    listNotConvex(work, report);
    Mesh result = meshOfCells(work.view(), boundary);
    report.triangles = result.triangles().size();
    report.quadrilaterals = result.elementCount() - report.triangles;
    return result;
}

} // namespace forefront
