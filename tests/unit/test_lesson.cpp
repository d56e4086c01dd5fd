#include "core/teaching/lesson/lesson_read.hpp"
#include "core/teaching/lesson/random_numbers.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A lesson of one page with further members.
std::string page(const std::string &members) {
    return "{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"T\", \"pages\": [\n"
           "{\"title\": \"P\", \"text\": \"t\"" +
           members + "}]}";
}
std::string question(const std::string &members) {
    return page(",\n\"question\": {\"text\": \"q\", " + members + "}");
}

Diagnostics faultsOf(const std::string &text, const LessonNames &names = {}) {
    const auto lesson = readLesson(sourceOf(text), names);
    return lesson ? Diagnostics{} : lesson.faults();
}

/// A run at advance 7 with three candidates, of which the second won.
struct LessonRun {
    SessionSnapshot snapshot;

    LessonRun() {
        auto advance = std::make_shared<AdvanceExplanation>();
        advance->a = {0, 0};
        advance->b = {3, 4};
        advance->rho = 2.5;
        advance->candidates.resize(3);
        advance->candidates[0].verdict = Verdict::CrossesFront;
        advance->candidates[1].verdict = Verdict::Accepted;
        advance->candidates[1].alpha = 0.75;
        advance->candidates[2].verdict = Verdict::Withdrawn;
        snapshot.state = RunState::Paused;
        snapshot.advance = 7;
        snapshot.frontSegments = 34;
        snapshot.work = {.elements = 4, .frontSum = 70, .delivered = 10};
        snapshot.explanation = std::move(advance);
    }
    LessonState state(std::optional<std::size_t> chosen = {}) const { return {snapshot, chosen}; }
};

} // namespace

TEST_CASE("Lesson: a page continues the scene of the one before, except for questions and highlights") {
    const std::string text = R"({"format": "forefront-lesson", "version": 1, "title": "T", "about": "A", "pages": [
        {"title": "one", "text": ["Γ has {front}.", "b"], "document": "a.json", "method": "classic", "grid": "none",
         "position": {"advance": 4, "events": 2}, "layers": ["mesh"], "panel": "steps", "highlight": ["x/y"],
         "camera": {"centre": [1, 2], "size": 4}, "range": [0.5, 1],
         "question": {"text": "q", "number": "front", "within": 0.5, "hint": "h", "why": "w {front}"}},
        {"title": "two", "text": "c", "position": "end", "camera": "follow"},
        {"title": "three", "text": "d", "document": "b.json"}]})";
    int read = 0;
    LessonNames names{.layers = {"mesh", "front"}, .panels = {"steps"}, .widgets = {}, .document = {}};
    names.document = [&](const std::string &name) -> Result<Document> {
        ++read;
        Document document;
        document.options.grid = name == "a.json" ? GridKind::Uniform : GridKind::Hierarchical;
        return document;
    };
    const auto lesson = readLesson(sourceOf(text), names);
    REQUIRE_MESSAGE(lesson.ok(), messages(lesson.faults()));
    CHECK(read == 2);
    REQUIRE(lesson->pages.size() == 3);
    const LessonPage &one = lesson->pages[0], &two = lesson->pages[1], &three = lesson->pages[2];
    CHECK(one.paragraphs.size() == 2);
    CHECK(one.position == LessonPosition{false, 4, 2});
    CHECK(one.camera.box->max.x == 3.0);
    REQUIRE(two.range);
    CHECK(two.range->from == 0.5);
    CHECK(two.range->to == 1.0);
    REQUIRE(one.question);
    CHECK(std::get<LessonNumber>(one.question->answer).within == 0.5);
    CHECK(documentOf(one)->options.grid == GridKind::None);
    CHECK(two.document == one.document);
    CHECK(two.layers == one.layers);
    CHECK(two.method == Method::Classic);
    CHECK(two.position.atEnd);
    CHECK(two.camera.follow);
    CHECK(two.highlights.empty());
    CHECK_FALSE(two.question);
    CHECK_FALSE(three.method); // of another document
    CHECK(documentOf(three)->options.grid == GridKind::Hierarchical);
    CHECK_FALSE(three.position.atEnd);
}

