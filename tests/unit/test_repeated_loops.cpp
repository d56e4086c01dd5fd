#include "core/files/common/repeated_loops.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace forefront;

namespace {

using Loop = std::vector<Vec2>;

std::vector<std::uint8_t> repeatsIn(const std::vector<Loop> &loops, double tolerance = 1e-6) {
    return findRepeatedLoops({loops.begin(), loops.end()}, tolerance);
}

} // namespace

TEST_CASE("findRepeatedLoops: the same nodes from another start, in either direction, within the tolerance") {
    const Loop square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, turned = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    const Loop reversed = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}, moved = {{1e-7, 0}, {1, -1e-7}, {1, 1}, {0, 1}};
    const std::vector<std::uint8_t> expected = {0, 1, 1, 1, 1};
    CHECK(repeatsIn({square, square, turned, reversed, moved}) == expected);
}

TEST_CASE("findRepeatedLoops: loops that differ in a node, in their number or in the order of nodes are kept") {
    const Loop square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, bow = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    const Loop moved = {{1e-5, 0}, {1, 0}, {1, 1}, {0, 1}}, triangle = {{0, 0}, {1, 0}, {1, 1}};
    const std::vector<std::uint8_t> expected = {0, 0, 0, 0};
    CHECK(repeatsIn({square, bow, moved, triangle}) == expected);
}

TEST_CASE("findRepeatedLoops: a loop with a node twice") {
    const Loop eight = {{0, 0}, {1, 1}, {0, 2}, {1, 1}}, other = {{1, 1}, {0, 0}, {1, 1}, {0, 2}};
    const std::vector<std::uint8_t> expected = {0, 1};
    CHECK(repeatsIn({eight, other}) == expected);
}
