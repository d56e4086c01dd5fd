#include "core/drawing_files/svg/svg.hpp"
#include "tests/unit/arrangement_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <set>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

using std::numbers::pi;

/// What is read from a drawing, and the codes of the notes.
struct PageReading {
    Domain domain;
    std::set<std::string> notes;

    double area() const { return areas(domain).at(1); }
};

PageReading read(const std::string &root, const std::string &content, bool beyondPage = false) {
    const std::string text = "<svg " + root + ">\n" + content + "\n</svg>\n";
    ImportNotes notes;
    SourceText source = sourceOf(text, "drawing.svg");
    source.notes = &notes;
    source.options.beyondPage = beyondPage;
    auto domain = readSvg(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    PageReading reading{std::move(*domain), {}};
    for (const ImportNote &note : notes.entries()) {
        reading.notes.insert(note.code);
    }
    return reading;
}

const std::string kTen = "viewBox=\"0 0 10 10\"";
const std::string kWide = "<rect id=\"wide\" x=\"-5\" y=\"2\" width=\"9\" height=\"6\"/>";

} // namespace

TEST_CASE("SVG page: filled shapes end at the view box, and a note says so") {
    const PageReading cut = read(kTen, kWide);
    CHECK(cut.area() == doctest::Approx(24));
    CHECK(cut.notes.count(kPageNote) == 1);
    std::set<std::string> names;
    for (const DomainSegment &segment : cut.domain.segments) {
        names.insert(boundaryName(cut.domain.boundaryNames, segment.tag));
    }
    CHECK(names == std::set<std::string>{"wide", "page"});
    const PageReading whole = read(kTen, kWide, true);
    CHECK(whole.area() == doctest::Approx(54));
    CHECK(whole.notes.empty());
}

TEST_CASE("SVG page: what lies within it is read as if there were none") {
    const std::string inside = "<rect width=\"10\" height=\"4\"/><circle cx=\"7\" cy=\"7\" r=\"3\"/>";
    const PageReading cut = read(kTen, inside), whole = read(kTen, inside, true);
    CHECK(cut.domain.nodes == whole.domain.nodes);
    CHECK(cut.domain.boundaryNames == whole.domain.boundaryNames);
    CHECK(cut.notes == whole.notes);
    // Rounding beyond the edge is no reason to cut, and what a clip path hides is not there.
    CHECK(read(kTen, "<rect x=\"-.001\" width=\"4\" height=\"4\"/>").notes.empty());
    const PageReading clipped = read(kTen, "<clipPath id=\"c\"><rect width=\"3\" height=\"10\"/></clipPath><g "
                                           "clip-path=\"url(#c)\">" +
                                               kWide + "</g>");
    CHECK(clipped.area() == doctest::Approx(18));
    CHECK(clipped.notes.count(kPageNote) == 0);
}

TEST_CASE("SVG page: a curve whose nodes lie on the page is cut where it leaves it") {
    const PageReading half = read(kTen, "<path d=\"M1 0A4 4 0 0 1 9 0V3H1Z\"/>");
    CHECK(half.area() == doctest::Approx(24).epsilon(1e-3));
    CHECK(half.notes.count(kPageNote) == 1);
    CHECK(read(kTen, "<circle cx=\"10\" cy=\"5\" r=\"4\"/>").area() == doctest::Approx(8 * pi).epsilon(2e-3));
}

TEST_CASE("SVG page: it is what a renderer shows of the document's size") {
    const std::string huge = "<rect x=\"-99\" y=\"-99\" width=\"300\" height=\"300\"/>";
    CHECK(read("width=\"20\" height=\"5\"", huge).area() == doctest::Approx(100));
    CHECK(read("width=\"20mm\" height=\"5mm\"", huge).area() == doctest::Approx(100)); // read in millimetres
    CHECK(read("viewBox=\"0 0 10 10\" width=\"100%\" height=\"100%\"", huge).area() == doctest::Approx(100));
    CHECK(read("viewBox=\"2 -3 10 10\" width=\"20\" height=\"20\"", huge).area() == doctest::Approx(100));
    // A document twice as wide as its view box shows as much again beside it, or half of its height.
    CHECK(read("viewBox=\"0 0 10 10\" width=\"40\" height=\"20\"", huge).area() == doctest::Approx(200));
    CHECK(
        read("viewBox=\"0 0 10 10\" width=\"40\" height=\"20\" preserveAspectRatio=\"xMidYMid slice\"", huge).area() ==
        doctest::Approx(50));
    CHECK(read("viewBox=\"0 0 10 10\" width=\"40\" height=\"20\" preserveAspectRatio=\"none\"", huge).area() ==
          doctest::Approx(100));
    CHECK(read("id=\"sizeless\"", huge).area() == doctest::Approx(90000));
    CHECK(read("viewBox=\"0 0 1e300 10\"", huge).area() == doctest::Approx(90000));
}

