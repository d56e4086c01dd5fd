#include "core/drawing/commands/corner_commands.hpp"
#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/repair_drawing.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/clipboard/clipboard.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/boundary/discretise.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

/// Returns the number of boundary edges with a tag, as meshed.
std::ptrdiff_t edges(const Document &document, std::int32_t tag) {
    const MeshingJob job = jobOf(document);
    const auto field = SpacingField::build(job.spacing, job.domain);
    REQUIRE(field.ok());
    const Result<DiscreteDomain> discrete =
        discretise(job.domain, **field, false, {}, nullptr, NarrowTips::Divided, job.spacing.placed.elements);
    REQUIRE(discrete.ok());
    return std::count_if(discrete->segments.begin(), discrete->segments.end(),
                         [&](const auto &segment) { return segment.tag == tag; });
}

/// Returns the number of edges along one segment of a shape.
std::ptrdiff_t edgesAlong(Document document, SegmentRef segment) {
    constexpr std::int32_t kApart = 999;
    const bool whole = taggedSegments(*findShape(document, segment.shape)) == 1;
    return edges(whole ? *setShapeTag(document, {segment.shape}, kApart) : *setSegmentTag(document, {segment}, kApart),
                 kApart);
}

} // namespace

TEST_CASE("setElementCount: a straight segment, a circle and an arc get exactly that many elements") {
    Shape circle = makeShape(ShapeKind::Circle, {{0, 0}, {0.7, 0.1}});
    Document document = *addShapes({}, {square({-4, -3}, 7.3), circle});
    document.spacing.size = 1e3;
    for (const std::uint32_t count : {1U, 2U, 3U, 7U, 10U, 33U, 49U, 1000U}) {
        CAPTURE(count);
        const Document next = *setElementCount(document, {{1, 1}}, count);
        CHECK(next.shapes[0]->segmentTags.empty()); // a number of elements is no boundary
        CHECK(next.shapes[0]->tag == 1);
        CHECK(next.shapes[1]->tag == 1);
        CHECK(elementCount(next, {1, 1}) == count);
        CHECK_FALSE(elementCount(next, {1, 0}).has_value());
        CHECK(edgesAlong(next, {1, 1}) == count);
    }
    for (const std::uint32_t count : {3U, 4U, 24U, 32U, 47U, 200U, 500U}) {
        CAPTURE(count);
        const Document next = *setElementCount(document, {{2, 0}}, count);
        CHECK(next.shapes[1]->segmentTags.empty());
        CHECK(elementCount(next, {2, 0}) == count);
        CHECK(edgesAlong(next, {2, 0}) == count);
    }
    Shape arc = makeShape(ShapeKind::Polyline, {{2, 0}, {2.5, 1}}, ShapeUse::Constraint);
    arc.path().curves = {arcThrough({2, 0}, {2.6, 0.4}, {2.5, 1})};
    const Shape ellipse = makeShape(ShapeKind::Ellipse, {{-2, 2}, {-1, 2}, {-2, 2.5}});
    document = *addShapes(document, {arc, ellipse});
    for (const std::uint32_t id : {3U, 4U}) {
        CAPTURE(id);
        for (const std::uint32_t count : {3U, 60U, 300U}) {
            CHECK(edgesAlong(*setElementCount(document, {{id, 0}}, count), {id, 0}) == count);
        }
    }
}

