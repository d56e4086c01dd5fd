#include "core/teaching/film/film_picture.hpp"
#include "core/teaching/film/png_writer.hpp"
#include "core/teaching/lesson/lesson_check.hpp"
#include "core/teaching/lesson/lesson_file.hpp"
#include "core/teaching/lesson/lesson_picture.hpp"
#include "core/teaching/lesson/lesson_read.hpp"
#include "core/teaching/lesson_page/text_html.hpp"
#include "core/teaching/markup/marked_text.hpp"
#include "core/teaching/markup/text_values.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A lesson of two pages, the second of which is called "Last", with the text of the first.
std::string lessonWith(const std::string &text, const std::string &question = "") {
    return "{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"T\", \"pages\": [\n"
           "{\"title\": \"P\", \"text\": \"" +
           text + '"' + question + "},\n{\"title\": \"Last\", \"text\": \"t\"}]}";
}

Diagnostic faultOf(const std::string &lesson) {
    const auto read = readLesson(sourceOf(lesson), {});
    REQUIRE_FALSE(read.ok());
    REQUIRE(read.faults().size() == 1);
    return read.faults().front();
}

/// A PNG file of many colours.
std::string pngFileOf(int columns, int rows) {
    FilmPicture picture{columns, rows, {}};
    for (int k = 0; k < columns * rows; ++k) {
        picture.pixels.push_back(static_cast<std::uint8_t>(7 * k % 250));
    }
    return forefront::pngOf(picture);
}

} // namespace

TEST_CASE("Markup: a text is split into words, formulas, images and links") {
    const auto pieces = parseMarkup("Let $x^2$ be [page 3](#3), see ![a ring](ring.png width=60%) and f[i] \\$5.");
    REQUIRE(pieces.ok());
    REQUIRE(pieces->size() == 7);
    CHECK((*pieces)[0].text == "Let ");
    CHECK((*pieces)[1].kind == PieceKind::Formula);
    CHECK((*pieces)[1].at == 4);
    CHECK((*pieces)[3].kind == PieceKind::Link);
    CHECK((*pieces)[3].text == "page 3");
    CHECK((*pieces)[3].target == "3");
    CHECK((*pieces)[5].kind == PieceKind::Image);
    CHECK((*pieces)[5].text == "a ring");
    CHECK((*pieces)[5].target == "ring.png");
    CHECK((*pieces)[5].share == doctest::Approx(0.6));
    CHECK((*pieces)[6].text == " and f[i] $5.");
    CHECK(plainText("Let $x^2$ be [this](#3)![no](a.png)") == "Let x^2 be this");
    CHECK(piecesOf("no $end").size() == 1);
}

TEST_CASE("Markup: faults name what is wrong and where") {
    const struct {
        const char *text, *code, *message;
        int column;
    } faults[] = {{"a $x", "bad-formula", "the formula that begins here has no closing $", 3},
                  {"a $x + \\no$", "bad-formula", "unknown command \\no", 8},
                  {"a $$", "bad-formula", "the formula is empty", 4},
                  {"![](a.png)", "bad-image", "the image has no words", 1},
                  {"x ![a]", "bad-image", "the brackets that begin here are not closed", 3},
                  {"![a](b.png", "bad-image", "the brackets that begin here are not closed", 1},
                  {"![a]( width=20%)", "bad-image", "the image has no file", 1},
                  {"![a](b.png width=0%)", "bad-image", "invalid width '0%'", 1},
                  {"![a](b.png width=2em)", "bad-image", "invalid width '2em'", 1},
                  {"[a](b)", "bad-link", "unknown target 'b' of a link", 1},
                  {"[a](#)", "bad-link", "unknown target '#' of a link", 1},
                  {"[ ](#1)", "bad-link", "unknown target '#1' of a link", 1}};
    for (const auto &[text, code, message, column] : faults) {
        CAPTURE(text);
        const auto pieces = parseMarkup(text);
        REQUIRE_FALSE(pieces.ok());
        CHECK(pieces.faults().front().code == code);
        CHECK_MESSAGE(pieces.faults().front().message.starts_with(message), pieces.faults().front().message);
        CHECK(pieces.faults().front().column == column);
    }
    CHECK(parseMarkup("$x$", MarkupKind::Formulas).ok());
    CHECK_FALSE(parseMarkup("[a](#1)", MarkupKind::Formulas).ok());
    CHECK_FALSE(parseMarkup("![a](b.png)", MarkupKind::Formulas).ok());
}

