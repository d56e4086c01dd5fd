#include "core/drawing/names/part_commands.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace forefront::part_cases {

using namespace edit_test;

Document twoSquares() {
    return documentOf({square({0, 0}, 4), square({1, 1}, 1)});
}

const BoundaryPart kOuter{.shapes = {1}, .segments = {}}, kHole{.shapes = {2}, .segments = {}};

TEST_CASE("Part commands: layers belong to the part alone, which gets a tag of its own") {
    LayerSpec spec;
    spec.first = 0.1;
    Result<Document> next = setLayers(twoSquares(), kHole, spec);
    REQUIRE(next.ok());
    const std::int32_t tag = next->shapes[1]->tag;
    CHECK(tag != next->shapes[0]->tag);
    REQUIRE(layersOf(*next, tag) != nullptr);
    CHECK(layersOf(*next, tag)->first == 0.1);
    CHECK(layersOf(*next, next->shapes[0]->tag) == nullptr);
    spec.count = 3;
    next = setLayers(*next, kHole, spec);
    REQUIRE(next.ok());
    CHECK(next->layers.size() == 1);
    CHECK(next->shapes[1]->tag == tag);
    CHECK(layersOf(*next, tag)->count == 3);
    spec.growth = 9.0;
    const Result<Document> wrong = setLayers(*next, kHole, spec);
    REQUIRE(!wrong.ok());
    CHECK(wrong.faults().front().code == "bad-layer");
    next = setLayers(*next, kHole, std::nullopt);
    REQUIRE(next.ok());
    CHECK(next->layers.empty());
}

TEST_CASE("Part commands: one side of a shape leaves the others alone, and keeps what it has") {
    Document document = documentOf({square({0, 0}, 4)});
    const BoundaryPart all{.shapes = {1}, .segments = {}}, side{.shapes = {}, .segments = {{1, 2}}};
    LayerSpec spec;
    spec.first = 0.1;
    Result<Document> next = setLayers(document, all, spec);
    REQUIRE(next.ok());
    next->spacing.partSizes[1] = {0.5, 0.2};
    const Document whole = *next;
    next = setPeriodic(whole, {.shapes = {}, .segments = {{1, 0}}}, std::nullopt);
    REQUIRE(next.ok());
    CHECK(next->shapes[0]->segmentTags.empty());
    spec.growth = 1.5;
    next = setLayers(whole, side, spec);
    REQUIRE(next.ok());
    const std::int32_t own = segmentTag(*next->shapes[0], 2);
    CHECK(own != 1);
    CHECK(layersOf(*next, own)->growth == 1.5);
    CHECK(layersOf(*next, 1)->growth == 1.2);
    CHECK(next->spacing.partSizes.at(own).size == 0.5);
    next = setLayers(whole, side, std::nullopt);
    REQUIRE(next.ok());
    CHECK(next->layers.size() == 1);
    CHECK(layersOf(*next, 1) != nullptr);
    CHECK(layersOf(*next, segmentTag(*next->shapes[0], 2)) == nullptr);
}

TEST_CASE("Part commands: a name means all that has it") {
    Document document = twoSquares();
    document.boundaryNames = {{1, "wall"}};
    LayerSpec spec;
    spec.first = 0.1;
    const Result<Document> next = setLayers(document, kHole, spec);
    REQUIRE(next.ok());
    CHECK(next->shapes[1]->tag == 1);
    CHECK(layersOf(*next, 1) != nullptr);
}

TEST_CASE("Part commands: cracks, periodic parts and mapped regions are set and removed") {
    Document document = twoSquares();
    Result<Document> next = setCrack(document, kHole, true);
    REQUIRE(next.ok());
    const std::int32_t tag = next->shapes[1]->tag;
    CHECK(isCrack(*next, tag));
    next = setCrack(*next, kHole, false);
    REQUIRE(next.ok());
    CHECK(next->cracks.empty());

    StripSpec strip;
    strip.width = 0.5;
    strip.rows = 2;
    next = setStrip(*next, kHole, strip);
    REQUIRE(next.ok());
    REQUIRE(stripOf(*next, tag) != nullptr);
    CHECK(stripOf(*next, tag)->rows == 2);
    strip.width = -1.0;
    CHECK(!setStrip(*next, kHole, strip).ok());
    next = setStrip(*next, kHole, std::nullopt);
    REQUIRE(next.ok());
    CHECK(next->strips.empty());

    const BoundaryPart left{.shapes = {}, .segments = {{1, 3}}}, right{.shapes = {}, .segments = {{1, 1}}};
    next = setPeriodic(*next, left, tag);
    REQUIRE(next.ok());
    const std::int32_t own = segmentTag(*next->shapes[0], 3);
    CHECK(own != segmentTag(*next->shapes[0], 1));
    CHECK(periodicPartner(*next, own) == tag);
    CHECK(periodicPartner(*next, tag) == own);
    CHECK(!setPeriodic(*next, left, own).ok());
    next = setPeriodic(*next, right, own); // the first pair is untied
    REQUIRE(next.ok());
    CHECK(next->periodic.size() == 1);
    CHECK(periodicPartner(*next, own) == segmentTag(*next->shapes[0], 1));
    next = setPeriodic(*next, right, std::nullopt);
    REQUIRE(next.ok());
    CHECK(next->periodic.empty());

    document = setMapped(document, 1, true);
    CHECK(isMapped(document, 1));
    document = setMapped(document, 1, true);
    CHECK(document.mapped.size() == 1);
    document = setMappedCorners(document, 1, {{0, 0}, {4, 0}, {4, 3}});
    REQUIRE(mappedOf(document, 1) != nullptr);
    CHECK(mappedOf(document, 1)->corners == std::vector<Vec2>{{0, 0}, {4, 0}, {4, 3}});
    CHECK(mappedOf(document, 7) == nullptr);
    CHECK(setMappedCorners(document, 7, {{0, 0}}).mapped == document.mapped);
    CHECK(setMapped(document, 1, true).mapped == document.mapped); // corners that were given are kept
    CHECK(!isMapped(setMapped(document, 1, false), 1));

    document = setElements(document, 1, Elements::Mixed);
    CHECK(elementsOf(document, 1) == Elements::Mixed);
    document = setElements(document, 1, Elements::Quads);
    CHECK(document.regionElements.size() == 1);
    CHECK(elementsOf(document, 1) == Elements::Quads);
    CHECK(!elementsOf(document, 2));
    CHECK(!elementsOf(setElements(document, 1, std::nullopt), 1));
}

} // namespace forefront::part_cases
