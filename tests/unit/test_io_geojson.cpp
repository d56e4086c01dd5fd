#include "core/drawing_files/geojson/geojson.hpp"
#include "core/engine/domain/validate.hpp"
#include "tests/support/curved_area.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::string feature(const std::string &type, const std::string &coordinates, const std::string &properties = "null") {
    return "{\"type\": \"Feature\", \"properties\": " + properties + ", \"geometry\": {\"type\": \"" + type +
           "\", \"coordinates\": " + coordinates + "}}";
}

std::string collection(const std::vector<std::string> &features) {
    std::string text = "{\"type\": \"FeatureCollection\", \"features\": [";
    for (std::size_t k = 0; k < features.size(); ++k) {
        text += (k == 0 ? "\n" : ",\n") + features[k];
    }
    return text + "]}";
}

Domain geoJsonDomain(const std::string &text) {
    const auto domain = readGeoJson(sourceOf(text));
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    return *domain;
}

std::size_t count(const Domain &domain, SegmentRole role) {
    std::size_t number = 0;
    for (const DomainSegment &segment : domain.segments) {
        number += segment.role == role ? 1U : 0U;
    }
    return number;
}

std::vector<std::int32_t> tagsOf(const Domain &domain) {
    std::vector<std::int32_t> tags;
    for (const DomainSegment &segment : domain.segments) {
        tags.push_back(segment.tag);
    }
    return tags;
}

const DomainSegment &between(const Domain &domain, Vec2 a, Vec2 b) {
    for (const DomainSegment &segment : domain.segments) {
        const Vec2 p = domain.nodes[segment.a], q = domain.nodes[segment.b];
        if ((p == a && q == b) || (p == b && q == a)) {
            return segment;
        }
    }
    FAIL("no such segment");
    return domain.segments.front();
}

} // namespace

TEST_CASE("GeoJSON: neighbouring polygons share their common side as an interface") {
    const Domain domain =
        geoJsonDomain(collection({feature("Polygon", "[[[0,0],[1,0],[1,1],[0,1],[0,0]]]", "{\"name\": \"land\"}"),
                                  feature("Polygon", "[[[1,0],[2,0,17.5],[2,1],[1,1]]]", "{\"name\": \"sea\"}")}));
    CHECK(domain.nodes.size() == 6);
    CHECK(domain.segments.size() == 7);
    CHECK(count(domain, SegmentRole::Constraint) == 1);
    CHECK(between(domain, {1, 0}, {1, 1}).role == SegmentRole::Constraint);
    REQUIRE(domain.regionMarkers.size() == 2);
    CHECK(regionName(domain.regionNames, domain.regionMarkers[0].tag) == "land");
    CHECK(regionName(domain.regionNames, domain.regionMarkers[1].tag) == "sea");
    CHECK(domain.regionMarkers[1].at.x > 1.0);
    CHECK(boundaryName(domain.boundaryNames, between(domain, {2, 0}, {2, 1}).tag) == "sea");
}

TEST_CASE("GeoJSON: a hole is outside, a polygon that fills it is a region, one inside a face divides it") {
    const std::string outer = "[[[0,0],[9,0],[9,9],[0,9],[0,0]],[[1,1],[3,1],[3,3],[1,3],[1,1]]]";
    const Domain hole = geoJsonDomain(feature("Polygon", outer));
    CHECK(count(hole, SegmentRole::Boundary) == 8);
    CHECK(hole.regionMarkers.empty());
    const Domain filled = geoJsonDomain(collection(
        {feature("Polygon", outer), feature("Polygon", "[[[1,1],[3,1],[3,3],[1,3],[1,1]]]", "{\"name\": \"lake\"}")}));
    CHECK(count(filled, SegmentRole::Boundary) == 4);
    CHECK(count(filled, SegmentRole::Constraint) == 4);
    const Domain island = geoJsonDomain(
        collection({feature("Polygon", outer), feature("Polygon", "[[[1.5,1.5],[2,1.5],[2,2],[1.5,1.5]]]")}));
    CHECK(count(island, SegmentRole::Boundary) == 11);
    const Domain nested =
        geoJsonDomain(collection({feature("Polygon", "[[[5,5],[6,5],[6,6],[5,5]]]"), feature("Polygon", outer)}));
    CHECK(count(nested, SegmentRole::Boundary) == 8);
    CHECK(count(nested, SegmentRole::Constraint) == 3);
    CHECK(nested.regionMarkers.size() == 2);
}