TEST_CASE("Lesson: faults are reported with line, column and what was expected") {
    const struct {
        std::string text;
        const char *code;
        int line;
        const char *part; ///< of message or advice
    } cases[] = {
        {"{\"format\": \"forefront\"}", "not-a-lesson", 1, "not a Forefront lesson"},
        {"{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"T\"}", "missing-field", 1, "pages"},
        {"{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"T\", \"pages\": []}", "no-pages", 1,
         "no pages"},
        {"{\"format\": \"forefront-lesson\", \"version\": 9, \"title\": \"T\", \"pages\": []}", "bad-number", 1,
         "version"},
        {page(", \"txet\": 1"), "unknown-member", 2, "'txet'"},
        {page(",\n\"method\": \"slow\""), "bad-field", 3, "\"classic\""},
        {page(",\n\"position\": \"middle\""), "bad-field", 3, "\"end\""},
        {page(",\n\"position\": \"30\""), "bad-field", 3, "got the string \"30\" write 30 without quotes"},
        {page(",\n\"highlight\": [\"menu/Lern\",\n\"steps/11\"]"), "unknown-name", 4, "steps/10"},
        {page(",\n\"position\": -1"), "bad-number", 3, "position"},
        {page(",\n\"position\": {\"events\": 3}"), "missing-field", 3, "advance"},
        {page(",\n\"layers\": [\"mesh\",\n\"sky\"]"), "unknown-name", 4, "'sky'"},
        {page(",\n\"panel\": \"stairs\""), "unknown-name", 3, "steps"},
        {page(",\n\"camera\": {\"centre\": [0, 0], \"size\": 0}"), "bad-number", 3, "greater than 0"},
        {page(",\n\"range\": [1, 0.5]"), "bad-range", 3, "increasing"},
        {page(",\n\"document\": \"none.json\""), "bad-document", 3, "'none.json'"},
        {page(",\n\"document\": \"\""), "empty-text", 3, "document"},
        {page(",\n\"document\": \"/etc/a.json\""), "bad-document", 3, "outside the lesson's folder"},
        {page(",\n\"document\": \"drawings/../../a.json\""), "bad-document", 3, "outside the lesson's folder"},
        {page(",\n\"position\": 3"), "no-document", 3, "\"document\""},
        {page(",\n\"grid\": \"none\""), "no-document", 3, "'grid'"},
        {question("\"choices\": [{\"text\": \"a\", \"right\": true}, {\"text\": \"b\"}], \"within\": 1"),
         "bad-question", 3, "\"within\""},
        {page(",\n\"question\": {\"text\": \"{fron}\", \"number\": \"front\"}"), "unknown-value", 3, "'fron'"},
        {page(",\n\"question\": {\"text\": \"{front\", \"number\": \"front\"}"), "unknown-value", 3, "'front'"},
        {question("\"number\": \"fronts\""), "bad-field", 3, "front, elements"},
        {question("\"hint\": \"h\""), "bad-question", 3, "found 0"},
        {question("\"number\": \"front\", \"until\": {\"value\": \"front\", \"is\": 1}"), "bad-question", 3, "found 2"},
        {question("\"until\": []"), "bad-condition", 3, "at least one"},
        {question("\"until\": {\"value\": \"front\"}"), "bad-condition", 3, "found 0"},
        {question("\"until\": {\"value\": \"front\", \"is\": 1, \"above\": 0}"), "bad-condition", 3, "found 2"},
        {question("\"choices\": [{\"text\": \"a\", \"right\": true}]"), "bad-count", 3, "found 1"},
        {question("\"choices\": [{\"text\": \"a\"}, {\"text\": \"b\", \"right\": false}]"), "no-answer", 3,
         "can be right"},
        {question("\"choices\": [{\"text\": \" \"}, {\"text\": \"b\", \"right\": true}]"), "empty-text", 3, "empty"},
    };
    LessonNames names{
        .layers = {"mesh"}, .panels = {"steps"}, .widgets = {{"steps", {"steps/1", "steps/10"}}}, .document = {}};
    names.document = [](const std::string &) -> Result<Document> { return error("cannot-read", "no such file"); };
    for (const auto &each : cases) {
        CAPTURE(each.text);
        const Diagnostics faults = faultsOf(each.text, names);
        REQUIRE_FALSE(faults.empty());
        CHECK(hasCode(faults, each.code));
        CHECK(faults.front().line == each.line);
        CHECK(faults.front().column > 0);
        const std::string said = faults.front().message + ' ' + faults.front().advice;
        CHECK_MESSAGE(said.find(each.part) != std::string::npos, said);
    }
}

