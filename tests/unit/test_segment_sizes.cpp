#include "core/drawing/commands/combine_shapes.hpp"
#include "core/drawing/commands/corner_commands.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/scale_document.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

using Sizes = std::map<std::uint32_t, SegmentSize>;

SegmentSize segmentSized(double size) {
    return {.size = size, .elements = 0, .growth = 0.2};
}

SegmentSize counted(std::uint32_t elements) {
    return {.size = 0.0, .elements = elements, .growth = 0.2};
}

/// A square of side 8 whose lower side has a size and whose right one has 12 elements.
Document sizedSquare() {
    Document document = documentOf({square({0, 0}, 8)});
    document = *setSegmentSize(document, {{1, 0}}, segmentSized(0.5));
    return *setSegmentSize(document, {{1, 1}}, counted(12));
}

/// Returns the sizes of a shape after a command, as the editor applies it.
Sizes carried(const Document &before, Result<Document> next, std::size_t shape = 0) {
    REQUIRE(next.ok());
    carrySegmentSizes(before, *next);
    REQUIRE(shape < next->shapes.size());
    return next->shapes[shape]->segmentSizes;
}

std::uint64_t hashOf(const Document &document) {
    const auto outcome = meshDomain(jobOf(document));
    REQUIRE(outcome);
    return meshHash(outcome->mesh);
}

} // namespace

TEST_CASE("Segment sizes: belong to segments, change no tag, and are in the spacing there") {
    Document document = sizedSquare();
    document.boundaryNames = {{1, "wall"}};
    document.spacing.size = 2.0;
    CHECK(document.shapes[0]->segmentTags.empty());
    CHECK(boundaryTags(document) == std::vector<std::int32_t>{1});
    const MeshingJob job = jobOf(document);
    CHECK(job.spacing.partSizes.empty());
    const auto field = SpacingField::build(job.spacing, job.domain);
    REQUIRE(field.ok());
    CHECK((*field)->at({4, 0}) == doctest::Approx(0.5));
    CHECK((*field)->at({8, 4}) == doctest::Approx(8.0 / 12.0));
    CHECK((*field)->at({0, 8}) == doctest::Approx(2.0));
    CHECK((*field)->sample({4, 0}).describe == "size of a segment of 'wall' at (4, 0)");
}

TEST_CASE("Segment sizes: take the place of the size of their boundary part, also a smaller one") {
    Document document = sizedSquare();
    document.spacing.size = 2.0;
    document = *setPartSize(document, 1, PartSize{0.1, 0.2});
    const MeshingJob job = jobOf(document);
    const auto field = SpacingField::build(job.spacing, job.domain);
    REQUIRE(field.ok());
    CHECK((*field)->at({0, 4}) == doctest::Approx(0.1));
    CHECK((*field)->at({4, 0}) == doctest::Approx(0.5));
}

TEST_CASE("Segment sizes: stay at their places when nodes are inserted, deleted or cut off") {
    const Document document = sizedSquare();
    CHECK(carried(document, insertNode(document, {1, 0}, {2, 0})) ==
          Sizes{{0, segmentSized(0.5)}, {1, segmentSized(0.5)}, {2, counted(12)}});
    CHECK(carried(document, insertNode(document, {1, 1}, {8, 2})) ==
          Sizes{{0, segmentSized(0.5)}, {1, counted(3)}, {2, counted(9)}});
    CHECK(carried(document, insertNode(document, {1, 3}, {0, 4})) == Sizes{{0, segmentSized(0.5)}, {1, counted(12)}});
    Selection node;
    node.nodes = {{1, 3}};
    CHECK(carried(document, deleteSelection(document, node)) == Sizes{{0, segmentSized(0.5)}, {1, counted(12)}});
    node.nodes = {{1, 0}}; // the first side goes
    CHECK(carried(document, deleteSelection(document, node)) == Sizes{{0, counted(12)}});
    node.nodes = {{1, 1}};
    CHECK(carried(document, filletCorners(document, node, 2.0)) == Sizes{{0, segmentSized(0.5)}, {2, counted(12)}});
    CHECK(carried(document, splitPath(document, {1, 2})) == Sizes{{2, segmentSized(0.5)}, {3, counted(12)}});
    Selection side;
    side.segments = {{1, 3}};
    CHECK(carried(document, deleteSelection(document, side)) == Sizes{{0, segmentSized(0.5)}, {1, counted(12)}});
}

