#include "core/teaching/lesson/lesson_read.hpp"

#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/files/json/json_check.hpp"
#include "core/files/rules/rules_json.hpp"
#include "core/teaching/lesson/markup_check.hpp"
#include "core/teaching/lesson/question_read.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>

namespace forefront {

namespace {

constexpr std::array<std::string_view, 5> kLessonMembers = {"format", "version", "title", "about", "pages"};
constexpr std::array<std::string_view, 16> kPageMembers = {
    "title",  "text",  "document", "method", "grid",    "improve",   "rules",    "position",
    "layers", "panel", "camera",   "range",  "colours", "highlight", "question", "random"};

class LessonReader {
  public:
    LessonReader(const SourceText &source, const LessonNames &names)
        : names_(names), check_(source), markup_(source, names.picture) {}

    Result<Lesson> read(const JsonValue &root) {
        const auto format = root.find("format");
        if (!format || format->string() != "forefront-lesson") {
            check_.fault(format.value_or(root), "not-a-lesson", "not a Forefront lesson",
                         "a lesson begins with {\"format\": \"forefront-lesson\", \"version\": 1");
            return check_.faults();
        }
        if (const auto version = check_.member(root, "version", "the lesson")) {
            check_.integer(*version, 1, kLessonVersion, "\"version\"");
        }
        check_.refuseRepeats(root);
        expectMembers(check_, root, kLessonMembers, "the lesson");
        Lesson lesson;
        if (const auto title = check_.member(root, "title", "the lesson")) {
            lesson.title = shownText(check_, *title, "the title of a lesson", nullptr);
        }
        if (const auto about = root.find("about")) {
            lesson.about = shownText(check_, *about, "\"about\"", nullptr);
        }
        if (const auto pages = check_.member(root, "pages", "the lesson");
            pages && check_.expect(*pages, JsonKind::Array, "\"pages\"")) {
            for (const JsonValue item : *pages) {
                if (check_.expect(item, JsonKind::Object, "a page")) {
                    if (const auto random = item.find("random")) {
                        const auto drawn = readNumbers(*random, check_, names_.seed, lesson.pages.size(), numbers_);
                        lesson.random.insert(lesson.random.end(), drawn.begin(), drawn.end());
                    }
                    lesson.pages.push_back(page(item, lesson.pages.empty() ? LessonPage() : lesson.pages.back()));
                    markup_.page(item, numbers_);
                }
            }
            markup_.links(lesson);
            if (lesson.pages.empty()) {
                check_.fault(*pages, "no-pages", "the lesson has no pages");
            }
        }
        Diagnostics faults = check_.faults();
        faults.insert(faults.end(), markup_.faults().begin(), markup_.faults().end());
        if (!faults.empty()) {
            return faults;
        }
        lesson.seed = numbers_.empty() ? 0 : names_.seed;
        lesson.pictures = markup_.takePictures();
        return lesson;
    }

  private:
    /// Reads a page that continues the scene of the one before.
    LessonPage page(const JsonValue &item, const LessonPage &before) {
        expectMembers(check_, item, kPageMembers, "a page");
        LessonPage page = before;
        page.paragraphs.clear();
        page.highlights.clear();
        page.question.reset();
        page.title.clear();
        if (const auto title = check_.member(item, "title", "the page")) {
            page.title = shownText(check_, *title, "the title of a page", nullptr);
        }
        if (const auto text = check_.member(item, "text", "the page")) {
            paragraphs(*text, page);
        }
        scene(item, page);
        if (const auto highlight = item.find("highlight")) {
            highlights(*highlight, page);
        }
        if (const auto question = item.find("question");
            question && check_.expect(*question, JsonKind::Object, "\"question\"")) {
            page.question = readQuestion(*question, check_, numbers_);
        }
        page.random = page.position.random || item.find("random") || namesNumber(item, false);
        return page;
    }

    /// Returns true if the texts or formulas of a part of a page name a random number.
    bool namesNumber(const JsonValue &value, bool isFormula) const {
        if (value.is(JsonKind::String)) {
            return forefront::namesNumber(value.string(), numbers_, isFormula);
        }
        constexpr std::array<std::string_view, 3> kTexts = {"text", "hint", "why"};
        for (auto item = value.begin(); item != value.end(); ++item) {
            const std::string key = value.is(JsonKind::Object) ? item.key() : std::string();
            const bool formula = key.empty() ? isFormula : std::find(kTexts.begin(), kTexts.end(), key) == kTexts.end();
            if (key != "title" && namesNumber(*item, formula)) {
                return true;
            }
        }
        return false;
    }

