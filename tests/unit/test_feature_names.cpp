#include "core/drawing_files/geojson/geojson.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

using Names = std::map<std::int32_t, std::string>;

/// A map of unit squares in a row, each with these properties.
std::string mapOf(const std::vector<std::string> &properties) {
    std::string text = R"({"type": "FeatureCollection", "features": [)";
    for (std::size_t k = 0; k < properties.size(); ++k) {
        const std::string a = std::to_string(k), b = std::to_string(k + 1);
        text += (k == 0 ? "\n" : ",\n") + (R"({"type": "Feature", "properties": )" + properties[k]) +
                R"(, "geometry": {"type": "Polygon", "coordinates": [[[)" + a + ",0],[" + b + ",0],[" + b + ",1],[" +
                a + ",1],[" + a + ",0]]]}}";
    }
    return text + "]}";
}

Result<Domain> readMap(const std::string &text, const std::optional<std::string> &key, ImportNotes *notes = nullptr) {
    SourceText source = sourceOf(text, "map.geojson");
    source.options.nameProperty = key;
    source.notes = notes;
    return readGeoJson(source);
}

Names featureNames(const std::vector<std::string> &properties, const std::optional<std::string> &key = {},
                   ImportNotes *notes = nullptr) {
    const auto domain = readMap(mapOf(properties), key, notes);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    CHECK(domain->boundaryNames == domain->regionNames);
    return domain->regionNames;
}

/// The text of the only note.
std::string noteOf(const ImportNotes &notes) {
    REQUIRE(notes.entries().size() == 1);
    return notes.entries()[0].message;
}

} // namespace

TEST_CASE("Names of features: administrative areas are named by the finest level that all of them have") {
    const std::string bern = R"({"NAME_0": "Swiss", "NAME_1": "Bern", "NAME_2": "Thun"})",
                      genf = R"({"NAME_0": "Swiss", "NAME_1": "Genf", "NAME_2": ""})";
    ImportNotes notes;
    CHECK(featureNames({bern}, {}, &notes) == Names{{1, "Thun"}});
    CHECK(noteOf(notes) == "properties other than \"NAME_2\" and \"tag\" are ignored: 'NAME_0', 'NAME_1'");
    CHECK(featureNames({bern, genf}) == Names{{1, "Bern"}, {2, "Genf"}});
    CHECK(featureNames({genf, bern}) == Names{{1, "Genf"}, {2, "Bern"}});
    CHECK(featureNames({bern, R"({"depth": 3})", "null"}) == Names{{1, "Thun"}});           // others have no such names
    CHECK(featureNames({R"({"NAME_0": "A", "tag": 7})", R"({"NAME_1": "B"})"}) == Names{}); // no common level
    CHECK(featureNames({R"({"NAME_0": "A", "NAME_3": 5, "NAME_10": "B", "NAME_": "C", "NAME_x": "D"})"}) ==
          Names{{1, "A"}});
}

TEST_CASE("Names of features: a map with names uses these alone") {
    ImportNotes notes;
    const std::string both = R"({"NAME": "land", "NAME_1": "level"})", level = R"({"name": 5, "NAME_1": "other"})";
    CHECK(featureNames({level, both, level}, {}, &notes) == Names{{2, "land"}});
    CHECK(noteOf(notes) == "properties other than \"name\" and \"tag\" are ignored: 'NAME_1'");
    CHECK(featureNames({R"({"name": " ", "Name": "b", "NAME": "c"})"}) == Names{{1, "b"}});
}

