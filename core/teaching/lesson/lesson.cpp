#include "core/teaching/lesson/lesson.hpp"

#include <algorithm>

namespace forefront {

namespace {

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
    return holds({question.value, LessonRelation::Is, number, {}, question.within}, state);
}

bool isDone(const LessonTask &task, const LessonState &state) {
    return allHold(task.until, state);
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

} // namespace forefront
