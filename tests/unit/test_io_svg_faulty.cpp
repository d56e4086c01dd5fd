// Drawings with parts that cannot be read: those parts are left out with a note, as browsers do, or refused if the
// input must not be changed.
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/files/files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/svg_samples.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// What is beside the faulty part: a square of 2 by 2.
constexpr char kSquare[] = "<rect x=\"7\" y=\"7\" width=\"2\" height=\"2\"/>";

std::string withSquare(const std::string &content) {
    return "<svg viewBox=\"0 0 10 10\">\n" + content + "\n" + kSquare + "</svg>\n";
}

/// Reads a drawing with a faulty part; checks that one note reports it, and that it is refused under `strict`.
/// Returns the area of the rest.
double areaWithout(const std::string &content, const std::string &code) {
    const std::string text = withSquare(content);
    ImportNotes notes;
    SourceText source = sourceOf(text, "faulty.svg");
    source.notes = &notes;
    const auto domain = readSvg(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries().front().code == code);
    CHECK(notes.entries().front().line == 2);
    SourceText strict = sourceOf(text, "faulty.svg");
    strict.options.strict = true;
    const auto refused = readSvg(strict);
    CHECK((!refused && hasCode(refused.faults(), code) && allLocated(refused.faults())));
    return enclosedArea(*domain);
}

/// Returns the area of a drawing on a page of 100 by 100.
double areaOnPage(const std::string &content) {
    const auto domain = readSvg(sourceOf("<svg viewBox=\"0 0 100 100\">" + content + "</svg>"));
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    return enclosedArea(*domain);
}

} // namespace

TEST_CASE("SVG: a path ends where its data can no longer be read") {
    CHECK(areaWithout("<path d=\"M1 1h2v2h-2z M5 5 L2 x\"/>", "bad-path") == doctest::Approx(8.0));
    CHECK(areaWithout("<path d=\"M1 1h2v2 -x\"/>", "bad-path") == doctest::Approx(6.0));
    CHECK(areaWithout("<path d=\"M1 1h2v2 A1 1 0 2 0 3 3\"/>", "bad-path") == doctest::Approx(6.0));
    CHECK(areaWithout("<path d=\"M1 1h2v2 1e999 0 Z\"/>", "bad-path") == doctest::Approx(6.0));
    CHECK(areaWithout("<path d=\"M1 1h2v2,, h-2z\"/>", "bad-path") == doctest::Approx(6.0));
    CHECK(areaWithout("<path d=\"L1 1\"/>", "bad-path") == doctest::Approx(4.0));
    CHECK(areaWithout("<polygon points=\"1 1 3 1 3 3 2\"/>", "bad-path") == doctest::Approx(6.0));
}

TEST_CASE("SVG: invalid lengths are 0, and shapes of size 0 disappear") {
    for (const char *shape :
         {"<circle r=\"5furlongs\"/>", "<circle r=\"nan\"/>", "<circle cx=\"1\" cy=\"1\" r=\"1 2\"/>",
          "<rect width=\"wide\" height=\"1\"/>", "<ellipse rx=\"1e999\"/>"}) {
        CAPTURE(shape);
        CHECK(areaWithout(shape, "bad-number") == doctest::Approx(4.0));
    }
    CHECK(areaWithout("<rect x=\"left\" width=\"1\" height=\"1\"/>", "bad-number") == doctest::Approx(5.0));
    CHECK(areaWithout("<ellipse cx=\"3\" cy=\"3\" rx=\"1\" ry=\"1e999\"/>", "bad-number") ==
          doctest::Approx(7.1416).epsilon(3e-3)); // as large as the other radius
}

TEST_CASE("SVG: a nested drawing without a valid size fills its parent, one of size 0 shows nothing") {
    const std::string inside = "viewBox=\"0 0 5 5\"><rect width=\"1\" height=\"1\"/></svg>";
    CHECK(areaWithout("<svg width=\"foo\" height=\"5\" " + inside, "bad-number") == doctest::Approx(5.0));
    const auto area = [&](const std::string &size) {
        const auto domain = readSvg(sourceOf(withSquare("<svg " + size + " " + inside)));
        REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
        return enclosedArea(*domain);
    };
    CHECK(area("width=\"auto\"") == doctest::Approx(8.0));
    CHECK(area("width=\"0\"") == doctest::Approx(4.0));
}

TEST_CASE("SVG: shapes beyond the range of coordinates are left out") {
    CHECK(areaWithout("<g transform=\"scale(1e200) scale(1e150)\"><rect width=\"1\" height=\"1\"/></g>",
                      "out-of-range") == doctest::Approx(4.0));
}