TEST_CASE("Names of features: a property can be given, with text or numbers") {
    ImportNotes notes;
    const std::vector<std::string> map{R"({"name": "A", "nom": "un", "code": 12})",
                                       R"({"name": "B", "nom": null, "code": 1.50e3})",
                                       R"({"name": "C", "nom": "un", "tag": 9, "code": "x"})"};
    CHECK(featureNames(map) == Names{{1, "A"}, {2, "B"}, {9, "C"}});
    CHECK(featureNames(map, "nom", &notes) == Names{{1, "un"}, {9, "un"}});
    CHECK(noteOf(notes) == "properties other than \"nom\" and \"tag\" are ignored: 'code', 'name'");
    CHECK(notes.contents().properties == std::vector<std::string>{"code", "name", "nom", "tag"});
    CHECK(featureNames(map, "code") == Names{{1, "12"}, {2, "1.50e3"}, {9, "x"}});
    CHECK(featureNames({R"({"NAME_1": "A", "NAME_2": "B"})"}, "NAME_1") == Names{{1, "A"}});
}

TEST_CASE("Names of features: the id of a feature stands in for a property of that name, if asked for") {
    const auto feature = [](const std::string &members, int at) {
        const std::string a = std::to_string(at), b = std::to_string(at + 1);
        return R"({"type": "Feature", )" + members + R"("geometry": {"type": "Polygon", "coordinates": [[[)" + a +
               ",0],[" + b + ",0],[" + b + ",1],[" + a + ",1],[" + a + ",0]]]}}";
    };
    const std::string map = R"({"type": "FeatureCollection", "features": [)" +
                            feature(R"("id": "01", "properties": {"name": "A"}, )", 0) + ", " +
                            feature(R"("id": 2, "properties": {"id": "own"}, )", 1) + ", " +
                            feature(R"("id": 30, )", 2) + ", " + feature(R"("properties": null, )", 3) + "]}";
    ImportNotes named, byId;
    const auto plain = readMap(map, {}, &named), ids = readMap(map, "id", &byId);
    REQUIRE(plain.ok());
    CHECK(plain->regionNames == Names{{1, "A"}});
    CHECK(named.contents().properties == std::vector<std::string>{"id", "name"});
    CHECK(named.entries().back().message == "members that have no meaning here are ignored: 'id'");
    REQUIRE(ids.ok());
    CHECK(ids->regionNames == Names{{1, "01"}, {2, "own"}, {3, "30"}});
    CHECK(noteOf(byId) == "properties other than \"id\" and \"tag\" are ignored: 'name'");
}

TEST_CASE("Names of features: a property that no feature has is refused with those that occur") {
    const auto refusal = [](const std::vector<std::string> &map, const std::string &key) {
        const auto domain = readMap(mapOf(map), key);
        REQUIRE_FALSE(domain.ok());
        CHECK(allLocated(domain.faults()));
        CHECK(domain.faults()[0].code == "unknown-property");
        return domain.faults()[0];
    };
    const Diagnostic fault = refusal({R"({"nom": "A", "état": 3, "flag": true, "none": null, "blank": ""})"}, "Nom");
    CHECK(fault.message == "no feature has a property 'Nom' with text or a number");
    CHECK(fault.advice == "expected one of 'nom', 'état'");
    CHECK(refusal({R"({"nom": "A", "none": null})"}, "none").advice == "expected one of 'nom'");
    CHECK(refusal({"null", "{}"}, "name").advice == "the features have no properties to take names from");
    std::string many;
    for (char letter = 'a'; letter < 'o'; ++letter) {
        many += std::string(many.empty() ? "{" : ", ") + '"' + letter + "\": 1";
    }
    CHECK(refusal({many + '}'}, "z").advice ==
          "expected one of 'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i', 'j', 'k', 'l' and 2 more");
}

TEST_CASE("Names of features: without names, a note says how to take them from a property with text") {
    const std::string hint = "; --name-property takes names from one of them";
    const auto hints = [&](const std::vector<std::string> &map, const std::optional<std::string> &key = {}) {
        ImportNotes notes;
        featureNames(map, key, &notes);
        return noteOf(notes).ends_with(hint);
    };
    CHECK(hints({R"({"depth": 3})", R"({"depth": 3, "naam": "A"})"}));
    CHECK_FALSE(hints({R"({"depth": 3})"}));
    CHECK_FALSE(hints({R"({"naam": "A"})", R"({"name": "B"})"}));
    CHECK_FALSE(hints({R"({"naam": "A", "other": "B"})"}, "naam"));
}
