// The parts of a divided line have the elements that lie in them, with the lengths that these had.
#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/element_places.hpp"
#include "core/engine/domain/element_shares.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

/// Returns the lengths of the elements of consecutive parts of a line of length 1.
std::vector<double> lengthsOf(const std::vector<ElementShare> &shares, const std::vector<double> &ends) {
    std::vector<double> lengths;
    double start = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const std::vector<double> places = elementPlaces(shares[k].elements, shares[k].bias);
        for (std::size_t e = 1; e < places.size(); ++e) {
            lengths.push_back((places[e] - places[e - 1]) * (ends[k] - start));
        }
        start = ends[k];
    }
    return lengths;
}

/// A unit square with inner lines that end on its lower side, which has a number of elements.
struct LinesOnSide {
    Domain domain;
    SpacingSpec spacing;

    LinesOnSide(const std::vector<double> &at, std::uint32_t elements, const ElementBias &bias) {
        domain.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
        for (const double x : at) {
            const auto node = static_cast<std::uint32_t>(domain.nodes.size());
            domain.nodes.insert(domain.nodes.end(), {{x, 0}, {x, 0.5}});
            domain.segments.push_back({node, node + 1, 2, SegmentRole::Constraint});
        }
        spacing.placed.elements.resize(domain.segments.size(), 0);
        spacing.placed.biases.resize(domain.segments.size());
        spacing.placed.elements[0] = elements;
        spacing.placed.biases[0] = bias;
    }

    /// Repairs the domain, and returns the shares of the parts of the side from left to right.
    std::vector<ElementShare> repaired(Diagnostics &losses) {
        const Repaired made = *repair(domain);
        losses = carryElements(domain, made, spacing);
        std::vector<std::pair<double, ElementShare>> parts;
        for (std::size_t s = 0; s < made.domain.segments.size(); ++s) {
            const Vec2 a = made.domain.nodes[made.domain.segments[s].a],
                       b = made.domain.nodes[made.domain.segments[s].b];
            if (spacing.placed.elements[s] > 0) {
                const ElementBias bias = spacing.placed.biases[s];
                parts.push_back({std::min(a.x, b.x), {spacing.placed.elements[s], a.x < b.x ? bias : bias.reversed()}});
            }
        }
        std::sort(parts.begin(), parts.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
        std::vector<ElementShare> shares;
        for (const auto &[x, share] : parts) {
            shares.push_back(share);
        }
        return shares;
    }
};

} // namespace

TEST_CASE("Element shares: the parts of a line have its elements, whose lengths stay about the same") {
    for (const ElementBias bias : {ElementBias{5.0, false}, ElementBias{0.2, false}, ElementBias{}}) {
        for (const std::vector<double> &ends :
             {std::vector{0.5, 1.0}, std::vector{0.21, 0.33, 0.8, 1.0}, std::vector{1.0}}) {
            CAPTURE(bias.ratio);
            CAPTURE(ends.size());
            const std::vector<ElementShare> shares = shareElements(20, bias, ends);
            REQUIRE(shares.size() == ends.size());
            const std::vector<double> lengths = lengthsOf(shares, ends), whole = elementPlaces(20, bias);
            REQUIRE(lengths.size() == 20);
            for (std::size_t k = 0; k < lengths.size(); ++k) {
                CHECK(lengths[k] == doctest::Approx(whole[k + 1] - whole[k]).epsilon(0.25));
            }
        }
    }
}

TEST_CASE("Element shares: a bias at both ends becomes one in each half, and is lost where the lengths turn") {
    const std::vector<ElementShare> halves = shareElements(9, {4.0, true}, std::vector{0.5, 1.0});
    REQUIRE(halves.size() == 2);
    CHECK(halves[0].elements + halves[1].elements == 9);
    CHECK(halves[0].bias.ratio == doctest::Approx(4.0));
    CHECK_FALSE(halves[0].bias.bothEnds);
    CHECK(halves[1].bias.ratio < 1.0);
    const std::vector<ElementShare> thirds = shareElements(12, {4.0, true}, std::vector{0.2, 0.8, 1.0});
    CHECK(thirds[1].bias.bothEnds);
    CHECK(thirds[1].keepsBias);
    const std::vector<ElementShare> turn = shareElements(12, {4.0, true}, std::vector{0.8, 1.0});
    CHECK_FALSE(turn[0].keepsBias);
    CHECK_FALSE(turn[0].bias.any());
    CHECK(turn[1].keepsBias);
}

