#include "tests/unit/svg_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

constexpr const char *kHundred = "viewBox=\"0 0 100 100\"";

/// Returns how many shapes of a drawing were left out as repeats.
std::size_t repeatsIn(const std::string &content, bool regions = false) {
    const std::string text = svgDrawing(content, kHundred);
    ImportNotes notes;
    SourceText source = sourceOf(text, "drawing.svg");
    source.notes = &notes;
    source.options.shapeRegions = regions;
    const auto domain = readSvg(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    const auto found = std::find_if(notes.entries().begin(), notes.entries().end(),
                                    [](const ImportNote &note) { return note.code == "svg-duplicate"; });
    return found == notes.entries().end() ? 0 : found->count;
}

} // namespace

TEST_CASE("SVG: filled shapes that are nearly equal count once") {
    std::string circles;
    for (int k = 0; k < 100; ++k) {
        circles += "<circle cx='" + std::to_string(50.0 + 1e-6 * k) + "' cy='50' r='40'/>";
    }
    CHECK(repeatsIn(circles) == 99);
    CHECK(enclosedArea(svgDomain(svgDrawing(circles, kHundred))) == doctest::Approx(1600 * 3.14159265).epsilon(5e-3));
    CHECK(repeatsIn("<circle cx='50' cy='50' r='40'/><circle cx='50' cy='50' r='39.9'/>") == 0);
}

TEST_CASE("SVG: filled shapes that are equal keep their names, strokes, holes and regions") {
    const std::string circle = "<circle cx='50' cy='50' r='40'/>", square = "<path d='M10 10h20v20h-20z'/>";
    CHECK(repeatsIn(circle + circle) == 1);
    CHECK(repeatsIn(circle + "<circle id='rim' cx='50' cy='50' r='40'/>") == 0);
    CHECK(repeatsIn(circle + "<circle stroke='black' cx='50' cy='50' r='40'/>") == 0);
    CHECK(repeatsIn(circle + circle, true) == 0);
    // A hole in another shape is no repeat, nor is what fills it.
    CHECK(repeatsIn(square + "<path d='M0 0v40h40v-40zM10 10h20v20h-20z' fill-rule='evenodd'/>") == 0);
}