TEST_CASE("GeoJSON: a polygon given twice is one polygon") {
    const std::string triangle = "[[[0,0],[1,0],[0,1],[0,0]]]";
    const Domain domain = geoJsonDomain(collection({feature("Polygon", triangle), feature("Polygon", triangle)}));
    CHECK(count(domain, SegmentRole::Boundary) == 3);
}

TEST_CASE("GeoJSON: lines are constraints and name the sides they coincide with; points are kept") {
    const Domain domain =
        geoJsonDomain(collection({feature("LineString", "[[0,0],[1,0]]", "{\"name\": \"inlet\"}"),
                                  feature("Polygon", "[[[0,0],[1,0],[1,1],[0,1],[0,0]]]", "{\"tag\": 7}"),
                                  feature("MultiLineString", "[[[0.2,0.2],[0.4,0.2],[0.4,0.2],[0.4,0.4]]]"),
                                  feature("MultiPoint", "[[0.7,0.7]]", "{\"name\": \"gauge\"}")}));
    CHECK(boundaryName(domain.boundaryNames, between(domain, {0, 0}, {1, 0}).tag) == "inlet");
    CHECK(between(domain, {0, 0}, {1, 0}).role == SegmentRole::Boundary);
    CHECK(between(domain, {1, 0}, {1, 1}).tag == 7);
    CHECK(between(domain, {0.4, 0.2}, {0.4, 0.4}).role == SegmentRole::Constraint);
    CHECK(count(domain, SegmentRole::Constraint) == 2);
    REQUIRE(domain.points.size() == 1);
    CHECK(domain.nodes[domain.points[0].node] == Vec2{0.7, 0.7});
    CHECK(boundaryName(domain.boundaryNames, domain.points[0].tag) == "gauge");
    CHECK(domain.regionMarkers.size() == 1);
}

TEST_CASE("GeoJSON: several polygons and a geometry collection without features") {
    const Domain domain = geoJsonDomain(
        "{\"type\": \"GeometryCollection\", \"geometries\": [{\"type\": \"MultiPolygon\", \"coordinates\": "
        "[[[[0,0],[1,0],[0,1],[0,0]]], [[[5,0],[6,0],[5,1],[5,0]]]]}]}");
    CHECK(count(domain, SegmentRole::Boundary) == 6);
}

TEST_CASE("GeoJSON: a polygon thinner than a millionth of the map stays if it is a visible part of its area") {
    const std::string needle = feature("Polygon", "[[[100,100],[1e6,110],[1e7,100],[100,100]]]");
    const std::string square = feature("Polygon", "[[[0,0],[0,200],[200,200],[200,0],[0,0]]]");
    const std::string continent = feature("Polygon", "[[[0,-9e6],[1e7,-9e6],[1e7,-10],[0,-10],[0,-9e6]]]");
    const auto nodesAt = [](const Domain &domain, Vec2 place) {
        return std::count(domain.nodes.begin(), domain.nodes.end(), place);
    };
    ImportNotes notes;
    const std::string text = collection({square, needle});
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto domain = readGeoJson(source);
    REQUIRE(domain.ok());
    CHECK(nodesAt(*domain, {1e6, 110.0}) == 1);
    CHECK(nodesAt(*domain, {1e7, 100.0}) == 1);
    REQUIRE(notes.entries().size() > 0);
    CHECK(notes.entries().front().code == "finer-weld");
    CHECK(notes.entries().front().message ==
          "used a weld tolerance of 0.313 instead of 10, which would change the area by over 0.1 %");
    CHECK(nodesAt(geoJsonDomain(collection({square, needle, continent})), {1e6, 110.0}) == 0);
}

