#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/geojson/geojson.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/files/files.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

using Areas = std::map<std::string, double>;

/// Returns the area of each region of a valid domain, by name.
Areas areas(const Domain &domain) {
    for (const Diagnostic &fault : validate(domain)) {
        FAIL(toString(fault));
    }
    const DomainGraph graph = graphOf(domain);
    const Faces faces = findFaces(graph.points, graph.edges, sweepPlane(graph.points, graph.edges));
    const FaceLabels labels = labelFaces(domain, graph, faces);
    Areas result;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const double area = 0.5 * cross(graph.points[graph.edges[e].a], graph.points[graph.edges[e].b]);
        for (const auto &[face, sign] : {std::pair{faces.left[e], 1.0}, {faces.right[e], -1.0}}) {
            if (labels.inside[face] != 0) {
                result[regionName(domain.regionNames, labels.tag[face])] += sign * area;
            }
        }
    }
    return result;
}

void checkAreas(const Areas &found, const Areas &expected) {
    REQUIRE(found.size() == expected.size());
    for (const auto &[name, area] : expected) {
        CAPTURE(name);
        REQUIRE(found.count(name) == 1);
        CHECK(found.at(name) == doctest::Approx(area).epsilon(1e-9));
    }
}

struct Read {
    Domain domain;
    ImportNotes notes;
    bool has(const std::string &code) const { return find(code) != nullptr; }
    const ImportNote *find(const std::string &code) const {
        const auto found = std::find_if(notes.entries().begin(), notes.entries().end(),
                                        [&](const ImportNote &note) { return note.code == code; });
        return found == notes.entries().end() ? nullptr : &*found;
    }
};

Read read(const std::string &text, const ImportOptions &options = {}) {
    Read result;
    SourceText source = sourceOf(text);
    source.options = options;
    source.notes = &result.notes;
    Result<Domain> domain = looksLikeSvg(text) ? readSvg(source) : readGeoJson(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    result.domain = std::move(*domain);
    return result;
}

std::string svg(const std::string &content) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 10\">" + content + "</svg>";
}

std::string rectangle(double x, double y, double width, double height) {
    const auto point = [](double px, double py) { return '[' + std::to_string(px) + ',' + std::to_string(py) + ']'; };
    return '[' + point(x, y) + ',' + point(x + width, y) + ',' + point(x + width, y + height) + ',' +
           point(x, y + height) + ',' + point(x, y) + ']';
}

/// A map of named polygons, each given by its rings.
std::string map(const std::vector<std::pair<std::string, std::string>> &polygons) {
    std::string text;
    for (const auto &[name, rings] : polygons) {
        text += (text.empty() ? "" : ",") +
                (R"({"type":"Feature","properties":{)" + (name.empty() ? "" : R"("name":")" + name + '"') +
                 R"(},"geometry":{"type":"Polygon","coordinates":[)" + rings + "]}}");
    }
    return R"({"type":"FeatureCollection","features":[)" + text + "]}";
}

} // namespace

TEST_CASE("Drawings: the fill rule decides what is inside") {
    const std::string squares = R"(d="M0 0H9V9H0ZM3 3H6V6H3Z"/>)";
    checkAreas(areas(read(svg("<path fill-rule=\"nonzero\" " + squares)).domain), {{"region_1", 81}});
    checkAreas(areas(read(svg("<path " + squares)).domain), {{"region_1", 81}});
    checkAreas(areas(read(svg("<path fill-rule=\"evenodd\" " + squares)).domain), {{"region_1", 72}});
    checkAreas(areas(read(svg("<g style=\"fill-rule: evenodd\"><path " + squares + "</g>")).domain),
               {{"region_1", 72}});
    checkAreas(areas(read(svg(R"(<path d="M0 0H9V9H0ZM3 3V6H6V3Z"/>)")).domain), {{"region_1", 72}});
}

TEST_CASE("Drawings: open subpaths are filled as if closed") {
    checkAreas(areas(read(svg(R"(<path d="M0 0H9V9H0ZM3 3H6V6L4 7"/>)")).domain), {{"region_1", 81}});
    checkAreas(areas(read(svg(R"(<path d="M0 0H9V9H0"/>)")).domain), {{"region_1", 81}});
}

TEST_CASE("Drawings: painted shapes are united, crossing or nested") {
    const Read nested = read(svg(R"(<rect width="9" height="9"/><rect x="3" y="3" width="2" height="2"/>)"));
    checkAreas(areas(nested.domain), {{"region_1", 81}});
    CHECK(nested.has("inner-outlines"));
    const Read crossing = read(svg(R"(<rect width="4" height="4"/><rect x="2" y="2" width="4" height="4"/>)"));
    checkAreas(areas(crossing.domain), {{"region_1", 28}});
    CHECK(crossing.has("crossing-segments"));
}

