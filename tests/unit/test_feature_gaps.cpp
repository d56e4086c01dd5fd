#include "core/drawing_files/geojson/geojson.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Returns the note on neighbours that nearly touch; empty if there is none.
std::string noteOn(const std::vector<std::string> &rings) {
    std::string features;
    for (const std::string &ring : rings) {
        features +=
            (features.empty() ? "" : ",\n") +
            (R"({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[)" + ring) +
            "]]}}";
    }
    const std::string text = R"({"type": "FeatureCollection", "features": [)" + features + "]}";
    ImportNotes notes;
    SourceText source = sourceOf(text, "map");
    source.notes = &notes;
    const auto domain = readGeoJson(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    std::string found;
    for (const ImportNote &note : notes.entries()) {
        found += note.code == "feature-gaps" ? note.message : "";
    }
    return found;
}

constexpr char kLeft[] = "[0,0],[10,0],[10,3],[10,10],[0,10],[0,0]";

} // namespace

TEST_CASE("feature gaps: neighbours that nearly touch are reported with the tolerance that joins them") {
    CHECK(noteOn({kLeft, "[10.003,0],[20,0],[20,10],[10.003,10],[10.003,0]"}) ==
          "features nearly touch in 5 places, at most 0.003 apart, first at (10, 0); --weld 0.00315 joins them");
}

TEST_CASE("feature gaps: neighbours that touch, lie apart, or meet in a corner are none") {
    CHECK(noteOn({kLeft, "[10,0],[20,0],[20,10],[10,10],[10,3],[10,0]"}).empty());
    CHECK(noteOn({kLeft, "[10.1,0],[20,0],[20,10],[10.1,10],[10.1,0]"}).empty());
    CHECK(noteOn({"[0,0],[10,0],[10,3],[10,3.001],[9,10],[0,10],[0,0]",
                  "[10,0],[20,0],[20,10],[11,10],[10.0003,3.001],[10,3],[10,0]"})
              .empty());
}

TEST_CASE("feature gaps: a wedge between long sides is reported though its ends lie where features meet") {
    const std::string south = "[0,0],[100,0],[100,99.9],[0,100],[0,0]";
    const std::string north = "[0,100],[100,100],[100,200],[0,200],[0,100]";
    const std::string east = "[100,0],[200,0],[200,200],[100,200],[100,100],[100,99.9],[100,0]";
    CHECK(noteOn({south, north, east}) ==
          "features nearly touch in 2 places, at most 0.1 apart, first at (50, 99.95); --weld 0.105 joins them");
    CHECK(noteOn({"[0,0],[100,0],[100,10],[0,10],[0,0]", "[100,0],[120,0],[120,10],[100,10],[100,0]",
                  "[-20,0],[0,0],[0,10],[-20,10],[-20,0]", "[49,10.01],[51,10.01],[51,12],[49,12],[49,10.01]"}) ==
          "features nearly touch in 3 places, at most 0.01 apart, first at (49, 10.01); --weld 0.0105 joins them");
    const std::string farther = "[0,0],[100,0],[100,98],[0,100],[0,0]"; // a wedge of 1 : 50 may be meant
    CHECK(noteOn({farther, north, "[100,0],[200,0],[200,200],[100,200],[100,100],[100,98],[100,0]"}).empty());
}