TEST_CASE("Lesson: a document that cannot be used is reported once, with the place of its own fault") {
    LessonNames names;
    names.document = [](const std::string &name) -> Result<Document> {
        Diagnostics faults = error("cannot-read", "cannot read the file: it is a folder");
        faults.front().line = name == "b.json" ? 7 : 0;
        return faults;
    };
    const auto message = [&](const char *file) {
        return faultsOf(page(std::string(",\n\"document\": \"") + file + '"'), names).front().message;
    };
    CHECK(message("a.json") == "cannot use the document 'a.json': cannot read the file: it is a folder");
    CHECK(message("b.json") == "cannot use the document 'b.json', line 7: cannot read the file: it is a folder");
}

TEST_CASE("Lesson: several faults of a file are reported together") {
    const Diagnostics faults = faultsOf(page(",\n\"panel\": 3,\n\"camera\": \"far\",\n\"zoom\": 1"));
    REQUIRE(faults.size() == 3);
    CHECK(faults[0].line + faults[1].line + faults[2].line == 3 + 4 + 5);
}

TEST_CASE("Lesson values: they describe the run, the advance and the choice of the learner") {
    const LessonRun run;
    const auto value = [&](LessonValue of) { return valueOf(of, run.state()); };
    CHECK(value(LessonValue::Advance) == 7.0);
    CHECK(value(LessonValue::Front) == 34.0);
    CHECK(value(LessonValue::Delivered) == 2.5);
    CHECK(value(LessonValue::Finished) == 0.0);
    CHECK(value(LessonValue::Base) == 5.0);
    CHECK(value(LessonValue::Candidates) == 3.0);
    CHECK(value(LessonValue::Winner) == 2.0);
    CHECK(value(LessonValue::Rejected) == 1.0);
    CHECK(value(LessonValue::Alpha) == 0.75);
    CHECK(value(LessonValue::Chosen) == 0.0);
    CHECK(valueOf(LessonValue::Chosen, run.state(1)) == 2.0);
    const SessionSnapshot nothing;
    for (const LessonValue of : valuesOf<LessonValue>()) {
        CAPTURE(wordOf(of));
        CHECK(valueOf(of, {nothing}).has_value() == (of == LessonValue::Chosen));
    }
}

TEST_CASE("Lesson texts: values in braces are filled in") {
    const LessonRun run;
    CHECK(withValues("Γ: {front}, α {alpha}", run.state()) == "Γ: 34, α 0.75");
    CHECK(withValues("{Nc}{front}", run.state()) == "2.534");
    CHECK(withValues("no values", run.state()) == "no values");
    CHECK(withValues("{front}", {SessionSnapshot()}) == "\xe2\x80\x93");
}

TEST_CASE("Lesson conditions: is, above and below a number or another value") {
    const LessonRun run;
    const auto check = [&](LessonCondition condition, std::optional<std::size_t> chosen = {}) {
        return holds(condition, run.state(chosen));
    };
    CHECK(check({LessonValue::Front, LessonRelation::Is, 34.0}));
    CHECK_FALSE(check({LessonValue::Front, LessonRelation::Is, 34.5}));
    CHECK(check({LessonValue::Front, LessonRelation::Is, 34.5, {}, 0.5}));
    CHECK(check({LessonValue::Front, LessonRelation::Above, 33.0}));
    CHECK_FALSE(check({LessonValue::Front, LessonRelation::Above, 34.0}));
    CHECK(check({LessonValue::Front, LessonRelation::Below, 35.0}));
    const LessonCondition wins{LessonValue::Chosen, LessonRelation::Is, 0.0, LessonValue::Winner};
    CHECK(check(wins, 1));
    CHECK_FALSE(check(wins, 0));
    CHECK_FALSE(check(wins));
    CHECK_FALSE(holds({LessonValue::Front, LessonRelation::Below, 1e9}, {SessionSnapshot()})); // there is no run
}

