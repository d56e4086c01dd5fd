#include "core/drawing_files/dxf/dxf_drawing.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/files/dxf/dxf_write.hpp"
#include "core/files/files.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace dxf_write_tests {

/// A fan of triangles in a disc of radius 2 about (1, 1), or in an ellipse as high as `height`, with a slit named by a
/// tag of its own.
TriMesh disc(double height = 2.0) {
    constexpr std::uint32_t kSides = 16;
    TriMesh mesh;
    mesh.curves = {Curve::arc({1, 1}, {2, 0}, {0, height})};
    const auto node = [](std::uint32_t n) { return NodeId{n}; };
    for (std::uint32_t k = 0; k < kSides; ++k) {
        mesh.nodes.push_back(mesh.curves[0].point(k / double{kSides}));
        mesh.elements.push_back({node(k), node((k + 1) % kSides), node(kSides)});
        mesh.edges.push_back({node(k), node((k + 1) % kSides), 2});
        mesh.edgeStretches.push_back({0, k / double{kSides}, (k + 1) / double{kSides}});
    }
    mesh.nodes.push_back({1, 1});
    mesh.edges.push_back({node(0), node(kSides), 7});
    mesh.edgeStretches.emplace_back();
    mesh.points = {{node(kSides), 1}};
    mesh.boundaryNames = {{2, "round wall"}, {7, "slit"}};
    return mesh;
}

DxfPaths pathsOf(const std::string &text) {
    const SourceText source = sourceOf(text);
    const auto file = readDxfFile(source);
    REQUIRE_MESSAGE(file.ok(), messages(file.faults()));
    const auto drawn = drawDxf(*file, source);
    REQUIRE_MESSAGE(drawn.ok(), messages(drawn.faults()));
    return *drawn;
}

double lengthOn(const DxfPaths &paths, const std::string &layer) {
    double length = 0.0;
    for (const DxfPath &path : paths.paths) {
        for (std::size_t k = path.first; paths.layers[path.layer] == layer && k < path.first + path.count; ++k) {
            length += paths.curves[k].length();
        }
    }
    return length;
}

std::size_t countIn(const std::string &text, const std::string &words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
        ++count;
    }
    return count;
}

} // namespace dxf_write_tests

namespace dw = dxf_write_tests;

TEST_CASE("DXF: an outline is written with its exact arcs, a layer for each boundary part") {
    const DxfPaths paths = dw::pathsOf(written(writeDxfOutline, dw::disc()));
    CHECK(paths.layers == std::vector<std::string>{"round_wall", "slit"});
    CHECK(dw::lengthOn(paths, "round_wall") == doctest::Approx(4 * std::numbers::pi).epsilon(1e-12));
    CHECK(dw::lengthOn(paths, "slit") == doctest::Approx(2.0));
    REQUIRE(paths.paths.size() == 2);
    CHECK(paths.paths[0].closed);
    CHECK(paths.paths[0].count == 3);
    // Ellipses become polylines close to them.
    const DxfPaths flat = dw::pathsOf(written(writeDxfOutline, dw::disc(1.0)));
    const double exact = Curve::arc({1, 1}, {2, 0}, {0, 1}).length();
    CHECK(dw::lengthOn(flat, "round_wall") == doctest::Approx(exact).epsilon(1e-5));
    // Sides become one segment each, however many edges they have.
    const TriMesh plate = twoRegionMesh();
    const DxfPaths sides = dw::pathsOf(written(writeDxfOutline, plate));
    CHECK(sides.curves.size() < plate.edges.size());
}

TEST_CASE("DXF: a mesh is written with faces on the layers of regions, and read back as its outline") {
    const std::string text = written(writeDxf, dw::disc());
    CHECK(dw::countIn(text, "\n3DFACE\n") == 16);
    CHECK(dw::countIn(text, "\nPOINT\n") == 1);
    CHECK(dw::countIn(text, "\n8\nregion_1\n") == 16);
    CHECK(text.starts_with("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n"));
    CHECK(text.ends_with("0\nENDSEC\n0\nEOF\n"));
    const DxfPaths paths = dw::pathsOf(text);
    CHECK(paths.curves.size() == 17); // the edges
    const Diagnostics notes = noteDxfChanges(dw::disc());
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].message.find("'round wall' is round_wall") != std::string::npos);
}
