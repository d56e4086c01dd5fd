#include "core/drawing/domain/document_domain.hpp"
#include "core/teaching/lesson/lesson_check.hpp"
#include "core/teaching/lesson/lesson_names.hpp"
#include "core/teaching/lesson/lesson_read.hpp"
#include "core/teaching/lesson/seed_check.hpp"
#include "core/teaching/lesson_page/lesson_page.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>

using namespace forefront;
using namespace forefront::testing;

namespace checked_lessons {

/// Returns a square of side 4 with a size of 1; with another name than "square", two of its sides cross.
Result<Document> drawing(const std::string &name) {
    Domain domain;
    domain.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    if (name != "square") {
        std::swap(domain.nodes[1], domain.nodes[2]);
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
        domain.segments.push_back({i, (i + 1) % 4, 1, SegmentRole::Boundary});
    }
    Document document = fromDomain(domain);
    document.spacing.size = 1.0;
    document.options.method = Method::Classic;
    return document;
}

/// Returns a lesson with one page about the square. `members`: further ones of the page.
std::string lesson(const std::string &members, const std::string &document = "square") {
    return "{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"T\", \"pages\": [\n"
           "{\"title\": \"P\", \"text\": \"t\", \"document\": \"" +
           document + "\"" + members + "}]}";
}

std::string lessonAsking(const std::string &members) {
    return ",\n\"question\": {\"text\": \"q\",\n" + members + "}";
}

/// Returns the faults of a lesson that can be read.
Diagnostics lessonFaults(const std::string &text) {
    LessonNames names;
    names.document = drawing;
    const SourceText source = sourceOf(text);
    const Result<Lesson> read = readLesson(source, names);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    return checkLesson(*read, source, {});
}

std::string codesOf(const std::string &text) {
    std::string codes;
    for (const Diagnostic &fault : lessonFaults(text)) {
        codes += (codes.empty() ? "" : " ") + fault.code;
    }
    return codes;
}

} // namespace checked_lessons

TEST_CASE("Lesson check: a lesson whose questions have answers is free of faults") {
    using namespace checked_lessons;
    CHECK(codesOf(lesson("")) == "");
    CHECK(codesOf(lesson(", \"position\": 3" + lessonAsking("\"number\": \"front\""))) == "");
    CHECK(codesOf(lesson(
              ", \"position\": \"end\"" +
              lessonAsking(R"("choices": [{"text": "a", "right": {"value": "finished", "is": 1}}, {"text": "b"}])"))) ==
          "");
    CHECK(codesOf(lesson(lessonAsking(R"("until": {"value": "finished", "is": 1}, "show": "end")"))) == "");
    CHECK(codesOf(lesson(lessonAsking(R"("until": {"value": "elements", "is": 5})"))) == "");
    CHECK(codesOf(lesson(", \"position\": 1" + lessonAsking(R"("until": {"value": "chosen", "is": "winner"})"))) == "");
    CHECK(codesOf(lesson(lessonAsking(R"("until": {"value": "improve-step", "is": 2})"))) == "");
}

TEST_CASE("Lesson check: what only a run can tell is reported with its page and line") {
    using namespace checked_lessons;
    const Diagnostics faults = lessonFaults(lesson(lessonAsking(R"("until": {"value": "elements", "is": 5000})")));
    REQUIRE(faults.size() == 1);
    CHECK(faults.front().code == "no-answer");
    CHECK(faults.front().line == 4);
    CHECK(faults.front().message.find("page 'P'") != std::string::npos);
    CHECK(codesOf(lesson("", "crossing")) == "not-meshed");
    CHECK(codesOf(lesson(", \"position\": 5000")) == "lesson-position");
    CHECK(codesOf(lesson(R"(, "position": {"advance": 1, "events": 400})")) == "lesson-position");
    CHECK(codesOf(lesson(lessonAsking(R"("number": "score")"))) == "no-answer"); // before the first advance
    CHECK(codesOf(lesson(lessonAsking(
              R"("choices": [{"text": "a", "right": {"value": "front", "is": 3}}, {"text": "b"}])"))) == "no-answer");
    CHECK(codesOf(lesson(lessonAsking(R"("choices": [{"text": "a", "right": true}, {"text": "b", "right": true}])"))) ==
          "all-right");
    CHECK(codesOf(lesson(lessonAsking(R"("until": {"value": "advance", "is": 0})"))) == "done-already");
    CHECK(codesOf(lesson(lessonAsking(R"("until": {"value": "elements", "is": 5}, "show": 4)"))) == "wrong-show");
    CHECK(codesOf(lesson(lessonAsking(R"("number": "front", "why": "{alpha}")"))) == "no-value");
}

