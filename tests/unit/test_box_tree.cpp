#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/hilbert.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
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

/// Random boxes, most of them in a spot far smaller than the whole, at any scale and far from the origin.
std::vector<Box2> crowdedBoxes(RandomSource &random, double scale, double offset) {
    std::vector<Box2> boxes = randomBoxes(random, 300);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const double factor = k % 8 == 0 ? scale : 1e-7 * scale;
        const Vec2 shift{offset * scale, offset * scale};
        boxes[k] = {factor * boxes[k].min + shift, factor * boxes[k].max + shift};
    }
    return boxes;
}

std::vector<std::uint32_t> found(const BoxTree &tree, const Box2 &box) {
    std::vector<std::uint32_t> items;
    tree.query(box, [&](std::uint32_t item) { items.push_back(item); });
    std::sort(items.begin(), items.end());
    return items;
}

std::vector<std::uint32_t> overlapping(const std::vector<Box2> &boxes, const Box2 &box) {
    std::vector<std::uint32_t> items;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].overlaps(box)) {
            items.push_back(i);
        }
    }
    return items;
}

} // namespace

TEST_CASE("BoxTree: a query finds exactly the boxes that meet the given one") {
    RandomSource random(13);
    for (const double scale : {1.0, 1e-300, 1e-306, 1e300}) {
        for (const double offset : {0.0, -1e4}) {
            const std::vector<Box2> boxes = crowdedBoxes(random, scale, offset);
            const BoxTree tree(boxes);
            std::size_t all = 0;
            for (const Box2 &box : crowdedBoxes(random, scale, offset)) {
                CHECK(found(tree, box) == overlapping(boxes, box));
                all += overlapping(boxes, box).size();
            }
            CHECK(all > 300);
        }
    }
}

TEST_CASE("BoxTree: a query finds boxes that only touch the given one") {
    std::vector<Box2> boxes;
    for (int x = 0; x < 20; ++x) {
        for (int y = 0; y < 20; ++y) {
            const Vec2 corner{1.0 * x, 1.0 * y};
            boxes.push_back(boxOf(corner, corner + Vec2{1, 1}));
        }
    }
    const BoxTree tree(boxes);
    for (const Box2 &box : boxes) {
        CHECK(found(tree, box) == overlapping(boxes, box));
        CHECK(found(tree, box).size() >= 4);
        CHECK(found(tree, boxAround(box.max, 0.0)) == overlapping(boxes, boxAround(box.max, 0.0)));
    }
}

TEST_CASE("BoxBlock: vector instructions find what comparisons find, at the first and last steps, too") {
    RandomSource random(15);
    const auto step = [&] {
        constexpr int kLast = 32766;
        const int choice = random.integer(0, 3);
        return static_cast<std::int16_t>(choice == 0 ? -kLast - 1 : choice == 1 ? kLast : random.integer(-3, 3));
    };
    const auto box = [&] {
        const std::int16_t x1 = step(), x2 = step(), y1 = step(), y2 = step();
        return StepBox{std::min(x1, x2), std::min(y1, y2), std::max(x1, x2), std::max(y1, y2)};
    };
    for (int run = 0; run < 500; ++run) {
        BoxBlock block;
        const auto filled = static_cast<std::size_t>(random.integer(0, 8));
        for (std::size_t lane = 0; lane < filled; ++lane) {
            block.set(lane, box());
        }
        const StepBox sought = box();
        CHECK(block.overlapping(sought) == block.overlappingOneByOne(sought));
        CHECK((block.overlapping(sought) >> filled) == 0U);
    }
}

TEST_CASE("BoxTree: a query finds boxes of any shape") {
    constexpr double kInfinity = std::numeric_limits<double>::infinity(), kMost = std::numeric_limits<double>::max();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Box2 point = boxOf(Vec2{2, 3}, Vec2{2, 3}), whole{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
    const Box2 most{{-kMost, -kMost}, {kMost, kMost}}, column{{1, -kInfinity}, {2, kInfinity}};
    const Box2 left{{-kMost, 0}, {-kMost, 1}}, unknown{{nan, 0}, {nan, 9}};
    const std::vector<std::vector<Box2>> sets = {{},
                                                 {point},
                                                 {point, point},
                                                 {unknown, point},
                                                 {whole, point},
                                                 {most, point, left},
                                                 {column, left, point, unknown}};
    for (const std::vector<Box2> &boxes : sets) {
        const BoxTree tree(boxes);
        for (const Box2 &box : {point, whole, most, column, left, unknown, boxOf(Vec2{2, 4}, Vec2{5, 9})}) {
            CHECK(found(tree, box) == overlapping(boxes, box));
        }
    }
}

TEST_CASE("BoxTree: a search whose visits shrink the box finds what meets the last one, and little else") {
    RandomSource random(14);
    const std::vector<Box2> boxes = randomBoxes(random, 2000);
    const BoxTree tree(boxes);
    for (int i = 0; i < 50; ++i) {
        const Vec2 centre{random.between(0.0, 1.0), random.between(0.0, 1.0)};
        double reach = 0.5;
        Box2 around = boxAround(centre, reach);
        std::vector<std::uint32_t> items;
        CHECK(tree.search(around, [&](std::uint32_t item) {
            CHECK(boxes[item].overlaps(around));
            items.push_back(item);
            reach = std::max(0.9 * reach, 0.02);
            around = boxAround(centre, reach);
            return true;
        }));
        std::sort(items.begin(), items.end());
        const std::vector<std::uint32_t> last = overlapping(boxes, around);
        CHECK(std::includes(items.begin(), items.end(), last.begin(), last.end()));
        CHECK(items.size() < 1000);
    }
    int visits = 0;
    CHECK_FALSE(tree.search(boxOf(Vec2{0, 0}, Vec2{1, 1}), [&](std::uint32_t) { return ++visits < 7; }));
    CHECK(visits == 7);
}

TEST_CASE("hilbertCode: cells that follow each other share a side") {
    constexpr std::uint32_t kSide = 64;
    std::vector<std::pair<std::uint32_t, std::pair<int, int>>> cells;
    for (std::uint32_t x = 0; x < kSide; ++x) {
        for (std::uint32_t y = 0; y < kSide; ++y) {
            cells.push_back({hilbertCode(morton::spread(x) | morton::spread(y) << 1), {x, y}});
        }
    }
    std::sort(cells.begin(), cells.end());
    for (std::size_t k = 1; k < cells.size(); ++k) {
        CHECK(cells[k].first == cells[k - 1].first + 1);
        const auto [x, y] = cells[k].second;
        const auto [lastX, lastY] = cells[k - 1].second;
        CHECK(std::abs(x - lastX) + std::abs(y - lastY) == 1);
    }
}

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