TEST_CASE("Lesson: hints belong to wrong choices and to numbers that learners confuse") {
    const auto lesson = readLesson(
        sourceOf(question(R"("choices": [{"text": "a", "hint": "not a"}, {"text": "b", "right": true}], "hint": "h")")),
        {});
    REQUIRE_MESSAGE(lesson.ok(), messages(lesson.faults()));
    const LessonQuestion &choices = *lesson->pages[0].question;
    CHECK(hintAfter(choices, 0) == "not a");
    CHECK(hintAfter(choices, 1) == "h");
    const auto numbers = readLesson(
        sourceOf(question(
            R"("number": "front", "within": "5 %", "hint": "h", "mistakes": [{"is": "elements", "hint": "triangles"},
               {"is": 70, "hint": "seventy"}])")),
        {});
    REQUIRE_MESSAGE(numbers.ok(), messages(numbers.faults()));
    const LessonQuestion &number = *numbers->pages[0].question;
    const LessonRun run; // Γ has 34 segments, the mesh 4 elements
    CHECK(hintAfter(number, 4.0, run.state()) == "triangles");
    CHECK(hintAfter(number, 72.0, run.state()) == "seventy");
    CHECK(hintAfter(number, 50.0, run.state()) == "h");
    const auto &asked = std::get<LessonNumber>(number.answer);
    CHECK(toleranceOf(asked, run.state()) == doctest::Approx(1.7));
    CHECK(isRight(asked, 35.6, run.state()));
    CHECK_FALSE(isRight(asked, 35.8, run.state()));
    CHECK(faultsOf(question(R"("number": "front", "within": "much")")).front().code == "bad-field");
    CHECK(faultsOf(question(R"("number": "front", "within": "-2 %")")).front().code == "bad-field");
    CHECK(faultsOf(question(R"("choices": [{"text": "a", "right": true, "hint": "x"}, {"text": "b"}])")).front().code ==
          "bad-question");
    CHECK(faultsOf(question(R"("until": {"value": "front", "is": 3}, "mistakes": [])")).front().code == "bad-question");
}

TEST_CASE("Lesson: a number is a value, a constant or a formula of values and random numbers") {
    const LessonRun run; // Γ has 34 segments, the mesh 4 elements
    const RandomNumbers numbers = {{"n", {7, -9}}, {"n2", {-3, -3}}};
    const auto value = [&](const std::string &text) {
        const Result<LessonFormula> formula = readFormula(text, numbers);
        REQUIRE_MESSAGE(formula.ok(), messages(formula.faults()));
        CHECK(formula->text == text);
        return valueOf(*formula, run.state());
    };
    CHECK(value("front") == 34.0);
    CHECK(value("2*front - n") == 61.0);
    CHECK(value("2*front-n") == 61.0);
    CHECK(value("n2^2 + elements") == 13.0);
    CHECK(value("new-nodes + 1e2") == 100.0); // a name with a hyphen, and a number with an exponent
    CHECK(value("sqrt(elements)") == 2.0);
    CHECK_FALSE(value("1/new-nodes").has_value());
    CHECK_FALSE(value("irregular").has_value()); // no clean-up is shown
    for (const char *wrong : {"frnt", "2*", "x + 1", "n3", "front elements", ""}) {
        const Result<LessonFormula> formula = readFormula(wrong, numbers);
        REQUIRE_FALSE(formula.ok());
        CHECK(formula.faults().front().code == "bad-field");
        CHECK(formula.faults().front().advice.find("chosen, n, n2") != std::string::npos);
    }
    const auto lesson = readLesson(
        sourceOf(question(R"("number": 0.5, "mistakes": [{"is": "front/elements", "hint": "quotient"}])")), {});
    REQUIRE_MESSAGE(lesson.ok(), messages(lesson.faults()));
    const LessonQuestion &half = *lesson->pages[0].question;
    CHECK(isRight(std::get<LessonNumber>(half.answer), 0.5, run.state()));
    CHECK_FALSE(isRight(std::get<LessonNumber>(half.answer), 0.51, run.state()));
    CHECK(hintAfter(half, 8.5, run.state()) == "quotient");
    CHECK(faultsOf(question(R"("number": "2*frnt")")).front().code == "bad-field");
}