TEST_CASE("Markup: values are replaced in texts and in formulas, where other braces are TeX's") {
    const auto number = [](std::string_view word) {
        return word == "n"      ? std::optional<std::string>("12")
               : word == "tiny" ? std::optional<std::string>("2.5e-07")
                                : std::nullopt;
    };
    CHECK(withValuesReplaced("{n} of {m}", number) == "12 of {m}");
    CHECK(withValuesReplaced("$x^{n} + \\value{n}$, {n}", number) == "$x^{n} + {12}$, 12");
    CHECK(withValuesReplaced("\\${n} $\\$\\value{n}$", number) == "\\$12 $\\${12}$");
    CHECK(withValuesReplaced("$\\value{tiny}$", number) == "${2.5\\cdot 10^{-7}}$");
    CHECK(parseMarkup(withValuesReplaced("$\\value{tiny}$", number)).ok());
    const std::vector<NamedValue> values = valuesNamed("{a} $\\frac{b}{c} \\value{d}$ {e");
    REQUIRE(values.size() == 3);
    CHECK(values[0].word == "a");
    CHECK(values[1].word == "d");
    CHECK(values[1].inFormula);
    CHECK_FALSE(values[2].closed);
}

TEST_CASE("Lesson: a fault in the markup of a text names the page and its place within the text") {
    // The fault is in line 2; the escapes before it count as they are written.
    const Diagnostic command = faultOf(lessonWith("\\u03c1 and \\\"this\\\" $a + \\\\foo$"));
    CHECK(command.code == "bad-formula");
    CHECK(command.message.starts_with("page 1: unknown command \\foo"));
    CHECK(command.line == 2);
    const std::string before = "{\"title\": \"P\", \"text\": \"\\u03c1 and \\\"this\\\" $a + ";
    CHECK(command.column == static_cast<int>(before.size()) + 1);

    CHECK(faultOf(lessonWith("[x](#3)")).message.starts_with("page 1: the link leads to page '3'"));
    CHECK(faultOf(lessonWith("![x](../a.png)")).message.starts_with("page 1: the image '../a.png' is outside"));
    const auto question = [](const std::string &members) {
        return ", \"question\": {\"text\": \"q\", " + members + '}';
    };
    CHECK(faultOf(lessonWith("t", question("\"number\": 1, \"hint\": \"a $\""))).code == "bad-formula");
    CHECK(faultOf(lessonWith("t", question("\"number\": 1, \"why\": \"$a\""))).code == "bad-formula");
    CHECK(
        faultOf(lessonWith("t", question("\"number\": 1, \"mistakes\": [{\"is\": 2, \"hint\": \"[a](#9)\"}]"))).code ==
        "bad-link");
    CHECK(
        faultOf(lessonWith("t", question("\"choices\": [{\"text\": \"[a](#1)\", \"right\": true}, {\"text\": \"b\"}]")))
            .code == "bad-link");
    CHECK(faultOf(lessonWith("$\\\\value{no}$")).code == "unknown-value");

    const auto good = readLesson(sourceOf(lessonWith("$\\\\frac{1}{2}$ [x](#2) [y](#Last) ![z](a.png)")), {});
    REQUIRE_MESSAGE(good.ok(), messages(good.faults()));
    CHECK(pageOfTarget(*good, "2") == 1);
    CHECK(pageOfTarget(*good, "Last") == 1);
    CHECK_FALSE(pageOfTarget(*good, "0").has_value());
    CHECK_FALSE(pageOfTarget(*good, "2x").has_value());
}

TEST_CASE("Lesson: a picture is checked by its bytes, and one that cannot be shown is a fault of the check only") {
    CHECK(lessonPictureOf(pngFileOf(5, 3)).columns == 5);
    CHECK(lessonPictureOf(pngFileOf(5, 3)).rows == 3);
    CHECK(lessonPictureOf("GIF89a").faults.front().code == "bad-picture");
    CHECK(lessonPictureOf(pngFileOf(40, 30).substr(0, 60)).faults.front().code == "bad-picture");
    CHECK(lessonPictureOf(pngFileOf(4097, 1)).faults.front().code == "large-picture");
    CHECK(lessonPictureOf("\xff\xd8\xff\xe0").faults.front().code == "bad-picture");
    const std::string jpeg("\xff\xd8\xff\xc0\x00\x11\x08\x00\x10\x00\x20\x03\x00\x00\xff\xd9", 16);
    CHECK(lessonPictureOf(jpeg).columns == 32);
    CHECK(lessonPictureOf(jpeg).rows == 16);
    std::string broken = pngFileOf(40, 30);
    broken[broken.size() - 30] = static_cast<char>(broken[broken.size() - 30] ^ 0x55); // of the pixels
    CHECK(lessonPictureOf(broken).faults.empty());
    CHECK_FALSE(damageOf(lessonPictureOf(broken)).empty());

    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "forefront-markup";
    std::filesystem::create_directories(folder);
    const auto write = [&](const char *name, const std::string &bytes) {
        std::ofstream(folder / name, std::ios::binary) << bytes;
    };
    write("good.png", pngFileOf(8, 8));
    write("broken.png", broken);
    write("lesson.json", lessonWith("![g](good.png) ![b](broken.png) ![m](missing.png)"));
    const Result<LessonFile> file = readLessonFile(folder / "lesson.json", {});
    REQUIRE_MESSAGE(file.ok(), messages(file.faults()));
    CHECK(file->lesson.pictures.size() == 3);
    const Diagnostics faults = checkLesson(file->lesson, file->source(), {});
    REQUIRE(faults.size() == 2);
    CHECK(faults[0].message.starts_with("page 1: cannot show the image 'broken.png': the file is damaged"));
    CHECK(faults[1].message.starts_with("page 1: cannot show the image 'missing.png'"));
    CHECK(faults[1].line == 2);

    TextHtml html(file->lesson);
    const std::string text = html.of("a < b ![g \"x\"](good.png width=50%) ![m](missing.png) [l](#Last) $x$");
    CHECK(text.find("a &lt; b ") != std::string::npos);
    CHECK(text.find("<img data-picture=\"0\" alt=\"g &quot;x&quot;\" style=\"width:50%\">") != std::string::npos);
    CHECK(text.find("Image not available: m") != std::string::npos);
    CHECK(text.find("<a href=\"#2\" data-page=\"1\">l</a>") != std::string::npos);
    REQUIRE(html.pictures().size() == 1);
    CHECK(html.pictures()[0].starts_with("data:image/png;base64,iVBOR"));
    CHECK(html.of("![g](good.png)").find("data-picture=\"0\"") != std::string::npos);
    CHECK(html.pictures().size() == 1);
    std::filesystem::remove_all(folder);
}

