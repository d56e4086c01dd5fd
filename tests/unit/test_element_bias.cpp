#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/domain/element_places.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace bias_test {

/// Returns the lengths of the edges between nodes of a mesh that lie on a line from a to b, in order.
std::vector<double> lengthsOnLine(const Document &document, Vec2 a, Vec2 b) {
    const MeshingJob job = jobOf(document);
    const auto outcome = meshDomain(job);
    REQUIRE(outcome.ok());
    CHECK(verifyAgainst(outcome->mesh, job.domain, job.spacing.placed.counts()).empty());
    std::vector<double> along;
    for (const Vec2 node : outcome->mesh.nodes) {
        const double t = dot(node - a, b - a) / lengthSquared(b - a);
        if (distance(node, a + t * (b - a)) < 1e-9 && t > -1e-9 && t < 1.0 + 1e-9) {
            along.push_back(t * distance(a, b));
        }
    }
    std::sort(along.begin(), along.end());
    std::vector<double> lengths;
    for (std::size_t k = 1; k < along.size(); ++k) {
        lengths.push_back(along[k] - along[k - 1]);
    }
    return lengths;
}

Document biased(const ElementBias &bias, std::uint32_t count = 10, SegmentRef segment = {1, 0}) {
    const Document counted = *setElementCount(documentOf({square({0, 0}, 4)}), {segment}, count);
    const Result<Document> next = setElementBias(counted, {segment}, bias);
    REQUIRE(next.ok());
    return *next;
}

} // namespace bias_test

using namespace bias_test;

TEST_CASE("Element bias: the mesh has the number of elements, and lengths in equal factors") {
    const std::vector<double> lengths = lengthsOnLine(biased({8.0, false}), {0, 0}, {4, 0});
    REQUIRE(lengths.size() == 10);
    CHECK(lengths.back() / lengths.front() == doctest::Approx(8.0).epsilon(1e-9));
    for (std::size_t k = 1; k < lengths.size(); ++k) {
        CHECK(lengths[k] / lengths[k - 1] == doctest::Approx(std::pow(8.0, 1.0 / 9.0)).epsilon(1e-9));
    }
    // The third side runs from right to left, and the second one upwards.
    const std::vector<double> above = lengthsOnLine(biased({8.0, false}, 10, {1, 2}), {0, 4}, {4, 4});
    REQUIRE(above.size() == 10);
    CHECK(above.front() / above.back() == doctest::Approx(8.0).epsilon(1e-9));
}

TEST_CASE("Element bias: at both ends, the lengths mirror each other, for even and odd numbers") {
    for (const std::uint32_t count : {2U, 3U, 8U, 9U}) {
        CAPTURE(count);
        const std::vector<double> lengths = lengthsOnLine(biased({5.0, true}, count), {0, 0}, {4, 0});
        REQUIRE(lengths.size() == count);
        for (std::size_t k = 0; k < count; ++k) {
            CHECK(lengths[k] == doctest::Approx(lengths[count - 1 - k]).epsilon(1e-9));
        }
        const double ratio = lengths[(count - 1) / 2] / lengths[0];
        CHECK(ratio == doctest::Approx(count > 2 ? 5.0 : 1.0).epsilon(1e-9));
    }
}

TEST_CASE("Element bias: along an arc, by its length, in the direction of the outline") {
    const Shape circle = makeShape(ShapeKind::Circle, {{0, 0}, {1, 0}});
    Document document = *setElementCount(documentOf({square({-4, -4}, 8), circle}), {{2, 0}}, 12);
    document = *setElementBias(document, {{2, 0}}, {4.0, false});
    const MeshingJob job = jobOf(document);
    const auto outcome = meshDomain(job);
    REQUIRE(outcome.ok());
    std::vector<double> angles;
    for (const Vec2 node : outcome->mesh.nodes) {
        if (std::fabs(length(node) - 1.0) < 1e-9) {
            const double angle = std::atan2(node.y, node.x);
            angles.push_back(angle < -1e-9 ? angle + 2.0 * std::numbers::pi : std::max(angle, 0.0));
        }
    }
    std::sort(angles.begin(), angles.end());
    REQUIRE(angles.size() == 12);
    angles.push_back(2.0 * std::numbers::pi);
    for (std::size_t k = 2; k < angles.size(); ++k) {
        CHECK((angles[k] - angles[k - 1]) / (angles[k - 1] - angles[k - 2]) ==
              doctest::Approx(std::pow(4.0, 1.0 / 11.0)).epsilon(1e-6));
    }
}