TEST_CASE("Drawings: unpainted shapes are lines, or nothing where other shapes are painted or stroked") {
    const Read lined = read(svg(R"(<rect width="9" height="9"/><path fill="none" stroke="red" d="M2 2H5V5H2Z"/>)"
                                R"(<path fill="none" d="M-5 -5H20V20H-5Z"/>)"));
    checkAreas(areas(lined.domain), {{"region_1", 81}});
    CHECK(lined.domain.segments.size() == 8);
    CHECK(lined.has("svg-unpainted"));
    const Read framed = read(svg(R"(<path fill="none" d="M0 0H24V24H0Z"/>)"
                                 R"(<rect fill="none" stroke="red" x="2" y="2" width="9" height="9"/>)"));
    checkAreas(areas(framed.domain), {{"region_1", 81}});
    CHECK(framed.has("svg-unpainted"));
    const Read outlines = read(svg(R"(<g fill="none" stroke="black"><rect width="9" height="9"/>)"
                                   R"(<circle cx="4" cy="4" r="1"/><path d="M6 6H8"/></g>)"));
    CHECK(areas(outlines.domain).at("region_1") == doctest::Approx(81 - 3.14159265).epsilon(1e-3));
    CHECK(std::count_if(outlines.domain.segments.begin(), outlines.domain.segments.end(),
                        [](const DomainSegment &s) { return s.role == SegmentRole::Constraint; }) == 1);
}

TEST_CASE("Drawings: the report says once how strokes and shapes without fill are read") {
    const Read mixed = read(svg("<rect width=\"9\" height=\"9\"/>\n"
                                "<path fill=\"none\" stroke=\"red\" d=\"M2 2H5V5H2Z M6 6H7V7H6Z\"/>\n"
                                "<path fill=\"none\" stroke=\"red\" d=\"M1 1H2V2H1Z\"/>"));
    REQUIRE(mixed.has("svg-unfilled"));
    CHECK(mixed.find("svg-unfilled")->count == 2); // elements, not subpaths
    CHECK(mixed.find("svg-unfilled")->line == 2);
    REQUIRE(mixed.has("svg-stroke"));
    CHECK(mixed.find("svg-stroke")->count == 2);
    CHECK_FALSE(mixed.has("svg-outlines"));
    const Read outlines = read(svg(R"(<g fill="none" stroke="black"><rect width="9" height="9"/>)"
                                   R"(<rect x="2" y="2" width="3" height="3"/></g>)"));
    REQUIRE(outlines.has("svg-outlines"));
    CHECK(outlines.find("svg-outlines")->count == 2);
    const Read plain = read(svg(R"(<rect width="9" height="9"/>)"));
    CHECK(plain.notes.entries().empty());
}

TEST_CASE("Drawings: shapes and features of which nothing is left are reported") {
    const Read drawing =
        read(svg(R"(<rect id="wall" width="9" height="9"/><rect id="door" x="3" width="2" height="2"/>)"
                 R"(<rect id="hair" x="20" width="1e-9" height="5"/>)"));
    REQUIRE(drawing.has("vanished-shapes"));
    CHECK(drawing.find("vanished-shapes")->message.find("2 shapes") == std::string::npos); // the door has an edge left
    CHECK(drawing.find("vanished-shapes")->message.find("hair") != std::string::npos);
    const Read covered = read(map({{"under", rectangle(1, 1, 2, 2)}, {"over", rectangle(1, 1, 2, 2)}}));
    REQUIRE(covered.has("vanished-shapes"));
    CHECK(covered.find("vanished-shapes")->message.find("under") != std::string::npos);
}

TEST_CASE("Maps: holes, covered features and features without a name are read") {
    checkAreas(
        areas(
            read(map({{"", rectangle(0, 0, 9, 9) + ',' + rectangle(4, 4, 2, 2)}, {"", rectangle(3, 3, 4, 4)}})).domain),
        {{"region_1", 81}});
    checkAreas(areas(read(map({{"", rectangle(0, 0, 5, 5)}, {"", rectangle(1, 1, 1, 1)}})).domain), {{"region_1", 25}});
    checkAreas(areas(read(map({{"", rectangle(0, 0, 5, 5) + ",[[5,0],[5,5],[3,4],[3,1],[5,0]]"}})).domain),
               {{"region_1", 17}});
}

TEST_CASE("Maps: a polygon inside another one keeps its area, in either order") {
    for (const bool innerFirst : {false, true}) {
        for (const double x : {1.0, 2.0}) {
            std::vector<std::pair<std::string, std::string>> polygons{{"A", rectangle(0, 0, 5, 5)},
                                                                      {"B", rectangle(x, x, 1, 1)}};
            if (innerFirst) {
                std::swap(polygons[0], polygons[1]);
            }
            checkAreas(areas(read(map(polygons)).domain), {{"A", 24}, {"B", 1}});
        }
    }
}

