#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/teaching/tables/power_law.hpp"
#include "core/teaching/tables/published.hpp"
#include "core/teaching/tables/table_case.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// The figures that the texts of lessons quote from runs other than those that their pages show.

using namespace forefront;
using namespace forefront::testing;

namespace lesson_numbers {

Document drawingOf(const std::string &name) {
    const std::filesystem::path folder =
        std::filesystem::path(__FILE__).parent_path().parent_path().parent_path() / "assets/lessons/drawings";
    Result<Document> document = readDocument(folder / name, {});
    REQUIRE_MESSAGE(document.ok(), messages(document.faults()));
    return *document;
}

WorkCounters workOf(MeshingJob job, int columns, int rows) {
    job.options.improve = ImproveLevel::None;
    job.options.grid = GridKind::Uniform;
    job.options.gridColumns = columns;
    job.options.gridRows = rows;
    const Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome.ok(), messages(outcome.faults()));
    return outcome->work;
}

double cellsPerElement(const WorkCounters &work) {
    return static_cast<double>(work.cellsVisited) / static_cast<double>(work.elements);
}

/// Returns the rounds of the adaptation that lesson 9 describes.
std::vector<AdaptRound> rounds(double size, double error, int count) {
    Document drawing = drawingOf("coarse.json");
    drawing.spacing.size = size;
    const MeshingJob job = jobOf(drawing);
    Result<MeshingOutcome> first = meshDomain(job);
    REQUIRE(first);
    const Result<NodalField> field = expressionField("atan(2*(hypot(x-10,y-7)-4))");
    REQUIRE(field);
    AdaptTarget target;
    target.error = error;
    const Result<AdaptOutcome> outcome = adaptMesh(job, takeTriMesh(std::move(first->mesh)), *field, target, count);
    REQUIRE(outcome);
    return outcome->rounds;
}

/// Returns the slope of the error from one mesh to another on logarithmic axes.
double slope(const AdaptRound &a, const AdaptRound &b) {
    return std::log(b.error / a.error) / std::log(static_cast<double>(b.elements) / static_cast<double>(a.elements));
}

/// Returns the explanation of an advance, counted from 1, of the classic method.
std::shared_ptr<const AdvanceExplanation> advanceOf(const std::string &name, std::uint64_t advance) {
    Result<MeshStepper> stepper = MeshStepper::create(jobOf(drawingOf(name)));
    REQUIRE(stepper);
    stepper->seek(advance);
    return stepper->explanation();
}

} // namespace lesson_numbers

TEST_CASE("Lesson 9: the front starts on the outline and is in the ring after 10 advances") {
    using namespace lesson_numbers;
    const auto fromRing = [](std::uint64_t advance) {
        const auto told = advanceOf("adapted.json", advance);
        return std::abs(distance(midpoint(told->a, told->b), Vec2{10, 7}) - 4.0);
    };
    const auto first = advanceOf("adapted.json", 1);
    CHECK(first->a.y == 14.0);
    CHECK(first->b.y == 14.0);
    for (std::uint64_t advance = 1; advance <= 10; ++advance) {
        CHECK((fromRing(advance) < 1.0) == (advance == 10));
    }
}

TEST_CASE("Lesson 12: the front closes a pocket by diagonals, and its walls reject candidates") {
    using namespace lesson_numbers;
    const Document pocket = drawingOf("pocket.json");
    CHECK(pocket.shapes.front()->nodes.size() == 12);
    std::size_t rejecting = 0;
    for (std::uint64_t advance = 1; advance <= 10; ++advance) {
        const auto told = advanceOf("pocket.json", advance);
        CHECK(told->made.size() == 1);
        rejecting += std::ranges::any_of(
            told->candidates, [](const CandidateTrace &candidate) { return candidate.verdict >= Verdict::NotLeft; });
        CHECK(std::ranges::none_of(told->candidates, [](const CandidateTrace &candidate) {
            return candidate.verdict == Verdict::Accepted && candidate.node == kNoNode;
        }));
    }
    CHECK(rejecting == 9);
}

TEST_CASE("Lesson 9: the rounds of the adaptation, and the errors of one size everywhere") {
    using namespace lesson_numbers;
    const std::vector<AdaptRound> adapted = rounds(2.0, 0.2, 8);
    REQUIRE(adapted.size() == 4);
    const std::size_t elements[] = {154, 430, 754, 1144};
    const double errors[] = {0.44, 0.31, 0.22, 0.17};
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(adapted[k].elements == elements[k]);
        CHECK(adapted[k].error == doctest::Approx(errors[k]).epsilon(0.02));
    }
    std::vector<Vec2> points;
    for (const AdaptRound &round : adapted) {
        points.push_back({static_cast<double>(round.elements), round.error});
    }
    CHECK(std::abs(fitPowerLaw(points)->exponent + 0.47) < 0.005);
    const double slopes[] = {-0.33, -0.60, -0.65};
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(slope(adapted[k], adapted[k + 1]) - slopes[k]) < 0.005);
    }
    CHECK(std::abs(slope(adapted[0], rounds(1.0, 0.99, 1).front()) + 0.18) < 0.005);
    const std::vector<AdaptRound> fine = rounds(2.0, 0.1, 8);
    CHECK(fine.back().elements == 2868);
    CHECK(fine.back().error < 0.1);
    const struct {
        double size;
        std::size_t elements;
        double error;
    } uniform[] = {{1.0, 632, 0.34}, {0.5, 2552, 0.19}, {0.25, 10'264, 0.095}};
    for (const auto &mesh : uniform) {
        const std::vector<AdaptRound> one = rounds(mesh.size, 0.99, 1);
        CHECK(one.front().elements == mesh.elements);
        CHECK(one.front().error == doctest::Approx(mesh.error).epsilon(0.01));
    }
    CHECK(publishedFigures("4", "none")->elements == 311'304);
    CHECK(publishedFigures("4", "none")->seconds == 151.7);
    CHECK(publishedFigures("4", "60x40")->seconds == 28.3);
}

TEST_CASE("Lesson 10: the work with cells of several sizes, and that of Lo's grids") {
    using namespace lesson_numbers;
    const MeshingJob plate = jobOf(drawingOf("plate.json"));
    const struct {
        int columns, rows;
        double neighbours, cells;
    } grids[] = {{5, 4, 20.8, 2.1}, {10, 7, 13.5, 3.7}, {20, 14, 9.9, 8.9}, {40, 28, 7.9, 25.7}, {80, 56, 6.8, 85.8}};
    for (const auto &grid : grids) {
        const WorkCounters work = workOf(plate, grid.columns, grid.rows);
        CHECK(std::abs(work.neighboursMean() - grid.neighbours) < 0.051);
        CHECK(std::abs(cellsPerElement(work) - grid.cells) < 0.051);
    }
    CHECK(std::abs(workOf(tableJob(*tableCase("1A")), 30, 20).neighboursMean() - 56.0) < 0.051);
    CHECK(std::abs(workOf(tableJob(*tableCase("1A")), 60, 40).neighboursMean() - 31.7) < 0.051);
}

TEST_CASE("Lesson 11: the rectangle with seams and without") {
    using namespace lesson_numbers;
    Document drawing = drawingOf("parts.json");
    std::erase_if(drawing.shapes, [](const auto &shape) { return shape->id != 1; });
    const Result<MeshingOutcome> whole = meshDomain(jobOf(drawing));
    REQUIRE(whole);
    CHECK(whole->mesh.elementCount() == 656);
    CHECK(measureQuality(whole->mesh, nullptr).alphaMean == doctest::Approx(0.987).epsilon(0.0005));
}
