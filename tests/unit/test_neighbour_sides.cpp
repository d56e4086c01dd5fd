// Closed shapes that have each drawn their common border share it as one line in the domain.
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/domain_sources.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::edit_test;

namespace {

std::size_t innerLines(const Domain &domain) {
    return static_cast<std::size_t>(
        std::count_if(domain.segments.begin(), domain.segments.end(),
                      [](const DomainSegment &segment) { return segment.role == SegmentRole::Constraint; }));
}

bool isRefused(const Document &document) {
    const Diagnostics faults = validate(toDomain(document));
    return std::any_of(faults.begin(), faults.end(),
                       [](const Diagnostic &fault) { return fault.code == "duplicate-segment"; });
}

double meshedArea(Document document) {
    document.spacing.size = 0.5;
    const Result<MeshingOutcome> meshed = meshDomain(jobOf(document));
    REQUIRE_MESSAGE(meshed.ok(), meshed.faults().front().message);
    double area = 0.0;
    const CellBlock &block = meshed->mesh.blocks.front();
    for (std::size_t e = 0; e < block.regions.size(); ++e) {
        const std::span<const NodeId> nodes = block.nodesOf(e);
        const auto at = [&](std::size_t k) { return meshed->mesh.nodes[index(nodes[k])]; };
        area += 0.5 * cross(at(1) - at(0), at(2) - at(0));
    }
    return area;
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

TEST_CASE("Neighbour sides: what lies on one side of both, is traced thrice or differs in size is refused") {
    CHECK(isRefused(documentOf({square({0, 0}, 4), square({0, 0}, 4)})));
    CHECK(isRefused(documentOf({square({0, 0}, 4), makeShape(ShapeKind::Polygon, {{4, 0}, {4, 4}, {2, 2}})})));
    CHECK(isRefused(documentOf({square({0, 0}, 4), square({4, 0}, 4), square({4, 0}, 4)})));
    Document sized = documentOf({square({0, 0}, 4), square({4, 0}, 4)});
    CHECK_FALSE(isRefused(sized));
    Shape fine = *sized.shapes[1];
    fine.segmentSizes[3].size = 0.1;
    sized.shapes[1] = std::make_shared<const Shape>(fine);
    CHECK(isRefused(sized));
}
