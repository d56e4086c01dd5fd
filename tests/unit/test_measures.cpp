#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace forefront;
using samples::node;

namespace {

/// A right triangle with legs 3 and 4, an equilateral one of side 4 below its leg, and a node without elements.
TriMesh unlikeTriangles() {
    TriMesh mesh;
    mesh.nodes = {{0, 0}, {4, 0}, {0, 3}, {2, -2 * std::numbers::sqrt3}, {9, 9}};
    mesh.elements = {{node(0), node(1), node(2)}, {node(1), node(0), node(3)}};
    mesh.regions = {1, 7};
    return mesh;
}

std::vector<double> values(Measure measure, const TriMesh &mesh, const SpacingField *spacing = nullptr) {
    return measureValues(measure, mesh, edgesOf(mesh), spacing);
}

std::shared_ptr<const SpacingField> uniformSpacing(const TriMesh &mesh, double size) {
    SpacingSpec spec;
    spec.size = size;
    Domain extent;
    extent.nodes = mesh.nodes;
    return SpacingField::build(spec, extent).value();
}

} // namespace

TEST_CASE("Measures: elements have the values that follow from their corners") {
    const TriMesh mesh = unlikeTriangles();
    const double small = std::atan2(3.0, 4.0) * 180.0 / std::numbers::pi;
    CHECK(values(Measure::MinAngle, mesh)[0] == doctest::Approx(small));
    CHECK(values(Measure::MaxAngle, mesh)[0] == doctest::Approx(90.0));
    CHECK(values(Measure::MinAngle, mesh)[1] == doctest::Approx(60.0));
    CHECK(values(Measure::ShapeFactor, mesh)[1] == doctest::Approx(1.0));
    CHECK(values(Measure::Area, mesh)[0] == doctest::Approx(6.0));
    CHECK(values(Measure::Area, mesh)[1] == doctest::Approx(4.0 * std::numbers::sqrt3));
    const double ratio = 4.0 * std::numbers::sqrt3 / 6.0;
    CHECK(values(Measure::AreaRatio, mesh)[0] == doctest::Approx(ratio));
    CHECK(values(Measure::AreaRatio, mesh)[1] == doctest::Approx(ratio));
    CHECK(values(Measure::Region, mesh) == std::vector<double>{1, 7});
    CHECK(values(Measure::Birth, mesh) == std::vector<double>{0, 1});
}

TEST_CASE("Measures: edges are compared with the spacing at their middles") {
    const TriMesh mesh = unlikeTriangles();
    const MeshEdges edges = edgesOf(mesh);
    REQUIRE(edges.edges.size() == 5);
    CHECK(edges.edges[0].a == node(0)); // 0-1, 0-2, 0-3, 1-2, 1-3
    CHECK(edges.edges[0].b == node(1));
    CHECK(edges.edges[0].elements[1] != kNoElement);
    CHECK(edges.edges[1].elements[1] == kNoElement);
    CHECK(std::ranges::equal(edges.of(0), std::array<std::uint32_t, 3>{0, 3, 1}));
    CHECK(edges.of(1, 1) == 2);
    const std::vector<double> lengths = values(Measure::Length, mesh);
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(lengths[k] == doctest::Approx(std::array<double, 5>{4, 3, 4, 5, 4}[k]));
    }
    CHECK(values(Measure::SizeRatio, mesh).empty());
    CHECK(values(Measure::Conformity, mesh).empty());
    const auto spacing = uniformSpacing(mesh, 4.0);
    CHECK(values(Measure::SizeRatio, mesh, spacing.get())[3] == doctest::Approx(1.25));
    CHECK(values(Measure::Conformity, mesh, spacing.get())[3] == doctest::Approx(0.8));
    CHECK(values(Measure::Conformity, mesh, spacing.get())[1] == doctest::Approx(0.75));
}

TEST_CASE("Measures: parts without a value are NaN and do not count") {
    const TriMesh mesh = unlikeTriangles();
    const std::vector<double> valences = values(Measure::Valence, mesh);
    CHECK(valences[0] == 2.0);
    CHECK(valences[2] == 1.0);
    CHECK(std::isnan(valences[4]));
    CHECK(summarise(valences).count == 4);
    TriMesh alone = mesh;
    alone.elements.pop_back();
    CHECK(std::isnan(values(Measure::AreaRatio, alone)[0]));
    CHECK(summarise(values(Measure::AreaRatio, alone)).count == 0);
}

