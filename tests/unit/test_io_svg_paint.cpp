#include "core/drawing_files/svg/style/svg_colour.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "tests/unit/arrangement_support.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/svg_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// The area of a drawing of 100 by 100, and the codes of its notes.
struct Painted {
    double area = 0.0;
    std::set<std::string> notes;
};

Painted paint(const std::string &content) {
    const std::string text = "<svg viewBox=\"0 0 100 100\">\n" + content + "\n</svg>\n";
    ImportNotes notes;
    SourceText source = sourceOf(text, "drawing.svg");
    source.notes = &notes;
    const auto domain = readSvg(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    Painted painted{areas(*domain).at(1), {}};
    for (const ImportNote &note : notes.entries()) {
        painted.notes.insert(note.code);
    }
    return painted;
}

const std::string kRect = "<rect x=\"5\" y=\"50\" width=\"10\" height=\"10\"/>";

} // namespace

TEST_CASE("SVG paint: a polyline without a stroke is filled by default; with one it is a line, with a note") {
    const std::string points = "points=\"60,10 90,10 90,40\"";
    CHECK(paint(kRect + "<polyline " + points + "/>").area == doctest::Approx(550));
    CHECK(paint("<polyline " + points + "/>").area == doctest::Approx(450));
    CHECK(paint(kRect + "<polyline fill=\"none\" " + points + "/>").area == doctest::Approx(100));
    const Painted stroked = paint(kRect + "<polyline stroke=\"red\" " + points + "/>");
    CHECK(stroked.area == doctest::Approx(100));
    CHECK(stroked.notes.count("svg-polyline") == 1);
    CHECK(paint(kRect + "<polyline stroke=\"red\" fill=\"none\" " + points + "/>").notes.count("svg-polyline") == 0);
}

TEST_CASE("SVG paint: what is no paint is ignored, so that an element inherits") {
    const auto square = [](const std::string &fill) {
        return "<rect x=\"50\" width=\"30\" height=\"30\" fill=\"" + fill + "\"/>";
    };
    for (const char *valid : {"red", "RED", "RebeccaPurple", "yellowgreen", "#1a2", "#1A2f", "#11aa22", "#11AA22ff",
                              "initial", "rgb(1, 2, 3)", "hsl(1 2% 3%)", "color(srgb 1 0 0)", "#CD853F icc-color(a, 1)",
                              "currentColor", "URL(#g)", "url( '#g' ) none"}) {
        CAPTURE(std::string(valid));
        CHECK(paint("<linearGradient id=\"g\"><stop/></linearGradient>" + kRect + "<g fill=\"none\">" + square(valid) +
                    "</g>")
                  .area == doctest::Approx(1000));
    }
    for (const char *invalid :
         {"undefined", "null", "#12", "#ggg", "#12345", "red;", "rouge", "0", "inherit", "none"}) {
        CAPTURE(std::string(invalid));
        CHECK(paint(kRect + "<g fill=\"none\">" + square(invalid) + "</g>").area == doctest::Approx(100));
    }
    for (const char *both : {R"(fill="red" style="fill: rouge")", R"(style="fill: red; fill: rouge")"}) {
        CHECK(paint(kRect + "<g fill=\"none\"><rect x=\"50\" width=\"30\" height=\"30\" " + both + "/></g>").area ==
              doctest::Approx(1000));
    }
    CHECK(paint(kRect + square("undefined")).area == doctest::Approx(1000)); // black from the start
}

TEST_CASE("SVG paint: a mask that shows in part is reported, however much it shows") {
    const auto masked = [](const std::string &shade) {
        return paint("<mask id=\"m\"><rect width=\"100\" height=\"100\" " + shade + "/></mask>" +
                     "<rect width=\"100\" height=\"100\" mask=\"url(#m)\"/>");
    };
    CHECK(masked("fill=\"white\"").notes.count("svg-mask") == 0);
    for (const char *shade : {"fill=\"gray\"", "fill=\"#aaa\"", "fill=\"silver\"", "fill=\"white\" fill-opacity=\".6\"",
                              "fill=\"#7f7f7f\"", "fill=\"#333\""}) {
        CAPTURE(std::string(shade));
        const Painted painted = masked(shade);
        CHECK(painted.notes.count("svg-mask") == 1);
        CHECK(painted.area == doctest::Approx(10000));
    }
}

