#include "core/drawing/arrangement/arrangement.hpp"
#include "tests/unit/arrangement_support.hpp"
#include "tests/unit/svg_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A line with its reach.
struct LooseLine {
    std::vector<Vec2> nodes;
    double reach = 0.0;
};

/// Returns a square of side 10 with lines.
ArrangementInput squareWith(const std::vector<LooseLine> &lines) {
    ArrangementInput input;
    addPath(input, FillRule::NonZero, {rectangle(0, 0, 10, 10)});
    for (const LooseLine &line : lines) {
        input.addChain(line.nodes, 5, {}, kNoClip, line.reach);
    }
    return input;
}

/// Returns the number of constraint segments.
std::size_t lineCount(const Domain &domain) {
    return static_cast<std::size_t>(
        std::count_if(domain.segments.begin(), domain.segments.end(),
                      [](const DomainSegment &segment) { return segment.role == SegmentRole::Constraint; }));
}

/// Returns true if a domain has a segment between two places.
bool hasSegment(const Domain &domain, Vec2 a, Vec2 b) {
    const auto same = [](Vec2 p, Vec2 q) { return distance(p, q) < 1e-9; };
    return std::any_of(domain.segments.begin(), domain.segments.end(), [&](const DomainSegment &segment) {
        const Vec2 p = domain.nodes[segment.a], q = domain.nodes[segment.b];
        return (same(p, a) && same(q, b)) || (same(p, b) && same(q, a));
    });
}

std::size_t linesIn(const std::vector<LooseLine> &lines) {
    return lineCount(arranged(squareWith(lines)).domain);
}

/// Returns the number of lines in a drawing with a square of side 8.
std::size_t linesInDrawing(const std::string &content, ImportNotes *notes = nullptr) {
    return lineCount(svgDomain(svgDrawing("<rect x=\"1\" y=\"1\" width=\"8\" height=\"8\"/>" + content), notes));
}

} // namespace

TEST_CASE("repeated outlines: a line that stays within its reach of outlines is dropped") {
    const std::vector<Vec2> beside{{1, 0.5}, {9.5, 0.3}, {9.6, 8}};
    const Arrangement result = arranged(squareWith({{beside, 0.6}}));
    CHECK(lineCount(result.domain) == 0);
    const ArrangementChange *const change = find(result, ChangeKind::RepeatedOutlines);
    REQUIRE(change != nullptr);
    CHECK(change->count == 2);
    CHECK(change->displacement == doctest::Approx(0.5));
    CHECK(linesIn({{beside, 0.45}}) == 2); // its first end is farther away
    CHECK(linesIn({{beside, 0.0}}) == 2);
    CHECK(linesIn({{beside, 0.6}, {beside, 0.0}}) == 2); // another line there must stay
}

TEST_CASE("repeated outlines: a line that only ends on, crosses or comes near an outline stays as a whole") {
    CHECK(linesIn({{{{0, 0}, {10, 10}}, 0.6}}) == 1);
    CHECK(linesIn({{{{5, 0}, {5, 4}}, 0.6}}) == 1);
    CHECK(linesIn({{{{5, 0}, {5, 0.6}}, 0.6}}) == 1); // however short
    CHECK(linesIn({{{{2, 0}, {9, 1}}, 0.6}}) == 1);   // at a small angle
    CHECK(linesIn({{{{2, -1}, {9, 2}}, 0.6}}) == 1);
    CHECK(linesIn({{{{9, 5}, {5, 0.1}, {1, 5}}, 0.6}}) == 2);           // a tip near the outline
    CHECK(linesIn({{{{1, 5}, {1, 0.5}, {5, 0.5}, {5, 5}}, 0.6}}) == 3); // short for its distance
    // Beside an outline, but beyond the reach, as hatching is; and beside another line.
    CHECK(linesIn({{{{1, 0.6}, {9, 0.6}, {5, 5}}, 0.3}}) == 2);
    CHECK(linesIn({{{{1, 5}, {9, 5}, {5, 2}}, 0.3}, {{{1, 5.1}, {9, 5.1}, {5, 8}}, 0.3}}) == 4);
}

