#include "core/drawing/arrangement/assembly/short_segments.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <optional>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Returns the note on nodes that are too close together; empty if there is none.
std::string closeNodesIn(const std::string &shapes, std::optional<double> weld = {}) {
    const std::string text = "<svg viewBox=\"0 0 100 100\">" + shapes + "</svg>";
    ImportNotes notes;
    SourceText source = sourceOf(text, "drawing.svg");
    source.notes = &notes;
    source.options.weldTolerance = weld;
    const auto domain = readSvg(source);
    REQUIRE_MESSAGE(domain.ok(), messages(domain.faults()));
    std::string found;
    for (const ImportNote &note : notes.entries()) {
        found += note.code == "close-nodes" ? note.message : "";
    }
    return found;
}

constexpr const char *kSliver = R"(<rect width="100" height="100"/><path d="M20 50H80" fill="none" stroke="#00f"/>)"
                                R"(<path d="M50 40V60" fill="none" stroke="#00f"/>)"
                                R"(<path d="M50.001 40V60" fill="none" stroke="#00f"/>)";

} // namespace

TEST_CASE("short segments: a line that crosses both sides of a sliver is named, with the tolerance that merges") {
    const std::string note = closeNodesIn(kSliver);
    CHECK(note.find("0.001 apart") != std::string::npos);
    CHECK(note.find("--weld 0.00105 merges them") != std::string::npos);
    CHECK(closeNodesIn(kSliver, 0.00105).empty());
}

TEST_CASE("short segments: short ones among short ones, and drawings without any, are not named") {
    CHECK(closeNodesIn(R"(<rect width="100" height="100"/>)").empty());
    CHECK(closeNodesIn(R"(<path d="M0 0H100V100H50.02L50.01 99.99L50 100H0Z"/>)").empty());
    Domain domain;
    domain.nodes = {{0, 0}, {1, 0}, {1.001, 0}, {2, 0}};
    domain.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}};
    const ShortSegments found = findShortSegments(domain, 0.01);
    CHECK(found.count == 1);
    CHECK(found.segment == 1);
    CHECK(found.longest == doctest::Approx(0.001));
    CHECK(findShortSegments(domain, 0.0005).count == 0);
    domain.segments = {{1, 2, 1}};
    CHECK(findShortSegments(domain, 0.01).count == 0); // alone
}
