#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/mesh_access.hpp"
#include "core/engine/mesh/mesh_extent.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/sharp_corners.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/meshed_job.hpp"
#include "tests/unit/block_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

using namespace forefront;
using samples::node;

namespace {

PlacedCell quadrilateralAt(std::array<Vec2, 4> corners) {
    PlacedCell cell;
    cell.kind = CellKind::Quadrilateral4;
    std::copy(corners.begin(), corners.end(), cell.nodes.begin());
    return cell;
}

PlacedCell triangleAt(Vec2 a, Vec2 b, Vec2 c) {
    PlacedCell cell;
    cell.nodes = {a, b, c};
    return cell;
}

std::vector<double> measured(Measure measure, const Mesh &mesh) {
    return measureValues(measure, mesh, edgesOf(mesh), nullptr);
}

double minimumOfValues(Measure measure, const Mesh &mesh) {
    return summarise(measured(measure, mesh)).minimum;
}

} // namespace

TEST_CASE("Cell measures: squares, rectangles and rhombi have the values of their formulas") {
    const PlacedCell square = quadrilateralAt({{{1, 1}, {3, 1}, {3, 3}, {1, 3}}});
    CHECK(shapeFactor(square) == doctest::Approx(1.0));
    CHECK(scaledJacobian(square) == doctest::Approx(1.0));
    CHECK(anglesOf(square).smallest == doctest::Approx(90.0));
    CHECK(anglesOf(square).largest == doctest::Approx(90.0));
    CHECK(twiceArea(square) == doctest::Approx(8.0));
    CHECK(aspectRatio(square) == doctest::Approx(1.0));
    CHECK(square.centre() == Vec2{2, 2});
    for (const double ratio : {0.1, 0.5, 3.0}) {
        const PlacedCell rectangle = quadrilateralAt({{{0, 0}, {ratio, 0}, {ratio, 1}, {0, 1}}});
        CHECK(shapeFactor(rectangle) == doctest::Approx(2.0 * ratio / (1.0 + ratio * ratio)));
        CHECK(scaledJacobian(rectangle) == doctest::Approx(1.0));
        CHECK(aspectRatio(rectangle) == doctest::Approx(std::max(ratio, 1.0 / ratio)));
    }
    const double angle = std::numbers::pi / 6.0;
    const Vec2 side{std::cos(angle), std::sin(angle)};
    const PlacedCell rhombus = quadrilateralAt({{{0, 0}, {1, 0}, Vec2{1, 0} + side, side}});
    CHECK(scaledJacobian(rhombus) == doctest::Approx(0.5));
    CHECK(aspectRatio(rhombus) == doctest::Approx(1.0));
    CHECK(anglesOf(rhombus).smallest == doctest::Approx(30.0));
    CHECK(anglesOf(rhombus).largest == doctest::Approx(150.0));
}

TEST_CASE("Cell measures: quadrilaterals that are flat, concave or inverted have the worst values") {
    const PlacedCell flat = quadrilateralAt({{{0, 0}, {2, 0}, {1, 1}, {0, 2}}});
    CHECK(shapeFactor(flat) == 0.0);
    CHECK(scaledJacobian(flat) == 0.0);
    const PlacedCell concave = quadrilateralAt({{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}});
    const PlacedCell inverted = quadrilateralAt({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}});
    for (const PlacedCell &cell : {flat, concave, inverted}) {
        CHECK(anglesOf(cell).smallest == 0.0);
        CHECK(anglesOf(cell).largest == 180.0);
    }
    for (const PlacedCell &cell : {concave, inverted}) {
        CHECK(shapeFactor(cell) < 0.0);
        CHECK(scaledJacobian(cell) < 0.0);
    }
    CHECK(twiceArea(inverted) == doctest::Approx(-2.0));
}

TEST_CASE("Cell measures: the scaled Jacobian of a triangle is the sine of its minimum angle, scaled") {
    samples::Random random(2);
    for (int round = 0; round < 200; ++round) {
        const PlacedCell cell = triangleAt({random(), random()}, {random(), random()}, {random(), random()});
        const double smallest = anglesOf(cell).smallest * std::numbers::pi / 180.0;
        if (twiceArea(cell) > 0.0) {
            CHECK(scaledJacobian(cell) == doctest::Approx(std::sin(smallest) * 2.0 / std::numbers::sqrt3));
        } else {
            CHECK(scaledJacobian(cell) < 0.0);
        }
    }
    CHECK(scaledJacobian(triangleAt({0, 0}, {1, 0}, {0.5, 0.5 * std::numbers::sqrt3})) == doctest::Approx(1.0));
    CHECK(scaledJacobian(triangleAt({0, 0}, {1, 0}, {1, 0})) == 0.0);
    CHECK(aspectRatio(triangleAt({0, 0}, {1, 0}, {0.5, 0.5 * std::numbers::sqrt3})) == doctest::Approx(1.0));
    CHECK(aspectRatio(triangleAt({0, 0}, {10, 0}, {4, 0.1})) == doctest::Approx(50.0 * std::numbers::sqrt3));
    CHECK(aspectRatio(triangleAt({0, 0}, {1, 0}, {2, 0})) == std::numeric_limits<double>::infinity());
}

