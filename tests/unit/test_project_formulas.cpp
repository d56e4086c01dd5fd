#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/plate_sample.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

template <class T>
std::string codeOf(const Result<T> &result) {
    return result ? "" : result.faults().front().code;
}

} // namespace

TEST_CASE("Project: parameters and formulas survive a round trip; formulas win over numbers") {
    const Document document = plate();
    const std::string text = projectText(document);
    const Result<Document> read = parseProject(text, "test");
    REQUIRE(read.ok());
    CHECK(read->parameters == document.parameters);
    CHECK(read->formulas == document.formulas);
    CHECK(read->spacing.names == document.spacing.names);
    CHECK(projectText(*read) == text);
    const Result<Document> edited = parseProject(
        R"({"format": "forefront", "version": 2, "shapes": [{"id": 1, "kind": "circle", "nodes": [[0, 0], [1, 0]]}],
            "parameters": {"d": "2*r", "r": 1.5}, "formulas": {"shape/1/radius": "d"}})",
        "test");
    REQUIRE(edited.ok());
    CHECK(edited->parameters == std::vector<Parameter>{{"d", "2*r"}, {"r", "1.5"}});
    CHECK(circleRadius(*edited->shapes[0]) == 3.0);
}

TEST_CASE("Project: hidden and locked shapes and sizes of boundary parts survive a round trip") {
    Document document = plate();
    document = *setHidden(document, {1}, true);
    document = *setLocked(document, {2}, true);
    document = *setPartSize(document, 1, PartSize{0.125, 0.3});
    const Result<Document> read = parseProject(projectText(document), "test");
    REQUIRE(read.ok());
    CHECK(read->shapes[0]->hidden);
    CHECK_FALSE(read->shapes[0]->locked);
    CHECK(read->shapes[1]->locked);
    CHECK(read->spacing.partSizes == document.spacing.partSizes);
    const auto faultOfSizes = [](const std::string &list) {
        return codeOf(parseProject(
            R"({"format": "forefront", "version": 2, "shapes": [], "spacing": {"partSizes": )" + list + "}}", "test"));
    };
    CHECK(faultOfSizes(R"([{"tag": 1, "size": 0.5}])").empty());
    CHECK(faultOfSizes(R"([{"tag": 1, "size": 0}])") == "bad-number");
    CHECK(faultOfSizes(R"([{"tag": 1, "size": 1, "growth": -1}])") == "bad-number");
    CHECK(faultOfSizes(R"([{"tag": 1, "size": 1}, {"tag": 1, "size": 2}])") == "bad-tag");
    CHECK(faultOfSizes(R"([{"size": 1}])") == "missing-field");
    CHECK(faultOfSizes("[1]") == "bad-field");
}

TEST_CASE("Project: faults of parameters and formulas name line and column") {
    const auto faultOfText = [](const std::string &members) {
        const Result<Document> read = parseProject("{\"format\": \"forefront\", \"version\": 2,\n\"shapes\": [{\"id\": "
                                                   "1, \"kind\": \"circle\", \"nodes\": [[0, 0], [1, 0]]}],\n" +
                                                       members + "}",
                                                   "test");
        REQUIRE_FALSE(read.ok());
        const Diagnostic &fault = read.faults().front();
        return fault.code + ' ' + std::to_string(fault.line) + ':' + std::to_string(fault.column) + ' ' + fault.message;
    };
    CHECK(faultOfText(R"("parameters": {"a": "b",
        "b": "a"})")
              .starts_with("bad-parameter 3:21 parameter 'a': depends on itself: a "));
    CHECK(faultOfText(R"("parameters": {"a": "c + 1"})") ==
          "bad-parameter 3:21 parameter 'a': expression, column 1: unknown name 'c'; expected a parameter, pi, e or a "
          "function");
    CHECK(faultOfText(R"("parameters": {"sin": 1})").starts_with("bad-parameter 3:16 parameter 'sin': the name"));
    CHECK(faultOfText(R"("parameters": {"a": "b", "b": "c", "c": "("})") ==
          "bad-parameter 3:41 parameter 'c': expression, column 2: unexpected end; expected a number, a name or '('");
    std::string chain = R"("parameters": {"p1000": 1)";
    for (std::size_t k = 0; k < kMaxParameters; ++k) {
        chain +=
            ",\n\"p" + std::to_string(kMaxParameters - 1 - k) + "\": \"p" + std::to_string(kMaxParameters - k) + '"';
    }
    CHECK(faultOfText(chain + '}') ==
          "bad-parameter 1003:1 parameter 'p0': there are 1001 parameters; expected at most 1000");
    CHECK(faultOfText(R"("parameters": [])").starts_with("bad-field 3:15"));
    CHECK(faultOfText(R"("formulas": {"shape/9/radius": "1"})")
              .starts_with("bad-formula 3:14 no number has the address"));
    CHECK(faultOfText(R"("formulas": {"shape/1/radius": "q"})").starts_with("bad-formula 3:32 expression, column 1"));
    CHECK(faultOfText(R"("formulas": {"shape/1/radius": "-1"})").starts_with("bad-number 3:32 formula for"));
}

TEST_CASE("Project: overrides of parameters apply while reading") {
    const std::string text = projectText(plate());
    SourceText source{text, "test", {}, {}};
    source.options.parameters = {{"r", "1"}};
    const Result<Document> read = readProjectText(source);
    REQUIRE(read.ok());
    CHECK(circleRadius(*read->shapes[1]) == 1.0);
    CHECK(read->parameters[1].expression == "1");
    source.options.parameters = {{"q", "1"}};
    CHECK(codeOf(readProjectText(source)) == "unknown-parameter");
    source.options.parameters = {{"r", "gap"}};
    CHECK(codeOf(readProjectText(source)) == "bad-parameter");
}
