#include "core/drawing_files/svg/svg.hpp"
#include "tests/unit/arrangement_support.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/svg_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

double areaOf(const std::string &content) {
    return areas(svgDomain(svgDrawing(content))).at(1);
}

bool notes(const std::string &content, const std::string &code) {
    ImportNotes found;
    svgDomain(svgDrawing(content), &found);
    return std::any_of(found.entries().begin(), found.entries().end(),
                       [&](const ImportNote &note) { return note.code == code; });
}

/// The area that is left of a square of side 10 by a clip path or mask with the id m.
double leftBy(const std::string &definition, const std::string &square = "clip-path=\"url(#m)\"") {
    return areaOf("<defs>" + definition + "</defs><rect width=\"10\" height=\"10\" " + square +
                  "/><rect id=\"far\" x=\"20\" width=\"1\" height=\"1\"/>") -
           1.0;
}

double maskedBy(const std::string &mask) {
    return leftBy(mask, "mask=\"url(#m)\"");
}

const std::string kHalf = "<clipPath id=\"m\"><rect width=\"5\" height=\"10\"/></clipPath>";
const std::string kRing = "M0 0H9V9H0ZM3 3H6V6H3Z"; // both squares run in the same direction

} // namespace

TEST_CASE("SVG clips: a clip path limits a shape, however it is given") {
    for (const char *given :
         {"clip-path=\"url(#m)\"", "clip-path=\"url('#m')\"", "style=\"clip-path: url(#m)\"", "class=\"cut\""}) {
        CAPTURE(given);
        CHECK(leftBy("<style>.cut { clip-path: url( \"#m\" ) }</style>" + kHalf, given) == doctest::Approx(50));
    }
    CHECK(leftBy("<clipPath id=\"M\"><rect width=\"1\" height=\"1\"/></clipPath>" + kHalf) == doctest::Approx(50));
    CHECK(leftBy(kHalf, "clip-path=\"none\"") == doctest::Approx(100));
}

TEST_CASE("SVG clips: the shapes of a clip path are united, each filled by its own clip rule") {
    CHECK(leftBy("<clipPath id=\"m\"><rect width=\"4\" height=\"4\"/><rect x=\"2\" width=\"4\" height=\"4\"/>"
                 "</clipPath>") == doctest::Approx(24));
    CHECK(leftBy("<clipPath id=\"m\"><path fill-rule=\"evenodd\" d=\"" + kRing + "\"/></clipPath>") ==
          doctest::Approx(81));
    CHECK(leftBy("<clipPath id=\"m\"><path clip-rule=\"evenodd\" d=\"" + kRing + "\"/></clipPath>") ==
          doctest::Approx(72));
    CHECK(leftBy("<g clip-rule=\"evenodd\"><clipPath id=\"m\"><path d=\"" + kRing +
                 "\"/><path clip-rule=\"nonzero\" d=\"M3 3H5V6H3Z\"/></clipPath></g>") == doctest::Approx(78));
}

TEST_CASE("SVG clips: clip paths of groups, copies and nested drawings meet in their intersection") {
    const std::string clips = kHalf + "<clipPath id=\"n\"><rect y=\"2\" width=\"10\" height=\"4\"/></clipPath>"
                                      "<rect id=\"s\" width=\"10\" height=\"10\"/>";
    const auto inside = [&](const std::string &content) { return areaOf("<defs>" + clips + "</defs>" + content); };
    CHECK(inside("<g clip-path=\"url(#m)\"><g clip-path=\"url(#n)\"><use href=\"#s\"/></g></g>") ==
          doctest::Approx(20));
    CHECK(inside("<g clip-path=\"url(#m)\"><use href=\"#s\" clip-path=\"url(#n)\"/></g>") == doctest::Approx(20));
    CHECK(inside("<svg clip-path=\"url(#m)\"><use href=\"#s\"/></svg>") == doctest::Approx(50));
    CHECK(inside("<use href=\"#s\" x=\"2\" clip-path=\"url(#m)\"/>") == doctest::Approx(50)); // moves with the copy
    CHECK(leftBy(clips + "<clipPath id=\"both\" clip-path=\"url(#n)\"><rect width=\"5\" height=\"10\"/></clipPath>",
                 "clip-path=\"url(#both)\"") == doctest::Approx(20));
    CHECK(leftBy(clips + "<clipPath id=\"both\"><rect width=\"5\" height=\"10\" clip-path=\"url(#n)\"/>"
                         "<rect x=\"9\" width=\"1\" height=\"10\"/></clipPath>",
                 "clip-path=\"url(#both)\"") == doctest::Approx(30));
}

