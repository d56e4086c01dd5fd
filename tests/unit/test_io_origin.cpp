#include "core/drawing_files/geojson/geojson.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/files/triangle/triangle.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Checks that there is one origin for each part that a reader makes.
void checkComplete(const DomainOrigin &origin, const Domain &domain) {
    CHECK(origin.of(DomainPartKind::Node).size() == domain.nodes.size());
    CHECK(origin.of(DomainPartKind::Segment).size() == domain.segments.size());
    CHECK(origin.of(DomainPartKind::ConstraintPoint).size() == domain.points.size());
    CHECK(origin.of(DomainPartKind::HoleMarker).size() == domain.holeMarkers.size());
    CHECK(origin.of(DomainPartKind::RegionMarker).size() == domain.regionMarkers.size());
}

} // namespace

TEST_CASE("DomainOrigin: places of GeoJSON nodes and segments are those of their coordinates") {
    const std::string text = R"({"type": "GeometryCollection", "geometries": [
        {"type": "MultiPolygon", "coordinates": [
            [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [1, 2], [2, 2], [1, 1]]],
            [[[4, 0], [9, 0], [9, 4], [4, 4]]]]},
        {"type": "LineString", "coordinates": [[5, 1], [6, 1], [6, 1], [9, 4]]},
        {"type": "Point", "coordinates": [8, 1]}]})";
    SourceText source = sourceOf(text);
    DomainOrigin origin;
    source.origin = &origin;
    const Result<Domain> domain = readGeoJson(source);
    REQUIRE(domain.ok());
    checkComplete(origin, *domain);
    const auto written = [&](const PartOrigin &place) {
        Vec2 p{-1, -1};
        CHECK(std::sscanf(text.c_str() + place.offset, "[%lf, %lf]", &p.x, &p.y) == 2);
        return p;
    };
    for (std::size_t n = 0; n < domain->nodes.size(); ++n) {
        CHECK(written(origin.of(DomainPartKind::Node)[n]) == domain->nodes[n]);
    }
    for (std::size_t s = 0; s < domain->segments.size(); ++s) {
        CHECK(written(origin.of(DomainPartKind::Segment)[s]) == domain->nodes[domain->segments[s].a]);
    }
    CHECK(written(origin.of(DomainPartKind::ConstraintPoint)[0]) == Vec2{8, 1});
}

TEST_CASE("DomainOrigin: parts of a .poly file keep their numbers") {
    const std::string text = "# a square, a free node, a hole\n6 2\n5 0 0\n6 4 0\n7 4 4\n8 0 4\n\n9 1 1 # free\n2 3 3\n"
                             "5\n10 5 6\n11 6 7\n12 7 8\n13 8 5\n14 7 2\n1\n21 2 2\n1\n31 3 1 7\n";
    SourceText source = sourceOf(text);
    DomainOrigin origin;
    source.origin = &origin;
    const Result<DomainFile> file = readPoly(source);
    REQUIRE(file.ok());
    checkComplete(origin, file->domain);
    for (const auto &kind : origin.parts) {
        for (const PartOrigin &place : kind) {
            REQUIRE(place.number);
            CHECK(std::stoll(text.substr(place.offset)) == *place.number);
        }
    }
    CHECK(origin.of(DomainPartKind::ConstraintPoint)[0].number == 9);
}

TEST_CASE("DomainOrigin: places of SVG parts are those of their elements") {
    const std::string text =
        "<svg viewBox=\"0 0 9 9\">\n<rect width=\"9\" height=\"9\"/>\n<circle cx=\"4\" cy=\"4\" r=\"2\"/></svg>";
    SourceText source = sourceOf(text);
    DomainOrigin origin;
    source.origin = &origin;
    const Result<Domain> domain = readSvg(source);
    REQUIRE(domain.ok());
    checkComplete(origin, *domain);
    for (std::size_t s = 0; s < domain->segments.size(); ++s) {
        CHECK(text.substr(origin.of(DomainPartKind::Segment)[s].offset).starts_with(s < 4 ? "rect" : "circle"));
    }
}

TEST_CASE("addPlaces: adds the known numbers and lines of parts to faults") {
    DomainOrigin origin;
    origin.of(DomainPartKind::Segment) = {{0, 11}, {6, {}}, {PartOrigin::kNowhere, 13}};
    Diagnostics faults = error("code", "two segments cross");
    faults[0].parts = {aSegment(2), aSegment(1), aSegment(3), aNode(0)}; // there is neither a fourth nor a node
    CHECK(toString(faults[0]) == "error: two segments cross [code]");
    addPlaces(faults, origin, "first\n second\n");
    CHECK(toString(faults[0]) == "error: two segments cross: segment 13 and segment (line 2) [code]");
    CHECK(faults[0].line == 2);
    origin.showsColumns = true;
    addPlaces(faults, origin, "first\n second\n");
    CHECK(faults[0].parts[1].column == 1);
    Diagnostics others = error("code", "two segments cross");
    others[0].parts = {aSegment(0)};
    others[0].file = "other.poly";
    addPlaces(others, origin, "first\n second\n");
    CHECK(toString(others[0]) == "other.poly: error: two segments cross [code]");
}
