#include "core/engine/mesh/verify.hpp"
#include "core/files/files.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <random>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Overwrites a number at a byte.
template <class T>
std::string with(std::string bytes, std::size_t place, T value) {
    REQUIRE(place + sizeof value <= bytes.size());
    std::memcpy(bytes.data() + place, &value, sizeof value);
    return bytes;
}

/// Returns the first byte after the name of a section and its line end.
std::size_t behind(const std::string &bytes, const std::string &section) {
    const std::size_t place = bytes.find("$" + section + "\n");
    REQUIRE(place != std::string::npos);
    return place + section.size() + 2;
}

void checkRefused(const std::string &bytes, const char *code, std::size_t place) {
    CAPTURE(code);
    const Result<TriMesh> mesh = triangles(readMsh(sourceOf(bytes, "broken.msh")));
    REQUIRE(!mesh.ok());
    REQUIRE(mesh.faults().size() == 1);
    const Diagnostic &fault = mesh.faults().front();
    CHECK(fault.code == code);
    CHECK_MESSAGE(fault.message.ends_with(", at byte " + std::to_string(place)), fault.message);
}

} // namespace

TEST_CASE("Binary MSH: gives the same mesh as the ASCII file, for any order of blocks") {
    const TriMesh mesh = twoRegionMesh();
    const Result<TriMesh> text = triangles(readMsh(sourceOf(written(writeMsh4, mesh))));
    const std::string bytes = written(writeMsh4Binary, mesh);
    const Result<TriMesh> binary = triangles(readMsh(sourceOf(bytes)));
    REQUIRE(text.ok());
    REQUIRE_MESSAGE(binary.ok(), messages(binary.faults()));
    CHECK(meshHash(*text) == meshHash(*binary));
    CHECK(difference(mesh, *binary) == "");
    CHECK(verify(*binary).empty());
    CHECK(written(writeMsh4Binary, *binary).size() == bytes.size());
}

TEST_CASE("Binary MSH: reads numbers whose bytes look like blanks, line ends or section names") {
    TriMesh mesh = samples::square(4, 4);
    const char name[] = "\n$EndNod";
    std::memcpy(&mesh.nodes[12].x, name, sizeof(double));
    std::memset(static_cast<void *>(&mesh.nodes[3].y), ' ', sizeof(double));
    mesh.elements.resize(1); // only the numbers matter
    const Result<TriMesh> back = triangles(readMsh(sourceOf(written(writeMsh4Binary, mesh))));
    REQUIRE_MESSAGE(back.ok(), messages(back.faults()));
    CHECK(back->nodes == mesh.nodes);
}

TEST_CASE("Binary MSH: nodal values are read as field and as spacing") {
    const TriMesh mesh = samples::square(2, 2);
    std::string bytes = written(writeMsh4Binary, mesh) + "$NodeData\n1\n\"heat\"\n1\n0\n3\n0\n1\n9\n";
    for (std::int32_t node = 1; node <= 9; ++node) {
        const double value = 10.0 / node;
        bytes.append(reinterpret_cast<const char *>(&node), sizeof node);
        bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
    }
    const std::size_t values = bytes.size() - 9 * 12;
    bytes += "\n$EndNodeData\n";
    const Result<MeshField> field = fieldIn(readMshFields, sourceOf(bytes), "heat");
    REQUIRE_MESSAGE(field.ok(), messages(field.faults()));
    CHECK(field->values[0] == 10.0);
    CHECK(field->values[8] == 10.0 / 9.0);
    const Result<SpacingSpec> spacing = readMshSpacing(sourceOf(bytes));
    REQUIRE(spacing.ok());
    CHECK(spacing->background->values[4] == 2.0);
    checkRefused(with(bytes, values + 12, std::int32_t{77}), "bad-index", values + 12);
    checkRefused(with(bytes, values + 16, std::numeric_limits<double>::infinity()), "non-finite", values + 16);
    const Result<SpacingSpec> negative = readMshSpacing(sourceOf(with(bytes, values + 28, -1.0)));
    REQUIRE(!negative.ok());
    CHECK(negative.faults().front().message.ends_with("at byte " + std::to_string(values + 28)));
}

TEST_CASE("Binary MSH: values of triangles are read in the order of the mesh") {
    const TriMesh mesh = twoRegionMesh();
    std::string bytes = written(writeMsh4Binary, mesh);
    const auto all = static_cast<std::int32_t>(mesh.points.size() + mesh.edges.size() + mesh.elements.size());
    bytes += "$ElementData\n1\n\"flux\"\n1\n0\n3\n0\n1\n" + std::to_string(all) + "\n";
    for (std::int32_t element = all; element >= 1; --element) {
        const double value = element;
        bytes.append(reinterpret_cast<const char *>(&element), sizeof element);
        bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
    }
    bytes += "\n$EndElementData\n";
    const Result<MeshFields> read = readMshFields(sourceOf(bytes));
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    CHECK(difference(mesh, takeTriMesh(read->mesh)) == "");
    const std::vector<double> &flux = read->elementFields.at("flux");
    REQUIRE(flux.size() == mesh.elements.size());
    for (std::size_t e = 1; e < flux.size(); ++e) {
        CHECK(flux[e] > flux[e - 1]); // the writer numbers them in order
    }
}