TEST_CASE("SVG clips: clip paths hold copies, transforms and parts of the element's box") {
    CHECK(leftBy("<rect id=\"r\" width=\"2\" height=\"2\"/><clipPath id=\"m\"><use href=\"#r\" x=\"1\"/>"
                 "<use href=\"#r\" transform=\"translate(5 5) scale(2)\"/></clipPath>") == doctest::Approx(20));
    CHECK(leftBy("<clipPath id=\"m\" transform=\"scale(2)\"><rect width=\"3\" height=\"3\" "
                 "transform=\"translate(1 1)\"/></clipPath>") == doctest::Approx(36));
    CHECK(leftBy(kHalf, "transform=\"scale(.5)\" clip-path=\"url(#m)\"") == doctest::Approx(12.5));
    const std::string box = "<clipPath id=\"m\" clipPathUnits=\"objectBoundingBox\">"
                            "<rect x=\".5\" width=\".5\" height=\".25\"/></clipPath>";
    CHECK(leftBy(box) == doctest::Approx(12.5));
    CHECK(leftBy("<clipPath id=\"m\" clipPathUnits=\"objectBoundingBox\" transform=\"translate(3 0) scale(2)\">"
                 "<rect width=\".2\" height=\".25\"/></clipPath>") == doctest::Approx(20)); // 3 units of the drawing
    CHECK(areaOf("<defs>" + box +
                 "</defs><g clip-path=\"url(#m)\" transform=\"translate(3) scale(2)\">"
                 "<rect x=\"1\" width=\"1\" height=\"4\"/><circle cx=\"4\" cy=\"7\" r=\"1\"/></g>"
                 "<rect x=\"50\" width=\"1\" height=\"1\"/>") == doctest::Approx(1));
    const double cap = 4.0 * std::numbers::pi / 3.0 - std::sqrt(3.0); // of the box of the curve, not of its nodes
    CHECK(areaOf("<defs>" + box + "</defs><circle r=\"2\" clip-path=\"url(#m)\"/>") ==
          doctest::Approx(0.5 * cap).epsilon(0.01));
}

TEST_CASE("SVG clips: an empty clip path hides, hidden parts do not count, and unknown ones are ignored with a note") {
    CHECK(leftBy("<clipPath id=\"m\"/>") == doctest::Approx(0));
    CHECK(leftBy("<clipPath id=\"m\"><rect width=\"5\" height=\"5\"/><rect width=\"9\" height=\"9\" "
                 "display=\"none\"/><rect width=\"9\" height=\"9\" visibility=\"hidden\"/>"
                 "<g><rect width=\"9\" height=\"9\"/></g></clipPath>") == doctest::Approx(25));
    for (const char *clip : {"", "<g id=\"m\"/>", "<mask id=\"m\"/>"}) {
        CHECK(leftBy(clip) == doctest::Approx(100));
        CHECK(notes(std::string(clip) + "<rect width=\"2\" height=\"2\" clip-path=\"url(#m)\"/>", "svg-clip-path"));
    }
    CHECK_FALSE(notes(kHalf + "<rect width=\"7\" height=\"2\" clip-path=\"url(#m)\"/>", "svg-clip-path"));
}

TEST_CASE("SVG clips: clip paths and masks that refer to themselves are ignored with a note") {
    CHECK(notes("<clipPath id=\"m\" clip-path=\"url(#m)\"><rect width=\"1\" height=\"1\"/></clipPath>"
                "<rect width=\"2\" height=\"2\" clip-path=\"url(#m)\"/>",
                "svg-clip-path"));
    CHECK(notes("<clipPath id=\"m\"><rect width=\"1\" height=\"1\" clip-path=\"url(#n)\"/></clipPath>"
                "<clipPath id=\"n\"><rect width=\"1\" height=\"1\" clip-path=\"url(#m)\"/></clipPath>"
                "<rect width=\"2\" height=\"2\" clip-path=\"url(#m)\"/>",
                "svg-clip-path"));
    CHECK(notes("<mask id=\"m\"><use href=\"#g\"/></mask><g id=\"g\" fill=\"#fff\" mask=\"url(#m)\">"
                "<rect width=\"2\" height=\"2\"/></g>",
                "svg-mask"));
    std::string bomb = "<clipPath id=\"c0\"><rect width=\"1\" height=\"1\"/></clipPath>";
    for (int k = 1; k < 40; ++k) {
        const std::string below =
            "<path d=\"M0 0h1v1z\" transform=\"scale(2)\" clip-path=\"url(#c" + std::to_string(k - 1) + ")\"/>";
        bomb += "<clipPath id=\"c" + std::to_string(k) + "\">" + below +
                "<path d=\"M0 0h1v1z\" transform=\"translate(1)\" clip-path=\"url(#c" + std::to_string(k - 1) +
                ")\"/></clipPath>";
    }
    const std::string text = svgDrawing(bomb + "<rect width=\"1\" height=\"1\" clip-path=\"url(#c39)\"/>");
    const auto domain = readSvg(sourceOf(text));
    REQUIRE_FALSE(domain.ok());
    CHECK(hasCode(domain.faults(), "too-large"));
}

