#include "core/drawing/domain/document_domain.hpp"
#include "core/teaching/lesson/answers.hpp"
#include "core/teaching/lesson/lesson_read.hpp"
#include "core/teaching/lesson/lesson_run.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace lesson_reply {

Result<Document> square(const std::string &) {
    Domain domain;
    domain.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        domain.segments.push_back({i, (i + 1) % 4, 1, SegmentRole::Boundary});
    }
    Document document = fromDomain(domain);
    document.spacing.size = 1.0;
    document.options.method = Method::Classic;
    return document;
}

/// Three questions about a square whose front begins with 16 segments.
Lesson lesson() {
    static const std::string kText = R"({"format": "forefront-lesson", "version": 1, "title": "T", "pages": [
        {"title": "A", "text": "t", "document": "square", "question": {"text": "q", "number": "front"}},
        {"title": "B", "text": "t", "question": {"text": "q", "choices": [{"text": "{front} yes", "right": true},
         {"text": "no"}]}},
        {"title": "C", "text": "t", "question": {"text": "q", "until": {"value": "elements", "is": 3}}}]})";
    LessonNames names;
    names.document = square;
    const auto read = readLesson(sourceOf(kText), names);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    return *read;
}

Result<AnswerScore> scoreOf(const LessonAnswers &given, const Progress &progress = {}) {
    const std::string text = answersText(given);
    const SourceText source = sourceOf(text);
    const Result<LessonAnswers> read = readAnswers(source);
    REQUIRE_MESSAGE(read.ok(), messages(read.faults()));
    LessonRuns runs;
    return checkAnswers(*read, source, lesson(), runs, progress);
}

LessonAnswers answers() {
    LessonAnswers given = noAnswers(lesson());
    given.pages[0].answers = {{"15", false}, {"16", true}};
    given.pages[1].answers = {{"16 yes", true}};
    given.pages[2].answers = {{"candidate 1", false}, {"advance 3", true}};
    return given;
}

} // namespace lesson_reply

TEST_CASE("Answers: a file is read as it was written, and answered again") {
    using namespace lesson_reply;
    CHECK_FALSE(hasAnswers(noAnswers(lesson())));
    CHECK(hasAnswers(answers()));
    const Result<AnswerScore> score = scoreOf(answers());
    REQUIRE_MESSAGE(score.ok(), messages(score.faults()));
    CHECK(score->questions == 3);
    CHECK(score->answered == 3);
    CHECK(score->firstTry == 1);
    REQUIRE(score->lines.size() == 3);
    CHECK(score->lines[0] == "A: right at try 2 (15; 16)");
    const Result<AnswerScore> none = scoreOf(noAnswers(lesson()));
    REQUIRE(none);
    CHECK(none->answered == 0);
    CHECK(none->lines[1] == "B: not answered");
}

TEST_CASE("Answers: a question that was shown is told from one that was answered") {
    using namespace lesson_reply;
    LessonAnswers given = answers();
    given.edition = "0123";
    given.pages[0].shown = true;
    given.pages[1].answers.clear();
    given.pages[1].shown = true;
    const std::string text = answersText(given);
    const Result<LessonAnswers> read = readAnswers(sourceOf(text));
    REQUIRE(read);
    CHECK(read->edition == "0123");
    CHECK(read->pages[0].shown);
    CHECK_FALSE(read->pages[2].shown);
    const AnswerCount count = countAnswers(*read);
    CHECK(count.answered == 2);
    CHECK(count.shown == 1);
    const Result<AnswerScore> score = scoreOf(given);
    REQUIRE(score);
    CHECK(score->answered == 2);
    CHECK(score->lines[0] == "A: right at try 2, after Show me (15; 16)");
    CHECK(score->lines[1] == "B: shown");
}

TEST_CASE("Answers: a file that claims what is not so is refused with its place") {
    using namespace lesson_reply;
    const auto codeOf = [](const LessonAnswers &given) {
        const Result<AnswerScore> score = scoreOf(given);
        return score ? std::string() : score.faults().front().code;
    };
    LessonAnswers given = answers();
    given.pages[0].answers[0].right = true;
    CHECK(codeOf(given) == "false-claim");
    const Result<AnswerScore> score = scoreOf(given);
    CHECK(score.faults().front().line > 1);
    given = answers();
    given.pages[1].answers[0].text = "17 yes";
    CHECK(codeOf(given) == "other-answer");
    given = answers();
    given.pages[2].answers[1].text = "advance 4";
    CHECK(codeOf(given) == "false-claim");
    given = answers();
    given.pages[2].answers[1].text = "advance 4000";
    CHECK(codeOf(given) == "other-answer");
    given = answers();
    given.lesson = "U";
    CHECK(codeOf(given) == "other-lesson");
    const std::string other = "{\"format\": \"forefront-lesson\"}";
    CHECK(readAnswers(sourceOf(other)).faults().front().code == "not-answers");
    const std::string broken = "{\"format\": \"forefront-answers\", \"version\": 1, \"lesson\": \"T\", \"pages\": [3]}";
    CHECK_FALSE(readAnswers(sourceOf(broken)).ok());
}

TEST_CASE("Answers: the check reports each answer, stops within a page, and has a limit") {
    using namespace lesson_reply;
    LessonAnswers given = answers();
    given.pages[0].answers.assign(1000, {"15", false});
    std::vector<double> fractions;
    Progress progress;
    progress.report = [&](std::string_view stage, double fraction) {
        if (stage == "checking answers") {
            fractions.push_back(fraction);
        }
    };
    const Result<AnswerScore> score = scoreOf(given, progress);
    REQUIRE_MESSAGE(score.ok(), messages(score.faults()));
    CHECK(fractions.size() == 1003);
    CHECK(std::is_sorted(fractions.begin(), fractions.end()));
    CHECK(fractions.front() == 0.0);
    CHECK(fractions.back() < 1.0);
    std::stop_source stop;
    progress.stop = stop.get_token();
    std::size_t reports = 0;
    progress.report = [&](std::string_view stage, double) {
        reports += stage == "checking answers" ? 1U : 0U;
        if (reports == 7) {
            stop.request_stop();
        }
    };
    CHECK(scoreOf(given, progress).faults().front().code == "cancelled");
    CHECK(reports == 7);
    given.pages[0].answers.push_back({"15", false});
    const Result<AnswerScore> large = scoreOf(given);
    REQUIRE_FALSE(large.ok());
    CHECK(large.faults().front().code == "too-large");
}

TEST_CASE("Answers: many answers to a task at a few moments of a run are checked once for each moment") {
    using namespace lesson_reply;
    LessonAnswers given = answers();
    given.pages[2].answers.assign(999, {"advance 9", false});
    given.pages[2].answers.push_back({"advance 3", true});
    const Result<AnswerScore> score = scoreOf(given);
    REQUIRE_MESSAGE(score.ok(), messages(score.faults()));
    CHECK(score->lines[2].starts_with("C: right at try 1000 ("));
}
