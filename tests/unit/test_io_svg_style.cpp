#include "core/drawing_files/svg/style/svg_css.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/svg_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::set<std::string> namesIn(const Domain &domain) {
    std::set<std::string> names;
    for (const DomainSegment &segment : domain.segments) {
        names.insert(boundaryName(domain.boundaryNames, segment.tag));
    }
    return names;
}

/// Returns the names of the squares that are read from a drawing with the squares a to f.
std::set<std::string> visible(const std::string &style, const std::string &attributes) {
    std::string content = "<style>" + style + "</style>\n";
    for (const char id : {'a', 'b', 'c'}) {
        content += std::string("<g ") + (id == 'b' ? attributes : "") + "><rect id=\"" + id + "\" class=\"part x-" +
                   id + "\" x=\"" + std::to_string(3 * (id - 'a')) + "\" width=\"2\" height=\"2\"/></g>\n";
    }
    return namesIn(svgDomain(svgDrawing(content)));
}

Vec2 sizeOf(const Domain &domain) {
    return domain.bounds().size();
}

} // namespace

TEST_CASE("SVG: leaves out shapes hidden by attribute, style or style sheet") {
    const std::set<std::string> all{"a", "b", "c"}, withoutB{"a", "c"};
    CHECK(visible("", "") == all);
    for (const char *attributes :
         {"display=\"none\"", "style=\"display: none\"", "style=\"fill:red; DISPLAY : none ;\"",
          "visibility=\"hidden\"", "style=\"visibility: collapse\""}) {
        CAPTURE(attributes);
        CHECK(visible("", attributes) == withoutB);
    }
    for (const char *style :
         {".x-b { display: none }", "#b{visibility:hidden}", "rect.part.x-b, #none { display:none; }",
          "/* all */ rect { display: none } .x-a, .x-c { display: inline }",
          "<![CDATA[ #b { display: none !important } ]]>",
          "@media print { #a { display: none } } "
          "#b{display:none}"}) {
        CAPTURE(style);
        CHECK(visible(style, "") == withoutB);
    }
    CHECK(visible("rect + rect { display: none } rect:hover { display: none } part { display: none }", "") == all);
    CHECK(visible("rect { visibility: visible }", "visibility=\"hidden\"") == all);
}

TEST_CASE("SVG: style sheets select elements inside of others") {
    const auto shown = [](const std::string &selector) {
        return namesIn(
            svgDomain(svgDrawing("<style>" + selector +
                                 " { display: none }</style><g class=\"a\"><g class=\"b\"><g class=\"a\">"
                                 "<rect id=\"deep\" width=\"1\" height=\"1\"/></g></g></g>"
                                 "<g id=\"other\"><rect id=\"flat\" x=\"2\" width=\"1\" height=\"1\"/></g>")));
    };
    const std::set<std::string> both = {"deep", "flat"}, flat = {"flat"}, deep = {"deep"};
    for (const char *inside : {"g g g rect", ".a rect", ".a .a > rect", "svg > g.a > .b *", ".a>.b .a> rect",
                               "g > g > g > rect", ".b rect, #none rect"}) {
        CAPTURE(inside);
        CHECK(shown(inside) == flat);
    }
    CHECK(shown("#other > rect") == deep);
    for (const char *nowhere :
         {".b > rect", "rect g", "g g g g rect", ".b .b rect", ".b > .b rect", "> rect", "g > > rect", "g >"}) {
        CAPTURE(nowhere);
        CHECK(shown(nowhere) == both);
    }
    // The more exact selector wins, wherever it stands.
    CHECK(namesIn(svgDomain(svgDrawing("<style>g .x { display: inline } .x { display: none }</style>"
                                       "<g><rect id=\"kept\" class=\"x\" width=\"1\" height=\"1\"/></g>"))) ==
          std::set<std::string>{"kept"});
}

TEST_CASE("SVG: style sheets have variables, and notes on rules within rules") {
    const auto shown = [](const std::string &sheet, const std::string &attributes, ImportNotes *notes = nullptr) {
        return namesIn(svgDomain(svgDrawing("<style>" + sheet +
                                            "</style><rect id=\"kept\" width=\"1\" height=\"1\"/><g " + attributes +
                                            "><rect id=\"b\" class=\"b\" x=\"2\" width=\"1\" height=\"1\"/></g>"),
                                 notes))
                   .count("b") == 1;
    };
    CHECK_FALSE(shown(":root { --shown: none } .b { display: var(--shown) }", ""));
    CHECK_FALSE(shown(".b { display: var(--SHOWN, none) }", "style=\"--other: inline\""));
    CHECK_FALSE(shown(".b { display: var(--a, var(--b, none)) }", ""));
    CHECK(shown(":root { --shown: none } .b { display: var( --shown ) }", "style=\"--shown: inline\""));
    CHECK(shown(".b { display: var(--unknown) }", ""));
    CHECK(shown(":root { --a: var(--b); --b: var(--a) } .b { display: var(--a) }", ""));
    ImportNotes notes;
    CHECK(shown("g { fill: red; .b { display: none } }", "", &notes));
    REQUIRE(notes.entries().size() == 2);
    CHECK(notes.entries()[0].code == "svg-style");
    CHECK(notes.entries()[1].code == "svg-regions");
}

