#include "core/drawing_files/geojson/geojson.hpp"
#include "core/drawing_files/geojson/local_projection.hpp"
#include "core/drawing_files/geojson/topojson.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

using namespace forefront;

namespace {

constexpr double kEarth = 6'371'008.7714; ///< of the Earth, in metres

double inRadians(double degrees) {
    return degrees * (std::numbers::pi / 180.0);
}

/// Returns the distance on the sphere, by the haversine formula.
double onGround(Vec2 a, Vec2 b) {
    const double north = std::sin(0.5 * inRadians(b.y - a.y)), east = std::sin(0.5 * inRadians(b.x - a.x));
    return 2.0 * kEarth *
           std::asin(std::sqrt(north * north + std::cos(inRadians(a.y)) * std::cos(inRadians(b.y)) * east * east));
}

/// Returns a map of one rectangle; `head`: further members.
std::string rectangleMap(Vec2 corner, Vec2 size, const std::string &head = {}) {
    const auto point = [&](double x, double y) {
        return '[' + std::to_string(corner.x + x * size.x) + ',' + std::to_string(corner.y + y * size.y) + ']';
    };
    return R"({"type":"Polygon",)" + head + R"("coordinates":[[)" + point(0, 0) + ',' + point(1, 0) + ',' +
           point(1, 1) + ',' + point(0, 1) + ',' + point(0, 0) + "]]}";
}

struct MapReading {
    Result<Domain> domain;
    ImportNotes notes;

