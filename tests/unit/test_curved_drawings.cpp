#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/chain_shape.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/files.hpp"
#include "core/files/text/atomic_file.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/io_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

using namespace forefront;
using namespace forefront::edit_test;
using namespace forefront::testing;

namespace {

using std::numbers::pi;

struct Drawing {
    const char *what;
    const char *content;
};

const Drawing kDrawings[] = {
    {"circle and ellipse", R"(<circle cx="5" cy="5" r="4"/><ellipse cx="16" cy="14" rx="6" ry="3"/>)"},
    {"thin ring", R"(<path fill-rule="evenodd" d="M12 1a11 11 0 1 1 0 22 11 11 0 0 1 0-22zm0 .02a10.98 10.98 0 1 0 0 )"
                  R"(21.96 10.98 10.98 0 0 0 0-21.96z"/>)"},
    {"rounded rectangle", R"(<rect x="2" y="3" width="18" height="12" rx="3"/>)"},
    {"bubble", R"(<path d="M12 3C6.5 3 2 6.6 2 11c0 2.1 1 4 2.7 5.4L4 21l4.5-2.3C9.6 18.9 10.8 19 12 19c5.5 0 )"
               R"(10-3.6 10-8s-4.5-8-10-8z"/>)"},
    {"teardrop of one curve", R"(<path d="M12 2C24 14 0 14 12 2z"/>)"},
    {"crossing circles", R"(<circle cx="9" cy="12" r="6"/><circle cx="15" cy="12" r="6"/>)"},
    {"turned ellipse and a line",
     R"svg(<g transform="rotate(30 12 12)"><ellipse cx="12" cy="12" rx="9" ry="4"/></g>)svg"
     R"(<path fill="none" stroke="#000" d="M10 11Q12 10 14 13"/>)"},
};

std::string svgOf(const Drawing &drawing) {
    return std::string("<svg viewBox=\"0 0 24 24\">") + drawing.content + "</svg>";
}

// Neighbours share borders, and not from end to end; one lies inside another. The order of their chains is not that of
// their segments.
const char *const kMap = R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "west"}, "geometry": {"type": "Polygon", "coordinates":
        [[[0, 0], [5, 0], [5, 3], [4, 4], [5, 8], [0, 8], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]]}},
    {"type": "Feature", "properties": {"name": "enclave"}, "geometry": {"type": "Polygon", "coordinates":
        [[[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]]}},
    {"type": "Feature", "properties": {"name": "south-east"}, "geometry": {"type": "Polygon", "coordinates":
        [[[9, 0], [9, 3], [5, 3], [5, 0], [9, 0]]]}},
    {"type": "Feature", "properties": {"name": "north-east"}, "geometry": {"type": "Polygon", "coordinates":
        [[[5, 8], [4, 4], [5, 3], [9, 3], [9, 8], [5, 8]]]}}]})";

/// Writes a drawing into a folder and returns its path.
std::filesystem::path fileOf(const Drawing &drawing, const TemporaryFolder &folder) {
    REQUIRE(writeFileAtomically(folder / "drawing.svg", svgOf(drawing)).empty());
    return folder / "drawing.svg";
}

std::uint64_t hashOf(const Domain &domain) {
    MeshingJob job;
    job.domain = domain;
    auto outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome.ok(), messages(outcome.faults()));
    return meshHash(outcome->mesh);
}

} // namespace

TEST_CASE("Curved drawings: a document meshes like its file, also after it was saved and read again") {
    for (const Drawing &drawing : kDrawings) {
        CAPTURE(drawing.what);
        const TemporaryFolder folder;
        const auto path = fileOf(drawing, folder);
        const Result<DomainFile> domain = allFormats().readDomain(path);
        const Result<Document> document = readDocument(path);
        REQUIRE(domain.ok());
        REQUIRE(document.ok());
        CHECK(sameDomain(toDomain(*document), domain->domain));
        const Result<Document> again = parseProject(projectText(*document), "again.forefront");
        REQUIRE_MESSAGE(again.ok(), messages(again.faults()));
        CHECK(sameContent(*again, *document));
        CHECK(validate(domain->domain).empty());
        CHECK(hashOf(toDomain(*again)) == hashOf(domain->domain));
        CHECK(sameContent(fromDomain(toDomain(*document)), *document));
    }
}