TEST_CASE("repeated outlines: a part of a line that repeats an outline is dropped, and the rest begins there") {
    const Arrangement result = arranged(squareWith({{{{1, 0.01}, {6, 0.01}, {5, 5}}, 0.6}}));
    REQUIRE(lineCount(result.domain) == 1);
    CHECK(hasSegment(result.domain, {6, 0}, {5, 5}));
    const ArrangementChange *const change = find(result, ChangeKind::RepeatedOutlines);
    REQUIRE(change != nullptr);
    CHECK(change->count == 1);
    CHECK(change->displacement == doctest::Approx(0.01));
    // Both ends of a line, and its middle.
    const Arrangement ends = arranged(squareWith({{{{0.01, 9}, {0.01, 4}, {5, 5}, {9, 0.01}, {2, 0.01}}, 0.6}}));
    CHECK(lineCount(ends.domain) == 2);
    CHECK(hasSegment(ends.domain, {0, 4}, {5, 5}));
    const Arrangement middle = arranged(squareWith({{{{1, 5}, {1, 0.01}, {7, 0.01}, {7, 5}}, 0.6}}));
    CHECK(lineCount(middle.domain) == 2);
    CHECK(hasSegment(middle.domain, {1, 0}, {1, 5}));
    CHECK(hasSegment(middle.domain, {7, 0}, {7, 5}));
    // A loop, whichever of its nodes comes first.
    std::vector<Vec2> loop{{1, 0.01}, {7, 0.01}, {7, 5}, {1, 5}};
    for (int turn = 0; turn < 4; ++turn) {
        std::rotate(loop.begin(), loop.begin() + 1, loop.end());
        LooseLine line{loop, 0.6};
        line.nodes.push_back(loop.front());
        const Domain domain = arranged(squareWith({line})).domain;
        CHECK(lineCount(domain) == 3);
        CHECK(hasSegment(domain, {1, 0}, {1, 5}));
    }
}

TEST_CASE("repeated outlines: a part ends where the outline turns away, and where the line crosses it") {
    ArrangementInput input;
    addPath(input, FillRule::NonZero, {{{0, 0}, {6, 0}, {6, -3}, {10, -3}, {10, 10}, {0, 10}}});
    input.addChain(std::vector<Vec2>{{1, 0.01}, {10, 0.01}}, 5, {}, kNoClip, 0.6);
    const Domain domain = arranged(input).domain;
    CHECK(lineCount(domain) == 1);
    CHECK(hasSegment(domain, {6, 0}, {10, 0.01}));
    CHECK(domain.nodes.size() == 7);
    // Along the outline on both sides of it: no nodes remain where they cross.
    CHECK(arranged(squareWith({{{{1, 0.01}, {3, -0.01}, {5, 0.01}, {7, -0.01}, {9, 0.01}, {5, 5}}, 0.6}}))
              .domain.nodes.size() == 6);
}

TEST_CASE("repeated outlines: lines are dropped from one node with other pieces to the next") {
    // The first line leaves the square where the second begins, and comes back.
    const LooseLine along{{{1, 0.2}, {4, 0.1}, {4, -2}, {6, -2}, {6, 0.1}, {9, 0.2}, {5, 5}}, 0.3};
    CHECK(linesIn({{along}}) == 3);
    const LooseLine whole{{{1, 0.2}, {9, 0.2}, {9, 5}, {5, 5}}, 0.3};
    CHECK(linesIn({whole}) == 2);
    CHECK(linesIn({whole, {{{6, 0}, {6, 5}}, 0.3}}) == 6);
}

