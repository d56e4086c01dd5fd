#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/geojson/geojson.hpp"
#include "core/drawing_files/geojson/topojson.hpp"
#include "core/files/files.hpp"
#include "core/files/format.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

// Two neighbours, each 2 wide and 3 high, with a common arc; the first has a hole.
const std::string kArcs = R"("arcs": [[[2, 0], [0, 3]], [[2, 3], [-2, 0], [0, -3], [2, 0]],
 [[2, 0], [2, 0], [0, 3], [-2, 0]], [[1, 1], [0, 1], [-1, 0], [1, -1]]])";
const std::string kObjects = R"("objects": {"land": {"type": "GeometryCollection", "geometries": [
 {"type": "Polygon", "properties": {"name": "west"}, "arcs": [[0, 1], [3]]},
 {"type": "MultiPolygon", "properties": {"name": "east", "tag": 7}, "arcs": [[[2, -1]]]}]}})";
const std::string kTransform = R"("transform": {"scale": [0.5, 1], "translate": [10, 20]})";

std::string topology(const std::string &members) {
    return "{\"type\": \"Topology\", " + members + "}";
}

Domain topoJsonDomain(const std::string &text, ImportNotes *notes = nullptr, const ImportOptions &options = {}) {
    SourceText source = sourceOf(text, "map.topojson");
    source.notes = notes;
    source.options = options;
    const auto domain = readTopoJson(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    return *domain;
}

Diagnostics topoFaults(const std::string &text) {
    const auto domain = readTopoJson(sourceOf(text, "map.topojson"));
    REQUIRE_FALSE(domain.ok());
    CHECK(allLocated(domain.faults()));
    return domain.faults();
}

std::string topoCodes(const ImportNotes &notes) {
    std::string codes;
    for (const ImportNote &note : notes.entries()) {
        codes += note.code + ' ' + std::to_string(note.count) + ' ';
    }
    return codes;
}

} // namespace

TEST_CASE("TopoJSON: gives the domain of the same map as GeoJSON") {
    const Domain topo = topoJsonDomain(topology(kTransform + ", " + kArcs + ", " + kObjects));
    const auto geo = readGeoJson(sourceOf(R"({"type": "FeatureCollection", "features": [
 {"type": "Feature", "properties": {"name": "west"}, "geometry": {"type": "Polygon", "coordinates":
  [[[11, 20], [11, 23], [10, 23], [10, 20], [11, 20]], [[10.5, 21], [10.5, 22], [10, 22], [10.5, 21]]]}},
 {"type": "Feature", "properties": {"name": "east", "tag": 7}, "geometry": {"type": "MultiPolygon", "coordinates":
  [[[[11, 20], [12, 20], [12, 23], [11, 23], [11, 20]]]]}}]})"));
    REQUIRE(geo.ok());
    CHECK(topo.nodes == geo->nodes);
    REQUIRE(topo.segments.size() == geo->segments.size());
    for (std::size_t s = 0; s < topo.segments.size(); ++s) {
        const DomainSegment &p = topo.segments[s], &q = geo->segments[s];
        CHECK((p.a == q.a && p.b == q.b && p.tag == q.tag && p.role == q.role));
    }
    CHECK(topo.regionMarkers == geo->regionMarkers);
    CHECK(topo.boundaryNames == geo->boundaryNames);
    CHECK(topo.regionNames == geo->regionNames);
    CHECK(topo.regionNames.at(7) == "east");
}

TEST_CASE("TopoJSON: without a transform, positions are as they stand") {
    const Domain domain = topoJsonDomain(topology(
        R"("arcs": [[[0.5, 0], [4, 0], [4, 3], [0.5, 0]]], "objects": {"a": {"type": "Polygon", "arcs": [[-1]]}})"));
    CHECK(domain.segments.size() == 3);
    CHECK(domain.bounds().max == Vec2{4, 3});
    CHECK(domain.bounds().min == Vec2{0.5, 0});
}

TEST_CASE("TopoJSON: lines and points are constraints; geometries without a type are noted") {
    ImportNotes notes;
    const Domain domain =
        topoJsonDomain(topology(R"("arcs": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]], [[1, 1], [2, 1]],
 [[2, 1, 9], [3, 2]]], "objects": {"a": {"type": "GeometryCollection", "id": 3, "geometries": [
 {"type": "Polygon", "arcs": [[0]]}, {"type": "LineString", "arcs": [1, 2], "properties": {"name": "road"}},
 {"type": "MultiPoint", "coordinates": [[1, 3], [3, 3]]}, {"type": null}]}})"),
                       &notes);
    CHECK(std::count_if(domain.segments.begin(), domain.segments.end(),
                        [](const DomainSegment &segment) { return segment.role == SegmentRole::Constraint; }) == 2);
    CHECK(domain.points.size() == 2);
    CHECK(topoCodes(notes) == "no-geometry 1 height 1 members 1 ");
}

