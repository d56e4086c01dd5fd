#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_parts.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

const std::string kNames = "$PhysicalNames\n2\n1 7 \"inlet\"\n2 3 \"plate\"\n$EndPhysicalNames\n";

/// A square of two triangles in two partitions: pieces 5 of curve 1, 2 and 3 of surface 1, and the interface 6.
const std::string kPartitioned =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + kNames +
    "$Entities\n0 1 1 0\n1 0 0 0 1 0 0 1 7 0\n1 0 0 0 1 1 0 1 3 1 1\n$EndEntities\n"
    "$PartitionedEntities\n2\n0\n1 2 2 0\n9 0 1 1 1 0 0 0 0\n5 1 1 1 1 0 0 0 1 0 0 0 0\n"
    "6 2 1 2 1 2 0 0 0 1 1 0 1 3 0\n"
    "2 2 1 1 1 0 0 0 1 1 0 1 3 1 5\n3 2 1 1 2 0 0 0 1 1 0 0 1 5\n$EndPartitionedEntities\n"
    "$Nodes\n1 4 1 4\n2 2 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n"
    "$Elements\n4 4 1 4\n1 5 1 1\n1 1 2\n1 6 1 1\n2 1 3\n2 3 2 1\n3 1 3 4\n2 2 2 1\n4 1 2 3\n$EndElements\n";

template <class T>
void put(std::string &bytes, T value) {
    bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
}
void ints(std::string &bytes, std::initializer_list<std::int32_t> values) {
    for (const std::int32_t value : values) {
        put(bytes, value);
    }
}
void size(std::string &bytes, std::uint64_t value) {
    put(bytes, value);
}
void reals(std::string &bytes, std::initializer_list<double> values) {
    for (const double value : values) {
        put(bytes, value);
    }
}

/// The same mesh in binary.
std::string partitionedBinary() {
    std::string b = "$MeshFormat\n4.1 1 8\n";
    ints(b, {1});
    b += "\n$EndMeshFormat\n" + kNames + "$Entities\n";
    for (const std::uint64_t count : {0, 1, 1, 0}) {
        size(b, count);
    }
    const auto entity = [&](std::initializer_list<std::int32_t> head, std::initializer_list<std::int32_t> partitions,
                            std::initializer_list<std::int32_t> groups, std::size_t coordinates) {
        ints(b, head);
        if (head.size() > 1) {
            size(b, partitions.size());
            ints(b, partitions);
        }
        for (std::size_t k = 0; k < coordinates; ++k) {
            reals(b, {0.0});
        }
        size(b, groups.size());
        ints(b, groups);
        if (coordinates == 6) {
            size(b, 0); // bounds
        }
    };
    entity({1}, {}, {7}, 6);
    entity({1}, {}, {3}, 6);
    b += "\n$EndEntities\n$PartitionedEntities\n";
    for (const std::uint64_t count : {2, 1}) {
        size(b, count);
    }
    ints(b, {8, 1}); // a ghost entity and its partition
    for (const std::uint64_t count : {1, 2, 2, 0}) {
        size(b, count);
    }
    entity({9, 0, 1}, {1}, {}, 3);
    entity({5, 1, 1}, {1}, {}, 6);
    entity({6, 2, 1}, {1, 2}, {3}, 6);
    entity({2, 2, 1}, {1}, {3}, 6);
    entity({3, 2, 1}, {2}, {}, 6);
    b += "\n$EndPartitionedEntities\n$Nodes\n";
    for (const std::uint64_t count : {1, 4, 1, 4}) {
        size(b, count);
    }
    ints(b, {2, 2, 0});
    for (const std::uint64_t count : {4, 1, 2, 3, 4}) {
        size(b, count);
    }
    reals(b, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    b += "\n$EndNodes\n$Elements\n";
    for (const std::uint64_t count : {4, 4, 1, 4}) {
        size(b, count);
    }
    const auto block = [&](std::initializer_list<std::int32_t> head, std::initializer_list<std::uint64_t> row) {
        ints(b, head);
        size(b, 1);
        for (const std::uint64_t value : row) {
            size(b, value);
        }
    };
    block({1, 5, 1}, {1, 1, 2});
    block({1, 6, 1}, {2, 1, 3});
    block({2, 3, 2}, {3, 1, 3, 4});
    block({2, 2, 2}, {4, 1, 2, 3});
    return b + "\n$EndElements\n";
}

void checkPartitions(const std::string &text) {
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto read = readMshFields(source);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    const TriMesh mesh = takeTriMesh(read->mesh);
    CHECK(mesh.regionNames == std::map<std::int32_t, std::string>{{3, "plate"}});
    CHECK(mesh.boundaryNames == std::map<std::int32_t, std::string>{{7, "inlet"}});
    REQUIRE(mesh.elements.size() == 2);
    CHECK(mesh.region(0) == 3);
    CHECK(mesh.region(1) == 3);
    REQUIRE(mesh.edges.size() == 1); // not the one between the partitions
    CHECK(mesh.edges[0].tag == 7);
    CHECK(read->elementFields == NamedFields{{"partition", {2, 1}}});
    REQUIRE(notes.entries().size() == 2);
    CHECK(notes.entries()[0].code == "partitions");
    CHECK(notes.entries()[0].message.find("2 partitions") != std::string::npos);
    CHECK(notes.entries()[1].code == "partition-interface");
    CHECK(notes.entries()[1].count == 1);
}

} // namespace

TEST_CASE("MSH 4.1: a mesh in partitions keeps names and tags, and its partitions are a field") {
    checkPartitions(kPartitioned);
    checkPartitions(partitionedBinary());
    const auto groups = mshCurveGroups(kPartitioned); // as check --domain reads them
    REQUIRE(groups);
    REQUIRE(groups->size() == 1);
    CHECK(groups->at(7).name == "inlet");
    CHECK(groups->at(7).length == 1.0);
    // Cut anywhere, it is refused, not misread.
    const std::string whole = partitionedBinary();
    for (std::size_t end = 0; end + 12 < whole.size(); end += 7) {
        CHECK_FALSE(readMsh(sourceOf(whole.substr(0, end))).ok());
    }
}

TEST_CASE("MSH 4.1: pieces without a group get the tag of the entity that they are pieces of") {
    std::string text = kPartitioned;
    for (const std::string group : {"0 1 3 1 1\n", "0 1 3 1 5\n"}) {
        text.replace(text.find(group), group.size(), "0 0" + group.substr(5));
    }
    const auto mesh = triangles(readMsh(sourceOf(text)));
    REQUIRE_MESSAGE(mesh.ok(), messages(mesh.faults()));
    CHECK(mesh->region(0) == 1);
    CHECK(mesh->region(1) == 1);
}

TEST_CASE("MSH 2.2: partitions are a field") {
    const auto read =
        readMshFields(sourceOf("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
                               "$EndNodes\n$Elements\n2\n1 2 4 3 1 1 2 1 2 3\n2 2 5 3 1 2 1 -2 1 3 4\n$EndElements\n"));
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    CHECK(MeshView(read->mesh).region(1) == 3);
    CHECK(read->elementFields == NamedFields{{"partition", {2, 1}}});
}