TEST_CASE("repeated outlines: what goes on from lines that are dropped ends on the outline") {
    // An inner frame is dropped. Lines that meet it go on to the outline.
    const LooseLine frame{{{0.2, 0.2}, {9.8, 0.2}, {9.8, 9.8}, {0.2, 9.8}, {0.2, 0.2}}, 0.3};
    CHECK(linesIn({frame, {{{5, 0}, {5, 10}}, 0.3}, {{{0, 5}, {10, 5}}, 0.3}}) == 4);
    const Domain across = arranged(squareWith({frame, {{{5, 0.2}, {5, 9.8}}, 0.3}})).domain;
    CHECK(lineCount(across) == 1);
    CHECK(hasSegment(across, {5, 0}, {5, 10}));
    CHECK(hasSegment(arranged(squareWith({frame, {{{5, 0.2}, {5, 5}}, 0.3}})).domain, {5, 0}, {5, 5}));
    const LooseLine diamond{{{5, 0.2}, {9.8, 5}, {5, 9.8}, {0.2, 5}, {5, 0.2}}, 0.3};
    CHECK(linesIn({frame, diamond}) == 4);
    // A line that reaches the outline beyond the frame stays as it is.
    CHECK(hasSegment(arranged(squareWith({frame, {{{0, 0.1}, {10, 2}}, 0.3}})).domain, {0, 0.1}, {10, 2}));
}

TEST_CASE("repeated outlines: lines that lead across to something stay") {
    // The frame stays if a line that must stay would no longer reach anything.
    const LooseLine frame{{{0.2, 0.2}, {9.8, 0.2}, {9.8, 9.8}, {0.2, 9.8}, {0.2, 0.2}}, 0.3};
    CHECK(linesIn({frame, {{{5, 0.2}, {5, 9.8}}, 0.0}}) == 7);
    CHECK(linesIn({frame, {{{5, 0.2}, {5, 5}}, 0.0}}) == 1); // divides nothing
    const LooseLine diamond{{{5, 0.2}, {9.8, 5}, {5, 9.8}, {0.2, 5}, {5, 0.2}}, 0.0};
    CHECK(linesIn({frame, diamond}) == 12);
    // So does a part.
    CHECK(linesIn({{{{1, 0.01}, {6, 0.01}, {5, 5}}, 0.6}, {{{1, 0.01}, {1, 9}}, 0.0}}) == 3);
    // Oblique dividers of a strip.
    ArrangementInput strip;
    addPath(strip, FillRule::NonZero, {rectangle(0, 0, 100, 2)});
    for (int k = 2; k < 90; k += 5) {
        strip.addChain(std::vector<Vec2>{{double(k), 0}, {double(k) + 4.0, 2}}, 5, {}, kNoClip, 1.01);
    }
    CHECK(lineCount(arranged(strip).domain) == 18);
    // A bridge across a narrow part, and a line that leads slowly from one side of it to the other.
    ArrangementInput holed;
    addPath(holed, FillRule::EvenOdd, {rectangle(0, 0, 10, 10), rectangle(0.5, 2, 4, 6)});
    holed.addChain(std::vector<Vec2>{{0, 5}, {0.5, 5}}, 5, {}, kNoClip, 0.3);
    CHECK(lineCount(arranged(holed).domain) == 1);
    ArrangementInput channel;
    addPath(channel, FillRule::NonZero, {rectangle(0, 0, 100, 1)});
    channel.addChain(std::vector<Vec2>{{0, 0}, {100, 1}}, 5, {}, kNoClip, 0.6);
    CHECK(lineCount(arranged(channel).domain) == 1);
}

TEST_CASE("repeated outlines: circles of a stroke inside the outline, whose chords are not parallel") {
    for (const char *const turn : {"rotate(0)", "rotate(7)", "rotate(30)"}) {
        for (const char *const ring : {"r=\"39.5\" stroke-width=\"1\"", "r=\"39.995\" stroke-width=\".01\""}) {
            CAPTURE(turn);
            CAPTURE(ring);
            const Domain domain = svgDomain(svgDrawing(
                std::string("<circle cx=\"50\" cy=\"50\" r=\"40\"/><circle cx=\"50\" cy=\"50\" fill=\"none\" "
                            "stroke=\"black\" transform-origin=\"50 50\" transform=\"") +
                    turn + "\" " + ring + "/>",
                "viewBox=\"0 0 100 100\""));
            CHECK(lineCount(domain) == 0);
        }
    }
    // The stroke of a thinner ring does not reach the outline, although its chords cross those of the outline.
    const Domain thin =
        svgDomain(svgDrawing("<circle cx=\"50\" cy=\"50\" r=\"40\"/><circle cx=\"50\" cy=\"50\" fill=\"none\" "
                             "stroke=\"black\" r=\"39.92\" stroke-width=\".01\"/>",
                             "viewBox=\"0 0 100 100\""));
    CHECK(lineCount(thin) > 20);
}