TEST_CASE("SVG paint: hsl(), and references to gradients and patterns that do not exist or paint nothing") {
    const auto area = [](const std::string &fill) {
        const auto domain = readSvg(
            sourceOf("<svg viewBox=\"0 0 10 10\"><linearGradient id=\"Known\"><stop/></linearGradient>"
                     "<radialGradient id=\"same\" href=\"#Known\"/><linearGradient id=\"empty\" href=\"#dots\"/>"
                     "<linearGradient id=\"a\" href=\"#b\"/><linearGradient id=\"b\" href=\"#a\"/>"
                     "<linearGradient id=\"clear\"><stop stop-opacity=\"0\"/><stop style=\"stop-color:#f000\"/>"
                     "</linearGradient><linearGradient id=\"fades\"><stop stop-opacity=\"0\"/><stop/></linearGradient>"
                     "<pattern id=\"dots\"><circle id=\"dot\" r=\"1\"/></pattern><pattern id=\"plain\"/>"
                     "<pattern id=\"more\" href=\"#dots\"/><rect width=\"1\" height=\"1\"/>"
                     "<rect x=\"2\" width=\"2\" height=\"2\" fill=\"" +
                     fill + "\"/></svg>"));
        REQUIRE(domain.ok());
        double twice = 0.0;
        for (const DomainSegment &segment : domain->segments) {
            twice += cross(domain->nodes[segment.a], domain->nodes[segment.b]);
        }
        return 0.5 * std::fabs(twice);
    };
    for (const char *none :
         {"url(#no)", "url(#no) none", "url(#known)", "url(#empty)", "url(#empty) red", "url(#a)", "url(#clear)",
          "url(#dot)", "url(#plain)", "hsla(0, 0%, 0%, 0)", "hsl(120deg 50% 50% / 0%)"}) {
        CAPTURE(none);
        CHECK(area(none) == doctest::Approx(1.0));
    }
    for (const char *some : {"url(#Known)", "url(#same)", "url(#fades)", "url(#dots)", "url(#more)", "url(#no) red",
                             "url(#dot) red", "url('#Known') none", "hsl(0,100%,50%)", "hsl(nothing)"}) {
        CAPTURE(some);
        CHECK(area(some) == doctest::Approx(5.0));
    }
    CHECK(parseColour("hsl(0, 0%, 0%)", {}).luminance == doctest::Approx(0.0));
    CHECK(parseColour("hsl(0, 0%, 100%)", {}).luminance == doctest::Approx(1.0));
    CHECK(parseColour("hsl(120, 100%, 50%)", {}).luminance == doctest::Approx(0.7154));
    CHECK(parseColour("hsl(-120, 100%, 50%)", {}).luminance == doctest::Approx(0.0721));
}

TEST_CASE("SVG paint: many shapes with one gradient of many transparent stops take little time") {
    std::string text = "<svg viewBox=\"0 0 200 200\"><rect width=\"1\" height=\"1\"/><linearGradient id=\"clear\">";
    for (int k = 0; k < 20'000; ++k) {
        text += "<stop stop-opacity=\"0\"/>";
    }
    text += "</linearGradient>";
    for (int k = 0; k < 20'000; ++k) {
        text += "<rect width=\"9\" height=\"9\" fill=\"url(#clear)\"/>";
    }
    const auto domain = readSvg(sourceOf(text + "</svg>"));
    REQUIRE(domain.ok());
    CHECK(enclosedArea(*domain) == doctest::Approx(1.0));
}