TEST_CASE("Segment sizes: go with moved, mirrored, turned, scaled and copied shapes") {
    const Document document = sizedSquare();
    const Sizes same{{0, segmentSized(0.5)}, {1, counted(12)}};
    CHECK(carried(document, setHandle(document, {1, 1}, {9, -1})) == same);
    CHECK(carried(document, moveSelection(document, selected({1}), {3, 4})) == same);
    CHECK(carried(document, transformSelection(document, selected({1}), PlaneMap::scaling({-1, 1}, {4, 4}))) == same);
    CHECK(carried(document, duplicateSelection(document, selected({1}), {20, 0}, nullptr), 1) == same);
    CHECK(carried(document, scaleDocument(document, {0, 0}, 2.0)) == Sizes{{0, segmentSized(1.0)}, {1, counted(12)}});

    Document box = documentOf({makeShape(ShapeKind::Rectangle, {{0, 0}, {6, 4}})});
    box = *setSegmentSize(box, {{1, 0}}, segmentSized(0.5));
    const PlaneMap quarter = PlaneMap::rotation(90.0, {0, 0}); // the lower side becomes the right one, the last
    CHECK(carried(box, transformSelection(box, selected({1}), quarter)) == Sizes{{3, segmentSized(0.5)}});
    CHECK(carried(box, convertToPath(box, 1)) == Sizes{{0, segmentSized(0.5)}});
    Shape rounded = *box.shapes[0];
    rounded.as<RectangleForm>().radius = 1.0;
    CHECK(carried(box, replaceShape(box, rounded)) == Sizes{{0, segmentSized(0.5)}});
    const Document round = *replaceShape(box, rounded);
    CHECK(carried(round, convertToPath(round, 1)) == Sizes{{0, segmentSized(0.5)}});

    Shape wide = makeShape(ShapeKind::Slot, {{0, 0}, {6, 0}});
    wide.as<SlotForm>().radius = 1.0;
    const Document slot = *setSegmentSize(documentOf({wide}), {{1, 0}}, segmentSized(0.5));
    CHECK(carried(slot, transformSelection(slot, selected({1}), PlaneMap::scaling({1, -1}, {0, 0}))) ==
          Sizes{{2, segmentSized(0.5)}});
}

TEST_CASE("Segment sizes: a circle that becomes a path shares its elements between its quarters") {
    Document document = documentOf({makeShape(ShapeKind::Circle, {{0, 0}, {2, 0}})});
    document = *setElementCount(document, {{1, 0}}, 30);
    const Sizes sizes = carried(document, convertToPath(document, 1));
    REQUIRE(sizes.size() == 4);
    std::uint32_t all = 0;
    for (const auto &[part, size] : sizes) {
        all += size.elements;
    }
    CHECK(all == 30);
}

TEST_CASE("Segment sizes: combined and trimmed shapes keep them on what is left of their segments") {
    Document document = documentOf({square({0, 0}, 8), square({6, 2}, 4)});
    document = *setSegmentSize(document, {{1, 0}}, segmentSized(0.5));
    document = *setSegmentSize(document, {{1, 1}}, counted(12)); // the other square divides this side
    Result<Document> united = combineShapes(document, {1, 2}, ShapeOperation::Union);
    REQUIRE(united.ok());
    carrySegmentSizes(document, *united);
    REQUIRE(united->shapes.size() == 1);
    const Shape &shape = *united->shapes[0];
    const Outline outline = outlineOf(shape);
    double fine = 0.0;
    std::uint32_t elements = 0;
    for (const auto &[part, size] : shape.segmentSizes) {
        const Vec2 middle = outline.curve(part).point(0.5);
        if (size.elements > 0) {
            CHECK(middle.x == 8.0);
            elements += size.elements;
        } else {
            CHECK(middle.y == 0.0);
            fine += outline.curve(part).length();
        }
    }
    CHECK(fine == 8.0);
    CHECK(elements == 6); // half of the side is left
}