TEST_CASE("setElementCount: each segment gets the number; tags and names stay, and so does the growth") {
    const Shape bar = makeShape(ShapeKind::Polygon, {{0, 0}, {4, 0}, {4, 1}, {0, 1}});
    Document document = *addShapes({}, {bar});
    document.boundaryNames = {{1, "wall"}};
    document.spacing.size = 1e3;
    document.spacing.partSizes[1] = {50.0, 0.4};
    const Document next = *setElementCount(document, {{1, 0}, {1, 1}, {1, 2}}, 8);
    CHECK(next.shapes[0]->segmentTags.empty());
    CHECK(next.boundaryNames == document.boundaryNames);
    CHECK(next.elementCounts.empty());
    CHECK(next.spacing.partSizes == document.spacing.partSizes);
    const SegmentSize eight{.size = 0.0, .elements = 8, .growth = 0.4};
    CHECK(next.shapes[0]->segmentSizes == std::map<std::uint32_t, SegmentSize>{{0, eight}, {1, eight}, {2, eight}});
    const PlacedSizes placed = spacingOf(next).placed;
    CHECK(placed.elements == std::vector<std::uint32_t>{8, 8, 8, 0});
    CHECK(placed.segments == std::vector<PartSize>{{0.5, 0.4}, {0.125, 0.4}, {0.5, 0.4}, {0.0, 0.0}});
    CHECK(edgesAlong(next, {1, 1}) == 8);
    CHECK(edgesAlong(next, {1, 0}) == 8);
    const Document again = *setElementCount(next, {{1, 1}}, 5);
    CHECK(elementCount(again, {1, 1}) == 5U);
    const Document none = *setElementCount(again, {{1, 1}}, std::nullopt);
    CHECK_FALSE(none.shapes[0]->segmentSizes.contains(1));
    CHECK(none.spacing.partSizes == document.spacing.partSizes);
}

TEST_CASE("setElementCount: tens of thousands of segments are changed in one pass; each keeps its growth") {
    std::vector<Vec2> corners;
    constexpr std::uint32_t kCorners = 20'000;
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kCorners;
        corners.push_back({std::cos(angle), std::sin(angle)});
    }
    Document document = *addShapes({}, {makeShape(ShapeKind::Polygon, corners), square({5, 5}, 1)});
    document = *setSegmentSize(document, {{1, 7}}, SegmentSize{.size = 1e-4, .growth = 0.6});
    std::set<SegmentRef> segments{{2, 1}};
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        segments.insert({1, k});
    }
    const Document next = *setElementCount(document, segments, 2);
    CHECK(next.shapes[0]->segmentSizes.size() == kCorners);
    CHECK(next.shapes[0]->segmentSizes.at(7).growth == 0.6);
    CHECK(next.shapes[0]->segmentSizes.at(8).growth == PartSize{}.growth);
    CHECK(next.shapes[1]->segmentSizes.size() == 1);
    CHECK(elementCount(next, {1, kCorners - 1}) == 2U);
    segments.insert({2, 9}); // which does not exist
    CHECK(setElementCount(document, segments, 2).faults().front().code == "no-such-segment");
}

TEST_CASE("setElementCount: a number of one segment takes precedence over that of its boundary part") {
    Document document = *addShapes({}, {square({0, 0}, 2)});
    document.boundaryNames = {{1, "wall"}};
    document = *setPartElements(document, 1, PartElements{8, 0.2});
    REQUIRE(elementCount(document, {1, 0}) == 8U);
    const Document next = *setElementCount(document, {{1, 0}}, 3);
    CHECK(elementCount(next, {1, 0}) == 3U);
    CHECK(elementCount(next, {1, 1}) == 8U);
    CHECK(edges(next, 1) == 3 + 3 * 8);
    CHECK(sameContent(*setElementCount(next, {{1, 0}}, std::nullopt), document));
}

TEST_CASE("setElementCount: automatic spacing, bends, finer sizes nearby and limits do not change the number") {
    const auto circle = makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}});
    Document document = *addShapes({}, {square({-5, -5}, 10), circle});
    document = *setShapeTag(document, {2}, 2);
    document = *setElementCount(document, {{2, 0}}, 24); // automatic spacing has 40 per turn
    CHECK(edges(document, 2) == 24);
    document.spacing.segmentsPerTurn = 90.0;
    CHECK(edges(document, 2) == 24);
    document.spacing.elementsAcross = 50.0;
    CHECK(edges(document, 2) == 24);
    SizeSource fine;
    fine.a = fine.b = {1, 0};
    fine.size = 0.01;
    document.spacing.sources.push_back(fine);
    CHECK(edges(document, 2) == 24);
    document.spacing.minimum = 0.5;
    CHECK(edges(document, 2) == 24);
    document.spacing.partSizes[1] = {0.5, 2.0};
    CHECK(edges(document, 2) == 24);
}

