#include "core/drawing/document/equality.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/drawing_files/drawing_formats.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/part_list.hpp"
#include "core/files/files.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

/// A square of side 10 with a size at a node, in its region and a number of elements along one side.
Document sizedSquare() {
    Document document = *addShape({}, square({0, 0}, 10));
    document = *addRegionMarker(document, {{5, 5}, 2, 1.5, 0.5, 0.1});
    document = *addRegionMarker(document, {{8, 8}, 2}); // without sizes
    document = *setNodeSize(document, {{1, 2}}, PartSize{0.1, 0.3});
    document = *setElementCount(document, {{1, 1}}, 8);
    return document;
}

constexpr const char *kCappedSquare = "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n"
                                      "0\n1\n1 2 2 7 0.05\n";

std::size_t countOf(const MeshingJob &job) {
    const auto outcome = meshDomain(job);
    REQUIRE(outcome);
    return outcome->mesh.elementCount();
}

} // namespace

TEST_CASE("Placed sizes: a document gives all of them with its spacing, and none with its domain") {
    const Document document = sizedSquare();
    const MeshingJob job = jobOf(document);
    CHECK(sameContent(spacingOf(document), job.spacing));
    CHECK(job.domain.regionMarkers == std::vector<RegionMarker>{{{5, 5}, 2}, {{8, 8}, 2}});
    const PlacedSizes &placed = job.spacing.placed;
    REQUIRE(placed.nodes.size() == 1);
    CHECK(placed.nodes[0].at == Vec2{10, 10});
    CHECK(placed.nodes[0].size == 0.1);
    CHECK(placed.regions == std::vector<RegionSize>{{{5, 5}, 1.5, 0.5, 0.1}});
    CHECK(placed.elements == std::vector<std::uint32_t>{0, 8, 0, 0});
    CHECK(rulesOf(document).placed == PlacedSizes());
    CHECK(placed.segments == std::vector<PartSize>{{0.0, 0.0}, {1.25, 0.2}, {0.0, 0.0}, {0.0, 0.0}});
    CHECK(rulesOf(document).partSizes == job.spacing.partSizes);
    CHECK(spacingOf(Document()).placed == PlacedSizes());
}

TEST_CASE("Placed sizes: other rules leave those of nodes and regions, and drop numbers of elements") {
    SpacingSpec spacing = jobOf(sizedSquare()).spacing;
    spacing.size = 3.0;
    const PlacedSizes before = spacing.placed;
    SpacingSpec rules;
    rules.expression = "1+x";
    rules.placed.nodes = {{.at = {1, 1}, .size = 9.0}}; // of another domain
    rules.placed.elements = {7};
    spacing.replaceRules(rules);
    CHECK_FALSE(spacing.size);
    CHECK(spacing.partSizes.empty());
    CHECK(spacing.expression == "1+x");
    CHECK(spacing.placed.nodes == before.nodes);
    CHECK(spacing.placed.regions == before.regions);
    CHECK(spacing.placed.elements.empty());
    CHECK(spacing.placed.segments.empty());
    CHECK(setSpacing(sizedSquare(), rules)->spacing.placed == PlacedSizes()); // a document has its own
}

TEST_CASE("Placed sizes: numbers of elements for another number of segments are refused") {
    MeshingJob job = jobOf(sizedSquare());
    job.spacing.placed.elements.pop_back();
    const auto outcome = meshDomain(job);
    REQUIRE_FALSE(outcome);
    CHECK(outcome.faults().front().code == "bad-element-counts");
    job.spacing.placed.elements.clear();
    CHECK(meshDomain(job));
    job.spacing.placed.segments.pop_back();
    const auto unsized = meshDomain(job);
    REQUIRE_FALSE(unsized);
    CHECK(unsized.faults().front().code == "bad-segment-sizes");
}

TEST_CASE("Placed sizes: a file gives them beside its domain, and its document has them") {
    const Result<DomainFile> file = readDomain(MemoryFile{kCappedSquare, "poly"});
    REQUIRE(file);
    CHECK(file->domain.regionMarkers == std::vector<RegionMarker>{{{2, 2}, 7}});
    CHECK(file->spacing.placed.regions == std::vector<RegionSize>{{.at = {2, 2}, .maxArea = 0.05}});
    CHECK(countOf({file->domain, file->spacing, {}}) > 320);
    const Document document = fromDomain(*file);
    CHECK(document.regionMarkers == std::vector<MarkedRegion>{{{2, 2}, 7, 0.05}});
    CHECK(spacingOf(document).placed == file->spacing.placed);

    const Document drawn = sizedSquare();
    const Result<DomainFile> project = allFormats().readDomain(MemoryFile{projectText(drawn), "project"});
    REQUIRE(project);
    CHECK(project->spacing.placed == spacingOf(drawn).placed);
    const Result<SpacingSpec> rules = allFormats().readSpacing(MemoryFile{projectText(drawn), "project"});
    REQUIRE(rules);
    CHECK(rules->placed == PlacedSizes());
}

TEST_CASE("Placed sizes: a document made of a domain has sizes of nodes, and markers for unmarked regions") {
    DomainFile file;
    addLoop(file.domain, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    file.domain.regionMarkers = {{{1, 1}, 5}};
    file.spacing.size = 2.0;
    file.spacing.placed.nodes = {{.at = {4, 4}, .size = 0.2, .growth = 0.1}};
    file.spacing.placed.regions = {{.at = {1, 1}, .size = 0.7}, {.at = {3, 3}, .maxArea = 0.3}};
    const Document document = fromDomain(file);
    CHECK(document.spacing.size == 2.0);
    CHECK(document.spacing.placed == PlacedSizes());
    CHECK(document.regionMarkers == std::vector<MarkedRegion>{{{1, 1}, 5, 0.0, 0.7}, {{3, 3}, 1, 0.3}});
    const PlacedSizes placed = spacingOf(document).placed;
    CHECK(placed.regions == file.spacing.placed.regions);
    REQUIRE(placed.nodes.size() == 1);
    CHECK(placed.nodes[0].at == Vec2{4, 4});
    CHECK(placed.nodes[0].growth == 0.1);
}

TEST_CASE("Placed sizes: hold in every round of an adaptation") {
    MeshingJob job = jobOf(sizedSquare());
    job.spacing.placed.regions = {{.at = {5, 5}, .maxArea = 0.2}};
    const auto first = meshDomain(job);
    REQUIRE(first);
    const Result<AdaptOutcome> outcome =
        adaptMesh(job, takeTriMesh(first->mesh), *expressionField("x"), {0.5, 0.0, 5.0, 0.3}, 1);
    REQUIRE(outcome);
    CHECK(outcome->spacing.placed == job.spacing.placed);
    CHECK(outcome->mesh.elements.size() > 500); // the area of the square is 100
    job.spacing.placed = {};
    const Result<AdaptOutcome> without =
        adaptMesh(job, takeTriMesh(first->mesh), *expressionField("x"), {0.5, 0.0, 5.0, 0.3}, 1);
    REQUIRE(without);
    CHECK(without->mesh.elements.size() < 500);
}
