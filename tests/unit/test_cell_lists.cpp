#include "core/grid/cell_lists.hpp"

#include <doctest/doctest.h>

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

std::set<std::uint32_t> nearOf(const CellLists &lists, const CellLists::List &list, const Box2 &box) {
    std::set<std::uint32_t> slots;
    lists.forEachNear(list, lists.scaled(box), [&](SlotId id) { slots.insert(static_cast<std::uint32_t>(index(id))); });
    return slots;
}

} // namespace

TEST_CASE("CellLists: pushing, erasing and moving in two lists agrees with a map") {
    CellLists lists({{0, 0}, {1, 1}});
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
            lists.push(list[k], SlotId{slot}, to);
            expected[k][slot] = to;
        } else if (random() % 3 == 0) {
            lists.move(list[k], SlotId{slot}, to);
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
        const std::set<std::uint32_t> near = nearOf(lists, list[k], query);
        for (const auto &[id, at] : expected[k]) {
            REQUIRE((near.count(id) == 1) >= query.overlaps(at));
            REQUIRE((near.count(id) == 0) >= !query.grown(1e-5).overlaps(at));
        }
    }
}

TEST_CASE("CellLists: boxes that touch are near, whatever the size of the domain and however far they leave it") {
    for (const double size : {1e-310, 1e-30, 1.0, 1e30, 1e300}) {
        for (const Vec2 corner : {Vec2{0, 0}, Vec2{-3, 7}}) {
            const Vec2 low = size * corner;
            const auto at = [&](double x, double y) { return low + Vec2{x * size, y * size}; };
            CellLists lists({low, at(1, 0.5)});
            CellLists::List list;
            std::mt19937_64 random(5);
            const auto far = [&] { return (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) * 200.0; };
            for (std::uint32_t i = 0; i < 300; ++i) {
                lists.push(list, SlotId{i}, boxOf(at(far(), far()), at(far(), far())));
                const Vec2 p = at(far(), far());
                lists.push(list, SlotId{1000 + i}, boxOf(p, at(far(), far())));
                REQUIRE(nearOf(lists, list, boxOf(p, p)).count(1000 + i) == 1);
            }
        }
    }
}