TEST_CASE("SVG paint: a note says that gradients that fade to transparent count as solid") {
    const auto codesOf = [](const std::string &shape) {
        ImportNotes notes;
        const std::string gradients =
            "<linearGradient id=\"fades\"><stop/><stop offset=\"1\" stop-opacity=\"0\"/></linearGradient>"
            "<radialGradient id=\"same\" href=\"#fades\"/>"
            "<linearGradient id=\"nearly\"><stop/><stop offset=\"1\" stop-color=\"#fff2\" stop-opacity=\".1\"/>"
            "</linearGradient><linearGradient id=\"half\"><stop/><stop stop-opacity=\".5\"/></linearGradient>"
            "<linearGradient id=\"faint\"><stop stop-opacity=\"0\"/><stop stop-opacity=\".04\"/></linearGradient>";
        svgDomain(svgDrawing(gradients + "<path d=\"M0 0h1v1z\"/>" + shape), &notes);
        std::string codes;
        for (const ImportNote &note : notes.entries()) {
            codes += note.code + ' ' + std::to_string(note.count) + ' ';
        }
        return codes;
    };
    for (const char *fill : {"url(#fades)", "url(#same)", "url(#nearly)"}) {
        CAPTURE(fill);
        const std::string group = "<g fill=\"" + std::string(fill) + "\">";
        CHECK(codesOf(group + "<path d=\"M2 2h1v1z\"/><path d=\"M4 4h1v1z\"/></g>") == "svg-gradient 2 ");
        CHECK(codesOf(group + "<path fill-opacity=\"0\" d=\"M2 2h1v1z\"/></g>").find("gradient") == std::string::npos);
        CHECK(codesOf("<clipPath id=\"c\">" + group +
                      "<path d=\"M2 2h1v1z\"/></g></clipPath>"
                      "<path d=\"M2 2h9v9z\" clip-path=\"url(#c)\"/>")
                  .find("gradient") == std::string::npos);
    }
    for (const char *fill : {"url(#half)", "url(#faint)", "#f008"}) {
        CAPTURE(fill);
        CHECK(codesOf("<path d=\"M2 2h1v1z\" fill=\"" + std::string(fill) + "\"/>").empty());
    }
}

TEST_CASE("SVG paint: a drawing of text alone is refused with what to do") {
    const auto refused = [](const std::string &text) {
        const auto domain = readSvg(sourceOf(text, "drawing.svg"));
        REQUIRE_FALSE(domain.ok());
        return domain.faults().front();
    };
    const Diagnostic text = refused("<svg viewBox=\"0 0 9 9\"><g><text x=\"1\" y=\"5\">only text</text></g></svg>");
    CHECK(text.code == "empty-domain");
    CHECK(text.advice.find("text to paths") != std::string::npos);
    CHECK(refused("<svg viewBox=\"0 0 9 9\"/>").advice.empty());
}

TEST_CASE("SVG paint: a drawing of symbols or glyphs alone is refused with the reason") {
    const auto messageOf = [](const std::string &content) {
        const auto domain = readSvg(sourceOf(svgDrawing(content), "drawing.svg"));
        REQUIRE_FALSE(domain.ok());
        return domain.faults().front().message;
    };
    const std::string start = "the drawing holds no path that could bound a domain";
    const std::string shapes = "<g><path d=\"M0 0h1v1z\"/></g><circle r=\"1\"/>";
    CHECK(messageOf("<symbol id=\"a\">" + shapes + "</symbol><defs><rect/></defs>") ==
          start + ": its 3 shapes are in symbols or definitions that nothing uses");
    CHECK(messageOf("<defs><path d=\"M0 0h1v1z\"/></defs>") ==
          start + ": its 1 shape is in symbols or definitions that nothing uses");
    CHECK(messageOf("<symbol id=\"a\" display=\"none\">" + shapes + "</symbol><use href=\"#a\"/>") == start);
    CHECK(messageOf("<defs><clipPath>" + shapes + "</clipPath><pattern>" + shapes + "</pattern></defs>") == start);
    CHECK(messageOf("<defs><font><glyph d=\"M0 0h1v1z\"/><glyph/><glyph d=\"M0 0h1v1z\"/></font></defs>") ==
          start + ": its 2 glyphs are of a font");
}