TEST_CASE("SVG: very many notes that differ are counted together") {
    std::string content;
    for (int k = 0; k < 1000; ++k) {
        content += "<rect width=\"1\" height=\"1\" clip-path=\"url(#c" + std::to_string(k) + ")\"/>";
    }
    const std::string text = withSquare(content);
    ImportNotes notes;
    SourceText source = sourceOf(text);
    source.notes = &notes;
    REQUIRE(readSvg(source).ok());
    CHECK(notes.entries().size() < 210);
    std::size_t count = 0;
    for (const ImportNote &note : notes.entries()) {
        count += note.code == "svg-clip-path" ? note.count : 0;
    }
    CHECK(count == 1000);
}

TEST_CASE("SVG: invalid transforms are ignored") {
    for (const char *attribute : {"transform=\"turn(3)\"", "style=\"transform: matrix3d(1)\"",
                                  "transform=\"scale(1)\" transform-origin=\"somewhere\""}) {
        CAPTURE(attribute);
        CHECK(areaWithout("<g " + std::string(attribute) + "><rect width=\"1\" height=\"1\"/></g>", "bad-transform") ==
              doctest::Approx(5.0));
    }
}

TEST_CASE("SVG: copies inside of what they copy are ignored") {
    CHECK(areaWithout("<g id=\"a\"><use href=\"#a\" x=\"3\"/><rect width=\"1\" height=\"1\"/></g>", "use-cycle") ==
          doctest::Approx(5.0));
    CHECK(areaWithout("<defs><g id=\"a\"><use href=\"#b\"/></g><g id=\"b\"><use href=\"#a\"/></g></defs>"
                      "<use href=\"#a\"/>",
                      "use-cycle") == doctest::Approx(4.0));
}

TEST_CASE("SVG: a malformed view box is reported") {
    for (const char *box : {"0 0 100", "0 0 0 0", "none"}) {
        CAPTURE(box);
        ImportNotes notes;
        const std::string text = "<svg viewBox=\"" + std::string(box) + "\">" + kSquare + "</svg>";
        SourceText source = sourceOf(text);
        source.notes = &notes;
        REQUIRE(readSvg(source).ok());
        REQUIRE(notes.entries().size() == 1);
        CHECK(notes.entries().front().code == "bad-view-box");
        source.options.strict = true;
        CHECK_FALSE(readSvg(source).ok());
    }
}

TEST_CASE("SVG: the note gives the place inside the attribute") {
    const std::string text = withSquare("<path id=\"x\" d=\"M1 1 L2 x\"/>");
    ImportNotes notes;
    SourceText source = sourceOf(text, "faulty.svg");
    source.notes = &notes;
    REQUIRE(readSvg(source).ok());
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries().front().column == 25);
    CHECK(notes.entries().front().message == "expected a number for path command L; the rest of the path is ignored");
}

TEST_CASE("SVG: lengths in units of the font") {
    CHECK(areaOnPage("<rect width=\"1em\" height=\"2EX\"/>") == doctest::Approx(256.0));
    CHECK(areaOnPage("<g font-size=\"10\"><rect width=\"1em\" height=\"2ch\"/></g>") == doctest::Approx(100.0));
    CHECK(
        areaOnPage("<g style=\"font-size:10px\"><g font-size=\"50%\"><rect width=\"1em\" height=\"1rem\"/></g></g>") ==
        doctest::Approx(80.0));
    CHECK(areaOnPage("<g font-size=\"2em\"><rect width=\"1em\" height=\"101.6q\"/></g>") ==
          doctest::Approx(32.0 * 96.0));
}

TEST_CASE("SVG: style sheets set sizes, places and path data") {
    CHECK(areaOnPage("<rect width=\"2\" height=\"2\" style=\"width:40px;height:30px\"/>") == doctest::Approx(1200.0));
    CHECK(areaOnPage("<style>circle{cx:30px;cy:30px;r:10px}</style><circle r=\"2\"/>") ==
          doctest::Approx(314.16).epsilon(3e-3));
    CHECK(areaOnPage("<path style=\"d:path('M0 0h10v10h-10z')\"/>") == doctest::Approx(100.0));
    CHECK(areaOnPage("<ellipse cx=\"50\" cy=\"50\" rx=\"10\"/>") == doctest::Approx(314.16).epsilon(3e-3));
    CHECK(areaOnPage("<ellipse cx=\"50\" cy=\"50\" rx=\"auto\" ry=\"10\"/>") == doctest::Approx(314.16).epsilon(3e-3));
    CHECK(areaOnPage("<rect width=\"10\" height=\"10\" rx=\"auto\" ry=\"5\"/>") ==
          doctest::Approx(78.54).epsilon(3e-3));
}

