#include "core/engine/grid/cell_lists.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace forefront;

namespace {

std::set<std::uint32_t> slotsOf(const CellLists &lists, const CellLists::List &list) {
    std::set<std::uint32_t> slots;
    lists.forEach(list, [&](SlotId id) { CHECK(slots.insert(static_cast<std::uint32_t>(index(id))).second); });
    return slots;
}

std::set<std::uint32_t> nearOf(const CellLists &lists, const CellLists::List &list, const CellBox &box) {
    std::set<std::uint32_t> slots;
    lists.forEachNear(list, box, [&](SlotId id) { slots.insert(static_cast<std::uint32_t>(index(id))); });
    return slots;
}

} // namespace

TEST_CASE("CellLists: pushing, erasing and moving in two lists agrees with a map") {
    CellLists lists;
    const CellScale scale(CellLayout({0, 0}, {1, 1}, 1, 1), 0, 0);
    std::array<CellLists::List, 2> list;
    std::array<std::map<std::uint32_t, Box2>, 2> expected;
    std::mt19937_64 random(11);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const auto box = [&] { return boxOf({unit(), unit()}, {unit(), unit()}); };
    for (int round = 0; round < 5000; ++round) {
        const std::size_t k = random() % 2;
        const auto slot = static_cast<std::uint32_t>(random() % 40);
        const auto found = expected[k].find(slot);
        const Box2 to = box();
        if (found == expected[k].end()) {
            lists.push(list[k], SlotId{slot}, scale(to));
            expected[k][slot] = to;
        } else if (random() % 3 == 0) {
            lists.move(list[k], SlotId{slot}, scale(to));
            found->second = to;
        } else {
            lists.erase(list[k], SlotId{slot});
            expected[k].erase(found);
        }
        REQUIRE(list[k].size == expected[k].size());
        std::set<std::uint32_t> all;
        for (const auto &[id, at] : expected[k]) {
            all.insert(id);
        }
        REQUIRE(slotsOf(lists, list[k]) == all);
        const Box2 query = boxAround({unit(), unit()}, 0.1);
        const std::set<std::uint32_t> near = nearOf(lists, list[k], scale(query));
        for (const auto &[id, at] : expected[k]) {
            REQUIRE((near.count(id) == 1) >= query.overlaps(at));
            REQUIRE((near.count(id) == 0) >= !query.grown(1.0 / CellScale::kSteps).overlaps(at));
        }
    }
}

TEST_CASE("CellScale: boxes that overlap do so in every cell, however far they extend beyond it") {
    for (const double size : {1e-60, 1e-30, 1.0, 1e30, 1e60}) {
        for (const Vec2 corner : {Vec2{0, 0}, Vec2{-3, 7}}) {
            const CellLayout layout(size * corner, {size / 3.0, size / 7.0}, 3, 7);
            std::mt19937_64 random(5);
            const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
            const auto box = [&] {
                const double extent = size * std::pow(10.0, 5.0 * unit() - 3.0);
                const Vec2 a = layout.origin + Vec2{size * (3.0 * unit() - 1.0), size * (3.0 * unit() - 1.0)};
                return boxOf(a, a + Vec2{extent * (unit() - 0.5), extent * (unit() - 0.5)});
            };
            int overlapping = 0;
            for (int round = 0; round < 1000; ++round) {
                const Box2 p = box();
                const Box2 q = round % 3 == 0 ? boxAround(p.max, 0.0) : box(); // the first only touches
                if (!p.overlaps(q)) {
                    continue;
                }
                overlapping += round % 3 == 0 ? 0 : 1;
                for (int cell = 0; cell < layout.columns * layout.rows; ++cell) {
                    const CellScale scale(layout, cell % layout.columns, cell / layout.columns);
                    CellLists lists;
                    CellLists::List list;
                    lists.push(list, SlotId{7}, scale(p));
                    REQUIRE(nearOf(lists, list, scale(q)).count(7) == 1);
                }
            }
            CHECK(overlapping > 50);
        }
    }
}
