#include "core/engine/domain/add_loop.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/build_spacing.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/kept_field.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

using namespace forefront;

namespace {

/// A polygon whose sides are kept, with a size.
MeshingJob keptPolygon(const std::vector<Vec2> &corners, double size) {
    MeshingJob job;
    addLoop(job.domain, corners);
    job.spacing.size = size;
    job.options.keepBoundary = true;
    return job;
}

/// Returns the length of the shortest edge with an end in a box.
double shortestEdgeIn(const Mesh &mesh, const Box2 &box) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Element &element : mesh.triangles()) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 a = mesh.nodes[index(element[k])], b = mesh.nodes[index(element[(k + 1) % 3])];
            if (box.contains(a)) {
                shortest = std::min(shortest, distance(a, b));
            }
        }
    }
    return shortest;
}

bool isKeptCrowded(const MeshingJob &job) {
    const auto field = buildSpacing(job, {});
    REQUIRE(field.ok());
    const auto *const kept = dynamic_cast<const KeptField *>(field->get());
    return kept != nullptr && !kept->crowded().empty();
}

} // namespace

TEST_CASE("Kept segments: between a few long ones, the size asked for is reached inside, graded from them") {
    const std::vector<std::vector<Vec2>> outlines = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                                     {{0, 0}, {1, 0}, {0.5, 0.9}},
                                                     {{0, 0}, {1.6, 0}, {1.6, 1}, {0, 1}},
                                                     {{0, 0}, {1, 0}, {1.5, 0.8}, {0.5, 1.6}, {-0.5, 0.8}}};
    for (const std::vector<Vec2> &corners : outlines) {
        for (const Method method : {Method::Fast, Method::Classic}) {
            for (const ImproveLevel level : {ImproveLevel::None, ImproveLevel::Default, ImproveLevel::Best}) {
                CAPTURE(corners.size());
                CAPTURE(std::string(wordOf(method)));
                CAPTURE(std::string(wordOf(level)));
                MeshingJob job = keptPolygon(corners, 0.05);
                REQUIRE(isKeptCrowded(job));
                job.options.method = method;
                job.options.improve = level;
                const auto outcome = meshDomain(job);
                REQUIRE(outcome.ok());
                CHECK(verifyAgainst(outcome->mesh, job.domain).empty());
                CHECK(outcome->mesh.edges.size() == corners.size()); // undivided
                CHECK(outcome->mesh.points.empty());
                const MeshQuality quality = measureQuality(outcome->mesh, outcome->spacing.get());
                CHECK(quality.elements >= (corners.size() == 3 ? 13 : 30)); // were 3, 4 and 5
                CHECK(quality.flat == 0);
                CHECK(quality.minAngle > (level == ImproveLevel::None ? 0.1 : 10.0));
                CHECK(shortestEdgeIn(outcome->mesh, job.domain.bounds()) < 0.1);
                REQUIRE(outcome->spacing->notes().size() == 1);
                CHECK(outcome->spacing->notes().front().code == "long-segments");
            }
        }
    }
}

TEST_CASE("Kept segments: graded nodes do not depend on grid and threads") {
    std::vector<std::uint64_t> hashes;
    for (const GridKind grid : {GridKind::None, GridKind::Uniform, GridKind::Hierarchical}) {
        for (const unsigned threads : {1U, 2U}) {
            MeshingJob job = keptPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.02);
            job.options.grid = grid;
            job.options.threads = threads;
            const auto outcome = meshDomain(job);
            REQUIRE(outcome.ok());
            hashes.push_back(meshHash(outcome->mesh));
        }
    }
    CHECK(std::all_of(hashes.begin(), hashes.end(), [&](std::uint64_t hash) { return hash == hashes.front(); }));
}

TEST_CASE("Kept segments: those between which the size is reached get no graded nodes; channels stay valid") {
    std::vector<Vec2> divided; // four segments on each side, as long as a quarter of it
    for (const auto &[from, to] :
         {std::pair<Vec2, Vec2>{{0, 0}, {8, 0}}, {{8, 0}, {8, 8}}, {{8, 8}, {0, 8}}, {{0, 8}, {0, 0}}}) {
        for (int k = 0; k < 4; ++k) {
            divided.push_back(lerp(from, to, 0.25 * k));
        }
    }
    CHECK_FALSE(isKeptCrowded(keptPolygon(divided, 0.1)));
    const MeshingJob channel = keptPolygon({{0, 0}, {10, 0}, {10, 1}, {0, 1}}, 0.1);
    const auto outcome = meshDomain(channel);
    REQUIRE(outcome.ok());
    CHECK(verifyAgainst(outcome->mesh, channel.domain).empty());
    CHECK(measureQuality(outcome->mesh, nullptr).flat == 0);
}