TEST_CASE("Element shares: each part has an element, also where there are more parts than elements") {
    const std::vector<ElementShare> shares = shareElements(2, {3.0, false}, std::vector{0.1, 0.2, 0.3, 1.0});
    REQUIRE(shares.size() == 4);
    for (const ElementShare &share : shares) {
        CHECK(share.elements == 1);
    }
    std::uint32_t sum = 0;
    for (const double from : {0.0, 0.25, 0.5, 0.75}) {
        sum += shareOfPart(10, {}, from, from + 0.25).elements;
    }
    CHECK(sum == 10);
    CHECK(shareOfPart(5, {}, 0.0, 0.5 + 1e-12).elements + shareOfPart(5, {}, 0.5 - 1e-12, 1.0).elements == 5);
}

TEST_CASE("Element shares: a repair does not restart a bias where it divides a segment, and reports what is lost") {
    Diagnostics losses;
    LinesOnSide biased({0.5}, 10, {5.0, false});
    const std::vector<ElementShare> shares = biased.repaired(losses);
    CHECK(losses.empty());
    REQUIRE(shares.size() == 2);
    const std::vector<double> lengths = lengthsOf(shares, {0.5, 1.0});
    REQUIRE(lengths.size() == 10);
    for (std::size_t k = 1; k < lengths.size(); ++k) {
        CHECK(lengths[k] > lengths[k - 1]); // restarted, it would fall by 2.24 at the joint
    }
    LinesOnSide single({0.5}, 1, {});
    CHECK(single.repaired(losses).size() == 2);
    REQUIRE(losses.size() == 1);
    CHECK(losses[0].code == "lost-elements");
    CHECK(losses[0].severity == Severity::Warning);
    CHECK(losses[0].message.find("1 element") != std::string::npos);
    CHECK(losses[0].at == Vec2{0.5, 0.0});
    LinesOnSide both({0.8}, 12, {4.0, true});
    CHECK(both.repaired(losses).size() == 2);
    REQUIRE(losses.size() == 1);
    CHECK(losses[0].message.find("bias") != std::string::npos);
}

TEST_CASE("Element shares: a line that ends on a side with a bias leaves the lengths of its elements") {
    Document document =
        documentOf({square({0, 0}, 1), makeShape(ShapeKind::Polyline, {{0.5, 0}, {0.5, 0.5}}, ShapeUse::Constraint)});
    Shape side = *document.shapes[0];
    side.segmentSizes[0] = {.elements = 10, .bias = {5.0, false}};
    document.shapes[0] = std::make_shared<const Shape>(side);
    document.spacing.size = 0.3;
    const Result<MeshingOutcome> meshed = meshDomain(jobOf(document));
    REQUIRE(meshed.ok());
    std::vector<double> along;
    for (const Vec2 node : meshed->mesh.nodes) {
        if (node.y == 0.0) {
            along.push_back(node.x);
        }
    }
    std::sort(along.begin(), along.end());
    REQUIRE(along.size() == 11);
    for (std::size_t k = 2; k < along.size(); ++k) {
        CHECK(along[k] - along[k - 1] > along[k - 1] - along[k - 2]);
    }
}

TEST_CASE("Element shares: a circle with a bias keeps it as a path of four parts") {
    Shape circle = makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}});
    circle.segmentSizes[0] = {.elements = 40, .bias = {16.0, false}};
    becomePath(circle);
    REQUIRE(circle.segmentSizes.size() == 4);
    std::uint32_t elements = 0;
    double ratio = 1.0;
    for (std::uint32_t k = 0; k < 4; ++k) {
        const SegmentSize &part = circle.segmentSizes.at(k);
        elements += part.elements;
        ratio *= std::pow(part.bias.ratio, 1.0 / (part.elements - 1.0));
        CHECK((k == 0 || part.elements < circle.segmentSizes.at(k - 1).elements));
    }
    CHECK(elements == 40);
    CHECK(ratio == doctest::Approx(std::pow(16.0, 4.0 / 39.0))); // each element is longer by the same factor
}
