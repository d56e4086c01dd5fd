#include "core/engine/grid/hierarchical_grid.hpp"
#include "core/engine/grid/no_grid.hpp"
#include "core/engine/grid/uniform_grid.hpp"
#include "tests/support/discrete_samples.hpp"
#include "tests/support/sanitizers.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// A front of many lengths and directions: nested polygons, each smaller than the last by a factor.
std::shared_ptr<const DiscreteDomain> nest(Vec2 offset) {
    DiscreteBuilder builder;
    double radius = 1.0;
    for (int ring = 0; ring < 12; ++ring) {
        builder.loop(circleNodes(offset + Vec2{0.001 * ring, 0.0}, radius, 7 + 5 * ring, ring % 2 == 0));
        radius *= 0.6;
    }
    return builder.region(1, 1.0).build();
}

/// Returns true if the segment ab meets the box, for segments that do not just touch it.
bool meetsBox(Vec2 a, Vec2 b, const Box2 &box) {
    const Vec2 d = b - a, half = 0.5 * box.size();
    return box.overlaps(boxOf(a, b)) &&
           std::abs(cross(d, box.centre() - a)) <= half.x * std::abs(d.y) + half.y * std::abs(d.x);
}

std::set<std::uint32_t> near(const GenerationFront &front, const Box2 &box) {
    std::set<std::uint32_t> slots;
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        if (front[SlotId{i}].alive && segmentNearBox(front.start(SlotId{i}), front.end(SlotId{i}), box)) {
            slots.insert(i);
        }
    }
    return slots;
}

template <class Grid>
std::set<std::uint32_t> delivered(const Grid &grid, const GenerationFront &front, const Box2 &box) {
    std::set<std::uint32_t> slots;
    grid.query(
        front, box,
        [&](SlotId id, bool near) {
            if (near && segmentNearBox(front.start(id), front.end(id), box)) {
                slots.insert(static_cast<std::uint32_t>(index(id)));
            }
        },
        [](const Box2 &) {});
    return slots;
}

/// Checks that all segments that meet the box are delivered, and none whose box is far from the part of it inside the
/// grid.
template <class Grid>
void checkNear(const Grid &grid, const GenerationFront &front, const Box2 &box, const Box2 &bounds) {
    std::set<std::uint32_t> slots;
    std::uint32_t calls = 0;
    double step = 0.0; // of the largest visited cell
    const std::uint32_t looked = grid.queryNear(
        front, box,
        [&](SlotId id) {
            ++calls;
            slots.insert(static_cast<std::uint32_t>(index(id)));
        },
        [&](const Box2 &cell) {
            step = std::max({step, cell.size().x / 256.0, cell.size().y / 256.0});
        });
    CHECK(looked >= calls);
    const auto inside = [&](Vec2 p) {
        return Vec2{std::clamp(p.x, bounds.min.x, bounds.max.x), std::clamp(p.y, bounds.min.y, bounds.max.y)};
    };
    const Box2 reach = Box2{inside(box.min), inside(box.max)}.grown(step + gridSlack(bounds));
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const Box2 ends = boxOf(front.start(SlotId{i}), front.end(SlotId{i}));
        if (meetsBox(front.start(SlotId{i}), front.end(SlotId{i}), box)) {
            REQUIRE(slots.count(i) == 1);
        } else if (!reach.overlaps(ends)) {
            REQUIRE(slots.count(i) == 0);
        }
    }
}

template <class Grid>
void checkAgainstAll(Grid grid, const GenerationFront &front, const Box2 &bounds) {
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        grid.insert(front, SlotId{i});
    }
    std::mt19937_64 random(7);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (int round = 0; round < (kSanitized ? 400 : 2000); ++round) {
        const Vec2 centre = bounds.min + Vec2{unit() * 1.4 - 0.2, unit() * 1.4 - 0.2} + Vec2{0.4, 0.4};
        const double radius = std::pow(10.0, -4.0 * unit());
        const Box2 box = boxAround(centre, radius);
        REQUIRE(delivered(grid, front, box) == near(front, box));
        checkNear(grid, front, box, bounds);
    }
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        grid.remove(front, SlotId{i});
    }
    std::uint32_t left = 0;
    grid.forEachCell([&](const Box2 &, std::uint32_t entries) { left += entries; });
    CHECK(left == 0);
}

} // namespace

TEST_CASE("Background grids: deliver every segment near a box, of any length, and no removed one") {
    for (const Vec2 offset : {Vec2{0, 0}, Vec2{1e5, -3e5}}) {
        const auto domain = nest(offset);
        const GenerationFront front(*domain);
        const Box2 bounds = domain->bounds();
        SUBCASE("none") {
            checkAgainstAll(NoGrid(), front, bounds);
        }
        SUBCASE("uniform") {
            checkAgainstAll(UniformGrid(bounds, 17, 11), front, bounds);
        }
        SUBCASE("uniform of one cell") {
            checkAgainstAll(UniformGrid(bounds, 1, 1), front, bounds);
        }
        SUBCASE("hierarchical") {
            for (const double cellPerLength : {2.0, 3.5, 12.0}) {
                checkAgainstAll(HierarchicalGrid(bounds, cellPerLength), front, bounds);
            }
        }
    }
}

