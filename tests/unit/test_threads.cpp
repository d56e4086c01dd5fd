// One mesh for any number of threads, on random domains and on real ones.
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/sanitizers.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

using namespace forefront;
using forefront::testing::randomDomain;
using forefront::testing::RandomSource;

namespace {

/// Random domains to mesh: FOREFRONT_THREADS_DOMAINS, or a few that take several seconds.
std::uint64_t domainCount() {
    const char *const requested = std::getenv("FOREFRONT_THREADS_DOMAINS");
    if (requested != nullptr) {
        return std::strtoull(requested, nullptr, 10);
    }
    return forefront::testing::kSanitized ? 2 : 10;
}

/// About 10,000 elements: enough that threads share the work. Every other domain is graded.
MeshingJob jobOf(std::uint64_t seed) {
    MeshingJob job;
    job.domain = randomDomain(seed);
    const Box2 box = job.domain.bounds();
    if (seed / testing::kDomainFamilies % 2 == 0) {
        job.spacing.size = box.diagonal() / 120.0;
    } else {
        RandomSource random(seed);
        SizeSource source;
        source.a = box.min + Vec2{random.unit() * box.size().x, random.unit() * box.size().y};
        source.size = box.diagonal() / 2000.0;
        source.growth = 0.03;
        job.spacing.sources.push_back(source);
        job.spacing.maximum = box.diagonal() / 60.0;
    }
    return job;
}

/// Meshes the job on 1, 2, 3, 5 and 8 threads with both methods at every level and compares the meshes; returns the
/// number of meshes made.
int checkThreads(MeshingJob job) {
    int meshes = 0;
    for (const Method method : {Method::Fast, Method::Classic}) {
        for (const ImproveLevel level : {ImproveLevel::None, ImproveLevel::Default, ImproveLevel::Best}) {
            CAPTURE(static_cast<int>(method));
            CAPTURE(static_cast<int>(level));
            job.options.method = method;
            job.options.improve = level;
            std::uint64_t expected = 0;
            for (const unsigned threads : {1U, 2U, 3U, 5U, 8U}) {
                CAPTURE(threads);
                job.options.threads = threads;
                const Result<MeshingOutcome> outcome = meshDomain(job);
                REQUIRE(outcome.ok());
                const std::uint64_t hash = meshHash(outcome->mesh);
                expected = threads == 1 ? hash : expected;
                CHECK(hash == expected);
                ++meshes;
            }
        }
    }
    return meshes;
}

} // namespace

TEST_CASE("Threads: random domains give the same mesh for any number of threads, by method and level") {
    int meshes = 0;
    for (std::uint64_t seed = 0; seed < domainCount(); ++seed) {
        CAPTURE(seed);
        meshes += checkThreads(jobOf(seed));
    }
    MESSAGE(meshes, " meshes compared");
}

TEST_CASE("Threads: real domains give the same mesh for any number of threads, by method and level") {
    const char *const folder = std::getenv("FOREFRONT_DATA");
    if (folder == nullptr) {
        MESSAGE("skipped: FOREFRONT_DATA names no folder with domains");
        return;
    }
    int files = 0, meshes = 0;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder)) {
        CAPTURE(entry.path().string());
        const Result<DomainFile> domain = allFormats().readDomain(entry.path());
        MeshingJob job;
        if (domain.ok()) {
            job.domain = domain->domain;
            job.spacing = domain->spacing;
        }
        if (!domain.ok() || !prepare(job).ok()) {
            continue; // a note beside the domains, or a domain that has to be repaired first
        }
        ++files;
        meshes += checkThreads(std::move(job));
    }
    CHECK(files > 0);
    MESSAGE(meshes, " meshes of ", files, " files compared");
}
