#include "core/drawing_files/drawing_formats.hpp"
#include "core/engine/mesh/quality.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/format_list.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <optional>
#include <string>

using namespace forefront;

namespace {

constexpr const char *kPlate = R"(<svg viewBox="0 0 100 60"><rect width="100" height="60" fill="#888"/>
<circle cx="30" cy="30" r="10" fill="#FFFFFF"/><rect x="60" y="20" width="20" height="20" fill="white"/>
<rect x="65" y="25" width="10" height="10" fill="red"/></svg>)";

/// Returns the area of what a drawing shows.
double areaOf(const std::string &svg, std::optional<bool> holes, ImportNotes *notes = nullptr) {
    ImportOptions options;
    options.whiteHoles = holes;
    const Result<DomainFile> file = allFormats().readDomain(MemoryFile{svg, "svg"}, options, notes);
    REQUIRE(file.ok());
    MeshingJob job{file->domain, {}, {}};
    job.spacing.size = 5.0;
    const auto outcome = meshDomain(job);
    REQUIRE(outcome);
    return measureQuality(outcome->mesh, nullptr).area;
}

bool has(const ImportNotes &notes, std::string_view code) {
    const Diagnostics list = notes.diagnostics();
    return std::any_of(list.begin(), list.end(), [code](const Diagnostic &note) { return note.code == code; });
}

} // namespace

TEST_CASE("SVG: white shapes on others are merged with them, with a note, or holes; what lies on a hole is there") {
    ImportNotes merged, cut;
    CHECK(areaOf(kPlate, false, &merged) == doctest::Approx(6000.0));
    CHECK(has(merged, "svg-white"));
    CHECK(merged.contents().whiteShapes == 2);
    CHECK(areaOf(kPlate, true, &cut) ==
          doctest::Approx(6000.0 - 100.0 * std::numbers::pi - 400.0 + 100.0).epsilon(1e-3));
    CHECK_FALSE(has(cut, "svg-white"));
    CHECK(cut.contents().whiteShapes == 2);
}

TEST_CASE("SVG: without a choice, white shapes on others are holes, with a note, unless nothing would remain") {
    ImportNotes cut, merged;
    CHECK(areaOf(kPlate, std::nullopt, &cut) == doctest::Approx(areaOf(kPlate, true)));
    CHECK(has(cut, "svg-white"));
    CHECK(cut.contents().whiteHoles);
    CHECK(areaOf(R"(<svg viewBox="0 0 40 20"><rect width="20" height="10"/><rect width="10" height="10" fill="white"/>
<rect x="10" width="10" height="10" fill="white"/></svg>)",
                 std::nullopt, &merged) == doctest::Approx(200.0));
    CHECK(has(merged, "svg-white"));
    CHECK_FALSE(merged.contents().whiteHoles);
}

TEST_CASE("SVG: white shapes that lie on nothing, on white or under others are areas, and so are translucent ones") {
    for (const char *shapes :
         {R"(<rect width="10" height="10" fill="white"/><rect x="20" width="10" height="10" fill="black"/>)",
          R"(<rect width="20" height="10" fill="white"/><rect x="5" y="2" width="5" height="5" fill="white"/>)",
          R"(<rect width="20" height="10" fill="white"/><rect x="5" y="2" width="5" height="5" fill="black"/>)",
          R"(<rect width="20" height="10"/><rect x="5" y="2" width="5" height="5" fill="white" fill-opacity="0.5"/>)",
          R"(<rect width="20" height="10"/><rect x="5" y="2" width="5" height="5" fill="ivory"/>)"}) {
        CAPTURE(shapes);
        ImportNotes notes;
        CHECK(areaOf("<svg viewBox=\"0 0 40 20\">" + std::string(shapes) + "</svg>", true, &notes) ==
              doctest::Approx(200.0));
        CHECK(notes.contents().whiteShapes == 0);
    }
}