TEST_CASE("Lesson check: stops when it is cancelled") {
    using namespace checked_lessons;
    LessonNames names;
    names.document = drawing;
    const std::string text = lesson("");
    const SourceText source = sourceOf(text);
    const Result<Lesson> read = readLesson(source, names);
    REQUIRE(read.ok());
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    progress.stop = stop.get_token();
    const Diagnostics faults = checkLesson(*read, source, progress);
    REQUIRE(faults.size() == 1);
    CHECK(faults.front().code == "cancelled");
}

TEST_CASE("Lesson check: a random number that has no answer is found, whichever it is, and each drawing is run once") {
    using namespace checked_lessons;
    const auto check = [](int last) {
        LessonFile file;
        file.text = lesson(R"(, "random": {"n": [0, )" + std::to_string(last) + R"(]}, "position": "n")" +
                           lessonAsking(R"("number": "front")"));
        file.path = "numbers.json";
        LessonNames names;
        names.document = drawing;
        const Result<Lesson> read = readLesson(file.source(), names);
        REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
        file.lesson = *read;
        LessonRuns runs(LessonRuns::Keep::All);
        const SeedCheck outcome = checkSeeds(file, names, runs, {});
        CHECK(runs.made() == 1);
        return outcome;
    };
    LessonNames names;
    names.document = drawing;
    const std::string plain = lesson("");
    LessonRuns runs;
    const auto run = runs.of(readLesson(sourceOf(plain), names)->pages[0], {});
    REQUIRE(run);
    const int length = static_cast<int>((*run)->advances() + (*run)->improveSteps());
    REQUIRE(length > 40);
    const SeedCheck whole = check(length);
    CHECK(whole.faults.empty());
    CHECK(whole.seeds > 20);
    const SeedCheck beyond = check(length + 1); // one number of many is no position of the run
    REQUIRE(beyond.faults.size() == 1);
    CHECK(beyond.faults.front().code == "lesson-position");
    CHECK(beyond.faults.front().message.find("(with the random numbers of --seed ") != std::string::npos);
    std::stop_source stop;
    stop.request_stop();
    LessonFile file;
    file.text = plain;
    file.lesson = *readLesson(file.source(), names);
    Progress progress;
    progress.stop = stop.get_token();
    CHECK(checkSeeds(file, names, runs, progress).faults.front().code == "cancelled");
}