TEST_CASE("repeated outlines: lines with a name of their own stay") {
    const std::string line = "<path d=\"M1.2 3V6\" fill=\"none\" stroke=\"red\" stroke-width=\".5\" id=\"";
    for (const char *const generated : {"path3948", "path12-5", "line", "use7", "Rectangle 5", "XMLID_4_"}) {
        CHECK(linesInDrawing(line + generated + "\"/>") == 0);
    }
    for (const char *const own : {"inlet", "path to the sea", "inlet2"}) {
        CHECK(linesInDrawing(line + own + "\"/>") == 1);
    }
}

TEST_CASE("repeated outlines: closed lines, and outlines of many short segments") {
    std::vector<Vec2> circle, ring;
    for (int k = 0; k <= 200; ++k) {
        const double angle = 6.283185307179586 * k / 200;
        circle.push_back({5 + 4 * std::cos(angle), 5 + 4 * std::sin(angle)});
        ring.push_back({5 + 3.9 * std::cos(1 - angle), 5 + 3.9 * std::sin(1 - angle)});
    }
    circle.pop_back();
    ring.back() = ring.front();
    for (const double reach : {0.09, 0.12}) {
        ArrangementInput input;
        addPath(input, FillRule::NonZero, {circle});
        input.addChain(ring, 5, {}, kNoClip, reach);
        CHECK(lineCount(arranged(input).domain) == (reach < 0.1 ? 200 : 0));
    }
}

TEST_CASE("repeated outlines: the order of the pieces does not matter") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> along(0.0, 10.0), off(0.0, 0.8), reach(0.0, 0.8);
    for (int round = 0; round < 200; ++round) {
        std::vector<LooseLine> lines;
        for (int k = 0; k < 6; ++k) {
            lines.push_back(
                {{{along(random), off(random)}, {along(random), off(random)}, {10 - off(random), 9}}, reach(random)});
        }
        const auto before = segmentSet(arranged(squareWith(lines)).domain);
        std::shuffle(lines.begin(), lines.end(), random);
        for (LooseLine &line : lines) {
            std::reverse(line.nodes.begin(), line.nodes.end());
        }
        CHECK(segmentSet(arranged(squareWith(lines)).domain) == before);
    }
}

TEST_CASE("repeated outlines: SVG strokes that reach the outline all along are dropped, with a note") {
    ImportNotes notes;
    CHECK(linesInDrawing("<rect x=\"1.1\" y=\"1.1\" width=\"7.8\" height=\"7.8\" fill=\"none\" stroke=\"red\" "
                         "stroke-width=\".2\"/>",
                         &notes) == 0);
    CHECK(std::any_of(notes.entries().begin(), notes.entries().end(),
                      [](const ImportNote &note) { return note.code == "repeated-outlines"; }));
    // Thinner ones do not reach it.
    CHECK(linesInDrawing("<rect x=\"1.1\" y=\"1.1\" width=\"7.8\" height=\"7.8\" fill=\"none\" stroke=\"red\" "
                         "stroke-width=\".15\"/>") == 4);
}

