#include "core/engine/base/key_order.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <numeric>

using namespace forefront;

namespace {

std::vector<std::uint32_t> stableOrder(const std::vector<std::uint64_t> &keys) {
    std::vector<std::uint32_t> order(keys.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return keys[i] < keys[j]; });
    return order;
}

std::uint64_t randomKey(testing::RandomSource &random, int bits) {
    std::uint64_t key = 0;
    for (int i = 0; i < bits; ++i) {
        key = key << 1U | static_cast<std::uint64_t>(random.chance(0.5));
    }
    return key;
}

} // namespace

TEST_CASE("orderByKeys: the order of a stable sort, for few and many keys of any length") {
    testing::RandomSource random(7);
    for (const std::size_t count : {0U, 1U, 2U, 999U, 1000U, 5000U}) {
        for (const int bits : {0, 3, 11, 12, 40, 64}) {
            std::vector<std::uint64_t> keys(count);
            std::generate(keys.begin(), keys.end(), [&] { return randomKey(random, bits); });
            CAPTURE(count);
            CAPTURE(bits);
            CHECK(orderByKeys(keys) == stableOrder(keys));
        }
    }
}

TEST_CASE("orderByKeys: keys that differ in their highest and lowest bits only") {
    std::vector<std::uint64_t> keys;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        keys.push_back((i % 3 == 0 ? std::uint64_t{1} << 63U : 0U) | (i % 2));
    }
    CHECK(orderByKeys(keys) == stableOrder(keys));
}

TEST_CASE("orderByKeys: runs of keys that agree in their upper bits") {
    testing::RandomSource random(11);
    std::vector<std::uint64_t> keys(6000);
    for (std::uint64_t &key : keys) {
        key = static_cast<std::uint64_t>(random.integer(0, 50)) << 50U | randomKey(random, 3);
    }
    CHECK(orderByKeys(keys) == stableOrder(keys));
}

TEST_CASE("sortKey: orders numbers of both signs and all sizes as they are") {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const std::vector<double> ascending{-kInfinity, -1e300, -1.0, -1e-300,     -5e-324, 0.0,
                                        5e-324,     1e-300, 1.0,  1.0 + 1e-15, 1e300,   kInfinity};
    for (std::size_t i = 1; i < ascending.size(); ++i) {
        CHECK(sortKey(ascending[i - 1]) < sortKey(ascending[i]));
    }
    CHECK(sortKey(-0.0) == sortKey(0.0));
}

TEST_CASE("pairKey: orders pairs by the first number, then by the second, and keeps both") {
    CHECK(pairKey(1, 0xffffffffU) < pairKey(2, 0));
    CHECK(pairKey(2, 0) < pairKey(2, 1));
    CHECK(pairKey(NodeId{3}, NodeId{5}) == pairKey(3, 5));
    CHECK(pairOf(pairKey(0xffffffffU, 7)) == std::array<std::uint32_t, 2>{0xffffffffU, 7});
}
