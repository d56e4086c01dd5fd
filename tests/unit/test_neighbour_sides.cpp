// Closed shapes that have each drawn their common border share it as one line in the domain.
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/shared_sides.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

bool isRefused(const Document &document) {
    const Diagnostics faults = validate(toDomain(document));
    return std::any_of(faults.begin(), faults.end(),
                       [](const Diagnostic &fault) { return fault.code == "duplicate-segment"; });
}

/// Gives a segment of a shape a size of its own.
void setSize(Document &document, std::size_t shape, std::uint32_t segment, const SegmentSize &size) {
    Shape sized = *document.shapes[shape];
    sized.segmentSizes[segment] = size;
    document.shapes[shape] = std::make_shared<const Shape>(sized);
}

} // namespace

TEST_CASE("Neighbour sides: a side that two shapes have drawn is one inner line, whichever way they turn") {
    for (const bool turned : {false, true}) {
        CAPTURE(turned);
        Shape right = square({4, 0}, 4);
        if (turned) {
            std::reverse(right.nodes.begin(), right.nodes.end());
        }
        const Document document = documentOf({square({0, 0}, 4), right, square({4, 4}, 4)});
        DomainSources sources;
        const Domain domain = toDomain(document, sources);
        CHECK(validate(domain).empty());
        CHECK(domain.segments.size() == 10);
        CHECK(innerLines(domain) == 2);
        REQUIRE(sources.segments.size() == domain.segments.size());
        for (std::size_t s = 0; s < domain.segments.size(); ++s) {
            const Shape &shape = *document.shapes[sources.segments[s].shape];
            CHECK(domain.nodes[domain.segments[s].a] == shape.nodes[sources.segments[s].node]);
        }
        CHECK(meshedArea(document) == doctest::Approx(48.0));
    }
}

TEST_CASE("Neighbour sides: what lies on one side of both, is traced thrice or has two sizes is refused") {
    CHECK(isRefused(documentOf({square({0, 0}, 4), square({0, 0}, 4)})));
    CHECK(isRefused(documentOf({square({0, 0}, 4), makeShape(ShapeKind::Polygon, {{4, 0}, {4, 4}, {2, 2}})})));
    CHECK(isRefused(documentOf({square({0, 0}, 4), square({4, 0}, 4), square({4, 0}, 4)})));
    Document sized = documentOf({square({0, 0}, 4), square({4, 0}, 4)});
    CHECK_FALSE(isRefused(sized));
    setSize(sized, 1, 3, {.size = 0.1});
    CHECK_FALSE(isRefused(sized));
    setSize(sized, 0, 1, {.size = 0.2});
    CHECK(isRefused(sized));
}

TEST_CASE("Neighbour sides: what one of two shapes has along a common side holds for both") {
    const Document plain = documentOf({square({0, 0}, 4), square({4, 0}, 4)});
    for (const auto &[shape, segment] : {std::pair{0U, 1U}, std::pair{1U, 3U}}) {
        CAPTURE(shape);
        Document counted = plain;
        setSize(counted, shape, segment, {.elements = 7, .bias = {4.0, false}});
        counted.spacing.size = 1.0;
        const MeshingJob job = jobOf(counted);
        CHECK(job.findings.empty());
        CHECK(innerLines(job.domain) == 1);
        CHECK(std::count(job.spacing.placed.elements.begin(), job.spacing.placed.elements.end(), 7U) == 1);
        const Result<MeshingOutcome> meshed = meshDomain(job);
        REQUIRE(meshed.ok());
        std::vector<double> along;
        for (const Vec2 node : meshed->mesh.nodes) {
            if (node.x == 4.0) {
                along.push_back(node.y);
            }
        }
        std::sort(along.begin(), along.end());
        REQUIRE(along.size() == 8);
        const double ratio = (along[7] - along[6]) / (along[1] - along[0]);
        CHECK(ratio == doctest::Approx(shape == 0 ? 4.0 : 0.25)); // each bias in the direction of its own side
        Document sized = plain;
        setSize(sized, shape, segment, {.size = 0.1});
        const MeshingJob fine = jobOf(sized);
        CHECK(fine.findings.empty());
        const std::vector<PartSize> &sizes = fine.spacing.placed.segments;
        CHECK(std::count(sizes.begin(), sizes.end(), PartSize{0.1, SegmentSize{}.growth}) == 1);
    }
    // The outline of a region lies on a part of the boundary, whose role and tag stay.
    Shape region = square({0, 0}, 2, ShapeUse::Constraint);
    region.tag = 7;
    Document within = documentOf({square({0, 0}, 4), region});
    setSize(within, 1, 0, {.elements = 9});
    const MeshingJob job = jobOf(within);
    CHECK(validate(job.domain).empty());
    const auto nine = std::find(job.spacing.placed.elements.begin(), job.spacing.placed.elements.end(), 9U);
    REQUIRE(nine != job.spacing.placed.elements.end());
    const DomainSegment &segment =
        job.domain.segments[static_cast<std::size_t>(std::distance(job.spacing.placed.elements.begin(), nine))];
    CHECK(segment.role == SegmentRole::Boundary);
    CHECK(segment.tag == 1);
}