TEST_CASE("Lesson: a mean is answered as people round it, and so are the mistakes that are means") {
    const auto asked = [](const std::string &members) {
        const auto lesson = readLesson(sourceOf(question(members)), {});
        REQUIRE_MESSAGE(lesson.ok(), messages(lesson.faults()));
        return *lesson->pages[0].question;
    };
    LessonRun run;
    run.snapshot.work = {.elements = 3, .delivered = 100}; // Nc = 33.333...
    const LessonQuestion front =
        asked(R"("number": "front", "hint": "h", "mistakes": [{"is": "Nc", "hint": "returned"}])");
    for (const double near : {33.3, 33.33, 33.333}) {
        CHECK(hintAfter(front, near, run.state()) == "returned");
    }
    for (const double far : {33.0, 33.2, 33.4, 35.0}) {
        CHECK(hintAfter(front, far, run.state()) == "h");
    }
    const LessonQuestion mean = asked(R"("number": "Nc", "mistakes": [{"is": "front", "hint": "front"}])");
    const auto &number = std::get<LessonNumber>(mean.answer);
    CHECK(isRight(number, 33.3, run.state()));
    CHECK(isRight(number, 33.33, run.state()));
    CHECK_FALSE(isRight(number, 33.4, run.state()));
    CHECK_FALSE(isRight(number, 33.0, run.state()));
    CHECK(hintAfter(mean, 34.0, run.state()) == "front");
    CHECK(hintAfter(mean, 33.9, run.state()).empty());                        // a whole number is not rounded
    const LessonQuestion exact = asked(R"("number": "Nc", "within": 0.001)"); // as the lesson says
    CHECK_FALSE(isRight(std::get<LessonNumber>(exact.answer), 33.3, run.state()));
    CHECK(isRight(std::get<LessonNumber>(exact.answer), 33.333, run.state()));
    CHECK(roundingOf(0.0) < 1e-8);
    CHECK(roundingOf(-0.9351) == doctest::Approx(0.0005));
    CHECK(roundingOf(1234.5) == doctest::Approx(5.0));
}

TEST_CASE("Lesson: only a choice among fixed texts does not depend on the run") {
    const auto asks = [](const std::string &members) {
        const auto lesson = readLesson(sourceOf(question(members)), {});
        REQUIRE_MESSAGE(lesson.ok(), messages(lesson.faults()));
        return asksAboutRun(*lesson->pages[0].question);
    };
    CHECK_FALSE(asks(R"("choices": [{"text": "a", "right": true}, {"text": "b"}])"));
    CHECK(asks(R"("choices": [{"text": "{front}", "right": true}, {"text": "b"}])"));
    CHECK(asks(R"("choices": [{"text": "a", "right": {"value": "front", "is": 3}}, {"text": "b"}])"));
    CHECK(asks(R"("number": "front")"));
    CHECK(asks(R"("until": {"value": "front", "is": 3})"));
}

TEST_CASE("Lesson: answers are read with a point or a comma") {
    CHECK(answeredNumber("12") == 12.0);
    CHECK(answeredNumber(" +0,5 ") == 0.5);
    CHECK(answeredNumber("1.5e3") == 1500.0);
    CHECK_FALSE(answeredNumber("").has_value());
    CHECK_FALSE(answeredNumber("12 m").has_value());
    CHECK_FALSE(answeredNumber("1e999").has_value());
    CHECK_FALSE(answeredNumber("nan").has_value());
}

