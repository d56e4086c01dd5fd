#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/geojson/geojson.hpp"
#include "core/drawing_files/geojson/topojson.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/files/abaqus/abaqus.hpp"
#include "core/files/format.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/medit/medit.hpp"
#include "core/files/obj/obj.hpp"
#include "core/files/su2/su2.hpp"
#include "core/files/triangle/triangle.hpp"
#include "core/files/vtk/vtk.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <random>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A small valid file of a format and its reader.
struct Seed {
    std::string name;
    std::string text;
    std::function<Diagnostics(const SourceText &)> read;
};

template <class T>
std::function<Diagnostics(const SourceText &)> faultsOf(Result<T> (*read)(const SourceText &)) {
    return [read](const SourceText &source) {
        const Result<T> result = read(source);
        return result ? Diagnostics{} : result.faults();
    };
}

std::vector<Seed> seeds() {
    const TriMesh mesh = twoRegionMesh(4, 2);
    std::vector<Seed> list = {
        {"project", projectText(fullDocument()), faultsOf(readProjectText)},
        {"geojson",
         "{\"type\": \"FeatureCollection\", \"features\": [{\"type\": \"Feature\", \"properties\": {\"name\": \"a\"}, "
         "\"geometry\": {\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], "
         "[2, 1], [2, 2], [1, 1]]]}}, {\"type\": \"Feature\", \"geometry\": {\"type\": \"LineString\", "
         "\"coordinates\": [[3, 3], [3.5, 3.5]]}}]}",
         faultsOf(readGeoJson)},
        {"topojson",
         "{\"type\": \"Topology\", \"transform\": {\"scale\": [0.5, 1], \"translate\": [1, 2]}, \"arcs\": [[[2, 0], "
         "[0, 3]], "
         "[[2, 3], [-2, 0], [0, -3], [2, 0]], [[2, 0], [2, 0], [0, 3], [-2, 0]]], \"objects\": {\"a\": {\"type\": "
         "\"GeometryCollection\", \"geometries\": [{\"type\": \"Polygon\", \"arcs\": [[0, 1]]}, {\"type\": "
         "\"MultiPolygon\", "
         "\"arcs\": [[[2, -1]]]}, {\"type\": \"Point\", \"coordinates\": [1, 1]}]}}}",
         faultsOf(readTopoJson)},
        {"svg",
         "<svg viewBox=\"0 0 10 10\"><g transform=\"rotate(30 5 5) scale(2)\"><path id=\"a\" d=\"M1 1h2v2C3 3 2 4 1 "
         "3zM6,6a1 2 30 1 0 1 1Q7 7 8 6t1 1z\"/></g><circle r=\"2\"/><rect width=\"3\" height=\"2\" rx=\".5\"/></svg>",
         faultsOf(readSvg)},
        {"poly",
         "8 2 1 1\n0 0 0 7 1\n1 4 0 7 1\n2 4 4 7 1\n3 0 4 7 1\n4 1 1 0 0\n5 2 1 0 0\n6 2 2 0 0\n7 1 2 0 0\n8 1\n0 0 1 "
         "3\n1 1 2 0\n2 2 3 2\n3 3 0 3\n4 4 5 9\n5 5 6 9\n6 6 7 9\n7 7 4 9\n1\n0 1.5 1.5\n1\n0 0.5 0.5 4 0.1\n",
         faultsOf(readPoly)}};
    for (const Format &format : allFormats().formats()) {
        if (format.readMesh != nullptr && format.writesText()) {
            list.push_back({format.about.id, written(format, mesh), faultsOf(format.readMesh)});
        }
    }
    return list;
}

