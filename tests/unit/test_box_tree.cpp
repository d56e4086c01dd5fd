#include "core/geometry/box_tree.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

std::vector<Box2> randomBoxes(RandomSource &random, int count) {
    std::vector<Box2> boxes;
    for (int i = 0; i < count; ++i) {
        const Vec2 p{random.between(0.0, 1.0), random.between(0.0, 1.0)};
        const double size = random.chance(0.1) ? 0.5 : 0.03;
        boxes.push_back(boxOf(p, p + Vec2{random.between(0.0, size), random.between(0.0, size)}));
    }
    return boxes;
}

Pairs sorted(Pairs pairs) {
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

} // namespace

TEST_CASE("BoxTree: joining trees finds each pair of boxes within reach once") {
    RandomSource random(11);
    for (const auto &[m, n] : {std::pair(0, 5), {1, 1}, {3, 400}, {500, 8}, {300, 300}}) {
        const std::vector<Box2> first = randomBoxes(random, m), second = randomBoxes(random, n);
        const BoxTree mine(first), theirs(second);
        for (const double reach : {0.0, 0.02}) {
            Pairs between, among, expectedBetween, expectedAmong;
            const auto into = [](Pairs &pairs) {
                return [&pairs](std::uint32_t i, std::uint32_t j) {
                    pairs.emplace_back(i, j);
                    return true;
                };
            };
            CHECK(mine.join(theirs, reach, into(between)));
            CHECK(mine.joinSelf(reach, into(among)));
            for (auto &[i, j] : among) {
                std::tie(i, j) = std::minmax({i, j});
            }
            for (std::uint32_t i = 0; i < first.size(); ++i) {
                for (std::uint32_t j = 0; j < second.size(); ++j) {
                    if (first[i].grown(reach).overlaps(second[j])) {
                        expectedBetween.emplace_back(i, j);
                    }
                }
                for (std::uint32_t j = i + 1; j < first.size(); ++j) {
                    if (first[i].grown(reach).overlaps(first[j])) {
                        expectedAmong.emplace_back(i, j);
                    }
                }
            }
            CHECK(sorted(between) == expectedBetween);
            CHECK(sorted(among) == expectedAmong);
        }
    }
}

TEST_CASE("BoxTree: joining trees ends when a visit says so") {
    RandomSource random(12);
    const BoxTree tree(randomBoxes(random, 200));
    int visits = 0;
    const auto visit = [&](std::uint32_t, std::uint32_t) { return ++visits < 7; };
    CHECK_FALSE(tree.joinSelf(0.1, visit));
    CHECK(visits == 7);
    visits = 0;
    CHECK_FALSE(tree.join(tree, 0.1, visit));
    CHECK(visits == 7);
}