    void paragraphs(const JsonValue &text, LessonPage &page) {
        if (text.is(JsonKind::String)) {
            page.paragraphs.push_back(shownText(check_, text, "\"text\"", &numbers_));
        } else if (check_.expect(text, JsonKind::Array, "\"text\"")) {
            for (const JsonValue paragraph : text) {
                page.paragraphs.push_back(shownText(check_, paragraph, "a paragraph", &numbers_));
            }
        }
    }

    void highlights(const JsonValue &list, LessonPage &page) {
        if (!check_.expect(list, JsonKind::Array, "\"highlight\"")) {
            return;
        }
        for (const JsonValue item : list) {
            const std::string name = check_.string(item, "the name of a widget");
            const auto family = names_.widgets.find(name.substr(0, name.find('/')));
            known(item, family != names_.widgets.end() ? family->second : std::vector<std::string>(), "widget");
            const TextPlace place = check_.place(item);
            page.highlights.push_back({name, {place.line, place.column}});
        }
    }

    void scene(const JsonValue &item, LessonPage &page) {
        if (const auto name = item.find("document")) {
            document(*name, page);
        }
        word(item, "method", page.method);
        word(item, "grid", page.grid);
        word(item, "improve", page.improve);
        if (const auto rules = item.find("rules")) {
            page.rules = readRules(*rules, check_);
        }
        if (const auto position = item.find("position")) {
            page.position = readPosition(*position, check_, numbers_);
        }
        if (const auto layers = item.find("layers")) {
            page.layers = words(*layers, "\"layers\"", names_.layers, "layer");
        }
        if (const auto panel = item.find("panel")) {
            page.panel = known(*panel, names_.panels, "panel");
        }
        if (const auto camera = item.find("camera")) {
            page.camera = readCamera(*camera);
        }
        if (const auto range = item.find("range")) {
            page.range = readRange(*range);
        }
        if (const auto colours = item.find("colours")) {
            page.colours = readColours(*colours);
        }
        needDocument(item, page);
    }

    /// Reads {"values": EXPRESSION} or {"error": EXPRESSION}, perhaps with a "name", or "alpha".
    LessonColours readColours(const JsonValue &value) {
        constexpr std::array<std::string_view, 1> kWords = {"alpha"};
        constexpr std::array<std::string_view, 3> kMembers = {"values", "error", "name"};
        LessonColours colours;
        if (!value.is(JsonKind::Object)) {
            check_.choice(value, kWords, "\"colours\"");
            return colours;
        }
        expectMembers(check_, value, kMembers, "\"colours\"");
        const auto values = value.find("values"), error = value.find("error");
        if (values.has_value() == error.has_value()) {
            check_.fault(value, "bad-colours", "expected one of \"values\" and \"error\" in \"colours\"",
                         "write an expression in x and y, such as {\"error\": \"sin(x)*y\"}");
            return colours;
        }
        const JsonValue expression = values ? *values : *error;
        colours.ofError = error.has_value();
        colours.expression = shownText(check_, expression, "the expression of \"colours\"", nullptr);
        colours.name = colours.ofError ? "estimated error" : "value";
        if (const auto name = value.find("name")) {
            colours.name = shownText(check_, *name, "the name of \"colours\"", nullptr);
        }
        const Result<NodalField> field = expressionField(colours.expression);
        if (!field && !colours.expression.empty()) {
            check_.fault(expression, "bad-colours", field.faults().front().message, field.faults().front().advice);
        }
        return colours;
    }

    /// Reports members that need a document when there is none.
    void needDocument(const JsonValue &item, const LessonPage &page) {
        if (!page.documentName.empty() || item.find("document")) {
            return;
        }
        for (const char *member : {"method", "grid", "improve", "rules", "position", "colours"}) {
            if (const auto value = item.find(member)) {
                check_.fault(*value, "no-document", inQuotes(member) + " has no effect without a document",
                             "add \"document\" to this page or to an earlier one");
            }
        }
    }