TEST_CASE("setElementCount: a curve that another shape divides has the number in all") {
    const auto circle = makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}});
    const auto spoke = makeShape(ShapeKind::Polyline, {{0, 0}, {1, 0}}, ShapeUse::Constraint, 5);
    Document document = *addShapes({}, {circle, spoke});
    const std::vector<Vec2> &nodes = toDomain(document).nodes;
    const auto off = makeShape(ShapeKind::Polyline, {{0, 0}, nodes[nodes.size() / 3]}, ShapeUse::Constraint, 5);
    document = *addShapes(document, {off});
    document.spacing.size = 1.0;
    for (const std::uint32_t count : {5U, 24U, 25U, 100U}) {
        CAPTURE(count);
        CHECK(edgesAlong(*setElementCount(document, {{1, 0}}, count), {1, 0}) == count);
    }
}

TEST_CASE("setElementCount: with fewer elements than keep the boundary apart, it gets more") {
    const auto outer = makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}});
    const auto inner = makeShape(ShapeKind::Circle, {{0, 0}, {0.9, 0}}, ShapeUse::Boundary, 2);
    const Document document = *addShapes({}, {outer, inner});
    CHECK(edges(*setElementCount(document, {{1, 0}}, 4), 1) > 4);
    CHECK(edges(*setElementCount(document, {{1, 0}}, 40), 1) == 40);
}

TEST_CASE("setElementCount: meshes with few elements along curves fit their domain, and others do not") {
    const auto slot = makeShape(ShapeKind::Circle, {{3, 2}, {4, 2}}, ShapeUse::Boundary, 2);
    const auto inner = makeShape(ShapeKind::Circle, {{7, 4}, {8, 4}}, ShapeUse::Constraint, 3);
    Document document = *addShapes({}, {square({0, 0}, 10), slot, inner});
    document = *setElementCount(*setElementCount(document, {{2, 0}}, 3), {{3, 0}}, 5);
    const MeshingJob whole = jobOf(document);
    const auto faultsIn = [&](const TriMesh &mesh) {
        return verifyAgainst(mesh, whole.domain, whole.spacing.placed.elements);
    };
    for (const Method method : {Method::Fast, Method::Classic}) {
        MeshingJob job = whole;
        job.options.method = method;
        const Result<MeshingOutcome> outcome = meshDomain(job);
        REQUIRE(outcome.ok());
        TriMesh mesh = takeTriMesh(outcome->mesh);
        for (const auto &[tag, count] : std::map<std::int32_t, std::ptrdiff_t>{{2, 3}, {3, 5}}) {
            CHECK(std::count_if(mesh.edges.begin(), mesh.edges.end(), [&](const auto &e) { return e.tag == tag; }) ==
                  count);
        }
        CHECK(faultsIn(mesh).empty());
        const auto onHole =
            std::find_if(mesh.edges.begin(), mesh.edges.end(), [](const auto &e) { return e.tag == 2; });
        Vec2 &moved = mesh.nodes[index(onHole->b)];
        moved += 1e-4 * (moved - Vec2{3, 2}); // beside the curve
        CHECK_FALSE(faultsIn(mesh).empty());
    }
}

TEST_CASE("setElementCount: refuses what cannot be counted, and replaces sizes, which replace it") {
    Shape rounded = makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 3}});
    rounded.as<RectangleForm>().radius = 1.5; // nothing is left of the shorter sides
    Document document = *addShapes({}, {rounded, square({6, 0}, 2)});
    CHECK(codeOf(setElementCount(document, {{1, 1}}, 4)) == "not-possible");
    CHECK(codeOf(setElementCount(document, {{2, 9}}, 4)) == "no-such-segment");
    CHECK(codeOf(setElementCount(document, {{2, 0}}, 0)) == "bad-number");
    CHECK(codeOf(setElementCount(document, {{2, 0}}, kMaxElementCount + 1)) == "bad-number");
    CHECK(codeOf(setPartElements(document, 1, PartElements{4, -1.0})) == "bad-source");
    CHECK_FALSE(elementCount(document, {2, 0}).has_value());
    const Document sized = *setPartSize(document, 1, PartSize{0.3, 0.1});
    const Document counted = *setElementCount(sized, {{2, 0}}, 8);
    CHECK(*segmentSize(counted, {2, 0}) == SegmentSize{.size = 0.0, .elements = 8, .growth = 0.1});
    const Document again = *changeSegmentSizes(counted, {{2, 0}}, {.size = 0.5, .growth = {}});
    CHECK(*segmentSize(again, {2, 0}) == SegmentSize{.size = 0.5, .elements = 0, .growth = 0.1});
    CHECK(spacingOf(again).placed.elements.empty());
    const Document other = *setSpacing(counted, spacingOf(sized));
    CHECK_FALSE(hasSegmentSizes(other));
    CHECK(spacingOf(other).partSizes == sized.spacing.partSizes);
    CHECK(codeOf(setSegmentSize(document, {{2, 0}}, SegmentSize{.size = -1.0})) == "bad-size");
    CHECK(codeOf(setSegmentSize(document, {{2, 9}}, SegmentSize{.size = 1.0})) == "no-such-segment");
    CHECK(codeOf(setSegmentSize(document, {{7, 0}}, SegmentSize{.size = 1.0})) == "no-such-shape");
}