TEST_CASE("Lesson: random numbers follow from the seed, and replace their names in texts, positions and conditions") {
    const std::string text = R"({"format": "forefront-lesson", "version": 1, "title": "T", "pages": [
        {"title": "P", "text": "{n} of {front}", "document": "a.json", "random": {"n": [3, 20]}, "position": "n",
         "question": {"text": "After {n}?", "until": {"value": "advance", "is": "n"}}},
        {"title": "Q", "text": "still {n}", "position": {"advance": "n", "events": 2}}]})";
    const auto read = [&](std::uint64_t seed) {
        LessonNames names;
        names.seed = seed;
        const auto lesson = readLesson(sourceOf(text), names);
        REQUIRE_MESSAGE(lesson.ok(), messages(lesson.faults()));
        return *lesson;
    };
    std::uint64_t smallest = 100, largest = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Lesson lesson = read(seed);
        const std::uint64_t n = lesson.pages[0].position.advance;
        CHECK(lesson.seed == seed);
        CHECK(lesson.pages[0].paragraphs[0] == std::to_string(n) + " of {front}");
        CHECK(lesson.pages[1].paragraphs[0] == "still " + std::to_string(n));
        CHECK(lesson.pages[1].position == LessonPosition{false, n, 2});
        CHECK(std::get<LessonTask>(lesson.pages[0].question->answer).until[0].number == static_cast<double>(n));
        smallest = std::min(smallest, n);
        largest = std::max(largest, n);
    }
    CHECK(smallest == 3);
    CHECK(largest == 20);
    CHECK(read(7).pages[0].position == read(7).pages[0].position);
    CHECK(readLesson(sourceOf(page("")), {})->seed == 0);
    CHECK(faultsOf(page(R"(, "random": {"front": [1, 2]})")).front().code == "bad-name");
    CHECK(faultsOf(page(R"(, "random": {"n": [2, 2]})")).front().code == "bad-range");
    CHECK(faultsOf(page(R"(, "random": {"n": [2]})")).front().code == "bad-range");
    const RandomRange widest{0, "n", -1'000'000'000, 1'000'000'000}, later{1, "n", -1'000'000'000, 1'000'000'000};
    CHECK(randomNumber(1, widest) != randomNumber(1, later));
}

TEST_CASE("Lesson: random numbers of negative ranges are drawn, shown and compared, but are no positions") {
    const std::string text = page(R"(, "random": {"n": [-3, 2]}, "question": {"text": "{n}", "choices":
        [{"text": "a", "right": {"value": "front", "above": "n"}}, {"text": "b"}]})");
    std::set<std::string> shown;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        LessonNames names;
        names.seed = seed;
        const auto lesson = readLesson(sourceOf(text), names);
        REQUIRE_MESSAGE(lesson.ok(), messages(lesson.faults()));
        const LessonQuestion &asked = *lesson->pages[0].question;
        const double bound = std::get<LessonChoices>(asked.answer).list[0].when[0].number;
        CHECK(asked.text == std::to_string(static_cast<int>(bound)));
        shown.insert(asked.text);
        CHECK(lesson->random == std::vector<RandomRange>{{0, "n", -3, 2}});
    }
    CHECK(shown == std::set<std::string>{"-3", "-2", "-1", "0", "1", "2"});
    for (std::uint64_t seed = 1; seed <= 20; ++seed) { // whatever is drawn
        LessonNames names;
        names.seed = seed;
        const Diagnostics faults =
            faultsOf(page(R"(, "document": "a.json", "random": {"n": [-1, 40]}, "position": "n")"), names);
        REQUIRE(faults.size() == 1);
        CHECK(faults.front().message == "the random number 'n' can be negative, down to -1, but a position cannot");
    }
}

TEST_CASE("Lesson: the seeds of a check draw every number of small ranges, and parts and ends of large ones") {
    const auto drawn = [](const RandomRange &range, const SeedsToCheck &check) {
        std::set<std::int64_t> numbers;
        for (const std::uint64_t seed : check.seeds) {
            numbers.insert(randomNumber(seed, range));
        }
        return numbers;
    };
    CHECK(seedsToCheck({}).seeds == std::vector<std::uint64_t>{1});
    const RandomRange small{0, "n", -20, 43}, pair{2, "m", 0, 1}, large{1, "k", 100, 600};
    const SeedsToCheck both = seedsToCheck({small, pair});
    CHECK(both.all);
    CHECK(drawn(small, both).size() == 64);
    CHECK(drawn(pair, both).size() == 2);
    CHECK(both.seeds.front() == 1);
    CHECK(both.seeds.size() <= 66);
    CHECK(std::is_sorted(both.seeds.begin(), both.seeds.end()));
    const SeedsToCheck sample = seedsToCheck({large});
    CHECK_FALSE(sample.all);
    const std::set<std::int64_t> numbers = drawn(large, sample);
    CHECK(*numbers.begin() == 100);
    CHECK(*numbers.rbegin() == 600);
    CHECK(numbers.size() >= 63);
    CHECK(sample.seeds.size() <= 66);
    const SeedsToCheck widest = seedsToCheck({{0, "n", -1'000'000'000, 1'000'000'000}});
    CHECK(widest.seeds.size() == 64);
}
