#include "core/teaching/lesson/question_read.hpp"

#include "core/files/common/names.hpp"

#include <algorithm>
#include <array>

namespace forefront {

namespace {

constexpr std::int64_t kMaxAdvances = 1'000'000'000;
constexpr std::int64_t kMaxEvents = 1'000'000;

LessonValue valueWord(const JsonValue &value, JsonCheck &check, std::string_view what) {
    return static_cast<LessonValue>(check.choice(value, wordsOf<LessonValue>(), what));
}

double tolerance(const JsonValue &object, JsonCheck &check) {
    const auto within = object.find("within");
    return within ? check.notNegative(*within, "\"within\"") : LessonCondition().within;
}

/// Reads {"value": WORD, "is": NUMBER or WORD}, or "above" or "below" in place of "is".
LessonCondition readCondition(const JsonValue &object, JsonCheck &check) {
    constexpr std::array<std::string_view, 5> kMembers = {"value", "is", "above", "below", "within"};
    LessonCondition condition;
    if (!check.expect(object, JsonKind::Object, "a condition")) {
        return condition;
    }
    expectMembers(check, object, kMembers, "a condition");
    if (const auto value = check.member(object, "value", "the condition")) {
        condition.value = valueWord(*value, check, "the value of a condition");
    }
    int relations = 0;
    for (const LessonRelation relation : valuesOf<LessonRelation>()) {
        const auto bound = object.find(wordOf(relation));
        if (!bound) {
            continue;
        }
        ++relations;
        condition.relation = relation;
        if (bound->is(JsonKind::String)) {
            condition.other = valueWord(*bound, check, "the bound of a condition");
        } else {
            condition.number = check.number(*bound, "the bound of a condition");
        }
    }
    if (relations != 1) {
        check.fault(object, "bad-condition",
                    "expected one of \"is\", \"above\" and \"below\" in a condition, found " +
                        std::to_string(relations));
    }
    condition.within = tolerance(object, check);
    return condition;
}

/// Reads a condition or a list of them.
std::vector<LessonCondition> readConditions(const JsonValue &value, JsonCheck &check) {
    std::vector<LessonCondition> conditions;
    if (!value.is(JsonKind::Array)) {
        conditions.push_back(readCondition(value, check));
        return conditions;
    }
    for (const JsonValue item : value) {
        conditions.push_back(readCondition(item, check));
    }
    if (conditions.empty()) {
        check.fault(value, "bad-condition", "expected at least one condition");
    }
    return conditions;
}

LessonChoices readChoices(const JsonValue &list, JsonCheck &check) {
    constexpr std::array<std::string_view, 2> kMembers = {"text", "right"};
    LessonChoices choices;
    if (!check.expect(list, JsonKind::Array, "\"choices\"")) {
        return choices;
    }
    bool anyRight = false;
    for (const JsonValue item : list) {
        LessonChoices::Choice choice;
        if (!check.expect(item, JsonKind::Object, "a choice")) {
            continue;
        }
        expectMembers(check, item, kMembers, "a choice");
        if (const auto text = check.member(item, "text", "the choice")) {
            choice.text = shownText(check, *text, "the text of a choice", true);
        }
        if (const auto right = item.find("right")) {
            if (right->is(JsonKind::True) || right->is(JsonKind::False)) {
                choice.right = right->is(JsonKind::True);
            } else {
                choice.when = readConditions(*right, check);
            }
        }
        anyRight = anyRight || choice.right || !choice.when.empty();
        choices.list.push_back(std::move(choice));
    }
    if (choices.list.size() < 2 || choices.list.size() > 9) {
        check.fault(list, "bad-count", "expected 2 to 9 choices, found " + std::to_string(choices.list.size()));
    } else if (!anyRight) {
        check.fault(list, "no-answer", "no choice can be right", "add \"right\": true or a condition to one of them");
    }
    return choices;
}

void checkBraces(JsonCheck &check, const JsonValue &value, std::string_view text) {
    for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
        const std::size_t close = std::min(text.find('}', open), text.size());
        const std::string_view word = text.substr(open + 1, close - open - 1);
        if (close == text.size() || !fromWord<LessonValue>(word)) {
            check.fault(value, "unknown-value", "unknown value " + inQuotes(word) + " in braces",
                        "expected one of: " + wordList<LessonValue>());
        }
    }
}

} // namespace

