#include "core/files/files.hpp"
#include "core/files/inner_edges.hpp"
#include "core/files/open_boundaries.hpp"
#include "core/files/source/source.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Returns the bytes of all files that a mesh is written to.
std::string bytesIn(const TemporaryFolder &folder, const FileFormat &format, const MeshView &mesh) {
    const std::filesystem::path path = folder / (std::string("a_") + format.id + format.extension);
    const Status status = writeMesh(path, mesh, format.id);
    REQUIRE_MESSAGE(status.empty(), messages(status));
    std::string bytes;
    for (const std::filesystem::path &file : filesOfMesh(path, format.id)) {
        bytes += readFileBytes(file, 1U << 26U).value();
    }
    return bytes;
}

} // namespace

TEST_CASE("Formats: what the list says of names and inner edges is true of their files") {
    const TemporaryFolder folder;
    TriMesh mesh = twoRegionMesh();
    mesh.boundaryNames.clear();
    mesh.regionNames.clear();
    for (const auto &[tag, name] : boundaryPartsOf(mesh)) {
        mesh.boundaryNames[tag] = "qzshore" + std::to_string(tag);
    }
    mesh.regionNames = {{2, "qzlake"}, {5, "qzbay"}};
    for (const FileFormat &format : engineFormats().list()) {
        if (!format.writesMesh) {
            continue;
        }
        CAPTURE(std::string(format.id));
        const std::string bytes = bytesIn(folder, format, mesh);
        CHECK((bytes.find("qzshore") == std::string::npos) == format.dropsBoundaryNames);
        CHECK((bytes.find("qzlake") == std::string::npos) == format.dropsRegionNames);
        if (format.acceptsInnerEdges) {
            CHECK((bytesIn(folder, format, withoutInnerEdges(mesh)) == bytes) == format.dropsInnerEdges);
        }
    }
}
