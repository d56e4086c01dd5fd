#include "core/engine/boundary/unmatched_sector.hpp"

#include <doctest/doctest.h>

#include <cstdint>

using namespace forefront;

TEST_CASE("unmatchedSector: finds the node where the faces beside a sector differ") {
    // A square with a line from corner to corner between regions 0 and 1, and one that ends inside region 1.
    DiscreteDomain domain;
    domain.nodes = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1.5, 0.5}};
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t left, std::uint32_t right) {
        DiscreteSegment segment;
        segment.a = a;
        segment.b = b;
        segment.leftRegion = left;
        segment.rightRegion = right;
        domain.segments.push_back(segment);
    };
    add(0, 1, 1, kOutside);
    add(1, 2, 1, kOutside);
    add(2, 3, 0, kOutside);
    add(3, 0, 0, kOutside);
    add(0, 2, 0, 1);
    add(1, 4, 1, 1);
    CHECK_FALSE(unmatchedSector(domain).has_value());
    domain.segments[4].rightRegion = 0;
    CHECK(unmatchedSector(domain) == 0U);
    domain.segments[4].rightRegion = 1;
    domain.segments[5].leftRegion = 0; // seen from its end, too
    CHECK(unmatchedSector(domain) == 1U);
}