TEST_CASE("Lesson: only pages with random numbers have others") {
    const auto lesson = readLesson(
        sourceOf("{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"T\", \"pages\": ["
                 "{\"title\": \"a\", \"text\": \"t\"},"
                 "{\"title\": \"b\", \"text\": \"t {n}\", \"random\": {\"n\": [1, 9]}},"
                 "{\"title\": \"n\", \"text\": \"t\"},"
                 "{\"title\": \"d\", \"text\": \"t\", \"question\": {\"text\": \"q\", \"number\": \"2*n\"}},"
                 "{\"title\": \"e\", \"text\": \"n\", \"question\": {\"text\": \"n\", \"number\": \"front\"}},"
                 "{\"title\": \"f\", \"text\": \"$\\\\value{n}$\"}]}"),
        {});
    REQUIRE_MESSAGE(lesson.ok(), messages(lesson.faults()));
    std::string random;
    for (const LessonPage &page : lesson->pages) {
        random += page.random ? '1' : '0';
    }
    CHECK(random == "010101");
}

TEST_CASE("Lesson: a page colours the mesh by an expression, until another drawing") {
    const auto with = [](const std::string &colours) {
        return "{\"format\": \"forefront-lesson\", \"version\": 1, \"title\": \"T\", \"pages\": ["
               "{\"title\": \"a\", \"text\": \"t\", \"document\": \"d\", \"colours\": " +
               colours +
               "}, {\"title\": \"b\", \"text\": \"t\"}, {\"title\": \"c\", \"text\": \"t\", \"document\": \"e\"}]}";
    };
    const auto lesson = readLesson(sourceOf(with("{\"error\": \"x*y\"}")), {});
    REQUIRE_MESSAGE(lesson.ok(), messages(lesson.faults()));
    CHECK(lesson->pages[0].colours.ofError);
    CHECK(lesson->pages[1].colours.expression == "x*y");
    CHECK_FALSE(lesson->pages[2].colours.any());
    const auto named = readLesson(sourceOf(with("{\"values\": \"x\", \"name\": \"u\"}")), {});
    REQUIRE(named.ok());
    CHECK(named->pages[0].colours.name == "u");
    CHECK(readLesson(sourceOf(with("\"alpha\"")), {}).ok());
    CHECK(faultOf(with("{\"error\": \"x*\"}")).code == "bad-colours");
    CHECK(faultOf(with("{}")).code == "bad-colours");
    CHECK(faultOf(with("{\"error\": \"x\", \"values\": \"x\"}")).code == "bad-colours");
    CHECK(faultOf(with("\"beta\"")).code == "bad-field");

    TriMesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.elements = {{NodeId(0), NodeId(1), NodeId(2)}, {NodeId(0), NodeId(2), NodeId(3)}};
    const auto values = coloursOn({"x+2*y", "u", false}, mesh, {});
    REQUIRE(values.ok());
    CHECK(*values == std::vector<double>{0, 1, 3, 2});
    const auto errors = coloursOn({"x+2*y", "e", true}, mesh, {});
    REQUIRE(errors.ok());
    REQUIRE(errors->size() == 2);
    CHECK((*errors)[0] == doctest::Approx(0.0));
    CHECK_FALSE(coloursOn({"1/x", "u", false}, mesh, {}).ok());
}
