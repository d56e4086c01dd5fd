#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

using namespace forefront;

TEST_CASE("Automatic spacing: real domains mesh well with default options, in moderate numbers of elements") {
    const char *const folder = std::getenv("FOREFRONT_DATA");
    if (folder == nullptr) {
        MESSAGE("skipped: FOREFRONT_DATA names no folder with .poly files");
        return;
    }
    int files = 0;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".poly") {
            continue;
        }
        ++files;
        const std::string name = entry.path().filename().string();
        const auto read = allFormats().readDomain(entry.path());
        REQUIRE_MESSAGE(read.ok(), name);
        MeshingJob job;
        job.domain = read->domain;
        job.spacing = read->spacing;
        const auto outcome = meshDomain(job);
        REQUIRE_MESSAGE(outcome.ok(), name);
        const MeshQuality quality = measureQuality(outcome->mesh, outcome->spacing.get());
        CHECK_MESSAGE(quality.alphaGeometricMean >= 0.93, name);
        CHECK_MESSAGE(quality.deltaMean >= 0.88, name);
        CHECK_MESSAGE(quality.elements >= 500, name);
        CHECK_MESSAGE(quality.elements <= 80000, name);
    }
    CHECK(files > 0);
}