TEST_CASE("SVG: many classes do not outweigh an id") {
    std::string many;
    for (int k = 0; k < 150; ++k) {
        many += ".x";
    }
    CHECK(namesIn(svgDomain(svgDrawing("<style>" + many +
                                       " { display: none } #a { display: inline }</style>"
                                       "<rect id=\"a\" class=\"x\" width=\"1\" height=\"1\"/>"))) ==
          std::set<std::string>{"a"});
}

TEST_CASE("SVG: the attribute style wins over a style sheet, and !important over both") {
    const auto shown = [](const std::string &sheet, const std::string &style) {
        return namesIn(svgDomain(svgDrawing("<style>" + sheet +
                                            "</style><rect id=\"a\" width=\"1\" height=\"1\"/>"
                                            "<rect id=\"b\" x=\"2\" width=\"1\" height=\"1\" style=\"" +
                                            style + "\"/>")))
                   .count("b") == 1;
    };
    CHECK(shown("#b { display: none }", "display: block"));
    CHECK_FALSE(shown("#b { display: none !important }", "display: block"));
    CHECK(shown("#b { display: block } rect { }", ""));
    CHECK(shown("rect { display: none } #a, #b { display: block }", ""));
}

TEST_CASE("SVG: <use> draws copies of shapes, groups, symbols and other copies at the right positions") {
    const Domain copies = svgDomain(svgDrawing("<defs><g id=\"pair\"><rect id=\"one\" width=\"1\" height=\"1\"/>"
                                               "<use href=\"#one\" x=\"2\"/></g></defs>"
                                               "<use xlink:href=\"#pair\" y=\"2\"/>"
                                               "<use href=\"#pair\" transform=\"scale(2)\" x=\"1\" y=\"2\"/>"));
    CHECK(copies.segments.size() == 16);
    CHECK(sizeOf(copies) == Vec2{8, 4}); // from (0, 2) to (8, 6)
    const Domain symbol =
        svgDomain(svgDrawing("<symbol id=\"s\" viewBox=\"0 0 4 4\"><rect width=\"4\" height=\"2\"/></symbol>"
                             "<use id=\"left\" href=\"#s\" width=\"2\" height=\"2\"/>"));
    CHECK(sizeOf(symbol) == Vec2{2, 1});
    const Domain named = svgDomain(svgDrawing("<defs><rect id=\"r\" width=\"1\" height=\"1\"/></defs>"
                                              "<use id=\"inlet\" href=\"#r\"/><use href=\"#r\" x=\"3\"/>"));
    CHECK(namesIn(named) == std::set<std::string>{"inlet", "r"});
}

TEST_CASE("SVG: refuses copies that multiply without limit") {
    std::string bomb = "<defs><rect id=\"a0\" width=\"1\" height=\"1\"/>";
    for (int k = 1; k < 40; ++k) {
        const std::string below = "<use href=\"#a" + std::to_string(k - 1) + "\"/>";
        bomb += "<g id=\"a" + std::to_string(k) + "\">" + below + below + "</g>";
    }
    const auto domain = readSvg(sourceOf(svgDrawing(bomb + "</defs><use href=\"#a39\"/>")));
    REQUIRE_FALSE(domain.ok());
    CHECK(hasCode(domain.faults(), "too-large"));
}

TEST_CASE("SVG: draws the first supported child of a <switch>") {
    const Domain domain = svgDomain(svgDrawing("<switch><foreignObject/><g requiredExtensions=\"http://example.org\">"
                                               "<rect width=\"9\" height=\"9\"/></g><g systemLanguage=\"de\">"
                                               "<rect width=\"8\" height=\"8\"/></g><rect width=\"2\" height=\"3\"/>"
                                               "<rect width=\"7\" height=\"7\"/></switch>"));
    CHECK(sizeOf(domain) == Vec2{2, 3});
}

TEST_CASE("SVG: elements for other languages or extensions are not drawn") {
    ImportNotes notes;
    const std::string others = "<rect requiredExtensions=\"http://example.org\" width=\"9\" height=\"9\"/>"
                               "<g systemLanguage=\"de, den\"><rect width=\"8\" height=\"8\"/></g>"
                               "<rect systemLanguage=\"\" width=\"7\" height=\"7\"/>";
    const std::string text = svgDrawing(others + "<rect systemLanguage=\"fr, EN-gb\" width=\"2\" height=\"3\"/>");
    SourceText source = sourceOf(text);
    source.notes = &notes;
    const auto domain = readSvg(source);
    REQUIRE(domain.ok());
    CHECK(sizeOf(*domain) == Vec2{2, 3});
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].code == "svg-hidden");
    CHECK(notes.entries()[0].count == 3);
}