TEST_CASE("Measures: flat and inverted elements have the worst angles and an unbounded area ratio") {
    TriMesh mesh = unlikeTriangles();
    std::swap(mesh.elements[0][0], mesh.elements[0][1]);
    CHECK(values(Measure::MinAngle, mesh)[0] == 0.0);
    CHECK(values(Measure::MaxAngle, mesh)[0] == 180.0);
    CHECK(values(Measure::Area, mesh)[0] == doctest::Approx(-6.0));
    mesh.nodes[2] = {1, 0};
    CHECK(values(Measure::MaxAngle, mesh)[0] == 180.0);
    CHECK(std::isinf(values(Measure::AreaRatio, mesh)[1]));
}

TEST_CASE("Measures: their figures are those of measureQuality()") {
    const TriMesh mesh = samples::square(23, 17, 0.2);
    const auto spacing = uniformSpacing(mesh, 0.05);
    const MeshQuality quality = measureQuality(mesh, spacing.get());
    const MeasureSummary alpha = summarise(values(Measure::ShapeFactor, mesh));
    CHECK(alpha.count == quality.elements);
    CHECK(alpha.mean == doctest::Approx(quality.alphaMean));
    CHECK(alpha.minimum == doctest::Approx(quality.alphaMin));
    CHECK(alpha.percentiles[0] == doctest::Approx(quality.alpha1));
    CHECK(alpha.percentiles[1] == doctest::Approx(quality.alpha5));
    CHECK(alpha.percentiles[3] == doctest::Approx(quality.alpha50));
    CHECK(summarise(values(Measure::MinAngle, mesh)).minimum == doctest::Approx(quality.minAngle));
    CHECK(summarise(values(Measure::MaxAngle, mesh)).maximum == doctest::Approx(quality.maxAngle));
    CHECK(summarise(values(Measure::Length, mesh)).count == quality.edges);
    CHECK(summarise(values(Measure::Conformity, mesh, spacing.get())).mean == doctest::Approx(quality.deltaMean));
    const std::vector<double> alphas = values(Measure::ShapeFactor, mesh);
    const MeasureHistogram bins = histogramOf(alphas, 0.0, 1.0, false, kHistogramBins);
    CHECK(std::equal(bins.bins.begin(), bins.bins.end(), quality.alphaHistogram.begin()));
    CHECK(ElementId{worstParts(Measure::ShapeFactor, alphas, 1).front()} == quality.worst);
}

TEST_CASE("Measures: every value lies in the range that its description states") {
    TriMesh mesh = samples::square(40, 3, 0.1);
    for (Vec2 &place : mesh.nodes) {
        place.x *= 10.0; // a strip, whose long sides face each other
    }
    mesh.elements.erase(mesh.elements.begin() + 102,
                        mesh.elements.begin() + 104); // a cell in the middle row: an island
    const auto spacing = uniformSpacing(mesh, 0.1);
    for (const Measure measure : valuesOf<Measure>()) {
        CAPTURE(wordOf(measure));
        const MeasureSummary summary = summarise(values(measure, mesh, spacing.get()));
        REQUIRE(summary.count > 0);
        CHECK(summary.minimum >= infoOf(measure).minimum);
        CHECK(summary.maximum <= infoOf(measure).maximum);
        CHECK(std::string_view(infoOf(measure).meaning).size() > 10);
    }
}

TEST_CASE("Measures: elements across a gap are counted between parts of the boundary that face each other") {
    const auto narrowest = [](TriMesh mesh, Vec2 stretch) {
        for (Vec2 &place : mesh.nodes) {
            place = {stretch.x * place.x, stretch.y * place.y};
        }
        return summarise(values(Measure::Across, mesh));
    };
    for (const std::size_t rows : {1U, 2U, 3U, 4U, 7U}) {
        CAPTURE(rows);
        CHECK(narrowest(samples::square(40, rows), {10.0, 1.0}).minimum == static_cast<double>(rows));
    }
    CHECK(narrowest(samples::square(12, 12, 0.1), {1.0, 1.0}).count == 0); // neither corners nor a square are gaps
    CHECK(narrowest(unlikeTriangles(), {1.0, 1.0}).count == 0);
}

