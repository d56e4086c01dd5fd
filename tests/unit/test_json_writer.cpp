#include "core/files/json/json_writer.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

using namespace forefront;

namespace {

std::string sampleText(JsonWriter::Layout layout) {
    JsonWriter json(layout);
    json.beginObject().member("text", "a \"b\"\n\\ \xc3\xa9").member("none", std::numeric_limits<double>::quiet_NaN());
    json.member("third", 1.0 / 3.0).member("large", std::numeric_limits<std::uint64_t>::max()).member("low", -7);
    json.member("yes", true).member("empty", std::string());
    json.key("list").values(std::vector<double>{1.5, -0.0, 1e300}).key("nothing").beginArray().endArray();
    json.key("inner").beginObject().endObject().key("deep").beginArray();
    json.beginObject().member("k", 1).endObject().beginArray().value("x").value(false).endArray();
    return json.endArray().endObject().text();
}

} // namespace

TEST_CASE("JsonWriter: another program reads back what was written, in both layouts") {
    for (const auto layout : {JsonWriter::Layout::OneLine, JsonWriter::Layout::Indented}) {
        const std::string text = sampleText(layout);
        const nlohmann::json read = nlohmann::json::parse(text, nullptr, false);
        REQUIRE(read.is_object());
        CHECK(read["text"] == "a \"b\"\n\\ \xc3\xa9");
        CHECK(read["none"].is_null());
        CHECK(read["third"].get<double>() == 1.0 / 3.0);
        CHECK(read["large"].get<std::uint64_t>() == std::numeric_limits<std::uint64_t>::max());
        CHECK(read["low"] == -7);
        CHECK(read["yes"] == true);
        CHECK(read["empty"] == "");
        CHECK(read["list"].get<std::vector<double>>() == std::vector<double>{1.5, 0.0, 1e300});
        CHECK(read["nothing"] == nlohmann::json::array());
        CHECK(read["inner"] == nlohmann::json::object());
        CHECK(read["deep"] == nlohmann::json::array({{{"k", 1}}, {"x", false}}));
        CHECK((text.find('\n') == text.size() - 1) == (layout == JsonWriter::Layout::OneLine));
    }
}

TEST_CASE("JsonWriter: bytes that are not UTF-8 are replaced, in names and in values") {
    JsonWriter json(JsonWriter::Layout::OneLine);
    const std::string text = json.beginObject().member("a\xff", "b\xc3").endObject().text();
    const nlohmann::json read = nlohmann::json::parse(text, nullptr, false);
    REQUIRE(read.is_object());
    CHECK(read.size() == 1);
}

TEST_CASE("JsonWriter: an indented text has a member a line, and plain lists stay in one") {
    JsonWriter json(JsonWriter::Layout::Indented);
    json.beginObject().member("a", 1).key("b").values(std::vector<int>{1, 2}).key("c").beginObject().member("d", 2.5);
    CHECK(json.endObject().endObject().text() ==
          "{\n  \"a\": 1,\n  \"b\": [1,2],\n  \"c\": {\n    \"d\": 2.5\n  }\n}\n");
}