TEST_CASE("SVG page: drawings of outlines, drawings beside the page and pasted shapes are read in full") {
    const std::string outline = "<path fill=\"none\" stroke=\"red\" d=\"M-5 0H5V4H-5Z\"/>";
    CHECK(read(kTen, outline).area() == doctest::Approx(40));
    CHECK(read(kTen, outline).notes.count(kPageNote) == 0);
    const PageReading beside = read(kTen, "<rect x=\"20\" width=\"3\" height=\"3\"/>");
    CHECK(beside.area() == doctest::Approx(9));
    CHECK(beside.notes == std::set<std::string>{"svg-off-page"});
    const std::string text = "<svg " + kTen + ">" + kWide + "</svg>";
    const auto pasted = readSvgShapes(sourceOf(text));
    REQUIRE(pasted.ok());
    CHECK(areas(*pasted).at(1) == doctest::Approx(54));
}

TEST_CASE("SVG page: shapes far larger than the page neither take long nor make what it shows coarser") {
    // A cubic that loops far outside and closes along y = 9, and a small square beside a hole.
    const PageReading cubic = read(kTen, "<path d=\"M0 9C-1e8 1e8 1e8 1e8 10 9z\"/>");
    CHECK(cubic.area() == doctest::Approx(10.0));
    CHECK(cubic.notes == std::set<std::string>{kPageNote, "clipped-segments"});
    const PageReading ring = read(kTen, "<path d=\"M-1e9 -1e9H1e9V1e9H-1e9z M2 2V8H8V2z\"/><path d=\"M3 5H5V6H3z\"/>");
    CHECK(ring.area() == doctest::Approx(100.0 - 36.0 + 2.0));
    CHECK(ring.domain.segments.size() == 12);
    CHECK(ring.notes.count("finer-weld") == 0);
}

TEST_CASE("SVG page: viewports, clip paths and masks far larger than the page limit as others do") {
    const std::string square = "<rect width=\"10\" height=\"10\"/>";
    const auto clipped = [&](const std::string &parts) {
        return read(kTen, "<clipPath id=\"c\">" + parts + "</clipPath><g clip-path=\"url(#c)\">" + square + "</g>")
            .area();
    };
    CHECK(read(kTen, "<svg x=\"-1000\" y=\"-1000\" width=\"5000\" height=\"5000\">"
                     "<rect x=\"995\" y=\"995\" width=\"10\" height=\"10\"/></svg>")
              .area() == doctest::Approx(25.0));
    CHECK(read(kTen, "<mask id=\"m\" maskUnits=\"userSpaceOnUse\" x=\"-900\" y=\"-900\" width=\"3000\" height=\"3000\">"
                     "<path fill=\"white\" d=\"M-1e6 0H5V1e6z\"/></mask><g mask=\"url(#m)\">" +
                         square + "</g>")
              .area() == doctest::Approx(50.0));
    // An open part of a clip path is closed by its last and first node; a line clips everything.
    CHECK(clipped("<path fill=\"none\" d=\"M-1000 -400L1000 -1000L1000 400\"/>") == doctest::Approx(20.0));
    CHECK(clipped("<path d=\"M1 1H2V2H1z M5 5L1000 3000\"/>") == doctest::Approx(1.0));
}

TEST_CASE("SVG page: lines far longer than the page keep what it shows of them") {
    const std::string square = "<rect width=\"10\" height=\"10\"/>";
    const auto linesIn = [](const PageReading &reading) {
        double sum = 0.0;
        for (const DomainSegment &segment : reading.domain.segments) {
            sum += segment.role == SegmentRole::Constraint
                       ? distance(reading.domain.nodes[segment.a], reading.domain.nodes[segment.b])
                       : 0.0;
        }
        return sum;
    };
    CHECK(linesIn(read(kTen, square + "<path stroke=\"black\" fill=\"none\" d=\"M5 -1e6V4H1e6\"/>")) ==
          doctest::Approx(9.0));
    CHECK(linesIn(read(kTen, square + "<path stroke=\"black\" fill=\"none\" d=\"M-1e6 5H1e6V1e6z\"/>")) ==
          doctest::Approx(10.0));
    // The stroke of an open filled shape does not follow the segment that closes the fill.
    const std::string open = "<path fill=\"blue\" stroke=\"black\" d=\"M5 -1e6V4H1e6\"/>";
    CHECK(read(kTen, open).area() == doctest::Approx(20.0));
    CHECK(linesIn(read(kTen, square + open)) == doctest::Approx(9.0));
}