void expectMembers(JsonCheck &check, const JsonValue &object, std::span<const std::string_view> members,
                   std::string_view what) {
    for (auto member = object.begin(); member != object.end(); ++member) {
        const std::string key = member.key();
        if (std::find(members.begin(), members.end(), key) == members.end()) {
            std::string list;
            for (const std::string_view name : members) {
                list += (list.empty() ? "" : ", ") + std::string(name);
            }
            check.fault(member.keyValue(), "unknown-member",
                        "unknown member " + inQuotes(key) + " of " + std::string(what), "expected one of: " + list);
        }
    }
}

std::string shownText(JsonCheck &check, const JsonValue &value, std::string_view what, bool values) {
    std::string text = check.string(value, what);
    if (value.is(JsonKind::String) && text.find_first_not_of(" \t\n") == std::string::npos) {
        check.fault(value, "empty-text", "expected a text for " + std::string(what) + ", got an empty one");
    }
    if (values) {
        checkBraces(check, value, text);
    }
    return text;
}

LessonPosition readPosition(const JsonValue &value, JsonCheck &check) {
    constexpr std::array<std::string_view, 2> kMembers = {"advance", "events"};
    LessonPosition position;
    const TextPlace place = check.place(value);
    position.place = {place.line, place.column};
    const auto advance = [&](const JsonValue &number) {
        return static_cast<std::uint64_t>(check.integer(number, 0, kMaxAdvances, "the position"));
    };
    if (value.is(JsonKind::String)) {
        const std::string word = value.string();
        const bool number = !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
        position.atEnd = true;
        if (word != "end") {
            check.fault(value, "bad-field",
                        "expected a number of advances, \"end\" or an object for the position, got the string \"" +
                            validUtf8(word) + '"',
                        number ? "write " + word + " without quotes" : "");
        }
    } else if (value.is(JsonKind::Object)) {
        expectMembers(check, value, kMembers, "a position");
        if (const auto number = check.member(value, "advance", "the position")) {
            position.advance = advance(*number);
        }
        if (const auto events = value.find("events")) {
            position.events = check.integer(*events, 0, kMaxEvents, "the number of events");
        }
    } else {
        position.advance = advance(value);
    }
    return position;
}

LessonQuestion readQuestion(const JsonValue &object, JsonCheck &check) {
    constexpr std::array<std::string_view, 8> kMembers = {"text",  "choices", "number", "within",
                                                          "until", "show",    "hint",   "why"};
    expectMembers(check, object, kMembers, "a question");
    LessonQuestion question;
    const TextPlace place = check.place(object);
    question.place = {place.line, place.column};
    if (const auto text = check.member(object, "text", "the question")) {
        question.text = shownText(check, *text, "the text of a question", true);
    }
    const auto choices = object.find("choices"), number = object.find("number"), until = object.find("until");
    const int kinds = (choices ? 1 : 0) + (number ? 1 : 0) + (until ? 1 : 0);
    if (kinds != 1) {
        check.fault(object, "bad-question",
                    "expected one of \"choices\", \"number\" and \"until\" in a question, found " +
                        std::to_string(kinds));
    }
    if (const auto within = object.find("within"); within && !number) {
        check.fault(*within, "bad-question", "\"within\" has no effect in a question without \"number\"",
                    "move it into the condition, or leave it out");
    }
    if (choices) {
        question.answer = readChoices(*choices, check);
    } else if (number) {
        question.answer = LessonNumber{valueWord(*number, check, "\"number\""), tolerance(object, check)};
    } else if (until) {
        question.answer = LessonTask{readConditions(*until, check)};
    }
    if (const auto show = object.find("show")) {
        question.show = readPosition(*show, check);
    }
    if (const auto hint = object.find("hint")) {
        question.hint = shownText(check, *hint, "\"hint\"", true);
    }
    if (const auto why = object.find("why")) {
        question.why = shownText(check, *why, "\"why\"", true);
    }
    return question;
}

} // namespace forefront