TEST_CASE("Neighbour sides: layers of the tag of one of two shapes hold along their common side") {
    Shape right = square({4, 0}, 4);
    right.tag = 2;
    Document document = documentOf({square({0, 0}, 4), right});
    document.layers = {{.tag = 2, .first = 0.05, .count = 2}};
    document.spacing.size = 0.5;
    const MeshingJob job = jobOf(document);
    CHECK(job.findings.empty());
    CHECK(std::count_if(job.domain.segments.begin(), job.domain.segments.end(), [](const DomainSegment &segment) {
              return segment.tag == 2 && segment.role == SegmentRole::Constraint;
          }) == 1);
    CHECK(meshDomain(job).ok());
}

TEST_CASE("Neighbour sides: two values along a common side are a fault that names both shapes") {
    Document document = documentOf({square({0, 0}, 4), square({4, 0}, 4)});
    const auto conflict = [&] {
        const Result<MeshingOutcome> refused = meshDomain(jobOf(document));
        REQUIRE_FALSE(refused.ok());
        REQUIRE(refused.faults().size() == 1);
        CHECK(refused.faults().front().code == "side-conflict");
        CHECK(refused.faults().front().at == Vec2{4, 2});
        return refused.faults().front().message;
    };
    const auto names = [&](const std::string &message, const char *first, const char *second) {
        const std::string both = "'" + displayName(*document.shapes[0]) + "' and '" + displayName(*document.shapes[1]);
        return message.find(both) == 0 && message.find(first) < message.find(second) &&
               message.find(second) != std::string::npos;
    };
    setSize(document, 0, 1, {.elements = 7});
    setSize(document, 1, 3, {.elements = 9});
    CHECK(names(conflict(), "7 elements", "9 elements"));
    setSize(document, 1, 3, {.elements = 7});
    CHECK(jobOf(document).findings.empty());
    setSize(document, 1, 3, {.size = 0.1}); // a number takes precedence over a size
    CHECK(jobOf(document).findings.empty());
    setSize(document, 0, 1, {.size = 0.3});
    CHECK(names(conflict(), "the size 0.3", "the size 0.1"));
    setSize(document, 0, 1, {.size = 0.1});
    CHECK(jobOf(document).findings.empty());
    Shape right = *document.shapes[1];
    right.tag = 2;
    document.shapes[1] = std::make_shared<const Shape>(right);
    document.layers = {{.tag = 1, .first = 0.05}, {.tag = 2, .first = 0.02}};
    CHECK(names(conflict(), "tag 1 with boundary layers", "tag 2 with boundary layers"));
}