TEST_CASE("Element bias: the size in the domain follows the lengths of the elements") {
    Document document = biased({16.0, false}, 20);
    document.spacing.size = 1e3; // no other size is smaller
    const MeshingJob job = jobOf(document);
    const auto field = SpacingField::build(job.spacing, job.domain);
    REQUIRE(field.ok());
    const std::vector<double> places = elementPlaces(20, {16.0, false});
    const double first = 4.0 * places[1], last = 4.0 * (1.0 - places[19]);
    CHECK((*field)->at({0.02, 0.0}) == doctest::Approx(first).epsilon(0.1));
    CHECK((*field)->at({2.0, 0.0}) > 3.0 * first);
    CHECK((*field)->at({3.9, 0.0}) > 0.6 * last);
}

TEST_CASE("Element bias: flipped, kept in projects, refused without a number of elements or with a bad ratio") {
    const Document document = biased({8.0, false});
    const Document flipped = *flipElementBias(document, {{1, 0}});
    CHECK(segmentSize(flipped, {1, 0})->bias == ElementBias{0.125, false});
    CHECK(*flipElementBias(flipped, {{1, 0}})->shapes[0] == *document.shapes[0]);
    const std::vector<double> lengths = lengthsOnLine(flipped, {0, 0}, {4, 0});
    CHECK(lengths.front() / lengths.back() == doctest::Approx(8.0).epsilon(1e-9));
    const Document both = *flipElementBias(biased({8.0, true}), {{1, 0}});
    CHECK(segmentSize(both, {1, 0})->bias == ElementBias{0.125, true});

    const Result<Document> back = parseProject(projectText(both), "bias.json");
    REQUIRE(back.ok());
    CHECK(*back->shapes[0] == *both.shapes[0]);

    CHECK(codeOf(setElementBias(documentOf({square({0, 0}, 4)}), {{1, 0}}, {2.0, false})) == "not-possible");
    for (const double ratio : {0.0, -2.0, 1e5, std::nan("")}) {
        CHECK(codeOf(setElementBias(document, {{1, 0}}, {ratio, false})) == "bad-number");
    }
    const std::string text = projectText(both);
    std::string wrong = text;
    wrong.replace(wrong.find("\"bias\": 0.125"), 13, "\"bias\": 1e9");
    CHECK(parseProject(wrong, "bias.json").faults().front().code == "bad-number");
    wrong = text;
    wrong.replace(wrong.find("\"elements\": 10"), 14, "\"size\": 2");
    CHECK(parseProject(wrong, "bias.json").faults().front().message.find("no number of elements") != std::string::npos);
}

TEST_CASE("Element bias: a changed number keeps it, a size removes it, and a divided segment keeps the factors") {
    const Document document = biased({8.0, false});
    CHECK(segmentSize(*setElementCount(document, {{1, 0}}, 6), {1, 0})->bias == ElementBias{8.0, false});
    const Document sized = *changeSegmentSizes(document, {{1, 0}}, {.size = 0.3, .growth = {}});
    CHECK(segmentSize(sized, {1, 0})->bias == ElementBias{});
    Document divided = *insertNode(document, {1, 0}, {2, 0});
    carrySegmentSizes(document, divided);
    const SegmentSize first = *segmentSize(divided, {1, 0}), second = *segmentSize(divided, {1, 1});
    CHECK(first.elements + second.elements == 10);
    CHECK(first.elements > second.elements);
    for (const SegmentSize &part : {first, second}) {
        CHECK(part.bias.ratio == doctest::Approx(std::pow(8.0, (part.elements - 1.0) / 9.0)));
    }
}

TEST_CASE("Element bias: a list of biases for another number of segments is refused") {
    MeshingJob job = jobOf(biased({8.0, false}));
    job.spacing.placed.biases.pop_back();
    CHECK(meshDomain(job).faults().front().code == "bad-element-counts");
}
