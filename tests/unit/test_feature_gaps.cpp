#include "core/io/geojson/geojson.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Returns the note on neighbours that nearly touch; empty if there is none.
std::string noteOn(const std::string &first, const std::string &second) {
    const auto feature = [](const std::string &ring) {
        return R"({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [[)" + ring +
               "]]}}";
    };
    const std::string text =
        R"({"type": "FeatureCollection", "features": [)" + feature(first) + ",\n" + feature(second) + "]}";
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
    CHECK(noteOn(kLeft, "[10.003,0],[20,0],[20,10],[10.003,10],[10.003,0]") ==
          "5 nodes nearly touch another feature, at most 0.003 away, first at (10, 0); --weld 0.00315 joins them");
}

TEST_CASE("feature gaps: neighbours that touch, lie apart, or meet in a corner are none") {
    CHECK(noteOn(kLeft, "[10,0],[20,0],[20,10],[10,10],[10,3],[10,0]").empty());
    CHECK(noteOn(kLeft, "[10.1,0],[20,0],[20,10],[10.1,10],[10.1,0]").empty());
    CHECK(noteOn("[0,0],[10,0],[10,3],[10,3.001],[9,10],[0,10],[0,0]",
                 "[10,0],[20,0],[20,10],[11,10],[10.0003,3.001],[10,3],[10,0]")
              .empty());
}