TEST_CASE("Neighbour sides: outlines of regions share sides with each other and with the boundary") {
    const auto region = [](Vec2 low, double side) { return square(low, side, ShapeUse::Constraint); };
    const Document document =
        documentOf({square({0, 0}, 10), region({0, 2}, 4), region({4, 2}, 4), region({4, 2}, 2), region({2, 2}, 2)});
    const Domain domain = toDomain(document);
    CHECK(validate(domain).empty());
    double boundary = 0.0, within = 0.0;
    for (const DomainSegment &segment : domain.segments) {
        const double length = distance(domain.nodes[segment.a], domain.nodes[segment.b]);
        (segment.role == SegmentRole::Boundary ? boundary : within) += length;
    }
    CHECK(boundary == doctest::Approx(40.0));
    CHECK(within == doctest::Approx(12.0 + 12.0 + 4.0 + 4.0));
    CHECK(meshedArea(document) == doctest::Approx(100.0));
}

TEST_CASE("Neighbour sides: a line with a crack, a strip or layers is not taken for another one") {
    Shape region = square({0, 2}, 4, ShapeUse::Constraint);
    region.tag = 7;
    Document document = documentOf({square({0, 0}, 10), region});
    CHECK_FALSE(isRefused(document));
    document.cracks = {7};
    CHECK(isRefused(document));
    document.cracks = {1};
    CHECK_FALSE(isRefused(document));
    document.layers = {{.tag = 7}};
    CHECK(isRefused(document));
    document.cracks.clear();
    REQUIRE(jobOf(document).findings.size() == 1);
    CHECK(jobOf(document).findings.front().message.find("tag 1 on the boundary there and the other tag 7 with boundary "
                                                        "layers") != std::string::npos);
}

TEST_CASE("Neighbour sides: arcs and Bezier curves that two shapes have drawn are one line, also in part") {
    const Curve cubic = Curve::cubic({4, 0}, {5, 1.5}, {3, 2.5}, {4, 4});
    const Curve back = Curve::cubic({4, 4}, {3, 2.5}, {5, 1.5}, {4, 0});
    const Document beside = documentOf(
        {withCurve({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1, cubic), withCurve({{4, 4}, {4, 0}, {9, 0}, {9, 4}}, 0, back)});
    CHECK(validate(toDomain(beside)).empty());
    CHECK(meshedArea(beside) == doctest::Approx(36.0));
    // Another curve between the same nodes is no common side.
    const Document lens = documentOf(
        {withCurve({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1, cubic),
         withCurve({{4, 4}, {4, 0}, {9, 0}, {9, 4}}, 0, Curve::cubic({4, 4}, {5.5, 2.5}, {5.5, 1.5}, {4, 0}))});
    CHECK(toDomain(lens).segments.size() > toDomain(beside).segments.size());
    // A disc in three parts, in two of which the arc is whole and in one a part of it is shared.
    const auto onCircle = [](double degrees) {
        const double a = degrees * std::numbers::pi / 180.0;
        return Vec2{2.0 * std::cos(a), 2.0 * std::sin(a)};
    };
    const Shape half =
        withCurve({onCircle(0), onCircle(180)}, 0, Curve::arc({0, 0}, {2, 0}, {0, 2}, 0.0, std::numbers::pi));
    const Shape ring =
        withCurve({onCircle(120), onCircle(60), 2.0 * onCircle(60), 2.0 * onCircle(120)}, 0,
                  Curve::arc({0, 0}, {2, 0}, {0, 2}, std::numbers::pi * 2.0 / 3.0, -std::numbers::pi / 3.0));
    const Document part = documentOf({half, ring});
    const Domain domain = toDomain(part);
    const Diagnostics faults = validate(domain);
    CHECK_MESSAGE(faults.empty(), faults.front().code, " ", faults.front().at->x, " ", faults.front().at->y);
    CHECK(innerLines(domain) > 0);
    for (const DomainSegment &segment : domain.segments) {
        if (segment.role == SegmentRole::Constraint) {
            CHECK(std::min(domain.nodes[segment.a].y, domain.nodes[segment.b].y) > 1.7);
        }
    }
}