TEST_CASE("Measures: where holes touch at a node, the elements around it are not across a gap") {
    TriMesh mesh = samples::square(12, 12);
    std::erase_if(mesh.elements, [&](const Element &element) { // two holes of 3 x 3 cells, 2 and 4 cells from the edge
        const Vec2 at =
            (4.0 * (mesh.nodes[index(element[0])] + mesh.nodes[index(element[1])] + mesh.nodes[index(element[2])]));
        const auto within = [&](double low, double high) {
            return at.x > low && at.x < high && at.y > low && at.y < high;
        };
        return within(2.0, 5.0) || within(5.0, 8.0);
    });
    mesh.edges.clear();
    CHECK(summarise(values(Measure::Across, mesh)).minimum == 2.0);
    const std::vector<double> across = values(Measure::Across, mesh);
    CHECK(std::count(across.begin(), across.end(), 2.0) > 0);
    CHECK(std::count_if(across.begin(), across.end(), [](double v) { return v < 2.0; }) == 0);
}

TEST_CASE("Measures: percentiles are values of that rank") {
    std::vector<double> numbers;
    for (int i = 100; i >= 0; --i) {
        numbers.push_back(i);
    }
    const MeasureSummary summary = summarise(numbers);
    for (std::size_t i = 0; i < kPercentiles.size(); ++i) {
        CHECK(summary.percentiles[i] == kPercentiles[i]);
    }
    CHECK(summary.minimum == 0.0);
    CHECK(summary.maximum == 100.0);
    CHECK(summary.mean == doctest::Approx(50.0));
    CHECK(summarise({}).count == 0);
}

TEST_CASE("Measures: a histogram counts every value once, and values outside in the end bins") {
    const std::vector<double> numbers{-5.0, 0.0, 0.24, 0.25, 0.99, 1.0, 7.0, std::nan("")};
    const MeasureHistogram linear = histogramOf(numbers, 0.0, 1.0, false, 4);
    CHECK(linear.bins == std::vector<std::uint64_t>{3, 1, 0, 3});
    CHECK(linear.edge(1) == 0.25);
    constexpr double kLargest = std::numeric_limits<double>::max();
    const std::vector<double> huge{-kLargest, 0.0, kLargest};
    const MeasureHistogram wide = histogramOf(huge, -kLargest, kLargest, false, 3);
    CHECK(wide.bins == std::vector<std::uint64_t>{1, 1, 1});
    CHECK(wide.edge(0) == -kLargest);
    CHECK(wide.edge(3) == kLargest);
    CHECK(histogramOf(huge, kLargest, kLargest, false, 3).bins.size() == 3); // an empty range
    const MeasureHistogram logarithmic =
        histogramOf(std::vector<double>{-1.0, 0.5, 1.0, 10.0, 99.0}, 1.0, 100.0, true, 2);
    CHECK(logarithmic.bins == std::vector<std::uint64_t>{3, 2});
    CHECK(logarithmic.edge(1) == doctest::Approx(10.0));
}

TEST_CASE("Measures: the worst parts come first, and equal ones are ordered by number") {
    const std::vector<double> low{0.5, 0.1, std::nan(""), 0.1, 0.9};
    CHECK(worstParts(Measure::ShapeFactor, low, 3) == std::vector<std::uint32_t>{1, 3, 0});
    CHECK(worstParts(Measure::MaxAngle, low, 9) == std::vector<std::uint32_t>{4, 0, 1, 3});
    CHECK(worstParts(Measure::SizeRatio, std::vector<double>{1.0, 1.9, 0.5, 2.0}, 3) ==
          std::vector<std::uint32_t>{2, 3, 1});
    CHECK(worstParts(Measure::Region, low, 3).empty());
}

