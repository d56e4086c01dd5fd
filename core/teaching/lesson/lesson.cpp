#include "core/teaching/lesson/lesson.hpp"

#include "core/files/source/source.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace forefront {

namespace {

constexpr double kExact = 1e-9; ///< differences that computing a number may cause

bool allHold(const std::vector<LessonCondition> &conditions, const LessonState &state) {
    return std::all_of(conditions.begin(), conditions.end(),
                       [&](const LessonCondition &condition) { return holds(condition, state); });
}

} // namespace

std::size_t questionsOf(const Lesson &lesson) {
    return static_cast<std::size_t>(std::count_if(lesson.pages.begin(), lesson.pages.end(),
                                                  [](const LessonPage &page) { return page.question.has_value(); }));
}

std::shared_ptr<const Document> documentOf(const LessonPage &page) {
    if (!page.document || (!page.method && !page.grid && !page.improve && !page.rules)) {
        return page.document;
    }
    auto document = std::make_shared<Document>(*page.document);
    document->options.method = page.method.value_or(document->options.method);
    document->options.grid = page.grid.value_or(document->options.grid);
    document->options.improve = page.improve.value_or(document->options.improve);
    document->options.rules = page.rules.value_or(document->options.rules);
    return document;
}

bool isRight(const LessonChoices &choices, std::size_t index, const LessonState &state) {
    const LessonChoices::Choice &choice = choices.list[index];
    return choice.when.empty() ? choice.right : allHold(choice.when, state);
}

bool isRight(const LessonNumber &question, double number, const LessonState &state) {
    const std::optional<double> value = valueOf(question.value, state);
    return value && std::abs(*value - number) <= toleranceOf(question, state);
}

double toleranceOf(const LessonNumber &question, const LessonState &state) {
    const double value = valueOf(question.value, state).value_or(0.0);
    return std::max(question.within.value_or(question.percent > 0.0 ? kExact : roundingOf(value)),
                    0.01 * question.percent * std::abs(value));
}

double roundingOf(double number) {
    constexpr double kSlack = 1.0 + 1e-9; // a half may be rounded either way
    if (std::abs(number - std::round(number)) <= kExact) {
        return kExact;
    }
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(number))) - 2.0);
    return 0.5 * kSlack * digit;
}

std::vector<KnownMistake> mistakesOf(const LessonNumber &question, const LessonState &state) {
    std::vector<KnownMistake> known;
    for (const LessonNumber::Mistake &mistake : question.mistakes) {
        const std::optional<double> value = valueOf(mistake.value, state);
        if (value) {
            const double rounding = std::max(question.within.value_or(0.0), roundingOf(*value));
            known.push_back({*value, std::max(rounding, 0.01 * question.percent * std::abs(*value)), &mistake.hint});
        }
    }
    return known;
}

std::optional<double> answeredNumber(std::string text) {
    if (text.find('.') == std::string::npos) {
        std::replace(text.begin(), text.end(), ',', '.');
    }
    const std::size_t from = text.find_first_not_of(" \t+"), to = text.find_last_not_of(" \t");
    if (from == std::string::npos) {
        return std::nullopt;
    }
    double number = 0.0;
    const char *const end = text.data() + to + 1;
    const auto [rest, fault] = std::from_chars(text.data() + from, end, number);
    return fault == std::errc() && rest == end && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

const std::string &hintAfter(const LessonQuestion &question, std::size_t choice) {
    const auto *const choices = std::get_if<LessonChoices>(&question.answer);
    const bool own = choices != nullptr && choice < choices->list.size() && !choices->list[choice].hint.empty();
    return own ? choices->list[choice].hint : question.hint;
}

const std::string &hintAfter(const LessonQuestion &question, double number, const LessonState &state) {
    const auto *const asked = std::get_if<LessonNumber>(&question.answer);
    if (asked == nullptr) {
        return question.hint;
    }
    const std::vector<KnownMistake> mistakes = mistakesOf(*asked, state);
    const auto made = std::find_if(mistakes.begin(), mistakes.end(), [number](const KnownMistake &mistake) {
        return std::abs(mistake.number - number) <= mistake.within;
    });
    return made != mistakes.end() ? *made->hint : question.hint;
}

bool isDone(const LessonTask &task, const LessonState &state) {
    return allHold(task.until, state);
}

bool asksAboutRun(const LessonQuestion &question) {
    const auto *const choices = std::get_if<LessonChoices>(&question.answer);
    return choices == nullptr ||
           std::any_of(choices->list.begin(), choices->list.end(), [](const LessonChoices::Choice &choice) {
               return !choice.when.empty() || choice.text.find('{') != std::string::npos;
           });
}

bool asksForCandidate(const LessonTask &task) {
    return std::any_of(task.until.begin(), task.until.end(), [](const LessonCondition &condition) {
        return condition.value == LessonValue::Chosen || condition.other == LessonValue::Chosen;
    });
}

bool asksForMesh(const LessonTask &task) {
    return std::any_of(task.until.begin(), task.until.end(), [](const LessonCondition &condition) {
        return needsMesh(condition.value) || (condition.other && needsMesh(*condition.other));
    });
}

std::optional<std::size_t> pageOfTarget(const Lesson &lesson, std::string_view target) {
    const auto titled = std::find_if(lesson.pages.begin(), lesson.pages.end(),
                                     [&](const LessonPage &page) { return page.title == target; });
    if (titled != lesson.pages.end()) {
        return static_cast<std::size_t>(titled - lesson.pages.begin());
    }
    std::size_t number = 0;
    const auto [end, problem] = std::from_chars(target.data(), target.data() + target.size(), number);
    const bool whole = problem == std::errc{} && end == target.data() + target.size();
    return whole && number >= 1 && number <= lesson.pages.size() ? std::optional(number - 1) : std::nullopt;
}

Diagnostics pictureFaults(const Lesson &lesson, const std::string &file, bool decode) {
    Diagnostics faults;
    for (const auto &[name, picture] : lesson.pictures) {
        for (Diagnostic fault : picture->faults.empty() && decode ? damageOf(*picture) : picture->faults) {
            fault.message = "page " + std::to_string(picture->page) + ": cannot show the image " + inQuotes(name) +
                            ": " + fault.message;
            fault.file = file;
            fault.line = picture->line;
            fault.column = picture->column;
            faults.push_back(std::move(fault));
        }
    }
    return faults;
}

} // namespace forefront