TEST_CASE("Maps: of overlapping polygons the later or the smaller one wins, with a note") {
    const std::string neighbours = map({{"A", rectangle(3, 1, 3, 2)}, {"B", rectangle(0, 0, 4, 4)}});
    const Read later = read(neighbours);
    checkAreas(areas(later.domain), {{"A", 4}, {"B", 16}});
    CHECK(later.has("overlapping-features"));
    ImportOptions smaller;
    smaller.overlap = OverlapRule::Smaller;
    checkAreas(areas(read(neighbours, smaller).domain), {{"A", 6}, {"B", 14}});
    checkAreas(areas(read(map({{"A", rectangle(0, 0, 3, 3)}, {"B", rectangle(1, 0.5, 3, 1)}})).domain),
               {{"A", 7}, {"B", 3}});
    checkAreas(
        areas(read(map({{"A", rectangle(0, 0, 3, 3)}, {"B", rectangle(3, 0, 3, 3)}, {"C", rectangle(2, -1, 2, 2)}}))
                  .domain),
        {{"A", 8}, {"B", 8}, {"C", 4}});
}

TEST_CASE("Maps: neighbours whose borders disagree by less than the tolerance share one border") {
    const auto withGap = [](double gap) {
        return map({{"A", rectangle(0, 0, 1, 1)}, {"B", rectangle(1 + gap, 0, 1, 1)}});
    };
    CHECK(read(withGap(-1e-6)).domain.segments.size() == 7);
    CHECK(read(withGap(-1e-6)).has("welded-nodes"));
    CHECK(read(withGap(0.01)).domain.segments.size() == 8);
    ImportOptions options;
    options.weldTolerance = 0.02;
    CHECK(read(withGap(0.01), options).domain.segments.size() == 7);
    options.weldTolerance = 0.0;
    CHECK(read(withGap(1e-6), options).domain.segments.size() == 8);
}

TEST_CASE("Drawings and maps: strict import refuses what it would have to change, and only that") {
    ImportOptions strict;
    strict.strict = true;
    const auto refused = [&](const std::string &text) {
        SourceText source = sourceOf(text);
        source.options = strict;
        const Result<Domain> domain = looksLikeSvg(text) ? readSvg(source) : readGeoJson(source);
        return !domain.ok() && allLocated(domain.faults());
    };
    CHECK(refused(svg(R"(<rect width="4" height="4"/><rect x="2" y="2" width="4" height="4"/>)")));
    CHECK(refused(map({{"A", rectangle(0, 0, 4, 4)}, {"B", rectangle(3, 1, 3, 2)}})));
    CHECK_FALSE(refused(svg(R"(<path d="M0 0H9V9H0ZM3 3H6V6H3Z"/>)")));
    CHECK_FALSE(refused(map({{"A", rectangle(0, 0, 1, 1)}, {"B", rectangle(1, 0, 1, 1)}})));
}

TEST_CASE("Drawings: lines that cross are cut there before their loops become outlines") {
    const Read lines = read(svg(R"(<line x1="-1" x2="9"/><line y1="-1" y2="9"/><line x1="8" y1="-1" x2="8" y2="9"/>)"
                                R"(<line x1="-1" y1="8" x2="9" y2="8"/>)"));
    checkAreas(areas(lines.domain), {{"region_1", 64}});
    CHECK(lines.has("lines-as-outline"));
    CHECK(lines.has("crossing-segments"));
    CHECK(lines.has("segment-outside"));
}

TEST_CASE("Drawings kept beside the repository have their known areas") {
    const std::filesystem::path folder =
        std::filesystem::path(FOREFRONT_SOURCE_DIR) / ".." / "shared" / "data" / "drawings";
    if (!std::filesystem::exists(folder)) {
        MESSAGE("not found: " << folder.string());
        return;
    }
    const std::map<std::string, Areas> expected{
        {"nz.svg", {{"region_1", 100}}},
        {"op.svg", {{"region_1", 100}}},
        {"two.svg", {{"region_1", 100}}},
        {"over_hole.geojson", {{"region_1", 100}}},
        {"overlap1.geojson", {{"A", 14}, {"B", 6}}},
        {"nest_unnamed.geojson", {{"region_1", 16}}},
        {"nest_centre.geojson", {{"A", 12}, {"B", 4}}},
        {"nest_onmarker.geojson", {{"A", 15}, {"B", 1}}},
        {"ov.geojson", {{"A", 3}, {"B", 2}}},
        {"tri3.geojson", {{"A", 3}, {"B", 3}, {"C", 4}}},
        {"hole_flush.geojson", {{"region_1", 10}}},
    };
    for (const auto &[name, regions] : expected) {
        CAPTURE(name);
        const Result<DomainFile> domain = allFormats().readDomain(folder / name);
        REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
        checkAreas(areas(domain->domain), regions);
    }
}
