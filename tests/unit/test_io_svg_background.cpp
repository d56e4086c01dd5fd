#include "tests/unit/svg_samples.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Returns the note on the background of a drawing; empty if there is none.
std::string backgroundNote(const std::string &content, ImportOptions options = {}) {
    ImportNotes notes;
    const std::string text = svgDrawing(content);
    SourceText source = sourceOf(text, "drawing.svg");
    source.notes = &notes;
    source.options = std::move(options);
    const auto domain = readSvg(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    for (const ImportNote &note : notes.entries()) {
        if (note.code == "svg-background") {
            return note.message;
        }
    }
    return {};
}

const std::string kPage = "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>";
const std::string kDisc = "<circle cx=\"5\" cy=\"5\" r=\"3\"/>";
const std::string kCorner = "<path d=\"M7 7h9v9z\"/>"; // reaches beyond the page

} // namespace

TEST_CASE("SVG background: a note says that other shapes vanish in a rectangle") {
    const std::string one =
        "a filled rectangle covers the other filled shape, which vanishes in it; remove it if it is "
        "a background";
    const std::string apart = "; --shape-regions makes each shape a region";
    CHECK(backgroundNote(kPage + kDisc) == one + apart);
    CHECK(backgroundNote(kDisc + kPage) == one);
    CHECK(backgroundNote(kPage + kDisc + kCorner) ==
          "a filled rectangle covers the 2 other filled shapes, which vanish in it; remove it if it is a background" +
              apart);
    CHECK(backgroundNote("<g transform=\"translate(1 1) scale(.5)\">"
                         "<path d=\"M1 1H9V9H1z\"/>" +
                         kDisc + "</g>") == one + apart);
    const std::string clip = "<clipPath id=\"c\"><rect width=\"10\" height=\"10\"/></clipPath>";
    CHECK(backgroundNote(clip + "<g clip-path=\"url(#c)\"><rect width=\"90\" height=\"90\"/>" + kDisc + "</g>") ==
          one + apart);
    CHECK(backgroundNote("<rect width=\"10\" height=\"10\" rx=\".5\"/>" + kDisc) == one + apart);
}

TEST_CASE("SVG background: no note if shapes remain, or are kept apart") {
    CHECK(backgroundNote(kDisc + kCorner).empty());
    CHECK(backgroundNote("<rect width=\"9\" height=\"9\" fill=\"red\"/>").empty());
    CHECK(backgroundNote("<rect x=\"3\" width=\"7\" height=\"10\"/>" + kDisc).empty());
    CHECK(backgroundNote("<path d=\"M0 0H10V10H0z M1 1V9H9V1z\"/>" + kDisc).empty()); // a frame
    CHECK(backgroundNote("<circle cx=\"5\" cy=\"5\" r=\"5\"/>" + kDisc).empty());
    CHECK(backgroundNote("<clipPath id=\"c\"><circle r=\"5\"/></clipPath><rect width=\"10\" height=\"10\" "
                         "clip-path=\"url(#c)\"/>" +
                         kDisc)
              .empty());
    CHECK(backgroundNote("<g fill=\"none\">" + kPage + "</g>").empty());
    ImportOptions options;
    options.shapeRegions = true;
    CHECK(backgroundNote(kPage + kDisc, options).empty());
}

TEST_CASE("SVG background: a note says that all lines lie in a white rectangle") {
    const std::string line = "<path fill=\"none\" stroke=\"black\" d=\"M1 1H9V9H1z\"/>";
    CHECK(backgroundNote(kPage + line) ==
          "a white rectangle is the only filled shape, and everything else is lines in it; remove it if it is a "
          "background");
    CHECK(backgroundNote("<rect width=\"10\" height=\"10\" fill=\"#c00\"/>" + line).empty());
    CHECK(backgroundNote("<rect width=\"5\" height=\"5\" fill=\"#fff\"/>" + line).empty());
    CHECK(backgroundNote(line).empty());
}