TEST_CASE("Cell measures: straight edges of second order change nothing, curved ones lower the scaled Jacobian") {
    const std::array<std::array<CellKind, 2>, 3> pairs = {{{CellKind::Triangle3, CellKind::Triangle6},
                                                           {CellKind::Quadrilateral4, CellKind::Quadrilateral8},
                                                           {CellKind::Quadrilateral4, CellKind::Quadrilateral9}}};
    for (const auto &[first, second] : pairs) {
        const Mesh one = samples::sampleMesh(first), two = samples::sampleMesh(second);
        for (const Measure measure : valuesOf<Measure>()) {
            if (infoOf(measure).part == MeshPart::Elements) {
                const std::vector<double> a = measured(measure, one), b = measured(measure, two);
                REQUIRE(a.size() == b.size());
                for (std::size_t e = 0; e < a.size(); ++e) {
                    CHECK(a[e] == doctest::Approx(b[e]));
                }
            }
        }
        Mesh moved = two;
        moved.nodes[index(moved.blocks[0].nodesOf(0)[traitsOf(second).corners])] += {0.03, 0.03};
        CHECK(measured(Measure::ScaledJacobian, moved)[0] < measured(Measure::ScaledJacobian, two)[0]);
    }
    // At the middle of the edge the determinant falls, at the corners it is 1 - 4·0.1: the minimum over the element.
    samples::BlockMaker maker({{0, 0}, {1, 0}, {0, 1}});
    maker.add(CellKind::Triangle6, {node(0), node(1), node(2)});
    maker.mesh.nodes[index(maker.mesh.blocks[0].nodesOf(0)[3])] = {0.5, 0.1};
    const double right = 2.0 / std::numbers::sqrt3 * std::sqrt(0.5);
    CHECK(measured(Measure::ScaledJacobian, maker.mesh)[0] == doctest::Approx(0.6 * right).epsilon(1e-5));
}