/// Breaks a file in one of several ways, each with its own fixed random sequence.
std::string broken(const std::string &text, std::size_t way, std::mt19937 &random) {
    std::string result = text;
    const auto at = [&] { return static_cast<std::size_t>(random() % std::max<std::size_t>(result.size(), 1)); };
    const auto digit = [&] {
        for (int tries = 0; tries < 200; ++tries) {
            const std::size_t place = at();
            if (result[place] >= '0' && result[place] <= '9') {
                return place;
            }
        }
        return std::size_t{0};
    };
    switch (way % 8) {
    case 0:
        result.resize(at());
        break;
    case 1:
        for (int k = 0; k < 3; ++k) {
            const std::size_t place = at();
            result[place] = static_cast<char>(result[place] ^ (1 << (random() % 8)));
        }
        break;
    case 2:
        result.replace(digit(), 1, "nan");
        break;
    case 3:
        result.replace(digit(), 1, "999999999999999999999");
        break;
    case 4:
        result.replace(digit(), 1, "-1e999");
        break;
    case 5:
        result.replace(digit(), 1, "4000000000");
        break;
    case 6: {
        const std::size_t begin = at();
        result.erase(begin, 1 + random() % 40);
        break;
    }
    default: {
        const std::size_t begin = at();
        result.insert(at(), result.substr(begin, 1 + random() % 60));
        break;
    }
    }
    return result;
}

} // namespace

TEST_CASE("Broken files: every reader accepts its intact sample") {
    for (const Seed &seed : seeds()) {
        CAPTURE(seed.name);
        const Diagnostics faults = seed.read(sourceOf(seed.text, "sound"));
        CHECK_MESSAGE(faults.empty(), messages(faults));
    }
}

TEST_CASE(
    "Broken files: truncated, altered or overflowing files of every format are refused with a place, or read safely") {
    std::size_t files = 0, refused = 0;
    for (const Seed &seed : seeds()) {
        std::mt19937 random(20240611);
        std::size_t refusedHere = 0;
        for (std::size_t way = 0; way < 96; ++way) {
            const std::string text = broken(seed.text, way, random);
            const Diagnostics faults = seed.read(sourceOf(text, seed.name));
            ++files;
            refusedHere += faults.empty() ? 0U : 1U;
            CAPTURE(seed.name);
            CAPTURE(way);
            CHECK_MESSAGE(allLocated(faults), messages(faults));
        }
        CAPTURE(seed.name);
        CHECK(refusedHere > 30);
        refused += refusedHere;
    }
    CHECK(files >= 1000);
    CHECK(refused >= 500);
}

TEST_CASE("Broken files: counts that exceed the file are refused in every format with counts") {
    const TriMesh mesh = samples::square(3, 3);
    for (const Format &format : allFormats().formats()) {
        if (format.readMesh == nullptr || !format.writesText() || std::string_view(format.about.id) == "inp" ||
            std::string_view(format.about.id) == "obj" || std::string_view(format.about.id) == "vtu" ||
            std::string_view(format.about.id) == "nastran" || std::string_view(format.about.id) == "2dm" ||
            std::string_view(format.about.id) == "msh41-binary") { // see test_io_binary.cpp
            continue;
        }
        CAPTURE(std::string(format.about.id));
        std::string text = written(format, mesh);
        const bool su2 = std::string_view(format.about.id) == "su2";
        const std::size_t count = text.find(su2 ? "NPOIN= 16" : "16") + (su2 ? 7 : 0);
        REQUIRE(count < text.size());
        text.replace(count, 2, "4294967296000");
        const auto result = format.readMesh(sourceOf(text));
        REQUIRE(!result.ok());
        CHECK_MESSAGE(allLocated(result.faults()), messages(result.faults()));
    }
}

TEST_CASE("Broken files: empty files, single bytes and random bytes") {
    std::mt19937 random(77);
    for (const Seed &seed : seeds()) {
        CAPTURE(seed.name);
        CHECK(!seed.read(sourceOf("", seed.name)).empty());
        for (int round = 0; round < 20; ++round) {
            std::string noise(random() % 300 + 1, '\0');
            for (char &c : noise) {
                c = static_cast<char>(random() & 255U);
            }
            if (round % 2 == 1) {
                noise = seed.text.substr(0, seed.text.size() / 2) + noise;
            }
            CHECK(allLocated(seed.read(sourceOf(noise, seed.name))));
        }
    }
}