TEST_CASE("SVG: entities of the document type are replaced") {
    const auto read = [](const std::string &definitions, const std::string &content) {
        return readSvg(sourceOf("<?xml version=\"1.0\"?><!DOCTYPE svg PUBLIC \"a\" \"b\" [" + definitions +
                                "]><svg viewBox=\"0 0 10 10\">" + content + "</svg>"));
    };
    const auto styled = read("<!ENTITY st0 \"fill:none;\">\n<!ENTITY st1 'width:2px;&st2;'><!ENTITY st2 \"fill:red\">",
                             "<rect width=\"5\" height=\"5\" style=\"&st0;\"/><rect height=\"2\" style=\"&st1;\"/>");
    REQUIRE_MESSAGE(styled.ok(), messages(styled.faults()));
    CHECK(enclosedArea(*styled) == doctest::Approx(4.0));
    std::string bomb = "<!ENTITY e0 \"0123456789\">";
    for (int k = 1; k < 9; ++k) {
        const std::string before = "&e" + std::to_string(k - 1) + ";";
        bomb += "<!ENTITY e" + std::to_string(k) + " \"";
        for (int copy = 0; copy < 10; ++copy) {
            bomb += before;
        }
        bomb += "\">";
    }
    const auto refused = read(bomb, "<rect width=\"1\" height=\"1\" id=\"&e8;&e8;&e8;&e8;\"/>");
    CHECK((!refused.ok() && hasCode(refused.faults(), "too-large")));
    CHECK(read("<!ENTITY a \"&a;\">", "<rect width=\"1\" height=\"1\" id=\"&a;&b;& c\"/>").ok());
    const std::string box = "<!ENTITY size \"width='2' height='2'\"><!ENTITY box \"<rect id='box' &size;/>\">";
    const auto drawn = read(box + "<!ENTITY all \"&box;<use href='#box' x='5'/>\">",
                            "<g>before &all; after</g><g transform=\"translate(0 5)\">&box;</g>");
    REQUIRE_MESSAGE(drawn.ok(), messages(drawn.faults()));
    CHECK(enclosedArea(*drawn) == doctest::Approx(12.0));
    const auto open = read("<!ENTITY open \"<rect width='2' height='2'>\">", "<g>&open;</g>");
    CHECK((!open.ok() && hasCode(open.faults(), "xml-syntax")));
    CHECK_FALSE(read(box, "<!-- &box; --><style>&box;</style>").ok());
    // Only entities bring elements, not text in which they are written out.
    const auto escaped = read(box + "<!ENTITY a \"b\">", "<g>&lt;rect width=\"5\" height=\"5\"/&gt; &a;</g>"
                                                         "<g>3 &lt; 4 &amp; &box;</g>");
    REQUIRE_MESSAGE(escaped.ok(), messages(escaped.faults()));
    CHECK(enclosedArea(*escaped) == doctest::Approx(4.0));
}

TEST_CASE("SVG: transforms of CSS, with units and origin") {
    const auto corner = [](const std::string &attributes) {
        const auto domain =
            readSvg(sourceOf("<svg viewBox=\"0 0 10 20\"><rect width=\"1\" height=\"1\" " + attributes + "/></svg>"));
        REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
        return domain->bounds().max;
    };
    CHECK(corner("style=\"transform: translate(2px, 10%)\"") == Vec2{3, 18});
    CHECK(corner("transform=\"translate(5 0)\" style=\"transform: translateY(3px)\"") == Vec2{1, 17});
    CHECK(distance(corner("style=\"transform: rotate(180deg); transform-origin: 50% 50%\""), {10, 1}) < 1e-12);
    CHECK(distance(corner("style=\"transform: translate(50%, 0) scale(2); transform-box: fill-box; transform-origin: "
                          "center\""),
                   {2.0, 20.0}) < 1e-12);
    CHECK(distance(corner("transform=\"scale(.5)\" transform-origin=\"1 1\""), {1, 19.5}) < 1e-12);
}

TEST_CASE("files: empty and compressed files of any format are refused") {
    const TemporaryFolder folder;
    for (const char *name : {"a.svg", "a.svgz", "a.geojson", "a.poly", "a.unknown"}) {
        CAPTURE(name);
        std::ofstream(folder / name, std::ios::binary).flush();
        CHECK(hasCode(allFormats().readDomain(folder / name).faults(), "empty-file"));
        std::ofstream(folder / name, std::ios::binary) << "\x1f\x8b\x08 packed";
        const auto packed = allFormats().readDomain(folder / name);
        CHECK(hasCode(packed.faults(), "compressed"));
        CHECK(packed.faults().front().advice.find("gunzip") != std::string::npos);
    }
}

TEST_CASE("SVG: what was left out follows the fault of an empty drawing") {
    const TemporaryFolder folder;
    const auto path = folder / "empty.svg";
    std::ofstream(path) << "<svg viewBox=\"0 0 10 10\"><rect width=\"x\" height=\"1\"/><text>a</text></svg>";
    ImportNotes notes;
    const auto domain = allFormats().readDomain(path, {}, &notes);
    REQUIRE_FALSE(domain.ok());
    REQUIRE(domain.faults().size() == 3);
    CHECK(domain.faults().front().code == "empty-domain");
    CHECK(hasCode(domain.faults(), "bad-number"));
    CHECK(hasCode(domain.faults(), "svg-element"));
}