TEST_CASE("SVG clips: light shapes of a mask show, black ones hide what was painted before them") {
    CHECK(maskedBy("<mask id=\"m\"><rect width=\"8\" height=\"8\" fill=\"white\"/>"
                   "<rect width=\"4\" height=\"4\"/><rect width=\"2\" height=\"2\" fill=\"#D9D9D9\"/></mask>") ==
          doctest::Approx(64 - 16 + 4));
    CHECK(maskedBy("<rect id=\"r\" width=\"3\" height=\"3\"/><mask id=\"m\" fill=\"#fff\"><use href=\"#r\"/></mask>") ==
          doctest::Approx(9));
    CHECK(maskedBy("<g fill=\"#fff\"><mask id=\"m\"><g><path d=\"" + kRing +
                   "\" fill-rule=\"evenodd\"/></g></mask></g>") == doctest::Approx(72));
    for (const char *black : {"black", "#000", "#000000ff", "rgb(0, 0, 0)", "rgb(0%,0%,0%)", "currentColor"}) {
        CAPTURE(black);
        CHECK(maskedBy("<mask id=\"m\"><rect width=\"8\" height=\"8\" fill=\"red\"/><rect width=\"4\" height=\"4\" "
                       "fill=\"" +
                       std::string(black) + "\"/></mask>") == doctest::Approx(48));
    }
    CHECK(maskedBy("<mask id=\"m\"><rect width=\"8\" height=\"8\"/></mask>") == doctest::Approx(0));
}

TEST_CASE("SVG clips: every painted shape of an alpha mask shows") {
    for (const char *type : {"mask-type=\"alpha\"", "style=\"mask-type:alpha\""}) {
        CHECK(maskedBy(
                  "<mask id=\"m\" " + std::string(type) +
                  "><rect width=\"3\" height=\"3\"/><rect x=\"5\" width=\"3\" height=\"3\" fill=\"none\"/></mask>") ==
              doctest::Approx(9));
    }
}

TEST_CASE("SVG clips: a mask ends at its own region") {
    const std::string white = "<rect width=\"10\" height=\"10\" fill=\"#fff\"/></mask>";
    CHECK(maskedBy("<mask id=\"m\" maskUnits=\"userSpaceOnUse\" x=\"1\" y=\"1\" width=\"4\" height=\"6\">" + white) ==
          doctest::Approx(24));
    CHECK(maskedBy("<mask id=\"m\" x=\"0\" y=\"50%\" width=\".5\" height=\"1\">" + white) == doctest::Approx(25));
    CHECK(maskedBy("<mask id=\"m\">" + white) == doctest::Approx(100));
    CHECK(maskedBy("<mask id=\"m\" maskContentUnits=\"objectBoundingBox\"><rect width=\".5\" height=\".5\" "
                   "fill=\"#fff\"/></mask>") == doctest::Approx(25));
}

TEST_CASE("SVG clips: what is not plainly black or white in a mask is shown, and a note says so") {
    const auto mask = [](const std::string &attributes, const std::string &first = "") {
        return "<linearGradient id=\"g\"><stop/></linearGradient><mask id=\"m\">" + first +
               "<rect width=\"6\" height=\"6\" " + attributes + "/></mask>";
    };
    const std::string square = "<rect width=\"10\" height=\"10\" mask=\"url(#m)\"/>";
    for (const char *attributes : {"fill=\"url(#g)\"", "fill=\"#333\"", "fill=\"#fff\" opacity=\".2\"",
                                   "fill=\"#fff\" filter=\"url(#f)\"", "fill=\"#fff\" stroke=\"#fff\""}) {
        CAPTURE(attributes);
        CHECK(maskedBy(mask(attributes)) == doctest::Approx(36));
        CHECK(notes(mask(attributes) + square, "svg-mask"));
    }
    const std::string white = "<rect width=\"8\" height=\"8\" fill=\"#fff\"/>";
    CHECK(maskedBy(mask("fill-opacity=\".5\"", white)) == doctest::Approx(64));
    CHECK_FALSE(notes(mask("", white) + square, "svg-mask"));
}