TEST_CASE("Segment sizes: of shapes that a command leaves alone give nothing to new ones at their places") {
    const Document document = sizedSquare();
    const Result<Document> next = addShape(document, makeShape(ShapeKind::Polyline, {{0, 0}, {8, 0}}));
    CHECK(carried(document, next, 1).empty());
    CHECK(carried(document, next, 0) == document.shapes[0]->segmentSizes);
    CHECK(carried(document, setSegmentSize(document, {{1, 0}, {1, 1}}, std::nullopt)).empty()); // removed on purpose
}

TEST_CASE("Segment sizes: follow expressions, and lose them when they are entered as numbers") {
    Document document = *setParameters(sizedSquare(), {{"h", "0.25"}});
    document = *changeSegmentSizes(document, {{1, 0}}, {.size = 0.25, .growth = {}});
    document = setFormula(std::move(document), "shape/1/segmentSize/0"_number, "h");
    CHECK(segmentSize(document, {1, 0})->size == 0.25);
    const Document finer = *overrideParameters(document, {{"h", "0.125"}});
    CHECK(segmentSize(finer, {1, 0})->size == 0.125);
    CHECK(segmentSize(finer, {1, 1})->elements == 12);
    Document typed = *changeSegmentSizes(finer, {{1, 0}}, {.size = 0.3, .growth = {}});
    carryFormulas(finer, typed);
    CHECK(typed.formulas.empty());
}

TEST_CASE("Segment sizes: are the same after saving and opening, and wrong ones are refused with their place") {
    const Document document = sizedSquare();
    const std::string text = projectText(document);
    CHECK(
        text.find(
            R"("segmentSizes": [{"segment": 0, "size": 0.5, "growth": 0.2}, {"segment": 1, "elements": 12, "growth": 0.2}])") !=
        std::string::npos);
    CHECK(text.find("partSizes") == std::string::npos);
    const Document read = *parseProject(text, "test");
    CHECK(sameContent(read, document));
    CHECK(hashOf(read) == hashOf(document));
    for (const char *wrong : {R"([{"segment": 4, "size": 1}])", R"([{"segment": 0}])", R"([{"segment": 0, "size": 0}])",
                              R"([{"segment": 0, "elements": 0}])", R"([{"segment": 0, "elements": 2, "size": 1}])",
                              R"([{"segment": 0, "size": 1}, {"segment": 0, "size": 2}])", R"([{"size": 1}])", "8"}) {
        CAPTURE(wrong);
        const auto refused = parseProject(
            R"({"format": "forefront", "version": 2, "spacing": {}, "shapes": [{"id": 1, "kind": "polygon", "nodes":
 [[0, 0], [1, 0], [1, 1], [0, 1]], "segmentSizes": )" +
                std::string(wrong) + "}]}",
            "test");
        REQUIRE_FALSE(refused.ok());
        CHECK(refused.faults().front().line == 2);
    }
}

TEST_CASE("Segment sizes: projects with sizes by tag keep their meaning and their meshes") {
    constexpr const char *kOlder = R"({"format": "forefront", "version": 2, "shapes": [
  {"id": 1, "kind": "polygon", "use": "boundary", "tag": 1, "name": "", "nodes": [[0, 0], [8, 0], [8, 8], [0, 8]],
   "segmentTags": [1, 2, 1, 3]}],
  "spacing": {"size": 2, "partSizes": [{"tag": 2, "size": 0.5, "growth": 0.2}]},
  "elementCounts": [{"tag": 3, "elements": 12, "growth": 0.2}]})";
    const Document older = *parseProject(kOlder, "test");
    CHECK(older.shapes[0]->segmentSizes.empty());
    CHECK(older.spacing.partSizes.at(2) == PartSize{0.5, 0.2});
    CHECK(older.elementCounts.at(3) == PartElements{12, 0.2});
    CHECK(sameContent(*parseProject(projectText(older), "test"), older));
    Document newer = older; // the same sizes at the segments themselves
    newer.spacing.partSizes.clear();
    newer.elementCounts.clear();
    newer = *setSegmentSize(*setSegmentSize(newer, {{1, 1}}, segmentSized(0.5)), {{1, 3}}, counted(12));
    CHECK(hashOf(newer) == hashOf(older));
}