TEST_CASE("Binary MSH: refuses impossible values with their byte") {
    const TriMesh mesh = twoRegionMesh(4, 2);
    const std::string bytes = written(writeMsh4Binary, mesh);
    const std::size_t format = behind(bytes, "MeshFormat"), entities = behind(bytes, "Entities"),
                      nodes = behind(bytes, "Nodes"), elements = behind(bytes, "Elements");
    constexpr std::uint64_t kHuge = 0x8000000000000000U, kMany = 1'000'000'000'000U;
    // Header: byte order, size of counts, version.
    checkRefused(with(bytes, format + 8, std::uint32_t{0x01000000}), "byte-order", format + 7);
    checkRefused(with(bytes, format + 8, std::uint32_t{2}), "bad-syntax", format + 7);
    checkRefused(with(bytes, format + 6, '4'), "unknown-size", format + 7);
    std::string older = bytes;
    older.replace(format, 3, "2.2");
    CHECK(triangles(readMsh(sourceOf(older))).faults().front().code == "binary");
    // Counts.
    for (const std::uint64_t count : {kHuge, kMany, ~std::uint64_t{0}}) {
        checkRefused(with(bytes, entities, count), "bad-count", entities);
        checkRefused(with(bytes, nodes, count), "bad-count", nodes);
        checkRefused(with(bytes, nodes + 8, count), "bad-count", nodes + 8);
        checkRefused(with(bytes, nodes + 44, count), "bad-count", nodes + 44);
        checkRefused(with(bytes, elements + 8, count), "bad-count", elements + 8);
        checkRefused(with(bytes, elements + 44, count), "bad-count", elements + 44);
    }
    checkRefused(with(bytes, nodes + 8, std::uint64_t{1}), "bad-count",
                 nodes + 44 + 12 + 8 + 32); // of the second block
    checkRefused(with(bytes, elements + 8, std::uint64_t{0}), "bad-count", elements + 44);
    // Numbers. The first block of each section is the tagged point: one node, one element.
    checkRefused(with(bytes, nodes + 32, std::int32_t{7}), "out-of-range", nodes + 32);
    checkRefused(with(bytes, nodes + 40, std::int32_t{2}), "out-of-range", nodes + 40);
    checkRefused(with(bytes, nodes + 52, std::int64_t{-3}), "out-of-range", nodes + 52);
    checkRefused(with(bytes, nodes + 60, std::numeric_limits<double>::quiet_NaN()), "non-finite", nodes + 60);
    const std::size_t lastHeight = bytes.find("\n$EndNodes") - sizeof(double);
    checkRefused(with(bytes, lastHeight, 1.0), "not-planar", lastHeight);
    checkRefused(with(bytes, elements + 40, std::int32_t{4}), "unknown-element", elements + 40);
    checkRefused(with(bytes, elements + 60, std::int64_t{16}), "bad-index", elements + 60);
}

TEST_CASE("Binary MSH: a truncated file is refused with a valid byte position") {
    const std::string bytes = written(writeMsh4Binary, twoRegionMesh(3, 2));
    for (std::size_t size = 0; size + 2 < bytes.size(); ++size) {
        CAPTURE(size);
        const Result<TriMesh> mesh = triangles(readMsh(sourceOf(bytes.substr(0, size), "cut")));
        // After the nodes, a cut between two sections leaves a valid file.
        if (mesh.ok()) {
            const bool afterNodes = size > bytes.find("$EndNodes") && size <= bytes.find("$Elements");
            const bool afterElements = size > bytes.find("$EndElements") && size <= bytes.find("$Comments");
            CHECK((afterNodes || afterElements));
            continue;
        }
        CHECK(allLocated(mesh.faults()));
        const std::string &message = mesh.faults().front().message;
        const std::size_t place = message.rfind(", at byte ");
        if (size > 20) {
            REQUIRE(place != std::string::npos);
            CHECK(std::stoull(message.substr(place + 10)) <= size);
        }
    }
}

TEST_CASE("Binary MSH: flipped bits are refused with a place, or harmless") {
    const std::string bytes = written(writeMsh4Binary, twoRegionMesh(4, 2));
    std::mt19937 random(3);
    int refused = 0;
    for (int round = 0; round < 4000; ++round) {
        std::string broken = bytes;
        for (auto flips = 1 + random() % 3; flips > 0; --flips) {
            char &byte = broken[random() % broken.size()];
            byte = static_cast<char>(byte ^ (1 << (random() % 8)));
        }
        const Result<TriMesh> mesh = triangles(readMsh(sourceOf(broken, "flipped")));
        refused += mesh.ok() ? 0 : 1;
        CHECK((mesh.ok() || allLocated(mesh.faults())));
    }
    CHECK(refused > 1000);
}
