#include "core/teaching/lesson/answers.hpp"

#include "core/files/json/json_check.hpp"
#include "core/files/json/json_writer.hpp"
#include "core/teaching/lesson/random_numbers.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr const char *kFormat = "forefront-answers";
constexpr int kVersion = 1;

PageAnswers readPage(const JsonValue &object, JsonCheck &check) {
    PageAnswers page;
    if (!check.expect(object, JsonKind::Object, "a page of answers")) {
        return page;
    }
    const TextPlace place = check.place(object);
    page.place = {place.line, place.column};
    if (const auto title = check.member(object, "title", "the page")) {
        page.title = check.string(*title, "the title of a page");
    }
    if (const auto question = object.find("question"); question && !question->is(JsonKind::Null)) {
        page.question = check.string(*question, "a question");
    }
    if (const auto shown = object.find("shown")) {
        page.shown = check.flag(*shown, "\"shown\"");
    }
    const auto answers = check.member(object, "answers", "the page");
    if (!answers || !check.expect(*answers, JsonKind::Array, "\"answers\"")) {
        return page;
    }
    for (const JsonValue item : *answers) {
        if (!check.expect(item, JsonKind::Object, "an answer")) {
            continue;
        }
        GivenAnswer given;
        if (const auto text = check.member(item, "answer", "the answer")) {
            given.text = check.string(*text, "an answer");
        }
        if (const auto right = check.member(item, "right", "the answer")) {
            given.right = check.flag(*right, "\"right\"");
        }
        page.answers.push_back(std::move(given));
    }
    return page;
}

} // namespace

LessonAnswers noAnswers(const Lesson &lesson) {
    LessonAnswers answers{lesson.title, lesson.seed, {}, {}};
    for (const LessonPage &page : lesson.pages) {
        PageAnswers none;
        none.title = page.title;
        none.question = page.question ? page.question->text : std::string();
        answers.pages.push_back(std::move(none));
    }
    return answers;
}

bool hasAnswers(const LessonAnswers &answers) {
    return std::any_of(answers.pages.begin(), answers.pages.end(),
                       [](const PageAnswers &page) { return !page.answers.empty() || page.shown; });
}

bool hasRightAnswer(const PageAnswers &page) {
    return std::any_of(page.answers.begin(), page.answers.end(),
                       [](const GivenAnswer &answer) { return answer.right; });
}

AnswerCount countAnswers(const LessonAnswers &answers) {
    AnswerCount count;
    for (const PageAnswers &page : answers.pages) {
        const bool right = hasRightAnswer(page);
        count.answered += right ? 1U : 0U;
        count.shown += !right && page.shown ? 1U : 0U;
    }
    return count;
}

bool mergeAnswers(LessonAnswers &given, const LessonAnswers &kept, const LessonAnswers &others) {
    if (given.seed != others.seed || given.edition != others.edition || given.pages.size() != others.pages.size()) {
        return false;
    }
    for (std::size_t k = 0; k < given.pages.size(); ++k) {
        PageAnswers &page = given.pages[k];
        const PageAnswers &other = others.pages[k];
        const std::size_t known =
            k < kept.pages.size() ? std::min(kept.pages[k].answers.size(), page.answers.size()) : 0;
        std::vector<GivenAnswer> all = other.answers;
        all.insert(all.end(), page.answers.begin() + static_cast<std::ptrdiff_t>(known), page.answers.end());
        page.answers = std::move(all);
        page.shown = page.shown || other.shown;
        page.question = page.question.empty() ? other.question : page.question;
    }
    return true;
}

std::string answersText(const LessonAnswers &answers) {
    JsonWriter json(JsonWriter::Layout::Indented);
    json.beginObject().member("format", kFormat).member("version", kVersion).member("lesson", answers.lesson);
    json.member("seed", answers.seed);
    if (!answers.edition.empty()) {
        json.member("edition", answers.edition);
    }
    json.key("pages").beginArray();
    for (const PageAnswers &page : answers.pages) {
        json.beginObject().member("title", page.title).member("question", page.question);
        if (page.shown) {
            json.member("shown", true);
        }
        json.key("answers").beginArray();
        for (const GivenAnswer &given : page.answers) {
            json.beginObject().member("answer", given.text).member("right", given.right).endObject();
        }
        json.endArray().endObject();
    }
    json.endArray().endObject();
    return json.text();
}

Result<LessonAnswers> readAnswers(const SourceText &source) {
    const auto json = JsonDocument::parse(source);
    if (!json) {
        return json.faults();
    }
    JsonCheck check(source);
    const JsonValue root = json->root();
    const auto format = root.find("format");
    if (!format || format->string() != kFormat) {
        check.fault(format.value_or(root), "not-answers", "not a file of answers",
                    "expected one that a lesson was saved to with Save answers");
        return check.faults();
    }
    LessonAnswers answers;
    if (const auto version = check.member(root, "version", "the file")) {
        check.integer(*version, 1, kVersion, "\"version\"");
    }
    if (const auto lesson = check.member(root, "lesson", "the file")) {
        answers.lesson = check.string(*lesson, "\"lesson\"");
    }
    if (const auto seed = root.find("seed")) {
        answers.seed = static_cast<std::uint64_t>(check.integer(*seed, 0, kMaxLessonSeed, "\"seed\""));
    }
    if (const auto edition = root.find("edition")) {
        answers.edition = check.string(*edition, "\"edition\"");
    }
    if (const auto pages = check.member(root, "pages", "the file");
        pages && check.expect(*pages, JsonKind::Array, "\"pages\"")) {
        for (const JsonValue page : *pages) {
            answers.pages.push_back(readPage(page, check));
        }
    }
    if (!check.faults().empty()) {
        return check.faults();
    }
    return answers;
}

} // namespace forefront