TEST_CASE("Element counts: are kept when the length changes") {
    Document document = *addShapes({}, {square({-10, -10}, 20), makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}})});
    document.spacing.size = 5.0;
    document.spacing.segmentsPerTurn = 0.0;
    document = *setElementCount(document, {{2, 0}}, 60);
    CHECK(edgesAlong(document, {2, 0}) == 60);
    for (const double radius : {0.3, 1.25, 4.0}) {
        CAPTURE(radius);
        CHECK(edgesAlong(*setRadius(document, 2, radius), {2, 0}) == 60);
    }
    Selection circle;
    circle.shapes = {2};
    Document copied = *duplicateSelection(document, circle, {5, 5}, nullptr);
    CHECK(edgesAlong(copied, {3, 0}) == 60);
    CHECK(edgesAlong(*setRadius(copied, 2, 2.0), {3, 0}) == 60); // each has its own
}

TEST_CASE("Element counts: divided and joined segments keep the size of their elements") {
    Document document = *addShapes({}, {square({-10, -10}, 20), makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}})});
    document.spacing.size = 50.0;
    document.spacing.segmentsPerTurn = 0.0;
    document = *setElementCount(*setElementCount(document, {{2, 0}}, 60), {{1, 0}}, 30);
    Document next = *insertNode(*convertToPath(document, 2), {1, 0}, {0, -10});
    carrySegmentSizes(document, next);
    for (std::uint32_t k = 0; k < 4; ++k) {
        CHECK(elementCount(next, {2, k}) == 15U);
        CHECK(edgesAlong(next, {2, k}) == 15);
    }
    CHECK(elementCount(next, {1, 0}) == 15U);
    CHECK(edgesAlong(next, {1, 1}) == 15);
    CHECK(next.shapes[0]->segmentSizes.size() == 2);
    Selection node;
    node.nodes = {{1, 1}};
    Document joined = deleteSelection(next, node);
    carrySegmentSizes(next, joined);
    CHECK(elementCount(joined, {1, 0}) == 30U);
    Document cut = document; // a fillet shortens the side, which keeps its number
    node.nodes = {{1, 1}};
    cut = *filletCorners(document, node, 4.0);
    carrySegmentSizes(document, cut);
    CHECK(elementCount(cut, {1, 0}) == 30U);
    CHECK(cut.shapes[0]->segmentSizes.size() == 1);
}

TEST_CASE("Element counts: a repair that divides a segment keeps the size of its elements") {
    Document document = *addShapes({}, {square({-10, -10}, 20),
                                        makeShape(ShapeKind::Polyline, {{-8, 0}, {8, 0}}, ShapeUse::Constraint, 2),
                                        makeShape(ShapeKind::Polyline, {{4, -5}, {4, 5}}, ShapeUse::Constraint, 3)});
    document.spacing.size = 50.0;
    document = *setElementCount(document, {{2, 0}}, 40);
    const Result<RepairedDrawing> repaired = repairDrawing(document, 0.0);
    REQUIRE(repaired.ok());
    Document next = repaired->document;
    carrySegmentSizes(document, next);
    CHECK(edges(next, 2) == 40); // 30 and 10
}