TEST_CASE("TopoJSON: of several layers the first with polygons is read, and a note says so") {
    ImportNotes notes;
    const std::string square = R"("arcs": [[[0, 0], [4, 0], [4, 4], [0, 0]]])";
    const Domain domain =
        topoJsonDomain(topology(square + R"(, "objects": {"cities": {"type": "Point", "coordinates": [1, 1]},
 "states": {"type": "Polygon", "arcs": [[0]]}, "nation": {"type": "Polygon", "arcs": [[0]]}})"),
                       &notes);
    CHECK(domain.points.empty());
    REQUIRE(topoCodes(notes) == "layers 1 ");
    CHECK(notes.diagnostics()[0].message ==
          "of several layers, only 'states' is read, not 'cities', 'nation'; --layer selects another");
    CHECK(notes.contents().layers == std::vector<std::string>{"cities", "states", "nation"});
    CHECK(notes.contents().layer == "states");
}

TEST_CASE("TopoJSON: an option selects the layer; an unknown one is refused with the names of all") {
    const std::string text = topology(
        R"("arcs": [[[0, 0], [4, 0], [4, 4], [0, 0]], [[6, 0], [8, 0], [8, 1], [6, 0]]], "objects": {
 "états": {"type": "Polygon", "arcs": [[0]], "properties": {"name": "A", "code": "x"}},
 "nation": {"type": "Polygon", "arcs": [[1]], "properties": {"name": "B", "tag": 1, "land": "y"}}})");
    ImportNotes notes;
    const Domain domain = topoJsonDomain(text, &notes, {.layer = "nation"});
    CHECK(domain.bounds().min == Vec2{6, 0});
    CHECK(domain.regionNames == std::map<std::int32_t, std::string>{{1, "B"}});
    CHECK(topoCodes(notes) == "properties 1 ");
    CHECK(notes.contents().layer == "nation");
    CHECK(notes.contents().layers.size() == 2);
    CHECK(notes.contents().properties == std::vector<std::string>{"land", "name", "tag"}); // of this layer alone
    CHECK(topoJsonDomain(text, &notes, {.layer = "états"}).bounds().max == Vec2{4, 4});
    for (const char *name : {"Nation", ""}) {
        SourceText source = sourceOf(text, "map.topojson");
        source.options.layer = name;
        const auto refused = readTopoJson(source);
        REQUIRE_FALSE(refused.ok());
        CHECK(allLocated(refused.faults()));
        CHECK(refused.faults().size() == 1);
        CHECK(refused.faults()[0].code == "unknown-layer");
        CHECK(refused.faults()[0].message == "unknown layer '" + std::string(name) + '\'');
        CHECK(refused.faults()[0].advice == "expected one of 'états', 'nation'");
    }
}

TEST_CASE("Maps: are recognised even if their type follows long lists, by content alone") {
    const TemporaryFolder folder;
    const std::string padding(2 * kHeadBytes, 'x'),
        name = R"(, "properties": {"name": ")" + padding + "\"}",
        square = R"("geometry": {"coordinates": [[[0, 0], [4, 0], [4, 3], [0, 0]]], "type": "Polygon"})";
    const std::string sorted = R"({"features": [{)" + square + name +
                               R"(, "type": "Feature"}], "type": "FeatureCollection"})",
                      late = R"({"note": "\"features\" )" + padding + R"(", "features": [{"type": "Feature", )" +
                             square + R"(}], "type": "FeatureCollection"})",
                      topology = R"({"objects": {"a": {"geometries": [{"type": "Polygon", "arcs": [[0]])" + name +
                                 R"(}], "type": "GeometryCollection"}}, "arcs": [[[0, 0], [4, 0], [4, 3], [0, 0]]],
 "type": "Topology"})";
    for (const auto &[text, id] : {std::pair{sorted, "geojson"}, {late, "geojson"}, {topology, "topojson"}}) {
        for (const char *file : {"a.json", "a.geojson", "a.topojson", "a.txt", "a"}) {
            std::ofstream(folder / file, std::ios::binary) << text;
            CAPTURE(file);
            REQUIRE(allFormats().detect(folder / file) != nullptr);
            CHECK(allFormats().detect(folder / file)->id == std::string(id));
            CHECK(allFormats().detect(file, text)->id == std::string(id));
            const auto domain = allFormats().readDomain(folder / file);
            REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
            CHECK(domain->domain.segments.size() == 3);
        }
    }
    std::ofstream(folder / "other.json", std::ios::binary) << R"({"note": ")" + padding + "\"}";
    CHECK(allFormats().detect(folder / "other.json")->id == std::string("project"));
    for (const char *broken : {"{", R"({"a)", R"({"a": "\)", R"({"a": {"b": [1, "}", 2)", R"({"type")",
                               R"({"type": "Topol)", R"({"type": 1, "features")", "[{}]", ""}) {
        CHECK_FALSE(looksLikeTopoJson(broken));
        CHECK_FALSE(looksLikeGeoJson(broken));
    }
}