TEST_CASE("Lesson page: the runs of the check are used again, and what only the editor shows is said") {
    using namespace checked_lessons;
    LessonNames names;
    names.document = drawing;
    const std::string text = lesson(lessonAsking(R"("until": {"value": "improve-step", "is": 2})") + // past the front
                                    "}, {\"title\": \"Q\", \"text\": \"t\", \"position\": 46");
    const SourceText source = sourceOf(text);
    const Result<Lesson> read = readLesson(source, names);
    REQUIRE(read.ok());
    LessonRuns runs(LessonRuns::Keep::All);
    CHECK(checkLesson(*read, source, runs, {}).empty());
    StringSink sink;
    TextWriter out(sink);
    const Status warnings = writeLessonPage(*read, runs, out, {}, 300); // of steps of the improvement: one
    out.flush();
    CHECK(runs.made() == 1);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings.front().code == "not-on-page");
    CHECK(warnings.front().severity == Severity::Warning);
    CHECK(warnings.front().line == 3);
    CHECK(sink.text.find("This task needs a moment that the editor shows") != std::string::npos);
    CHECK(sink.text.find("\"note\":\"This page is about step ") != std::string::npos);
    StringSink whole;
    TextWriter all(whole);
    CHECK(writeLessonPage(*read, runs, all, {}).empty()); // with all steps
    all.flush();
    CHECK(whole.text.find("note\":") == std::string::npos);
    const std::uint64_t advances = (*runs.of(read->pages[0], {}))->advances();
    REQUIRE(advances < 46);
    const std::string front = '[' + std::to_string(advances) + ",0,";
    CHECK(whole.text.find("\"done\":[" + front + "2,-1,") != std::string::npos);
    CHECK(whole.text.find("\"at\":" + front + std::to_string(46 - advances) + ']') != std::string::npos);
}

TEST_CASE("Lesson check: names of layers, panels and widgets are known without a window") {
    const LessonNames names = editorNames();
    CHECK(names.layers.size() == 23);
    CHECK(names.panels.size() == 19);
    CHECK(names.widgets.at("steps").back() == "steps/10");
    const std::string text = checked_lessons::lesson(R"(, "layers": ["mesch"])");
    const Result<Lesson> read = readLesson(sourceOf(text), names);
    REQUIRE_FALSE(read.ok());
    CHECK(read.faults().front().code == "unknown-name");
}

TEST_CASE("Lesson page: has the mistakes of a question with the differences that the editor allows") {
    using namespace checked_lessons;
    LessonNames names;
    names.document = drawing;
    const std::string text = lesson(R"(, "position": 20)" + lessonAsking(R"("number": "front", "hint": "h",
        "mistakes": [{"is": "Nb", "hint": "That is the mean."}, {"is": 4, "hint": "Four."}])"));
    const Result<Lesson> read = readLesson(sourceOf(text), names);
    REQUIRE(read.ok());
    LessonRuns runs(LessonRuns::Keep::All);
    const auto run = runs.of(read->pages[0], {});
    REQUIRE(run);
    const std::shared_ptr<const SessionSnapshot> shown = (*run)->at({.advance = 20});
    const double mean = valueOf(LessonValue::FrontMean, {*shown}).value();
    REQUIRE(mean != std::round(mean));
    StringSink sink, expected;
    TextWriter out(sink), number(expected);
    REQUIRE(writeLessonPage(*read, runs, out, {}).empty());
    out.flush();
    number << "\"mistakes\":[[" << mean << ',' << roundingOf(mean) << ",\"That is the mean.\"],[4," << roundingOf(4.0)
           << ",\"Four.\"]]";
    number.flush();
    CHECK(sink.text.find(expected.text) != std::string::npos);
}

TEST_CASE("Lesson page: has the values, the right answers and the moments of its tasks") {
    using namespace checked_lessons;
    LessonNames names;
    names.document = drawing;
    const std::string text = lesson(
        R"(, "position": 2)" + lessonAsking(R"("until": {"value": "elements", "is": 3}, "why": "{front} </script>")"));
    const Result<Lesson> read = readLesson(sourceOf(text), names);
    REQUIRE(read.ok());
    StringSink sink;
    TextWriter out(sink);
    REQUIRE(writeLessonPage(*read, out, {}).empty());
    out.flush();
    const std::string &page = sink.text;
    CHECK(page.find("\"run\":0,\"at\":[2,0,0]") != std::string::npos);
    CHECK(page.find("\"done\":[[3,0,0,-1,0],[3,1,0,-1,0]]") != std::string::npos);
    CHECK(page.find("&lt;/script&gt;") != std::string::npos);
    CHECK(page.find("http") == std::string::npos);
}