TEST_CASE("repeated outlines: SVG strokes that leave the outline that they nearly follow") {
    const std::string stroke = "<path fill=\"none\" stroke=\"#000\" stroke-width=\"2\" ";
    const Domain straight = svgDomain(svgDrawing(
        "<path d=\"M10 10h40v40h-40z\"/>" + stroke + "d=\"M10 10.0007h30l-10 15\"/>", "viewBox=\"0 0 72 72\""));
    CHECK(lineCount(straight) == 1);
    CHECK(hasSegment(straight, {40, 62}, {30, 46.9993}));
    // The stroke of a curve leaves it in the middle of a piece; the rest follows its curve.
    const std::string arch = "<path d=\"M10 40 C 10 0 60 0 60 40 z\"/>", page = "viewBox=\"0 0 72 72\"";
    const Domain curved =
        svgDomain(svgDrawing(arch + stroke + "d=\"M10.0007 40 C 10 0.02 60 0.02 59.98 39.98 L 30 30\"/>", page));
    CHECK(lineCount(curved) == 1);
    CHECK(hasSegment(curved, {60, 32}, {30, 42}));
    const std::string square = "<path d=\"M10 10h50v50h-50z\"/>", away = "d=\"M10 10.001C40 10.001 55 15 55 40\"";
    const Domain leaving = svgDomain(svgDrawing(square + stroke + away + "/>", page));
    const Domain whole = svgDomain(svgDrawing(square + stroke + "id=\"wall\" " + away + "/>", page));
    CHECK(lineCount(leaving) < lineCount(whole));
    CHECK(std::count_if(leaving.segments.begin(), leaving.segments.end(), [](const DomainSegment &segment) {
              return segment.role == SegmentRole::Constraint && segment.stretch.follows();
          }) > 0);
}

TEST_CASE("repeated outlines: SVG stroke widths are inherited, scaled and have units") {
    const std::string line = "<path d=\"M1.5 1.2H4.5\" fill=\"none\" stroke=\"red\"";
    CHECK(linesInDrawing(line + "/>") == 0); // 1 by default
    CHECK(linesInDrawing("<g stroke-width=\".3\">" + line + "/></g>") == 1);
    CHECK(linesInDrawing("<g stroke-width=\".3\">" + line + " style=\"stroke-width: 0.5px\"/></g>") == 0);
    CHECK(linesInDrawing("<g stroke-width=\".3\">" + line + " stroke-width=\"-1\"/></g>") == 1);
    CHECK(linesInDrawing("<g stroke-width=\".3\">" + line + " style=\"stroke-width: initial\"/></g>") == 0);
    CHECK(linesInDrawing(line + " stroke-width=\"2%\"/>") == 1);
    CHECK(linesInDrawing(line + " stroke-width=\"5%\"/>") == 0);
    const std::string scaled = "<g transform=\"scale(.1)\"><path d=\"M15 12H45\" fill=\"none\" stroke=\"red\" ";
    CHECK(linesInDrawing(scaled + "stroke-width=\"3\"/></g>") == 1);
    CHECK(linesInDrawing(scaled + "stroke-width=\"5\"/></g>") == 0);
    CHECK(linesInDrawing("<g transform=\"scale(1 .1)\"><path d=\"M1.5 12H4.5\" fill=\"none\" stroke=\"red\" "
                         "stroke-width=\"3\"/></g>") == 1); // narrower than .4 across
    // Not scaled: the width is not known. Without a stroke, there is none.
    CHECK(linesInDrawing(line + " vector-effect=\"non-scaling-stroke\"/>") == 1);
    CHECK(linesInDrawing("<path d=\"M1.5 1.2H4.5\" fill=\"none\"/>") == 1);
    // Very wide ones reach 1/32 of the drawing's diagonal at most.
    CHECK(linesInDrawing("<path d=\"M1.5 1.35H4.5\" fill=\"none\" stroke=\"red\" stroke-width=\"9\"/>") == 0);
    CHECK(linesInDrawing("<path d=\"M1.5 1.37H4.5\" fill=\"none\" stroke=\"red\" stroke-width=\"9\"/>") == 1);
}

TEST_CASE("repeated outlines: lines with a name that nearly follow the boundary are reported") {
    const std::string line = "<path d=\"M1 1.0001H7L5 4\" fill=\"none\" stroke=\"red\" stroke-width=\".5\" id=\"";
    const auto reported = [](const ImportNotes &notes) {
        return std::any_of(notes.entries().begin(), notes.entries().end(), [](const ImportNote &note) {
            return note.code == "near-lines" && note.message.find("0.0001 away") != std::string::npos;
        });
    };
    ImportNotes named, unnamed;
    CHECK(linesInDrawing(line + "inlet\"/>", &named) == 2);
    CHECK(reported(named));
    CHECK(linesInDrawing(line + "path7\"/>", &unnamed) == 1);
    CHECK_FALSE(reported(unnamed));
}
