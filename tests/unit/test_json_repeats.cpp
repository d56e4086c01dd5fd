#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/script/script.hpp"
#include "core/files/rules/rules_json.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using namespace forefront::testing;

TEST_CASE("JSON: members that stand twice are refused with both lines") {
    const std::string project = "{\"format\": \"forefront\", \"version\": 1,\n \"spacing\": {\"size\": 1},\n"
                                " \"shapes\": [],\n \"spacing\": {\"size\": 2}}";
    const Result<Document> twice = parseProject(project, "a.json");
    REQUIRE_FALSE(twice);
    CHECK(hasCode(twice.faults(), "duplicate-member"));
    CHECK(messages(twice.faults()).find("a.json:4:2: error: duplicate member 'spacing'; the first is in line 2") == 0);
    const Result<Document> inner = parseProject(
        "{\"format\": \"forefront\", \"version\": 1, \"spacing\": {\"size\": 1, \"si\\u007ae\": 2}, \"shapes\": []}",
        "a");
    REQUIRE_FALSE(inner);
    CHECK(hasCode(inner.faults(), "duplicate-member"));
    CHECK(parseProject("{\"format\": \"forefront\", \"version\": 1, \"shapes\": []}", "a"));
}

TEST_CASE("JSON: members that stand twice are refused in scripts and rules, too") {
    const Result<Script> script = Script::read(sourceOf("{\"command\": \"undo\", \"steps\": 1, \"steps\": 2}"));
    REQUIRE_FALSE(script);
    CHECK(hasCode(script.faults(), "duplicate-member"));
    CHECK(hasCode(readRulesText(sourceOf("{\"format\": \"forefront-rules\", \"format\": 1}")).faults(),
                  "duplicate-member"));
}