TEST_CASE("GeoJSON: a map without polygons is refused with what it holds") {
    const auto domain = readGeoJson(sourceOf(feature("MultiPoint", "[[0,0],[1,0],[2,2]]"), "a.geojson"));
    REQUIRE_FALSE(domain.ok());
    CHECK(domain.faults()[0].code == "empty-domain");
    CHECK(domain.faults()[0].message ==
          "the file holds only points (3); expected polygons, or lines that form closed loops");
    const auto lines = readGeoJson(sourceOf(feature("LineString", "[[0,0],[1,0],[2,2]]"), "a.geojson"));
    REQUIRE(lines.ok());
    const Diagnostics faults = validate(*lines);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].message.find("only inner lines") != std::string::npos);
}

TEST_CASE("GeoJSON: faults have a location") {
    const auto codeOf = [](const std::string &text) {
        const auto domain = readGeoJson(sourceOf(text, "a.geojson"));
        REQUIRE(!domain.ok());
        CHECK(allLocated(domain.faults()));
        return domain.faults()[0].code;
    };
    CHECK(codeOf("{}") == "missing-field");
    CHECK(codeOf("[]") == "missing-field");
    CHECK(codeOf("{\"type\": \"Topology\"}") == "bad-field");
    CHECK(codeOf(collection({})) == "empty-domain");
    CHECK(codeOf(feature("Curve", "[]")) == "unknown-geometry");
    CHECK(codeOf(feature("Polygon", "[[[0,0],[1,0],[0,0]]]")) == "empty-domain");
    CHECK(codeOf(feature("Polygon", "[[[0,0],[1,0],[2,0],[0,0]]]")) == "empty-domain");
    CHECK(codeOf(feature("Polygon", "[[[0,0],[1,null],[2,3],[0,0]]]")) == "bad-number");
    CHECK(codeOf(feature("LineString", "[[0,0]]")) == "bad-count");
    CHECK(codeOf(feature("Point", "3")) == "bad-field");
}

TEST_CASE("GeoJSON: features may be separate texts, by lines or with record separators") {
    const std::string land = feature("Polygon", "[[[0,0],[1,0],[1,1],[0,1],[0,0]]]", "{\"name\": \"land\"}"),
                      sea = feature("Polygon", "[[[1,0],[2,0],[2,1],[1,1],[1,0]]]", "{\"tag\": 1, \"name\": \"sea\"}");
    const Domain whole = geoJsonDomain(collection({land, sea}));
    CHECK(whole.regionNames == std::map<std::int32_t, std::string>{{1, "sea"}, {2, "land"}});
    for (const std::string &text :
         {land + "\n" + sea + "\n", land + "\r\n\r\n" + sea, land + sea, "\x1e" + land + "\n\x1e" + sea + "\n",
          collection({land}) + "\n" + collection({sea})}) {
        CAPTURE(text);
        CHECK(looksLikeGeoJson(text));
        const Domain domain = geoJsonDomain(text);
        CHECK(domain.nodes == whole.nodes);
        CHECK(tagsOf(domain) == tagsOf(whole));
        CHECK(domain.regionNames == whole.regionNames);
    }
    for (const auto &[text, message, line] :
         {std::tuple{land + "\n" + sea + "}\n", "expected the end of the file", 2U},
          std::tuple{land + "\n{\"type\": \"Feature\"\n", "expected ',' or '}'", 3U},
          std::tuple{"\x1e" + land + "\n\x1e[]", "expected the end of the file", 2U},
          std::tuple{std::string("\x1e\n"), "expected a value", 2U}}) {
        CAPTURE(text);
        const auto domain = readGeoJson(sourceOf(text));
        REQUIRE_FALSE(domain.ok());
        CHECK(domain.faults()[0].message.starts_with(message));
        CHECK(domain.faults()[0].line == line);
    }
}