    /// Returns false and reports an error if a path leaves the lesson's folder.
    bool isInFolder(const JsonValue &value, const std::string &name) {
        if (isWithinFolder(name)) {
            return true;
        }
        check_.fault(value, "bad-document", "the document " + inQuotes(name) + " is outside the lesson's folder",
                     "move it into that folder, and give its path relative to the lesson");
        return false;
    }

    void document(const JsonValue &value, LessonPage &page) {
        page.documentName = shownText(check_, value, "\"document\"", nullptr);
        page.method.reset();
        page.grid.reset();
        page.improve.reset();
        page.rules.reset();
        page.position = {};
        page.camera = {};
        page.colours = {};
        if (!isInFolder(value, page.documentName) || !names_.document || page.documentName.empty()) {
            return;
        }
        std::shared_ptr<const Document> &known = documents_[page.documentName];
        if (!known) {
            Result<Document> read = names_.document(page.documentName);
            if (!read) {
                const Diagnostic &fault = read.faults().front();
                check_.fault(value, "bad-document",
                             "cannot use the document " + inQuotes(page.documentName) +
                                 (fault.line > 0 ? ", line " + std::to_string(fault.line) : "") + ": " + fault.message,
                             fault.advice);
                return;
            }
            known = std::make_shared<const Document>(std::move(*read));
        }
        page.document = known;
    }

    template <class Enum>
    void word(const JsonValue &item, std::string_view member, std::optional<Enum> &to) {
        if (const auto value = item.find(member)) {
            to = static_cast<Enum>(check_.choice(*value, wordsOf<Enum>(), '"' + std::string(member) + '"'));
        }
    }

    LessonCamera readCamera(const JsonValue &value) {
        constexpr std::array<std::string_view, 2> kWords = {"all", "follow"};
        constexpr std::array<std::string_view, 2> kMembers = {"centre", "size"};
        LessonCamera camera;
        if (!value.is(JsonKind::Object)) {
            camera.follow = check_.choice(value, kWords, "\"camera\"") == 1;
            return camera;
        }
        expectMembers(check_, value, kMembers, "the camera");
        const auto centre = check_.member(value, "centre", "the camera");
        const auto size = check_.member(value, "size", "the camera");
        if (centre && size) {
            camera.box = boxAround(check_.point(*centre, "the centre of the camera"),
                                   0.5 * check_.positive(*size, "the size of the camera"));
        }
        return camera;
    }

    LessonRange readRange(const JsonValue &value) {
        const std::size_t before = check_.faults().size();
        const Vec2 ends = check_.point(value, "\"range\"");
        if (check_.faults().size() == before && !(ends.x < ends.y)) {
            check_.fault(value, "bad-range", "expected two increasing numbers for \"range\"",
                         "write the values of α at the ends of the colour scale, such as [0.5, 1]");
            return {};
        }
        return {ends.x, ends.y};
    }

    std::vector<std::string> words(const JsonValue &list, std::string_view what, const std::vector<std::string> &names,
                                   const char *kind) {
        std::vector<std::string> found;
        if (check_.expect(list, JsonKind::Array, what)) {
            for (const JsonValue item : list) {
                found.push_back(known(item, names, kind));
            }
        }
        return found;
    }

    /// Reads one of the names; any name if there are none to choose from.
    std::string known(const JsonValue &value, const std::vector<std::string> &names, const char *kind) {
        std::string name = check_.string(value, std::string("the name of a ") + kind);
        if (!names.empty() && value.is(JsonKind::String) &&
            std::find(names.begin(), names.end(), name) == names.end()) {
            std::string list;
            for (const std::string &each : names) {
                list += (list.empty() ? "" : ", ") + each;
            }
            check_.fault(value, "unknown-name", std::string("unknown ") + kind + ' ' + inQuotes(name),
                         "expected one of: " + list);
        }
        return name;
    }

    const LessonNames &names_;
    JsonCheck check_;
    MarkupCheck markup_;
    RandomNumbers numbers_; ///< of this page and those before
    std::map<std::string, std::shared_ptr<const Document>> documents_;
};

} // namespace

Result<Lesson> readLesson(const SourceText &source, const LessonNames &names) {
    const auto json = JsonDocument::parse(source);
    if (!json) {
        return json.faults();
    }
    return LessonReader(source, names).read(json->root());
}

} // namespace forefront