    bool has(const std::string &code, Severity severity) const {
        const Diagnostics list = notes.diagnostics();
        return std::any_of(list.begin(), list.end(),
                           [&](const Diagnostic &d) { return d.code == code && d.severity == severity; });
    }
    std::string text() const { return notes.empty() ? std::string() : notes.entries().front().message; }
};

MapReading readingOf(const std::string &text, DegreeRule rule, bool strict = false) {
    MapReading read{Domain(), {}};
    SourceText source;
    source.text = text;
    source.name = "map.geojson";
    source.options.degrees = rule;
    source.options.strict = strict;
    source.notes = &read.notes;
    read.domain = text.find("Topology") != std::string::npos ? readTopoJson(source) : readGeoJson(source);
    return read;
}

double enclosedByMap(const Domain &domain) {
    double twice = 0.0;
    for (const DomainSegment &segment : domain.segments) {
        const Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::fabs(twice);
}

} // namespace

TEST_CASE("LocalProjection: distances and directions from the centre are those on the sphere") {
    for (const Vec2 centre : {Vec2{24.5, 60.5}, Vec2{0, 0}, Vec2{-70.2, -33.4}, Vec2{179.9, 12}, Vec2{10, 90}}) {
        const LocalProjection projection(centre);
        CHECK(projection(centre) == Vec2{0, 0});
        for (const Vec2 step : {Vec2{0.5, 0}, Vec2{0, -0.4}, Vec2{-3, 2}, Vec2{1e-7, 1e-7}, Vec2{25, -14}}) {
            const Vec2 place = projection(centre + step);
            CHECK(length(place) == doctest::Approx(onGround(centre, centre + step)).epsilon(1e-8));
        }
        const Vec2 north = projection(centre - Vec2{0, 1});
        CHECK(std::fabs(north.x) < 1e-6);
        CHECK(north.y == doctest::Approx(-kEarth * inRadians(1)));
        CHECK(projection(centre + Vec2{360, -1}).y == doctest::Approx(north.y));
    }
    CHECK(LocalProjection::stretch({0, 0}) == 1.0);
    CHECK(LocalProjection::stretch({kEarth * std::numbers::pi / 2, 0}) == doctest::Approx(std::numbers::pi / 2));
}

TEST_CASE("Maps: longitudes and latitudes are reported with the factor of their distortion, and meshed as they are") {
    const std::string map = rectangleMap({24, 60}, {1, 1});
    const MapReading read = readingOf(map, DegreeRule::Warn);
    REQUIRE(read.domain.ok());
    CHECK(read.domain->bounds() == Box2{{24, 60}, {25, 61}});
    CHECK(read.has("degrees", Severity::Warning));
    CHECK(read.text().find("at latitude 60.5, lengths from west to east are 2.031 times too long") !=
          std::string::npos);
    CHECK(read.text().find("--projection local") != std::string::npos);
    CHECK(read.text().find("--allow-degrees") != std::string::npos);
    CHECK(read.notes.contents().degrees);

    const MapReading kept = readingOf(map, DegreeRule::Keep);
    REQUIRE(kept.domain.ok());
    CHECK(kept.notes.empty());
    CHECK(kept.domain->nodes == read.domain->nodes);
    CHECK(kept.notes.contents().degrees);

    const MapReading strict = readingOf(map, DegreeRule::Warn, true);
    REQUIRE_FALSE(strict.domain.ok());
    CHECK(strict.domain.faults().front().code == "degrees");
    CHECK(readingOf(map, DegreeRule::Keep, true).domain.ok());
    CHECK(readingOf(map, DegreeRule::Local, true).domain.ok());
}

TEST_CASE("Maps: the local projection gives metres about the middle of the map") {
    const MapReading read = readingOf(rectangleMap({24, 60}, {1, 1}), DegreeRule::Local);
    REQUIRE(read.domain.ok());
    CHECK(read.has("projected", Severity::Note));
    CHECK(read.text().find("longitude 24.5, latitude 60.5") != std::string::npos);
    const double onSphere = kEarth * kEarth * inRadians(1) * (std::sin(inRadians(61)) - std::sin(inRadians(60)));
    CHECK(enclosedByMap(*read.domain) == doctest::Approx(onSphere).epsilon(2e-4));
    const Box2 box = read.domain->bounds();
    CHECK(std::fabs(box.min.x + box.max.x) < 1e-6);

    const MapReading wide = readingOf(rectangleMap({0, 0}, {60, 40}), DegreeRule::Local);
    REQUIRE(wide.domain.ok());
    CHECK(wide.text().find("times too long") != std::string::npos);
    const MapReading globe = readingOf(rectangleMap({-170, -80}, {340, 160}), DegreeRule::Local);
    REQUIRE_FALSE(globe.domain.ok());
    CHECK(globe.domain.faults().front().code == "large-map");
}

TEST_CASE("Maps: coordinates of a named system, beyond degrees or near the equator are not warned about") {
    const std::string named = R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::3067"}},)";
    for (const std::string &map : {rectangleMap({24, 60}, {1, 1}, named), rectangleMap({687123, 5312345}, {800, 600}),
                                   rectangleMap({0, 0}, {8, 6})}) {
        const MapReading read = readingOf(map, DegreeRule::Warn, true);
        REQUIRE(read.domain.ok());
        CHECK_FALSE(read.has("degrees", Severity::Warning));
    }
    const MapReading kept = readingOf(rectangleMap({24, 60}, {1, 1}, named), DegreeRule::Warn);
    CHECK(kept.text() == "coordinates in the reference system 'urn:ogc:def:crs:EPSG::3067' are used as they are");
    CHECK_FALSE(kept.notes.contents().degrees);
    for (const char *degrees : {"urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326"}) {
        const std::string head = R"("crs":{"type":"name","properties":{"name":")" + std::string(degrees) + "\"}},";
        CHECK(readingOf(rectangleMap({24, 60}, {1, 1}, head), DegreeRule::Warn).has("degrees", Severity::Warning));
    }
    for (const std::string &map :
         {rectangleMap({24, 60}, {1, 1}, named), rectangleMap({687123, 5312345}, {800, 600})}) {
        const MapReading refused = readingOf(map, DegreeRule::Local);
        REQUIRE_FALSE(refused.domain.ok());
        CHECK(refused.domain.faults().front().code == "not-degrees");
    }
}

TEST_CASE("Maps: the longitudes and latitudes of TopoJSON are treated alike, with lines and points") {
    const std::string map = R"({"type":"Topology","transform":{"scale":[0.1,0.1],"translate":[24,60]},)"
                            R"("arcs":[[[0,0],[10,0],[0,10],[-10,0],[0,-10]]],"objects":{"lake":{"type":)"
                            R"("GeometryCollection","geometries":[{"type":"Polygon","arcs":[[0]]},)"
                            R"({"type":"Point","coordinates":[5,5]}]}}})";
    const MapReading warned = readingOf(map, DegreeRule::Warn);
    REQUIRE(warned.domain.ok());
    CHECK(warned.has("degrees", Severity::Warning));
    const MapReading read = readingOf(map, DegreeRule::Local);
    REQUIRE(read.domain.ok());
    CHECK(read.has("projected", Severity::Note));
    REQUIRE(read.domain->points.size() == 1);
    CHECK(read.domain->bounds().size().y == doctest::Approx(kEarth * inRadians(1)).epsilon(1e-2));
}