TEST_CASE("SVG clips: boundary parts along a clip have the name of its shape, or of the clip path") {
    const auto namesIn = [](const std::string &content) {
        const Domain domain = svgDomain(svgDrawing(content));
        std::set<std::string> names;
        for (const DomainSegment &segment : domain.segments) {
            names.insert(boundaryName(domain.boundaryNames, segment.tag));
        }
        for (const auto &[tag, name] : domain.boundaryNames) {
            CHECK(names.count(name) == 1);
        }
        return names;
    };
    const std::string square = "<rect id=\"square\" width=\"8\" height=\"8\" clip-path=\"url(#c)\"/>";
    CHECK(namesIn("<clipPath id=\"c\"><rect width=\"5\" height=\"9\"/></clipPath>" + square) ==
          std::set<std::string>{"square", "c"});
    CHECK(namesIn("<clipPath id=\"c\"><rect id=\"half\" width=\"5\" height=\"9\"/></clipPath>" + square) ==
          std::set<std::string>{"square", "half"});
    CHECK(namesIn("<clipPath id=\"c\"><rect id=\"wide\" x=\"-1\" y=\"-1\" width=\"50\" height=\"90\"/></clipPath>" +
                  square) == std::set<std::string>{"square"});
}

TEST_CASE("SVG clips: lines are cut at their clip") {
    const Domain domain =
        svgDomain(svgDrawing(kHalf + "<rect width=\"10\" height=\"10\"/><path id=\"l\" d=\"M1 3H9\" fill=\"none\" "
                                     "stroke=\"red\" clip-path=\"url(#m)\"/>"));
    double length = 0.0;
    for (const DomainSegment &segment : domain.segments) {
        length +=
            segment.role == SegmentRole::Constraint ? distance(domain.nodes[segment.a], domain.nodes[segment.b]) : 0.0;
    }
    CHECK(length == doctest::Approx(4));
    CHECK(areaOf(kHalf + "<g clip-path=\"url(#m)\"><path fill=\"none\" stroke=\"red\" d=\"M1 1H7V7H1Z\"/></g>") ==
          doctest::Approx(24)); // closed lines are outlines
}

TEST_CASE("SVG clips: shapes that are imported apart are not clipped, and a note says so") {
    const std::string text = svgDrawing(kHalf + "<mask id=\"k\"/><rect width=\"9\" height=\"9\" clip-path=\"url(#m)\"/>"
                                                "<rect x=\"20\" width=\"9\" height=\"9\" mask=\"url(#k)\"/>");
    ImportNotes found;
    SourceText source = sourceOf(text, "drawing.svg");
    source.notes = &found;
    const auto shapes = readSvgShapes(source);
    REQUIRE(shapes.ok());
    CHECK(areas(*shapes).at(1) == doctest::Approx(162));
    std::set<std::string> codes;
    for (const ImportNote &note : found.entries()) {
        codes.insert(note.code);
    }
    CHECK(codes.count("svg-clip-path") == 1);
    CHECK(codes.count("svg-mask") == 1);
}

TEST_CASE("SVG clips: a nested drawing ends at its viewport unless it overflows visibly") {
    const std::string content = "><rect width=\"9\" height=\"2\"/></svg>";
    CHECK(areaOf("<svg width=\"5\" height=\"5\"" + content) == doctest::Approx(10));
    CHECK(areaOf("<svg width=\"5\" height=\"5\" overflow=\"visible\"" + content) == doctest::Approx(18));
    CHECK(areaOf("<symbol id=\"s\" viewBox=\"0 0 4 4\"><rect width=\"9\" height=\"4\"/></symbol>"
                 "<use href=\"#s\" width=\"2\" height=\"2\"/>") == doctest::Approx(4));
}

TEST_CASE("SVG: fully transparent paint is no paint") {
    for (const char *transparent : {"opacity=\"0\"", "fill-opacity=\"0\"", "style=\"fill-opacity:0%\"",
                                    "fill=\"rgba(9,9,9,0)\"", "fill=\"#12345600\"", "fill=\"transparent\""}) {
        CAPTURE(transparent);
        const std::string group = "<g " + std::string(transparent) + "><rect x=\"4\" width=\"3\" height=\"3\"/></g>";
        CHECK(areaOf("<rect width=\"2\" height=\"2\"/>" + group) == doctest::Approx(4));
    }
    CHECK(areaOf("<rect width=\"2\" height=\"2\" opacity=\".1\" fill-opacity=\"20%\"/>") == doctest::Approx(4));
}

TEST_CASE("SVG clips: a clip of thousands of shapes is read in about the time of its shapes") {
    std::string content = "<clipPath id=\"m\"><rect width=\"8000\" height=\"0.5\"/></clipPath>";
    constexpr int kShapes = 4000;
    for (int k = 0; k < kShapes; ++k) {
        content += "<rect x=\"" + std::to_string(2 * k) + "\" width=\"1\" height=\"1\" clip-path=\"url(#m)\"/>";
    }
    CHECK(areaOf(content) == doctest::Approx(0.5 * kShapes));
}
