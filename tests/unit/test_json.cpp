#include "core/files/json/json.hpp"
#include "core/files/text/base64.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

using namespace forefront;
using namespace forefront::testing;

TEST_CASE("JSON: syntax faults are located at the offending byte") {
    const auto place = [](const char *text) {
        const auto json = JsonDocument::parse(sourceOf(text));
        REQUIRE(!json.ok());
        return std::pair(json.faults()[0].line, json.faults()[0].column);
    };
    CHECK(place("") == std::pair(1, 1));
    CHECK(place("{\n  \"a\": 1,\n  b: 2}") == std::pair(3, 3));
    CHECK(place("[1, 2") == std::pair(1, 6));
    CHECK(place("[1] 2") == std::pair(1, 5));
    CHECK(place("[01]") == std::pair(1, 3));
    CHECK(place("[NaN]") == std::pair(1, 2));
    CHECK(place("[1.]") == std::pair(1, 4));
    CHECK(place("\"\\x\"") == std::pair(1, 3));
    CHECK(place("\"\\u12G4\"") == std::pair(1, 6));
    CHECK(place("\"a\nb\"") == std::pair(1, 3));
    CHECK(place("[1,]") == std::pair(1, 4));
    CHECK(place("{\"a\" 1}") == std::pair(1, 6));
}

TEST_CASE("JSON: refuses nesting beyond the limit at any depth") {
    const std::string deep(5'000'000, '[');
    const auto json = JsonDocument::parse(sourceOf(deep));
    REQUIRE(!json.ok());
    CHECK(json.faults()[0].code == "too-deep");
    CHECK(json.faults()[0].column == 65);
}

TEST_CASE("JSON: escapes, pairs of surrogates and lone surrogates are decoded") {
    const std::string text = R"(["\"\\\/\b\f\n\r\t", "\u00e4\u20AC\ud83d\ude00", "\ud83d x", "ä"])";
    const auto json = JsonDocument::parse(sourceOf(text));
    REQUIRE(json.ok());
    auto item = json->root().begin();
    CHECK((*item).string() == "\"\\/\b\f\n\r\t");
    CHECK((*++item).string() == "\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80");
    CHECK((*++item).string() == "\xef\xbf\xbd x");
    CHECK((*++item).string() == "ä");
    CHECK(json->root().count() == 4);
}

TEST_CASE("JSON: numbers keep their bits, and integers are distinguished") {
    const std::string text = "[0.1, -0, 12, 1e400, 1e-400, 9223372036854775807, 9223372036854775808, 1.0, 2E3]";
    const auto json = JsonDocument::parse(sourceOf(text));
    REQUIRE(json.ok());
    auto item = json->root().begin();
    CHECK((*item).number() == 0.1);
    CHECK(std::signbit(*(*++item).number()));
    CHECK((*++item).integer() == 12);
    CHECK(!(*++item).number());
    CHECK((*++item).number() == 0.0);
    CHECK((*++item).integer() == 9223372036854775807);
    CHECK(!(*++item).integer());
    CHECK(!(*++item).integer());
    CHECK((*++item).number() == 2000.0);
}

TEST_CASE("Base64: round trip at every length; refuses damaged text") {
    std::mt19937 random(4);
    for (std::size_t length = 0; length < 70; ++length) {
        std::string bytes(length, '\0');
        for (char &c : bytes) {
            c = static_cast<char>(random() & 255U);
        }
        CHECK(fromBase64(toBase64(bytes)) == bytes);
    }
    CHECK(toBase64("Man") == "TWFu");
    CHECK(toBase64("Ma") == "TWE=");
    CHECK(fromBase64("TW Fu\n") == "Man");
    for (const char *wrong : {"T", "TWE", "TWE==", "T=FU", "TW*u", "TWFuT==="}) {
        CAPTURE(wrong);
        CHECK(!fromBase64(wrong));
    }
}