TEST_CASE("GeoJSON: holes outside the outline of their polygon are parts of it, in any order") {
    const std::string island = "[[5,0],[6,0],[6,1],[5,0]]", land = "[[0,0],[4,0],[4,4],[0,4],[0,0]]",
                      lake = "[[1,1],[2,1],[2,2],[1,2],[1,1]]";
    for (const std::string &rings :
         {island + ',' + land + ',' + lake, lake + ',' + land + ',' + island, land + ',' + lake + ',' + island}) {
        ImportNotes notes;
        const std::string text = feature("Polygon", "[" + rings + "]");
        SourceText source = sourceOf(text);
        source.notes = &notes;
        const auto domain = readGeoJson(source);
        REQUIRE(domain.ok());
        CHECK(curvedAreas(*domain).at(1) == doctest::Approx(15.5));
        REQUIRE_FALSE(notes.entries().empty());
        CHECK(notes.entries()[0].code == "outer-hole");
    }
}

TEST_CASE("GeoJSON: holes that touch the outline from outside are parts, too") {
    const auto area = [](const std::string &outline, const std::string &hole) {
        const auto domain = readGeoJson(sourceOf(feature("Polygon", "[" + outline + "," + hole + "]")));
        REQUIRE(domain.ok());
        return curvedAreas(*domain).at(1);
    };
    const std::string notched = "[[0,0],[1,0],[2,2],[3,0],[4,0],[4,4],[0,4],[0,0]]";
    CHECK(area(notched, "[[1,0],[3,0],[2,2],[1,0]]") == doctest::Approx(16)); // fills the notch
    const std::string uneven = "[[0.137,0.211],[1.013,0.219],[2.071,2.317],[3.119,0.233],[4.357,0.241],[4.361,4.173],"
                               "[0.149,4.191],[0.137,0.211]]";
    CHECK(area(uneven, "[[1.013,0.219],[3.119,0.233],[2.071,2.317],[1.013,0.219]]") ==
          doctest::Approx(16.7).epsilon(0.01));
    CHECK(area(notched, "[[4,0],[6,0],[6,4],[4,4],[4,0]]") == doctest::Approx(22));
    CHECK(area(notched, "[[4,4],[5,4],[5,5],[4,4]]") == doctest::Approx(14.5));
    CHECK(area("[[0,0],[4,0],[4,4],[0,4],[0,0]]", "[[4,1],[4,3],[-1,2],[4,1]]") == doctest::Approx(11.2)); // crosses it
}

TEST_CASE("GeoJSON: rings that cross the antimeridian without being cut there are reported") {
    const auto isReported = [](const std::string &ring) {
        ImportNotes notes;
        const std::string text = feature("Polygon", "[" + ring + "]");
        SourceText source = sourceOf(text);
        source.notes = &notes;
        REQUIRE(readGeoJson(source).ok());
        return std::any_of(notes.entries().begin(), notes.entries().end(),
                           [](const ImportNote &note) { return note.code == "antimeridian"; });
    };
    CHECK(isReported("[[177,-18],[-179,-18],[-179,-16],[177,-16],[177,-18]]"));
    CHECK_FALSE(isReported("[[177,-18],[181,-18],[181,-16],[177,-16],[177,-18]]"));
    CHECK_FALSE(isReported("[[-180,-90],[180,-90],[180,-70],[-180,-65],[-180,-90]]")); // along the edge of the map
    CHECK_FALSE(isReported("[[-100,0],[100,0],[100,50],[-100,50],[-100,0]]"));
    CHECK_FALSE(isReported("[[-175,0],[175,0],[175,500],[-175,500],[-175,0]]")); // no degrees
}

TEST_CASE("GeoJSON: holes that touch the outline from inside or cross it are cut from their polygon") {
    for (const char *hole :
         {"[[0,1],[1,0],[1,1],[0,1]]", "[[3,1],[5,1],[5,2],[3,2],[3,1]]", "[[1,1],[2,1],[2,2],[1,1]]"}) {
        ImportNotes notes;
        const std::string text = feature("Polygon", std::string("[[[0,0],[4,0],[4,4],[0,4],[0,0]],") + hole + "]");
        SourceText source = sourceOf(text);
        source.notes = &notes;
        REQUIRE(readGeoJson(source).ok());
        for (const ImportNote &note : notes.entries()) {
            CHECK(note.code != "outer-hole");
        }
    }
}