TEST_CASE("Element counts: a side whose corners are rounded keeps its number on the straight part") {
    Document document = *addShapes({}, {makeShape(ShapeKind::Rectangle, {{0, 0}, {8, 6}})});
    document.spacing.size = 50.0;
    document = *setElementCount(document, {{1, 0}}, 60);
    Shape rounded = *document.shapes[0];
    rounded.as<RectangleForm>().radius = 1.0;
    Document next = *replaceShape(document, rounded);
    carrySegmentSizes(document, next);
    CHECK(next.shapes[0]->segmentSizes.size() == 1);
    CHECK(edgesAlong(next, {1, 0}) == 60);
}

TEST_CASE("Element counts: follow expressions, which must give whole numbers") {
    Document document = *addShapes({}, {makeShape(ShapeKind::Circle, {{0, 0}, {8, 0}})});
    document = *setParameters(*setElementCount(document, {{1, 0}}, 24), {{"d", "16"}, {"n", "24"}});
    document = setFormula(std::move(document), "shape/1/radius"_number, "d/2");
    document = setFormula(std::move(document), "shape/1/segmentElements/0"_number, "n");
    CHECK(edges(document, 1) == 24);
    const Document larger = *overrideParameters(document, {{"d", "20"}, {"n", "60"}});
    CHECK(circleRadius(*larger.shapes[0]) == 10.0);
    CHECK(elementCount(larger, {1, 0}) == 60U);
    CHECK(edges(larger, 1) == 60);
    const Result<Document> broken = overrideParameters(document, {{"n", "24.5"}});
    REQUIRE_FALSE(broken.ok());
    CHECK(broken.faults().front().message ==
          "invalid number of elements 24.5; expected a whole number from 1 to 1000000");
}

TEST_CASE("Element counts: of boundary parts are written to projects with their sizes, which older programs use") {
    Document document = *addShapes({}, {square({0, 0}, 4)});
    document = *setPartElements(*setSegmentTag(document, {{1, 0}, {1, 2}}, 2), 2, PartElements{8, 0.2});
    const std::string text = projectText(document);
    CHECK(text.find(R"("partSizes": [
      {"tag": 2, "size": 0.5, "growth": 0.2}
    ])") != std::string::npos);
    CHECK(text.find(R"("elementCounts": [{"tag": 2, "elements": 8, "growth": 0.2}])") != std::string::npos);
    const Document read = *parseProject(text, "test");
    CHECK(sameContent(read, document));
    CHECK(read.spacing.partSizes.empty());
    CHECK(projectText({}).find("elementCounts") == std::string::npos);
    for (const char *wrong : {R"([{"tag": 2, "elements": 0}])", R"([{"tag": 2, "elements": 2.5}])", R"([{"tag": 2}])",
                              R"([{"tag": 2, "elements": 3}, {"tag": 2, "elements": 4}])", "8"}) {
        CAPTURE(wrong);
        const auto refused =
            parseProject(R"({"format": "forefront", "version": 2, "shapes": [], "spacing": {}, "elementCounts": )" +
                             std::string(wrong) + "}",
                         "test");
        REQUIRE_FALSE(refused.ok());
        CHECK(refused.faults().front().line == 1);
    }
}

TEST_CASE("Element counts: come along with copies into another drawing") {
    Document document = *addShapes({}, {square({0, 0}, 4), makeShape(ShapeKind::Circle, {{2, 2}, {3, 2}})});
    document = *setElementCount(document, {{2, 0}}, 24);
    Selection circle;
    circle.shapes = {2};
    const Result<Document> copied = readClipboard(clipboardText(document, circle));
    REQUIRE(copied.ok());
    const Document other = *setShapeTag(*addShapes({}, {square({0, 0}, 4)}), {1}, 2);
    for (const Document &into : {Document(), other}) {
        const Document next = *insertCopied(into, *copied, {1, 1}, nullptr);
        CHECK(elementCount(next, {next.shapes.back()->id, 0}) == 24U);
    }
    document = *setPartElements(*setShapeTag(document, {2}, 2), 2, PartElements{7, 0.2}); // also of a boundary part
    const Result<Document> part = readClipboard(clipboardText(document, circle));
    REQUIRE(part.ok());
    CHECK(insertCopied({}, *part, {1, 1}, nullptr)->elementCounts == document.elementCounts);
    CHECK(insertCopied(other, *part, {1, 1}, nullptr)->elementCounts.empty());
}
