#include "core/drawing_files/svg/svg.hpp"
#include "core/drawing_files/svg/values/svg_pen.hpp"
#include "core/drawing_files/svg/values/svg_transform.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "core/files/files.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/svg_samples.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace forefront;
using namespace forefront::testing;

namespace {

using std::numbers::pi;

std::string drawing(const std::string &content, const std::string &attributes = "viewBox=\"0 0 10 10\"") {
    return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">\n" + content +
           "\n</svg>\n";
}

Domain domainOf(const std::string &text, double tolerance = 0.0) {
    SourceText source = sourceOf(text);
    source.options.curveTolerance = tolerance;
    source.options.beyondPage = true;
    const auto domain = readSvg(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    return *domain;
}

Diagnostic faultOf(const std::string &text) {
    const auto domain = readSvg(sourceOf(text, "bad.svg"));
    REQUIRE(!domain.ok());
    CHECK(allLocated(domain.faults()));
    return domain.faults()[0];
}

} // namespace

TEST_CASE("SVG: the drawing is upright inside its view box") {
    const Domain domain = domainOf(drawing("<polygon points=\"1,2 4,2 1,6\"/>", "viewBox=\"0 0 10 20\""));
    REQUIRE(domain.nodes.size() == 3);
    CHECK(domain.nodes[0] == Vec2{1, 18});
    CHECK(domain.nodes[2] == Vec2{1, 14});
    CHECK(domainOf(drawing("<polygon points=\"1,2 4,2 1,6\"/>", "height=\"30\"")).nodes[0] == Vec2{1, 28});
}

TEST_CASE("SVG: all path commands, absolute and relative, with numbers run together") {
    const Domain domain = domainOf(drawing("<path d=\"M1 1h2v2H1zm4,0l2 0,0 2-2,0Z\"/>"));
    CHECK(domain.nodes.size() == 8);
    CHECK(domain.segments.size() == 8);
    CHECK(domain.segments[4].role == SegmentRole::Boundary);
    CHECK(domain.nodes[4] == Vec2{5, 9});
    const Domain compact = domainOf(drawing("<path d=\"M.5.5L1.5.5 1.5,1.5e0-.5.5z\"/>"));
    REQUIRE(compact.nodes.size() == 4);
    CHECK(compact.nodes[1] == Vec2{1.5, 9.5});
    CHECK(compact.nodes[3] == Vec2{-0.5, 9.5});
    const Domain lower = domainOf(drawing("<path d=\"M2 2c1 0 1 1 0 1s-1 1 0 1q1 1 0 2t0 1a1 1 0 1 1-1-1l-1 0z\"/>"));
    const Domain upper = domainOf(drawing("<path d=\"M2 2C3 2 3 3 2 3S1 4 2 4Q3 5 2 6T2 7A1 1 0 1 1 1 6L0 6Z\"/>"));
    REQUIRE(lower.nodes.size() == upper.nodes.size());
    CHECK(lower.nodes.size() > 40);
    for (std::size_t n = 0; n < lower.nodes.size(); ++n) {
        CHECK(distance(lower.nodes[n], upper.nodes[n]) < 1e-12);
    }
}

TEST_CASE("SVG: circles, ellipses and rounded rectangles keep their area within the tolerance") {
    CHECK(enclosedArea(domainOf(drawing("<circle cx=\"5\" cy=\"5\" r=\"2\"/>"), 1e-4)) ==
          doctest::Approx(4 * pi).epsilon(2e-4));
    CHECK(enclosedArea(domainOf(drawing("<ellipse rx=\"2\" ry=\"1\"/>"), 1e-4)) ==
          doctest::Approx(2 * pi).epsilon(2e-4));
    CHECK(enclosedArea(domainOf(drawing("<rect x=\"1\" width=\"4\" height=\"3\" rx=\"1\"/>"), 1e-4)) ==
          doctest::Approx(12 - 4 + pi).epsilon(2e-4));
    CHECK(enclosedArea(domainOf(drawing("<rect width=\"4\" height=\"3\"/>"))) == 12.0);
    const auto sized = [](const std::string &name, const std::string &radii) { // of 4 x 4
        return enclosedArea(domainOf(drawing("<" + name + " width=\"4\" height=\"4\" " + radii + "/>"), 1e-4));
    };
    for (const char *radii : {"rx=\"2\" ry=\"-1\"", "rx=\"-1\" ry=\"2\""}) { // a negative one counts as not given
        CHECK(sized("rect", radii) == doctest::Approx(4 * pi).epsilon(2e-4));
        CHECK(sized("ellipse", radii) == doctest::Approx(4 * pi).epsilon(2e-4));
    }
    CHECK(sized("rect", "rx=\"wide\" ry=\"2\"") == doctest::Approx(4 * pi).epsilon(2e-4));
    CHECK(sized("rect", "rx=\"-1\" ry=\"-1\"") == 16.0);
    CHECK(domainOf(drawing("<circle r=\"2\"/>"), 1e-5).nodes.size() >
          2 * domainOf(drawing("<circle r=\"2\"/>"), 1e-4).nodes.size());
}

TEST_CASE("SVG: transforms of groups and elements are combined, and hidden parts and definitions are left out") {
    const Domain domain = domainOf(
        drawing("<defs><rect width=\"1\" height=\"1\"/></defs><g transform=\"translate(2 3) scale(2)\">"
                "<rect transform=\"rotate(90)\" width=\"1\" height=\"2\"/></g>"
                "<g style=\"fill:red;display:none\"><circle r=\"1\"/></g><g display=\"none\"><circle r=\"1\"/></g>"));
    REQUIRE(domain.nodes.size() == 4);
    CHECK(enclosedArea(domain) == doctest::Approx(8.0));
    CHECK(distance(domain.nodes[0], {2, 7}) < 1e-12);
    CHECK(distance(domain.nodes[1], {2, 5}) < 1e-12);
    CHECK(distance(domain.nodes[3], {-2, 7}) < 1e-12);
}

TEST_CASE("SVG: elements may have any prefix that stands for SVG; those of other namespaces are private") {
    const std::string shapes = "<a:g id=\"g\"><a:path d=\"M1 1h2v2h-2z\"/><b:path d=\"M5 1h2v2h-2z\"/></a:g>"
                               "<a:use b:href=\"#g\" y=\"4\"/><svg:path d=\"M5 5h2v2h-2z\"/>"
                               "<c:path xmlns:c=\"http://www.w3.org/2000/svg\" d=\"M8 8h1v1h-1z\"/>";
    const std::string text = "<?xml version=\"1.0\"?><!DOCTYPE svg>\n<a:svg xmlns:a=\"http://www.w3.org/2000/svg\" "
                             "xmlns:b=\"http://www.w3.org/1999/xlink\" viewBox=\"0 0 10 10\">" +
                             shapes + "</a:svg>";
    CHECK(looksLikeSvg(text));
    CHECK(enclosedArea(domainOf(text)) == doctest::Approx(13.0));
    CHECK(looksLikeSvg("<svg width=\"1\">"));
    for (const char *const other : {"<html><b>svg</b>", "<a href=\"x:svg\">", "svg", "< a:svgs", "<!-- :svg -->"}) {
        CAPTURE(other);
        CHECK_FALSE(looksLikeSvg(other));
    }
}

TEST_CASE("SVG: transform lists are parsed") {
    const auto at = [](const char *text, Vec2 p) {
        const auto map = parseTransform(text, {10, 20});
        REQUIRE(map.has_value());
        return (*map)(p);
    };
    CHECK(at("", {1, 2}) == Vec2{1, 2});
    CHECK(at("matrix(1 2 3 4 5 6)", {1, 1}) == Vec2{9, 12});
    CHECK(at("translate(3)", {1, 1}) == Vec2{4, 1});
    CHECK(distance(at("rotate(90, 1 0)", {2, 0}), {1, 1}) < 1e-15);
    CHECK(distance(at("skewX(45)", {0, 1}), {1, 1}) < 1e-15);
    CHECK(distance(at("skewY(45) , scale(2,1)", {1, 0}), {2, 2}) < 1e-15);
    CHECK(at("translate(10px, -50%)translateX(1in)TranslateY(5%)", {1, 1}) == Vec2{107, -8});
    CHECK(at("scale(200%, 3)scaleX(.5)scaleY(2)", {1, 1}) == Vec2{1, 6});
    CHECK(distance(at("skew(45deg, 50grad)", {1, 3}), {4, 4}) < 1e-15);
    for (const char *quarter :
         {"rotate(90deg)", "rotate(.25turn)", "rotate(100grad)", "rotate(1.5707963267948966rad)"}) {
        CAPTURE(quarter);
        CHECK(distance(at(quarter, {2, 0}), {0, 2}) < 1e-15);
    }
    CHECK(distance(at("rotate(90deg, 1px 0)", {2, 0}), {1, 1}) < 1e-15);
    CHECK(parseTransform("matrix(3 0 0 0.5 9 9)", {})->stretch() == doctest::Approx(3.0));
    for (const char *wrong :
         {"rotate", "rotate(", "spin(3)", "scale(1,2,3)", "matrix(1,2,3,4,5,x)", "translate()", "translate(1deg)",
          "rotate(1px)", "scale(1px)", "matrix(1,0,0,1,2px,3)", "translateX(1 2)", "matrix(1 0 0 1 0 0 0)",
          "rotate(1 2)", "rotate(1 2deg 3)", "scale(2, )"}) {
        CAPTURE(wrong);
        CHECK(!parseTransform(wrong, {10, 20}));
    }
}

TEST_CASE("SVG: the origin of a transform is read as lengths and keywords") {
    const auto at = [](const char *text) { return parseTransformOrigin(text, {10, 20}); };
    CHECK(at("3 4px 5") == Vec2{3, 4});
    CHECK(at("50% 25%") == Vec2{5, 5});
    CHECK(at("center") == Vec2{5, 10});
    CHECK(at("center left") == Vec2{0, 10});
    CHECK(at("center 2px") == Vec2{5, 2});
    CHECK(at("bottom right") == Vec2{10, 20});
    CHECK(at("top") == Vec2{5, 0});
    CHECK(at("0") == Vec2{0, 10});
    for (const char *wrong : {"", "left right", "1deg 2", "middle", "1,2 3"}) {
        CAPTURE(wrong);
        CHECK(!at(wrong));
    }
}

TEST_CASE("SVG: closed outlines bound the domain, open ones are constraints, and labels become names") {
    const Domain domain =
        domainOf(drawing("<g fill=\"none\"><rect id=\"frame\" width=\"9\" height=\"9\"/>"
                         "<rect id=\"r1\" inkscape:label=\"pier\" x=\"1\" y=\"1\" width=\"1\" height=\"1\"/>"
                         "<line inkscape:label=\"pier\" x1=\"4\" y1=\"4\" x2=\"5\" y2=\"5\"/>"
                         "<path d=\"M6 6 7 6 7 7 6 6\"/><polyline points=\"3 3 3 4 2 4\"/></g>"));
    std::size_t boundary = 0;
    for (const DomainSegment &segment : domain.segments) {
        boundary += segment.role == SegmentRole::Boundary ? 1U : 0U;
    }
    CHECK(boundary == 11);
    REQUIRE(domain.segments.size() == 14);
    CHECK(boundaryName(domain.boundaryNames, domain.segments[0].tag) == "frame");
    CHECK(boundaryName(domain.boundaryNames, domain.segments[4].tag) == "pier");
    CHECK(domain.segments[8].tag == domain.segments[4].tag);
    CHECK(domain.segments[8].role == SegmentRole::Constraint);
}

TEST_CASE("SVG: a drawing without anything that bounds a domain is refused") {
    CHECK(faultOf(drawing("<use href=\"#a\"/>")).code == "empty-domain");
    CHECK(faultOf(drawing("<text>hello</text>")).code == "empty-domain");
    CHECK(faultOf(drawing("<g><path d=\"M1 1\"/>")).code == "xml-syntax");
    CHECK(faultOf("<html/>").code == "not-svg");
}

TEST_CASE("SVG: deep nesting and exponential entities are handled safely") {
    std::string deep;
    for (int k = 0; k < 200'000; ++k) {
        deep += "<g>";
    }
    CHECK(!readSvg(sourceOf("<svg>" + deep)).ok());
    std::string closing;
    for (int k = 0; k < 200'000; ++k) {
        closing += "</g>";
    }
    CHECK(readSvg(sourceOf("<svg>" + deep + "<rect width=\"1\" height=\"1\"/>" + closing + "</svg>")).ok());
    const std::string bomb = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">"
                             "<!ENTITY c \"&b;&b;&b;&b;&b;&b;&b;\">]><svg><path d=\"&c;&c;&c;\"/></svg>";
    CHECK(!readSvg(sourceOf(bomb)).ok());
}
