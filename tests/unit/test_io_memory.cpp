#include "core/drawing_files/drawing_formats.hpp"
#include "core/files/files.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>

namespace forefront {

TEST_CASE("Files in memory: every format that can be written to a stream is read back, by id or by name") {
    const TriMesh mesh = samples::constrainedSquare(4, 0.1, {}, 3);
    int formats = 0;
    for (const FileFormat &format : engineFormats().list()) {
        StringSink sink;
        if (!format.readsMesh || !format.writesMesh || !writeMesh(sink, mesh, format.id).empty()) {
            continue;
        }
        CAPTURE(format.id);
        ++formats;
        const Result<TriMesh> byId = testing::triangles(readMesh(MemoryFile{sink.text, format.id}));
        const Result<TriMesh> byName =
            testing::triangles(readMesh(MemoryFile{sink.text, std::string("mesh") + format.extension}));
        const Result<DomainFile> domain = readDomain(MemoryFile{sink.text, format.id});
        REQUIRE(byId);
        REQUIRE(byName);
        CHECK(meshHash(*byId) == meshHash(*byName));
        CHECK(byId->elements.size() == mesh.elements.size());
        REQUIRE(domain);
        CHECK_FALSE(domain->domain.segments.empty());
        CHECK(readFields(MemoryFile{sink.text, format.id}));
    }
    CHECK(formats > 5);
}

TEST_CASE("Files in memory: a domain by its content alone, and a grid of sizes") {
    const Result<DomainFile> domain = allFormats().readDomain(
        MemoryFile{R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 0]]]})"});
    REQUIRE(domain);
    CHECK(domain->domain.segments.size() == 3);
    const Result<SpacingSpec> spacing =
        readSpacing(MemoryFile{"ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n", "depth.asc"});
    REQUIRE(spacing);
    CHECK(spacing->background->values.size() == 16);
}

TEST_CASE("Files in memory: faults name the file as the caller does") {
    const Result<TriMesh> bad =
        testing::triangles(readMesh(MemoryFile{"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nmany\n", "plate.msh"}));
    REQUIRE_FALSE(bad);
    CHECK(bad.faults().front().file == "plate.msh");
    CHECK(bad.faults().front().line == 5);
    CHECK(testing::triangles(readMesh(MemoryFile{"", "msh2"})).faults().front().code == "empty-file");
    const Result<TriMesh> unknown = testing::triangles(readMesh(MemoryFile{"no mesh at all"}));
    REQUIRE_FALSE(unknown);
    CHECK(unknown.faults().front().code == "unknown-format");
    CHECK(unknown.faults().front().file == "memory");
}

} // namespace forefront