TEST_CASE("Cell measures: areas and lengths of curved elements are those of their parabolas") {
    samples::BlockMaker maker({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    maker.add(CellKind::Quadrilateral8, {node(0), node(1), node(2), node(3)});
    maker.tag(node(0), node(1), 1);
    Mesh mesh = std::move(maker.mesh);
    const NodeId bottom = mesh.edges[0].middle;
    mesh.nodes[index(bottom)] = {0.5, -0.25};
    CHECK(measured(Measure::Area, mesh)[0] == doctest::Approx(1.0 + 2.0 / 3.0 * 0.25));
    // y = x² - x from 0 to 1: √2/2 + asinh(1)/2
    const double length = 0.5 * std::numbers::sqrt2 + 0.5 * std::asinh(1.0);
    const MeshEdges edges = edgesOf(mesh);
    CHECK(measured(Measure::Length, mesh)[edges.of(0, 0)] == doctest::Approx(length));
    CHECK(measured(Measure::Length, mesh)[edges.of(0, 1)] == doctest::Approx(1.0));
    CHECK(edges.edges[edges.of(0, 0)].middle == bottom);
    CHECK(placeOf(mesh, edges, MeshPart::Edges, edges.of(0, 0)) == Vec2{0.5, -0.25});
    const MeshExtent extent = extentOf(mesh, edges.edges.size());
    CHECK(extent.boundaries[0].length == doctest::Approx(length));
    CHECK(extent.regions[0].area == doctest::Approx(1.0 + 2.0 / 3.0 * 0.25));
    CHECK(extent.parts == 1);
    CHECK(extent.holes == 0);
}

TEST_CASE("Cell measures: the figures of a mesh are those of its measures") {
    for (const Mesh &mesh : {samples::allKindsSample(), samples::mixedSample(), samples::secondOrderSample(),
                             samples::sampleMesh(CellKind::Triangle3)}) {
        const MeshQuality quality = measureQuality(mesh, nullptr);
        const MeshView view(mesh);
        CHECK(quality.elements == view.elementCount());
        CHECK(quality.nodes == mesh.nodes.size());
        for (const CellKind kind : valuesOf<CellKind>()) {
            const auto block = std::find_if(mesh.blocks.begin(), mesh.blocks.end(),
                                            [&](const CellBlock &some) { return some.kind() == kind; });
            CHECK(quality.kinds[static_cast<std::size_t>(kind)] == (block == mesh.blocks.end() ? 0 : block->size()));
        }
        const MeasureSummary alpha = summarise(measured(Measure::ShapeFactor, mesh));
        CHECK(quality.alphaMin == doctest::Approx(alpha.minimum));
        CHECK(quality.alphaMean == doctest::Approx(alpha.mean));
        CHECK(quality.minAngle == doctest::Approx(minimumOfValues(Measure::MinAngle, mesh)));
        CHECK(quality.maxAngle == doctest::Approx(summarise(measured(Measure::MaxAngle, mesh)).maximum));
        CHECK(quality.minScaledJacobian == doctest::Approx(minimumOfValues(Measure::ScaledJacobian, mesh)));
        double area = 0.0;
        for (const double value : measured(Measure::Area, mesh)) {
            area += value;
        }
        CHECK(quality.area == doctest::Approx(area));
        CHECK(quality.edges == edgesOf(mesh).edges.size());
        CHECK(shapeFactors(mesh)[index(quality.worst)] == doctest::Approx(quality.alphaMin));
        const MeshExtent extent = extentOf(mesh, quality.edges);
        CHECK(extent.holes == 0);
        CHECK(extent.parts == (mesh.blocks.size() == 5 ? 2 : 1));
        CHECK(extent.regions.size() == 2);
    }
    TriMesh inverted = samples::square(2, 2);
    std::swap(inverted.elements[0][1], inverted.elements[0][2]);
    CHECK(measureQuality(inverted, nullptr).minScaledJacobian < 0.0);
    CHECK(measureQuality(inverted, nullptr).minScaledJacobian ==
          doctest::Approx(minimumOfValues(Measure::ScaledJacobian, inverted)));
}

TEST_CASE("Cell measures: valence and neighbours go by corners and sides") {
    const Mesh mesh = samples::sampleMesh(CellKind::Quadrilateral9);
    const std::vector<double> valence = measured(Measure::Valence, mesh);
    CHECK(valence[0] == 1.0);                          // a corner of the square
    CHECK(valence[6] == 4.0);                          // inside
    CHECK(std::isnan(valence[mesh.nodes.size() - 1])); // a middle
    CHECK(measureQuality(mesh, nullptr).valence[4] == 6);
    const MeshEdges edges = edgesOf(mesh);
    CHECK(edges.edges.size() == 4 * 4 + 5 * 3);
    CHECK(edges.of(0).size() == 4);
    for (std::size_t e = 0; e < 12; ++e) {
        for (std::size_t k = 0; k < 4; ++k) {
            const MeshEdge &edge = edges.edges[edges.of(e, k)];
            CHECK(std::ranges::count(edge.elements, ElementId{static_cast<std::uint32_t>(e)}) == 1);
        }
    }
    Mesh strip = samples::gridOfCells(12, 3, [](auto, auto) { return CellKind::Quadrilateral4; });
    for (Vec2 &p : strip.nodes) {
        p.x *= 10.0; // its long sides face each other
    }
    CHECK(minimumOfValues(Measure::Across, strip) == 3.0);
}

TEST_CASE("Cell measures: sides of tagged edges are those of any elements") {
    const Mesh mesh = samples::secondOrderSample();
    const std::vector<EdgeSides> sides = edgeSides(mesh);
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        const bool inner = mesh.edges[e].tag == 5;
        CHECK(sides[e].isInterface() == inner);
        CHECK(sides[e].left != kNoElement);
        CHECK((sides[e].right == kNoElement) == !inner);
        CHECK(sides[e].leftRegion == MeshView(mesh).region(index(sides[e].left)));
    }
    CHECK(edgesWithTag(mesh, 5).size() == 3);
    CHECK(coordinates(mesh).size() == 2 * mesh.nodes.size());
}

TEST_CASE("Cell measures: limits name quadrilaterals and the scaled Jacobian") {
    MeshLimits limits;
    limits[MeshLimit::MinScaledJacobian] = 0.9;
    samples::BlockMaker maker({{0, 0}, {1, 0}, {2, 1}, {1, 1}, {2, 0}, {3, 0}, {3, 1}});
    maker.add(CellKind::Quadrilateral4, {node(0), node(1), node(2), node(3)});
    const std::vector<LimitVerdict> verdicts = checkLimits(maker.mesh, limits, nullptr);
    REQUIRE(verdicts.size() == 1);
    CHECK(verdicts[0].broken == 1);
    CHECK(verdicts[0].worst == doctest::Approx(std::sqrt(0.5)));
    CHECK(toString(verdicts[0]) ==
          "minimum scaled Jacobian 0.9: violated by 1 of 1 elements, worst 0.7071 at (1, 0.5)");
    MeshLimits thin;
    thin[MeshLimit::MaxAspect] = 3.0;
    maker.mesh.nodes = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
    CHECK(toString(checkLimits(maker.mesh, thin, nullptr)[0]) ==
          "maximum aspect ratio 3: violated by 1 of 1 elements, worst 4 at (2, 0.5)");
    CHECK(limitFault(MeshLimit::MinScaledJacobian, 1.5) == "expected a number from 0 to 1, got 1.5");
}

TEST_CASE("Cell measures: the aspect ratio of boundary layers has a limit of its own") {
    MeshingJob job;
    job.domain = forefront::testing::squareDomain(1.0);
    job.spacing.size = 0.1;
    MeshLimits limits;
    limits[MeshLimit::MaxAspect] = 3.0;
    const Mesh isotropic = forefront::testing::meshedJob(job).mesh;
    limits[MeshLimit::MaxLayerAspect] = 60.0;
    CHECK(toString(checkLimits(isotropic, limits, nullptr)[1]) ==
          "maximum layer aspect 60: met: there are no boundary layers");
    for (const LayerCells cells : {LayerCells::Quads, LayerCells::Triangles}) {
        for (const Elements elements : {Elements::Triangles, Elements::Quads}) {
            job.options.elements = elements;
            job.layers = {LayerSpec{.tag = 1, .first = 0.002, .count = 8, .cells = cells}};
            const MeshingOutcome outcome = forefront::testing::meshedJob(job);
            limits[MeshLimit::MaxLayerAspect] = std::nullopt;
            CHECK_FALSE(checkLimits(outcome.mesh, limits, nullptr)[0].met());
            limits[MeshLimit::MaxLayerAspect] = 100.0;
            std::vector<LimitVerdict> verdicts = checkLimits(outcome.mesh, limits, nullptr);
            REQUIRE(verdicts.size() == 2);
            CHECK(verdicts[0].met());
            CHECK(verdicts[1].met());
            CHECK(verdicts[0].judged + verdicts[1].judged == outcome.mesh.elementCount());
            const std::size_t made = outcome.layers.quadrilaterals + outcome.layers.triangles;
            CHECK(verdicts[1].judged <= made);
            CHECK(10 * verdicts[1].judged >= 8 * made); // others have the height of isotropic ones
            limits[MeshLimit::MaxLayerAspect] = 10.0;
            verdicts = checkLimits(outcome.mesh, limits, nullptr);
            CHECK(verdicts[0].met());
            CHECK_FALSE(verdicts[1].met());
        }
    }
}

TEST_CASE("Cell measures: sharp corners are found between quadrilaterals") {
    samples::BlockMaker maker({{0, 0}, {4, 0}, {4, 0.4}, {8, 0}, {8, 0.8}});
    maker.add(CellKind::Triangle3, {node(0), node(1), node(2)});
    maker.add(CellKind::Quadrilateral4, {node(1), node(3), node(4), node(2)});
    for (const auto &[a, b] : {std::pair{0, 1}, std::pair{1, 3}, std::pair{3, 4}, std::pair{4, 2}, std::pair{2, 0}}) {
        maker.tag(NodeId{static_cast<std::uint32_t>(a)}, NodeId{static_cast<std::uint32_t>(b)}, 1);
    }
    const SharpCorners sharp = sharpCorners(maker.mesh, 20.0);
    REQUIRE(sharp.corners.size() == 1);
    CHECK(sharp.corners[0].node == node(0));
    CHECK(sharp.corners[0].angle == doctest::Approx(std::atan2(0.4, 4.0) * 180.0 / std::numbers::pi));
    CHECK(sharp.minAngleElsewhere == 60.0); // the most that an element beside a triangle is compared with
    const Mesh grid = samples::sampleMesh(CellKind::Quadrilateral4);
    CHECK(sharpCorners(grid, 20.0).minAngleElsewhere == doctest::Approx(minimumOfValues(Measure::MinAngle, grid)));
}
