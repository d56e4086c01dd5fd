#include "core/teaching/lesson/question_read.hpp"

#include "core/files/common/names.hpp"
#include "core/teaching/markup/text_values.hpp"

#include <algorithm>
#include <array>

namespace forefront {

namespace {

constexpr std::int64_t kMaxAdvances = 1'000'000'000;
constexpr std::int64_t kMaxEvents = 1'000'000;

/// Reads the word of a value; `numbers` may be expected there, too, and are named in the fault.
LessonValue valueWord(const JsonValue &value, JsonCheck &check, std::string_view what,
                      const RandomNumbers &numbers = {}) {
    const auto words = wordsOf<LessonValue>();
    std::vector<std::string_view> expected(words.begin(), words.end());
    for (const auto &[name, number] : numbers) {
        expected.push_back(name);
    }
    return static_cast<LessonValue>(check.choice(value, expected, what));
}

/// Reads a number, or a formula of values, random numbers and numbers.
LessonFormula formula(const JsonValue &value, JsonCheck &check, const RandomNumbers &numbers, std::string_view what) {
    if (!value.is(JsonKind::String)) {
        return formulaOf(check.number(value, what));
    }
    Result<LessonFormula> read = readFormula(value.string(), numbers);
    if (!read) {
        const Diagnostic &fault = read.faults().front();
        check.fault(value, fault.code.c_str(), fault.message, fault.advice);
        return formulaOf(0.0);
    }
    return *std::move(read);
}

double tolerance(const JsonValue &object, JsonCheck &check) {
    const auto within = object.find("within");
    return within ? check.notNegative(*within, "\"within\"") : LessonCondition().within;
}

/// Reads the tolerance of a number: a difference, or per cent of the value as a text such as "2 %".
void readTolerance(const JsonValue &object, JsonCheck &check, LessonNumber &number) {
    const auto within = object.find("within");
    if (!within) {
        return;
    }
    if (!within->is(JsonKind::String)) {
        number.within = tolerance(object, check);
        return;
    }
    std::string text = within->string();
    const std::size_t sign = text.find('%');
    const auto percent = sign + 1 == text.size() ? answeredNumber(text.substr(0, sign)) : std::nullopt;
    if (percent && *percent >= 0.0) {
        number.percent = *percent;
        return;
    }
    check.fault(*within, "bad-field",
                "expected a number or a text such as \"2 %\" for \"within\", got \"" + validUtf8(text) + '"');
}

/// Reads a number, the name of a random number, or the word of a value.
void readBound(const JsonValue &bound, JsonCheck &check, const RandomNumbers &numbers, double &number,
               std::optional<LessonValue> &value, std::string_view what) {
    if (!bound.is(JsonKind::String)) {
        number = check.number(bound, what);
    } else if (const auto random = numbers.find(bound.string()); random != numbers.end()) {
        number = static_cast<double>(random->second.value);
    } else {
        value = valueWord(bound, check, what, numbers);
    }
}

/// Reads {"value": WORD, "is": NUMBER or WORD}, or "above" or "below" in place of "is".
LessonCondition readCondition(const JsonValue &object, JsonCheck &check, const RandomNumbers &numbers) {
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
        readBound(*bound, check, numbers, condition.number, condition.other, "the bound of a condition");
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
std::vector<LessonCondition> readConditions(const JsonValue &value, JsonCheck &check, const RandomNumbers &numbers) {
    std::vector<LessonCondition> conditions;
    if (!value.is(JsonKind::Array)) {
        conditions.push_back(readCondition(value, check, numbers));
        return conditions;
    }
    for (const JsonValue item : value) {
        conditions.push_back(readCondition(item, check, numbers));
    }
    if (conditions.empty()) {
        check.fault(value, "bad-condition", "expected at least one condition");
    }
    return conditions;
}

LessonChoices::Choice readChoice(const JsonValue &item, JsonCheck &check, const RandomNumbers &numbers) {
    constexpr std::array<std::string_view, 3> kMembers = {"text", "right", "hint"};
    LessonChoices::Choice choice;
    expectMembers(check, item, kMembers, "a choice");
    if (const auto text = check.member(item, "text", "the choice")) {
        choice.text = shownText(check, *text, "the text of a choice", &numbers);
    }
    if (const auto right = item.find("right")) {
        if (right->is(JsonKind::True) || right->is(JsonKind::False)) {
            choice.right = right->is(JsonKind::True);
        } else {
            choice.when = readConditions(*right, check, numbers);
        }
    }
    if (const auto hint = item.find("hint")) {
        choice.hint = shownText(check, *hint, "the hint of a choice", &numbers);
        if (choice.right && choice.when.empty()) {
            check.fault(*hint, "bad-question", "a hint has no effect on a choice that is right",
                        "move it to a wrong choice, or into \"why\"");
        }
    }
    return choice;
}

/// Reads [{"is": NUMBER or WORD, "hint": TEXT}, ...].
std::vector<LessonNumber::Mistake> readMistakes(const JsonValue &list, JsonCheck &check, const RandomNumbers &numbers) {
    constexpr std::array<std::string_view, 2> kMembers = {"is", "hint"};
    std::vector<LessonNumber::Mistake> mistakes;
    if (!check.expect(list, JsonKind::Array, "\"mistakes\"")) {
        return mistakes;
    }
    for (const JsonValue item : list) {
        if (!check.expect(item, JsonKind::Object, "a mistake")) {
            continue;
        }
        expectMembers(check, item, kMembers, "a mistake");
        LessonNumber::Mistake mistake;
        if (const auto bound = check.member(item, "is", "the mistake")) {
            mistake.value = formula(*bound, check, numbers, "the number of a mistake");
        }
        if (const auto hint = check.member(item, "hint", "the mistake")) {
            mistake.hint = shownText(check, *hint, "the hint of a mistake", &numbers);
        }
        mistakes.push_back(std::move(mistake));
    }
    return mistakes;
}

LessonChoices readChoices(const JsonValue &list, JsonCheck &check, const RandomNumbers &numbers) {
    LessonChoices choices;
    if (!check.expect(list, JsonKind::Array, "\"choices\"")) {
        return choices;
    }
    bool anyRight = false;
    for (const JsonValue item : list) {
        if (!check.expect(item, JsonKind::Object, "a choice")) {
            continue;
        }
        LessonChoices::Choice choice = readChoice(item, check, numbers);
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

void checkBraces(JsonCheck &check, const JsonValue &value, std::string_view text, const RandomNumbers &numbers) {
    for (const NamedValue &named : valuesNamed(text)) {
        if (!named.closed || !fromWord<LessonValue>(named.word)) {
            std::string names = wordList<LessonValue>();
            for (const auto &[name, number] : numbers) {
                names += ", " + name;
            }
            check.fault(value, "unknown-value", "unknown value " + inQuotes(named.word) + " in braces",
                        "expected one of: " + names);
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

std::string shownText(JsonCheck &check, const JsonValue &value, std::string_view what, const RandomNumbers *numbers) {
    std::string text = check.string(value, what);
    if (value.is(JsonKind::String) && text.find_first_not_of(" \t\n") == std::string::npos) {
        check.fault(value, "empty-text", "expected a text for " + std::string(what) + ", got an empty one");
    }
    if (numbers != nullptr) {
        text = withNumbers(text, *numbers);
        checkBraces(check, value, text, *numbers);
    }
    return text;
}

std::vector<RandomRange> readNumbers(const JsonValue &object, JsonCheck &check, std::uint64_t seed, std::size_t page,
                                     RandomNumbers &numbers) {
    constexpr std::int64_t kMax = 1'000'000'000;
    std::vector<RandomRange> ranges;
    if (!check.expect(object, JsonKind::Object, "\"random\"")) {
        return ranges;
    }
    for (auto member = object.begin(); member != object.end(); ++member) {
        const std::string name = member.key();
        if (name.empty() || name == "end" || fromWord<LessonValue>(name) ||
            name.find_first_of("{} ") != std::string::npos) {
            check.fault(member.keyValue(), "bad-name", "a random number cannot be called " + inQuotes(name),
                        "choose a word that is no value, such as n");
        }
        std::vector<std::int64_t> ends;
        if (check.expect(*member, JsonKind::Array, "a random number")) {
            for (const JsonValue end : *member) {
                ends.push_back(check.integer(end, -kMax, kMax, "the range of a random number"));
            }
        }
        if (ends.size() != 2 || ends[0] >= ends[1]) {
            check.fault(*member, "bad-range", "expected the smallest and the largest number, such as [3, 20]");
            ends = {0, 1};
        }
        ranges.push_back({page, name, ends[0], ends[1]});
        numbers[name] = {randomNumber(seed, ranges.back()), ends[0]};
    }
    return ranges;
}

LessonPosition readPosition(const JsonValue &value, JsonCheck &check, const RandomNumbers &numbers) {
    constexpr std::array<std::string_view, 2> kMembers = {"advance", "events"};
    LessonPosition position;
    const TextPlace place = check.place(value);
    position.place = {place.line, place.column};
    const auto isRandom = [&](const JsonValue &name) {
        const auto random = name.is(JsonKind::String) ? numbers.find(name.string()) : numbers.end();
        if (random == numbers.end()) {
            return false;
        }
        if (random->second.from < 0) {
            check.fault(name, "bad-field",
                        "the random number " + inQuotes(random->first) + " can be negative, down to " +
                            std::to_string(random->second.from) + ", but a position cannot",
                        "let its range begin at 0 or above");
        }
        position.advance = static_cast<std::uint64_t>(std::max<std::int64_t>(random->second.value, 0));
        position.random = true;
        return true;
    };
    const auto advance = [&](const JsonValue &number) {
        return static_cast<std::uint64_t>(check.integer(number, 0, kMaxAdvances, "the position"));
    };
    if (isRandom(value)) {
        return position;
    }
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
            position.advance = isRandom(*number) ? position.advance : advance(*number);
        }
        if (const auto events = value.find("events")) {
            position.events = check.integer(*events, 0, kMaxEvents, "the number of events");
        }
    } else {
        position.advance = advance(value);
    }
    return position;
}

LessonQuestion readQuestion(const JsonValue &object, JsonCheck &check, const RandomNumbers &numbers) {
    constexpr std::array<std::string_view, 9> kMembers = {"text",  "choices", "number", "within", "mistakes",
                                                          "until", "show",    "hint",   "why"};
    expectMembers(check, object, kMembers, "a question");
    LessonQuestion question;
    const TextPlace place = check.place(object);
    question.place = {place.line, place.column};
    if (const auto text = check.member(object, "text", "the question")) {
        question.text = shownText(check, *text, "the text of a question", &numbers);
    }
    const auto choices = object.find("choices"), number = object.find("number"), until = object.find("until");
    const int kinds = (choices ? 1 : 0) + (number ? 1 : 0) + (until ? 1 : 0);
    if (kinds != 1) {
        check.fault(object, "bad-question",
                    "expected one of \"choices\", \"number\" and \"until\" in a question, found " +
                        std::to_string(kinds));
    }
    for (const char *const member : {"within", "mistakes"}) {
        if (const auto given = object.find(member); given && !number) {
            check.fault(*given, "bad-question",
                        '"' + std::string(member) + "\" has no effect in a question without \"number\"",
                        "move it into the condition, or leave it out");
        }
    }
    if (choices) {
        question.answer = readChoices(*choices, check, numbers);
    } else if (number) {
        LessonNumber asked{.value = formula(*number, check, numbers, "\"number\"")};
        readTolerance(object, check, asked);
        if (const auto mistakes = object.find("mistakes")) {
            asked.mistakes = readMistakes(*mistakes, check, numbers);
        }
        question.answer = std::move(asked);
    } else if (until) {
        question.answer = LessonTask{readConditions(*until, check, numbers)};
    }
    if (const auto show = object.find("show")) {
        question.show = readPosition(*show, check, numbers);
    }
    if (const auto hint = object.find("hint")) {
        question.hint = shownText(check, *hint, "\"hint\"", &numbers);
    }
    if (const auto why = object.find("why")) {
        question.why = shownText(check, *why, "\"why\"", &numbers);
    }
    return question;
}

} // namespace forefront