TEST_CASE("TopoJSON: names can come from the ids of geometries, with or without properties") {
    const std::string text = topology(kTransform + ", " + kArcs + R"(, "objects": {"counties": {
 "type": "GeometryCollection", "geometries": [
 {"type": "Polygon", "id": "01001", "properties": {"name": "Lee"}, "arcs": [[0, 1], [3]]},
 {"type": "GeometryCollection", "id": 2, "properties": {"name": "Lee"}, "geometries": [
  {"type": "MultiPolygon", "id": "part", "arcs": [[[2, -1]]]}]},
 {"type": "Polygon", "id": 3, "arcs": [[-4]]}]}})");
    CHECK(topoJsonDomain(text).regionNames == std::map<std::int32_t, std::string>{{1, "Lee"}});
    CHECK(topoJsonDomain(text, nullptr, {.nameProperty = "id"}).regionNames ==
          std::map<std::int32_t, std::string>{{1, "01001"}, {2, "2"}, {3, "3"}});
}

TEST_CASE("TopoJSON: faults are located") {
    const std::string arcs = R"("arcs": [[[0, 0], [4, 0], [4, 4], [0, 0]]])";
    const auto inLayer = [&](const std::string &geometry) {
        return topoFaults(topology(arcs + ",\n \"objects\": {\"a\": " + geometry + "}"));
    };
    const Diagnostic fault = inLayer(R"({"type": "Polygon", "arcs": [[1]]})")[0];
    CHECK(fault.code == "bad-arc");
    CHECK(fault.message == "expected the number of one of the 1 arcs, or its complement");
    CHECK(fault.line == 2);
    CHECK(fault.column == 49);
    CHECK(inLayer(R"({"type": "Polygon", "arcs": [[-2]]})")[0].code == "bad-arc");
    CHECK(inLayer(R"({"type": "Polygon", "arcs": [[0.5]]})")[0].code == "bad-arc");
    CHECK(inLayer(R"({"type": "Polygon", "arcs": [7]})")[0].code == "bad-field");
    CHECK(inLayer(R"({"type": "Polygon"})")[0].code == "bad-field");
    CHECK(inLayer(R"({"type": "Sphere", "arcs": []})")[0].code == "unknown-geometry");
    CHECK(inLayer(R"({"type": "LineString", "arcs": []})")[0].code == "bad-count");
    CHECK(inLayer(R"({"type": "Point", "coordinates": [1, 2]})")[0].code == "empty-domain");
    CHECK(inLayer("{}")[0].code == "missing-field");
    CHECK(hasCode(topoFaults(topology(arcs)), "missing-field"));
    CHECK(hasCode(topoFaults(topology(R"("objects": {})")), "missing-field"));
    CHECK(hasCode(topoFaults(topology(R"("arcs": [[]], "objects": {})")), "bad-field"));
    CHECK(hasCode(topoFaults(topology(arcs + R"(, "objects": {})")), "empty-domain"));
    CHECK(hasCode(topoFaults(topology(R"("transform": {"scale": [1]}, )" + arcs + R"(, "objects": {})")),
                  "missing-field"));
    CHECK(hasCode(topoFaults("[1, 2]"), "missing-field"));
    CHECK(hasCode(topoFaults(R"({"type": "Feature", "arcs": [], "objects": {}})"), "bad-field"));
}

TEST_CASE("TopoJSON: a small file that repeats a long arc very often is refused") {
    std::string arc, ring;
    for (int k = 0; k < 2000; ++k) {
        arc += (k == 0 ? "[" : ",[") + std::to_string(k) + ",1]";
        ring += k == 0 ? "0" : ",0";
    }
    const Diagnostics faults = topoFaults(
        topology("\"arcs\": [[" + arc + R"(]], "objects": {"a": {"type": "Polygon", "arcs": [[)" + ring + "]]}}"));
    CHECK(hasCode(faults, "too-large"));
}

TEST_CASE("TopoJSON: is recognised by its content under any name; GeoJSON with such words is not") {
    const TemporaryFolder folder;
    const std::string text = topology(kArcs + ", " + kObjects),
                      turned = "{" + kArcs + ", " + kObjects + ", \"type\": \"Topology\"}";
    for (const char *name : {"a.json", "a.topojson", "a.geojson", "a.other"}) {
        for (const std::string &content : {text, turned, "\n " + text}) {
            std::ofstream(folder / name, std::ios::binary) << content;
            CHECK(allFormats().readDomain(folder / name).ok());
        }
    }
    CHECK(looksLikeTopoJson("{\"objects\": {\"a\": {\"type\": \"Polygon\"}}, \"type\" :\n\"Topology\""));
    CHECK(looksLikeTopoJson(R"({"objects": {"a": {"geometries": [{"arcs": [[0]], "properties": {"FeatureID": 1)"));
    CHECK(looksLikeTopoJson("\xef\xbb\xbf{\"type\":\"Topology\",\"objects\":{\"Features\":{"));
    CHECK_FALSE(looksLikeTopoJson(R"({"features": [{"properties": {"objects": 3, "arcs": 4}}], "objects": [)"));
    CHECK_FALSE(looksLikeTopoJson(R"({"type": "Feature", "properties": {"type": "Topology"}})"));
    CHECK_FALSE(looksLikeTopoJson(R"({"name": "Topology", "shapes": []})"));
    CHECK_FALSE(looksLikeTopoJson(""));
    CHECK_FALSE(looksLikeTopoJson("{"));
}