TEST_CASE("Maps: a document meshes like its file, also after it was saved and read again") {
    const TemporaryFolder folder;
    const std::pair<const char *, const char *> files[] = {
        {"map.geojson", kMap},
        {"straight.svg", R"(<svg viewBox="0 0 9 9"><path d="M1 1H6V6H1z"/><path fill="red" d="M3 3H8V8H3z"/></svg>)"}};
    for (const auto &[name, text] : files) {
        CAPTURE(name);
        REQUIRE(writeFileAtomically(folder / name, text).empty());
        const Result<DomainFile> domain = allFormats().readDomain(folder / name);
        const Result<Document> document = readDocument(folder / name);
        REQUIRE(domain.ok());
        REQUIRE(document.ok());
        CHECK(sameDomain(toDomain(*document), domain->domain));
        CHECK(document->regionNames == domain->domain.regionNames);
        CHECK(document->boundaryNames == domain->domain.boundaryNames);
        const Result<Document> again = parseProject(projectText(*document), "again.forefront");
        REQUIRE_MESSAGE(again.ok(), messages(again.faults()));
        CHECK(hashOf(toDomain(*again)) == hashOf(domain->domain));
        CHECK(sameContent(fromDomain(toDomain(*document)), *document));
    }
}

TEST_CASE("fromDomain: a curve of one chord keeps it, also in a project file") {
    Domain domain;
    domain.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    domain.curves = {Curve::cubic({0, 0}, {1, -1}, {3, -1}, {4, 0})};
    for (std::uint32_t k = 0; k < 4; ++k) {
        domain.segments.push_back({k, (k + 1) % 4});
    }
    domain.segments[0].stretch = {0, 0.0, 1.0};
    const Document document = fromDomain(domain);
    REQUIRE(document.shapes.size() == 1);
    CHECK(document.shapes[0]->cuts == std::vector<std::vector<double>>{{1.0}, {}, {}, {}});
    CHECK(sameDomain(toDomain(document), domain));
    const Result<Document> again = parseProject(projectText(document), "again.forefront");
    REQUIRE_MESSAGE(again.ok(), messages(again.faults()));
    CHECK(sameDomain(toDomain(*again), domain));
}

TEST_CASE("Curved drawings: paths keep the curves of the file exactly") {
    const TemporaryFolder folder;
    const Drawing drop{"drop", R"svg(<g transform="scale(2)"><path d="M1 2C3 4 5 -6 7 2A3 2 0 0 1 1 2z"/></g>)svg"};
    const Result<Document> document = readDocument(fileOf(drop, folder), {.beyondPage = true});
    REQUIRE(document.ok());
    REQUIRE(document->shapes.size() == 1);
    const Shape &shape = *document->shapes[0];
    REQUIRE(shape.nodes.size() == 2);
    REQUIRE(shape.path().curves.size() == 2);
    const Vec2 start = shape.nodes[0];
    CHECK(shape.path().curves[0] == Curve::cubic(start, {6, start.y - 4}, {10, start.y + 16}, {14, start.y}));
    REQUIRE(shape.path().curves[1].kind() == CurveKind::Arc);
    CHECK(shape.path().curves[1].numbers()[2] == doctest::Approx(6.0));
    CHECK(joins(shape.path().curves[1], shape.nodes[1], start));
}

TEST_CASE("Curved drawings: loops of one curve become circles and ellipses, and crossings end curves") {
    const TemporaryFolder folder;
    const Result<Document> loops = readDocument(fileOf(kDrawings[0], folder));
    REQUIRE(loops.ok());
    REQUIRE(loops->shapes.size() == 2);
    CHECK(loops->shapes[0]->kind() == ShapeKind::Circle);
    CHECK(circleRadius(*loops->shapes[0]) == doctest::Approx(4.0));
    CHECK(loops->shapes[1]->kind() == ShapeKind::Ellipse);
    CHECK(areaOf(*loops->shapes[1]) == doctest::Approx(18.0 * pi));
    const Result<Document> crossing = readDocument(fileOf(kDrawings[5], folder));
    REQUIRE(crossing.ok());
    REQUIRE(crossing->shapes.size() == 1);
    CHECK(curvedSegments(*crossing) >= 2);
    const double lens = 2.0 * (36.0 * std::acos(0.5) - 3.0 * std::sqrt(27.0));
    CHECK(areaOf(*crossing->shapes[0]) == doctest::Approx(72.0 * pi - lens).epsilon(2e-3));
}