TEST_CASE("Limits: verdicts count what breaks a limit and list the worst places") {
    const TriMesh mesh = unlikeTriangles();
    MeshLimits limits;
    CHECK_FALSE(limits.any());
    CHECK(checkLimits(mesh, limits, nullptr).empty());
    limits[MeshLimit::MinAngle] = 40.0;
    limits[MeshLimit::MaxAngle] = 90.0; // exactly that of the right triangle
    limits[MeshLimit::MinDelta] = 0.9;
    limits[MeshLimit::MaxLength] = 3.5;
    const std::vector<LimitVerdict> verdicts = checkLimits(mesh, limits, nullptr, 2);
    REQUIRE(verdicts.size() == 4);
    CHECK(verdicts[0].limit == MeshLimit::MinAngle);
    CHECK(verdicts[0].broken == 1);
    CHECK(verdicts[0].worst == doctest::Approx(36.8699));
    REQUIRE(verdicts[0].places.size() == 1);
    CHECK(verdicts[0].places[0].part == 0);
    CHECK(distance(verdicts[0].places[0].at, {4.0 / 3.0, 1.0}) < 1e-12);
    CHECK(toString(verdicts[0]) ==
          "minimum angle 40\xc2\xb0: violated by 1 of 2 elements, worst 36.87\xc2\xb0 at (1.33333, 1)");
    REQUIRE(faultsOf(verdicts[0]).size() == 1);
    CHECK(faultsOf(verdicts[0])[0].message ==
          "element 0: min \xe2\x88\xa0 36.87\xc2\xb0 violates the limit 40\xc2\xb0");
    const MeshNumbers numbers{PartNumbers(1), PartNumbers(5)};
    CHECK(faultsOf(verdicts[0], numbers)[0].message.find("element 5: ") == 0);
    CHECK(faultsOf(verdicts[2], numbers)[0].message.find("edge 2-3: ") == 0); // by its nodes
    CHECK(verdicts[1].met());
    CHECK(toString(verdicts[1]) == "maximum angle 90\xc2\xb0: met, worst 90\xc2\xb0");
    CHECK(verdicts[2].broken == 4);
    CHECK(verdicts[2].places.size() == 2);
    CHECK(verdicts[2].places[0].value == 5.0);
    CHECK(verdicts[3].judged == 0);
    CHECK_FALSE(verdicts[3].met());
    const auto spacing = uniformSpacing(mesh, 4.0);
    CHECK(checkLimits(mesh, limits, spacing.get())[3].broken == 2);
    MeshLimits across;
    across[MeshLimit::MinAcross] = 3.0; // nothing faces anything, which violates no limit
    CHECK(checkLimits(mesh, across, nullptr).front().met());
    CHECK(toString(checkLimits(mesh, across, nullptr).front()) ==
          "minimum across gaps 3: met: nothing faces across a gap");
}

TEST_CASE("Limits: values outside their range are explained") {
    CHECK(limitFault(MeshLimit::MinAngle, 25.0).empty());
    CHECK(limitFault(MeshLimit::MinAngle, 100.0) == "expected a number from 0 to 90, got 100");
    CHECK(limitFault(MeshLimit::MinLength, 0.0) == "expected a positive number, got 0");
    CHECK(limitFault(MeshLimit::MaxLength, INFINITY) == "expected a positive number, got inf");
}

TEST_CASE("Limits: an island counts once, at its first edge, and the measure colours all of its shore") {
    TriMesh mesh = samples::square(4, 4); // cells of area 1/16 in two triangles
    MeshLimits limits;
    limits[MeshLimit::MinIslandArea] = 0.07;
    CHECK(toString(checkLimits(mesh, limits, nullptr).front()) ==
          "minimum island area 0.07: met: there are no islands");
    std::erase_if(mesh.elements, [&](const Element &element) {
        const Vec2 at = (1.0 / 3.0) *
                        (mesh.nodes[index(element[0])] + mesh.nodes[index(element[1])] + mesh.nodes[index(element[2])]);
        return at.x > 0.25 && at.x < 0.5 && at.y > 0.5 && at.y < 0.75;
    });
    REQUIRE(mesh.elements.size() == 30);
    const LimitVerdict verdict = checkLimits(mesh, limits, nullptr).front();
    CHECK(verdict.judged == 1);
    CHECK(verdict.broken == 1);
    CHECK(verdict.worst == doctest::Approx(1.0 / 16.0));
    CHECK(toString(verdict).find("violated by 1 of 1 islands, worst 0.0625 at (") != std::string::npos);
    CHECK(distance(verdict.places.front().at, {0.375, 0.625}) < 0.2);
    const std::vector<double> areas = values(Measure::IslandArea, mesh);
    CHECK(std::count_if(areas.begin(), areas.end(), [](double area) { return std::isnan(area); }) ==
          static_cast<std::ptrdiff_t>(areas.size()) - 4);
    limits[MeshLimit::MinIslandArea] = 1.0 / 16.0;
    CHECK(checkLimits(mesh, limits, nullptr).front().met());
}