TEST_CASE("HierarchicalGrid: the number of delivered segments does not grow when sizes differ by a factor of 1e5") {
    DiscreteBuilder builder;
    double radius = 1.0;
    for (int ring = 0; ring < 24; ++ring, radius *= 0.6) {
        builder.loop(circleNodes({0, 0}, radius, 40, ring % 2 == 0));
    }
    const auto domain = builder.region(1, 1.0).build();
    const GenerationFront front(*domain);
    HierarchicalGrid grid(domain->bounds(), 4.0);
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        grid.insert(front, SlotId{i});
    }
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const SlotId id{i};
        std::size_t count = 0;
        grid.query(
            front, boxAround(front.start(id), front[id].length), [&](SlotId, bool) { ++count; }, [](const Box2 &) {});
        CHECK(count < 400);
    }
}

TEST_CASE("Background grids: a node far away makes no cells near the others coarse") {
    constexpr double kFar = 1e20;
    for (const Vec2 far : {Vec2{4, kFar}, Vec2{-kFar, 1}, Vec2{kFar, kFar}, Vec2{-kFar, -0.5 * kFar}}) {
        CAPTURE(far.x);
        CAPTURE(far.y);
        DiscreteBuilder builder;
        double radius = 1.0;
        for (int ring = 0; ring < 12; ++ring, radius *= 0.6) {
            builder.loop(circleNodes({0, 0}, radius, 40, ring % 2 == 0));
        }
        builder.loop({{2, 2}, far, {2, 2.5}});
        const auto domain = builder.region(1, 1.0).build();
        const GenerationFront front(*domain);
        HierarchicalGrid grid(domain->bounds(), 4.0);
        UniformGrid uniform(domain->bounds(), 5, 3);
        for (std::uint32_t i = 0; i < front.capacity(); ++i) {
            grid.insert(front, SlotId{i});
            uniform.insert(front, SlotId{i});
        }
        for (std::uint32_t i = 0; i < front.capacity(); ++i) {
            const SlotId id{i};
            std::size_t count = 0;
            const Box2 box = boxAround(front.start(id), std::min(1.0, front[id].length));
            grid.query(
                front, box, [&](SlotId, bool) { ++count; }, [](const Box2 &) {});
            CHECK(count < 300);
            REQUIRE(delivered(grid, front, box) == near(front, box));
            REQUIRE(delivered(uniform, front, box) == near(front, box));
        }
        for (std::uint32_t i = 0; i < front.capacity(); ++i) {
            grid.remove(front, SlotId{i});
        }
        std::uint32_t left = 0;
        grid.forEachCell([&](const Box2 &, std::uint32_t entries) { left += entries; });
        CHECK(left == 0);
    }
}

TEST_CASE("CellLayout: cells crossed by a segment contain every point of it") {
    const CellLayout layout({-1, -1}, {0.1, 0.07}, 20, 30);
    std::mt19937_64 random(3);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (int round = 0; round < 3000; ++round) {
        const Vec2 a{unit() * 3 - 1.5, unit() * 3 - 1.5};
        const Vec2 b = round % 3 == 0 ? Vec2{a.x, unit()} : Vec2{unit() * 3 - 1.5, unit() * 3 - 1.5};
        std::set<std::pair<int, int>> cells;
        forEachCrossedCell(layout, a, b, 1e-12, 1e-12, [&](int i, int j) { cells.insert({i, j}); });
        for (int k = 0; k <= 200; ++k) {
            const Vec2 p = lerp(a, b, k / 200.0);
            REQUIRE(cells.count({layout.column(p.x), layout.row(p.y)}) == 1);
        }
    }
}

TEST_CASE("HierarchicalGrid: a segment that moves within its cell is found only at its new position") {
    DiscreteBuilder builder;
    builder.loop({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
    const auto domain = builder.region(1, 1.0).build();
    GenerationFront front(*domain);
    HierarchicalGrid grid(domain->bounds(), 4.0);
    const SlotId a = front.insertAfter(SlotId{0}, {0.1, 0.1}, NodeId{4});
    const SlotId b = front.insertAfter(a, {0.8, 0.2}, NodeId{5});
    grid.insert(front, a);
    const Vec2 to{0.2, 0.9};
    REQUIRE(grid.keeps(a, front.start(a), to));
    front.replace(b, to, NodeId{6});
    grid.moved(front, a);
    const auto finds = [&](Vec2 p) {
        bool found = false;
        grid.queryNear(
            front, boxAround(p, 0.01), [&](SlotId id) { found = found || id == a; }, [](const Box2 &) {});
        return found;
    };
    CHECK(finds({0.15, 0.5}));
    CHECK(finds({0.2, 0.9}));
    CHECK_FALSE(finds({0.15, 0.95}));
    CHECK_FALSE(finds({0.5, 0.15}));
}