TEST_CASE("SVG: a document in millimetres gives millimetres, for any view box") {
    const std::string rect = "<rect width=\"200\" height=\"100\"/>";
    const auto size = [&](const std::string &attributes) { return sizeOf(svgDomain(svgDrawing(rect, attributes))); };
    CHECK(size("width=\"50mm\" height=\"25mm\" viewBox=\"0 0 200 100\"") == Vec2{50, 25});
    CHECK(size("width=\"5cm\" viewBox=\"0 0 200 100\"") == Vec2{5, 2.5});
    CHECK(size("width=\"400\" height=\"200\" viewBox=\"0 0 200 100\"") ==
          Vec2{200, 100}); // pixels are not a physical unit
    CHECK(size("width=\"100%\" viewBox=\"0 0 200 100\"") == Vec2{200, 100});
    CHECK(size("width=\"50mm\" height=\"50mm\" viewBox=\"0 0 200 100\"") == Vec2{50, 25});
    CHECK(size("width=\"50mm\" height=\"50mm\" preserveAspectRatio=\"none\" viewBox=\"0 0 200 100\"") == Vec2{50, 50});
    // Without a view box a user unit is 1/96 of an inch.
    const Domain plain =
        svgDomain(svgDrawing("<rect width=\"30mm\" height=\"1cm\"/>", "width=\"60mm\" height=\"60mm\""));
    CHECK(sizeOf(plain).x == doctest::Approx(30.0));
    CHECK(sizeOf(plain).y == doctest::Approx(10.0));
    // A percentage is one of the view box.
    CHECK(sizeOf(svgDomain(svgDrawing("<rect width=\"50%\" height=\"10%\"/>", "viewBox=\"0 0 40 20\""))) ==
          Vec2{20, 2});
}

TEST_CASE("SVG: reports unused content once per kind with its count") {
    ImportNotes notes;
    svgDomain(svgDrawing("<style>g + rect { fill: red }</style>\n<text>Lake</text>\n<text>Sea</text>\n<image/>\n"
                         "<rect width=\"2\" height=\"2\" clip-path=\"url(#c)\" style=\"rotate: 3deg\"/>\n"
                         "<rect x=\"3\" width=\"2\" height=\"2\" display=\"none\"/>\n<use href=\"other.svg#a\"/>"),
              &notes);
    std::map<std::string, std::size_t> counts;
    for (const ImportNote &note : notes.entries()) {
        counts[note.code] += note.count;
        CHECK(note.file == "drawing.svg");
        CHECK(note.line > 1);
    }
    CHECK(counts == std::map<std::string, std::size_t>{{"svg-style", 1},
                                                       {"svg-element", 3},
                                                       {"svg-clip-path", 1},
                                                       {"svg-css-transform", 1},
                                                       {"svg-hidden", 1},
                                                       {"svg-use", 1}});
    const Diagnostics list = notes.diagnostics();
    const auto text = std::find_if(list.begin(), list.end(),
                                   [](const Diagnostic &d) { return d.message.find("<text>") != std::string::npos; });
    REQUIRE(text != list.end());
    CHECK(toString(*text) ==
          "drawing.svg:3:2: note: <text> is ignored: text has no outline; convert it to paths in the "
          "drawing program (2 times) [svg-element]");
}

TEST_CASE("SVG: a note says that filters are ignored") {
    ImportNotes notes;
    svgDomain(svgDrawing("<defs><filter id=\"f\"><feGaussianBlur stdDeviation=\"2\"/></filter></defs>"
                         "<g filter=\"url(#f)\"><rect width=\"2\" height=\"2\"/></g>"
                         "<rect x=\"3\" width=\"2\" height=\"2\" style=\"filter: drop-shadow(1px 1px black)\"/>"
                         "<rect x=\"6\" width=\"2\" height=\"2\" filter=\"none\"/>"),
              &notes);
    REQUIRE(notes.entries().size() == 1);
    CHECK(notes.entries()[0].code == "svg-filter");
    CHECK(notes.entries()[0].count == 2);
}

TEST_CASE("SVG: notes say that patterns count as solid, and that markers are ignored") {
    ImportNotes notes;
    const std::string definitions = "<defs><pattern id=\"p\" width=\"1\" height=\"1\"><rect width=\".5\"/></pattern>"
                                    "<marker id=\"m\"><rect width=\"9\" height=\"9\"/></marker></defs>";
    const std::string shapes = "<g fill=\"url(#p)\"><rect width=\"2\" height=\"2\"/>"
                               "<rect x=\"2.5\" width=\"1\" height=\"2\" fill=\"red\" marker-end=\"url(#m)\"/></g>"
                               "<path d=\"M4 0h2v2h-2z\" style=\"marker-mid: url(#m); marker-end: none\"/>"
                               "<path d=\"M8 0h2v2h-2z\" marker-end=\"url(#missing)\" marker=\"url(#m)\"/>";
    const Domain domain = svgDomain(svgDrawing(definitions + shapes), &notes);
    std::string codes;
    for (const ImportNote &note : notes.entries()) {
        codes += note.code + ' ' + std::to_string(note.count) + ' ';
    }
    CHECK(codes == "svg-pattern 1 svg-marker 1 ");
    CHECK(enclosedArea(domain) == doctest::Approx(14.0));
}
