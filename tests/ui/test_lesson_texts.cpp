#include "core/teaching/film/film_picture.hpp"
#include "core/teaching/film/png_writer.hpp"
#include "core/teaching/markup/math_symbols.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/ui/driver.hpp"
#include "tests/ui/own_lesson.hpp"
#include "tests/ui/widget_rects.hpp"
#include "ui/lessons/lesson_list.hpp"
#include "ui/lessons/lesson_player.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace forefront::test {

namespace {

/// Writes a picture of 200 by 100 pixels.
void writePng(const std::filesystem::path &file) {
    const FilmPicture picture{200, 100, std::vector<std::uint8_t>(20'000, 40)};
    std::ofstream(file, std::ios::binary) << pngOf(picture);
}

using testing::TemporaryFolder;

/// A reader of a lesson of its own.
class OwnReader : public Driver {
  public:
    explicit OwnReader(double scale = 1.0) : Driver({}, {1280, 800}, scale) { writePng(folder.path / "good.png"); }

    void open(const std::string &text, const std::string &more = "}") {
        const std::filesystem::path file = folder.path / "mine.json";
        writeOwnLesson(file, text, more);
        const Diagnostics faults = openLessonFile(context(), file);
        REQUIRE_MESSAGE(faults.empty(), (faults.empty() ? "" : faults.front().message));
        settle();
        until([&] { return context().lessons.open.has_value(); });
        settle();
    }
    const WidgetRegistry::Widget &widget(const std::string &name) {
        const WidgetRegistry::Widget *const found = context().widgets.find(name);
        REQUIRE_MESSAGE(found != nullptr, name);
        return *found;
    }

    TemporaryFolder folder;
};

bool logged(Driver &driver, const std::string &text) {
    const auto &entries = driver.context().log.entries();
    return std::any_of(entries.begin(), entries.end(), [&](const MessageLog::Entry &entry) {
        return entry.diagnostic.message.find(text) != std::string::npos;
    });
}

} // namespace

TEST_CASE("Lessons: a tall formula takes more room than words, and one on a line of its own more still") {
    const auto heightOf = [](const std::string &text) {
        OwnReader reader;
        reader.open(text);
        return rectOf(reader, "lesson/text/0").height;
    };
    const double words = heightOf("words and words"), flat = heightOf("words $x$"),
                 fraction = heightOf("words $\\\\frac{a}{b}$"), alone = heightOf("$\\\\frac{a}{b}$");
    CHECK(flat == words);
    CHECK(fraction > words);
    CHECK(alone > fraction);
}

TEST_CASE("Lessons: a long formula is broken, and long words do not leave the column") {
    OwnReader reader;
    reader.open(
        "$a = b + c + d + e + f + g + h + i + j + k + l + m + n + o + p + q + r + s + t + u + v + w + x + y + z$ "
        "Donaudampfschifffahrtselektrizitaetenhauptbetriebswerkbauunterbeamtengesellschaftsvorsitzender");
    const PixelRect text = rectOf(reader, "lesson/text/0");
    CHECK(text.height > 3.0 * 16.0);
    CHECK(text.x + text.width <= 42.0 + 330.0);
}

TEST_CASE("Lessons: a picture is shown in its size, not wider than the column, and sharp at every scale") {
    for (const double scale : {1.0, 2.0}) {
        OwnReader reader(scale);
        reader.open("![a grey box](good.png) ![half](good.png width=50%)");
        const PixelRect whole = rectOf(reader, "lesson/image/0"), half = rectOf(reader, "lesson/image/1");
        CHECK(whole.width == doctest::Approx(200.0 * scale).epsilon(0.02));
        CHECK(whole.height == doctest::Approx(100.0 * scale).epsilon(0.02));
        CHECK(half.width < whole.width);
        CHECK(half.y >= whole.y + whole.height);
        reader.settle();
        const Driver::Picture picture = reader.picture();
        const auto x = static_cast<std::size_t>(whole.x + 0.5 * whole.width),
                   y = static_cast<std::size_t>(whole.y + 0.5 * whole.height);
        const std::size_t at = 4 * (y * static_cast<std::size_t>(picture.size.width) + x);
        const std::vector<std::uint8_t> palette = filmPalette();
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(picture.rgba[at + k] == palette[3 * 40 + k]);
        }
    }
}

TEST_CASE("Lessons: a picture that is missing or broken leaves its words and a warning") {
    OwnReader reader;
    std::ofstream(reader.folder.path / "broken.png") << "no picture";
    reader.open("![a ring](missing.png)![a plate](broken.png)");
    CHECK(rectOf(reader, "lesson/image/0").height > 30.0);
    CHECK(rectOf(reader, "lesson/image/1").height > 30.0);
    CHECK(logged(reader, "page 1: cannot show the image 'missing.png'"));
    CHECK(logged(reader, "page 1: cannot show the image 'broken.png'"));
}

TEST_CASE("Lessons: a link turns to its page") {
    OwnReader reader;
    reader.open("go to [the last page](#Z)",
                R"x(}, {"title": "B", "text": "t"}, {"title": "Z", "text": "back to [one](#1)"})x");
    CHECK(reader.click("lesson/link/0"));
    reader.settle();
    CHECK(reader.context().lessons.open->page == 2);
    CHECK(reader.click("lesson/link/0"));
    reader.settle();
    CHECK(reader.context().lessons.open->page == 0);
}

TEST_CASE("Lessons: the fonts have every symbol of formulas, in both sizes") {
    Driver driver;
    driver.settle();
    const Fonts &fonts = driver.context().fonts;
    for (const std::string_view name :
         {"alpha",  "omega", "Gamma",    "Omega",    "infty", "partial",  "nabla",  "emptyset", "angle",
          "degree", "dots",  "prime",    "|",        "cdot",  "times",    "div",    "pm",       "mp",
          "cup",    "cap",   "setminus", "le",       "ge",    "ne",       "approx", "sim",      "equiv",
          "propto", "in",    "notin",    "parallel", "to",    "leftarrow"}) {
        CAPTURE(name);
        const std::string_view text = symbolOfCommand(name)->text;
        const auto byte = [&](std::size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(text[k])); };
        const unsigned code = text.size() == 1 ? byte(0)
                              : text.size() == 2
                                  ? ((byte(0) & 0x1fU) << 6U) | (byte(1) & 0x3fU)
                                  : ((byte(0) & 0xfU) << 12U) | ((byte(1) & 0x3fU) << 6U) | (byte(2) & 0x3fU);
        CHECK(imgui::holds(*fonts.body, code));
        CHECK(imgui::holds(*fonts.index, code));
    }
    CHECK(imgui::holds(*fonts.sum, 0x2211));
    CHECK(imgui::holds(*fonts.sum, 0x220f));
    CHECK(imgui::holds(*fonts.sum, 0x222b));
}

TEST_CASE("Lessons: a page colours the mesh by its field and by the error of each triangle") {
    Driver driver;
    listLessons(driver.context());
    for (const LessonEntry &entry : std::vector<LessonEntry>(driver.context().lessons.list)) {
        if (entry.id == "9-adaptive") {
            openLesson(driver.context(), entry);
        }
    }
    driver.settle();
    goToPage(driver.context(), 0);
    driver.settle();
    CHECK(driver.context().judgement->name == "u");
    CHECK(driver.context().judgement->info.part == MeshPart::Nodes);
    goToPage(driver.context(), 1);
    driver.settle();
    const Judgement &judgement = *driver.context().judgement;
    CHECK(judgement.name == "estimated error");
    REQUIRE(judgement.of.fieldValues);
    CHECK(judgement.values.size() == 154);
    goToPage(driver.context(), 2); // another drawing
    driver.settle();
    CHECK_FALSE(driver.context().view.formula.any());
    CHECK(driver.context().layer("size")->visible);
    closeLesson(driver.context());
    driver.settle();
    CHECK_FALSE(driver.context().view.formula.any());
}

} // namespace forefront::test
