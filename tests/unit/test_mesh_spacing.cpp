#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/mesh_spacing.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace mesh_spacings {

/// A plate with a hole, around which elements are smaller.
MeshingJob plate() {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {12, 0}, {12, 8}, {0, 8}});
    std::vector<Vec2> hole;
    for (int k = 0; k < 24; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 24.0;
        hole.push_back({4.0 + std::cos(angle), 4.0 + std::sin(angle)});
    }
    addLoop(job.domain, hole, 2);
    job.spacing.size = 1.2;
    SizeSource &source = job.spacing.sources.emplace_back();
    source.shape = SourceShape::Circle;
    source.a = {4, 4};
    source.radius = 1.0;
    source.size = 0.3;
    job.spacing.gradation = 0.2;
    return job;
}

Mesh meshOf(const MeshingJob &job) {
    Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome.ok(), messages(outcome.faults()));
    return std::move(outcome->mesh);
}

} // namespace mesh_spacings

TEST_CASE("Mesh spacing: a domain meshed with the sizes of its mesh has about as many elements, in the same places") {
    using namespace mesh_spacings;
    const Mesh first = meshOf(plate());
    MeshingJob again = plate();
    again.spacing = {};
    again.spacing.background = spacingOfMesh(first);
    REQUIRE(again.spacing.background);
    const Mesh second = meshOf(again);
    const auto near = [](const Mesh &mesh) {
        std::size_t count = 0;
        const MeshView view(mesh);
        for (std::size_t e = 0; e < view.elementCount(); ++e) {
            const Vec2 corner = mesh.nodes[index(view.cornersOf(e)[0])];
            count += distance(corner, {4, 4}) < 1.5 ? 1U : 0U;
        }
        return static_cast<double>(count);
    };
    const double before = static_cast<double>(first.elementCount()), after = static_cast<double>(second.elementCount());
    CHECK(after == doctest::Approx(before).epsilon(0.1));
    CHECK(near(second) == doctest::Approx(near(first)).epsilon(0.25));
    MeshingJob plain = plate();
    plain.spacing = {};
    CHECK(std::abs(static_cast<double>(meshOf(plain).elementCount()) - before) > 0.2 * before);
}

TEST_CASE("Mesh spacing: a triangle counts as the regular one of its area, a quadrilateral as the square") {
    Mesh mesh;
    mesh.nodes = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {9, 9}};
    const std::array<NodeId, 4> corners = {NodeId{0}, NodeId{1}, NodeId{2}, NodeId{3}};
    mesh.block(CellKind::Quadrilateral4).add(corners);
    const auto square = spacingOfMesh(mesh);
    REQUIRE(square);
    CHECK(square->elements.size() == 2);
    for (std::size_t n = 0; n < 4; ++n) {
        CHECK(square->values[n] == doctest::Approx(2.0));
    }
    CHECK(square->values[4] > 0.0);
    TriMesh triangle;
    triangle.nodes = {{0, 0}, {3, 0}, {1.5, 1.5 * std::numbers::sqrt3}};
    triangle.elements = {{NodeId{0}, NodeId{1}, NodeId{2}}};
    CHECK(spacingOfMesh(Mesh(triangle))->values[1] == doctest::Approx(3.0));
    CHECK(spacingOfMesh(Mesh()) == nullptr);
}

TEST_CASE("Mesh spacing: files of meshes without values have the sizes of their elements, with a note") {
    using namespace mesh_spacings;
    const TemporaryFolder folder;
    const Mesh mesh = meshOf(plate());
    for (const char *name : {"plate.msh", "plate.vtu", "plate.su2"}) {
        CAPTURE(name);
        REQUIRE_FALSE(hasErrors(writeMesh(folder / name, mesh)));
        ImportNotes notes;
        const Result<SpacingSpec> spacing = readSpacing(folder / name, {}, &notes);
        REQUIRE_MESSAGE(spacing.ok(), messages(spacing.faults()));
        REQUIRE(spacing->background);
        CHECK(spacing->background->elements.size() == mesh.elementCount());
        CHECK(hasCode(notes.diagnostics(), "element-sizes"));
    }
}
