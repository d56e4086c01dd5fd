#include "core/engine/front/base_order.hpp"
#include "core/engine/front/generation_front.hpp"
#include "core/engine/front/order_key.hpp"
#include "tests/support/discrete_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::uint64_t hashOf(const GenerationFront &front) {
    Hash64 hash;
    front.addTo(hash);
    return hash.value();
}

/// Returns the slot of the segment that starts at p.
SlotId slotAt(const GenerationFront &front, Vec2 p) {
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        if (front[SlotId{i}].alive && front.start(SlotId{i}) == p) {
            return SlotId{i};
        }
    }
    return kNoSlot;
}

std::shared_ptr<const DiscreteDomain> unitSquare() {
    return DiscreteBuilder().loop(rectangleNodes({0, 0}, {1, 1}, 1)).region(1, 1.0).build();
}

} // namespace

TEST_CASE("GenerationFront: starts as the boundary with the domain on the left") {
    const GenerationFront front(*unitSquare());
    CHECK(front.segments() == 4);
    CHECK(front.consistent());
    const SlotId a = slotAt(front, {0, 0});
    CHECK(front.end(a) == Vec2{1, 0});
    CHECK(front.start(front.prev(a)) == Vec2{0, 1});
}

TEST_CASE("GenerationFront: both sides of a constraint inside the domain are segments of the front") {
    const auto domain = DiscreteBuilder()
                            .loop(rectangleNodes({0, 0}, {4, 4}, 4))
                            .chain({{1, 1}, {2, 2}, {3, 1}})
                            .region(1, 16.0)
                            .build();
    const GenerationFront front(*domain);
    CHECK(front.segments() == 4 + 2 * 2);
    CHECK(front.consistent());
    const SlotId tip = slotAt(front, {1, 1});
    CHECK(front.end(tip) == Vec2{2, 2});
    CHECK(front.start(front.prev(tip)) == Vec2{2, 2});
}

TEST_CASE("GenerationFront: loops that touch at a node keep their own free angles") {
    // Two triangles that share the node (1, 1), both holes of a large square.
    const auto domain = DiscreteBuilder()
                            .loop(rectangleNodes({-4, -4}, {6, 6}, 10))
                            .loop({{1, 1}, {0, 0}, {0, 2}})
                            .loop({{1, 1}, {2, 2}, {2, 0}})
                            .region(1, 98.0)
                            .build();
    const GenerationFront front(*domain);
    CHECK(front.segments() == 10);
    CHECK(front.consistent());
    // Continuing from one hole leads around the other.
    SlotId walk = slotAt(front, {0, 0});
    std::size_t length = 0;
    const SlotId first = walk;
    do {
        walk = front.next(walk);
        ++length;
    } while (walk != first && length < 20);
    CHECK(length == 6);
}

TEST_CASE("GenerationFront: removing a segment relinks its neighbours") {
    GenerationFront front(*unitSquare());
    const SlotId corner = slotAt(front, {1, 0});
    const SlotId before = front.prev(corner);
    front.cutOut(corner);
    CHECK(front.segments() == 3);
    CHECK(front.consistent());
    CHECK(front.end(before) == Vec2{1, 1});
}

TEST_CASE("GenerationFront: a connection splits a loop in two and merges two loops into one") {
    const auto hexagon = DiscreteBuilder().loop(circleNodes({0, 0}, 1.0, 6)).region(1, 2.6).build();
    GenerationFront front(*hexagon);
    const SlotId a{0};
    const SlotId opposite{3};
    const SlotId t = front.connect(a, opposite);
    CHECK(front.consistent());
    CHECK(front.segments() == 7);
    CHECK(front.next(a) == opposite);
    CHECK(front[t].node == front[opposite].node);
    CHECK(front.next(front.next(front.next(front.next(opposite)))) == opposite);
}

TEST_CASE("GenerationFront: every change can be undone exactly") {
    const auto domain = discretePlate(0.2);
    GenerationFront front(*domain);
    const std::uint64_t start = hashOf(front);
    const SlotId a{0};
    const SegmentMark mark = front[a].mark;

    SUBCASE("a new node") {
        const SlotId c = front.insertAfter(a, {0.1, 0.1}, NodeId{999});
        CHECK(hashOf(front) != start);
        front.undoInsertAfter(a, c, mark);
    }
    SUBCASE("a slot cut out") {
        const SlotId x = front.next(a);
        const FrontSlot removed = front[x];
        front.cutOut(x);
        CHECK(hashOf(front) != start);
        front.undoCutOut(x, a, removed.node, removed.position, removed.mark, mark);
    }
    SUBCASE("a connection") {
        const SlotId s{6};
        const SlotId t = front.connect(a, s);
        CHECK(hashOf(front) != start);
        front.undoConnect(a, s, t, mark);
    }
    SUBCASE("a connection to an isolated point") {
        const SlotId s = slotAt(front, {0.7, 0.3});
        REQUIRE(front.isolated(s));
        const SlotId t = front.connect(a, s);
        CHECK(t == s);
        CHECK_FALSE(front.isolated(s));
        front.undoConnect(a, s, t, mark);
        CHECK(front.isolated(s));
    }
    CHECK(front.consistent());
    CHECK(hashOf(front) == start);
}

TEST_CASE("GenerationFront: the free angle at a corner, at a reflex corner and at the tip of a slit") {
    const GenerationFront square(*unitSquare());
    const SlotId corner = slotAt(square, {0, 0});
    CHECK(square.insideAngle(corner, {0.5, 0.5}));
    CHECK_FALSE(square.insideAngle(corner, {0.5, 0.0}));
    CHECK_FALSE(square.insideAngle(corner, {0.5, -0.1}));

    const auto holed = DiscreteBuilder()
                           .loop(rectangleNodes({-3, -3}, {3, 3}, 6))
                           .loop(rectangleNodes({0, 0}, {1, 1}, 1, false))
                           .region(1, 35.0)
                           .build();
    const GenerationFront hole(*holed);
    const SlotId reflex = slotAt(hole, {0, 0});
    CHECK(hole.insideAngle(reflex, {-1, -1}));
    CHECK(hole.insideAngle(reflex, {-1, 0.5}));
    CHECK_FALSE(hole.insideAngle(reflex, {0.5, 0.5}));
    CHECK_FALSE(hole.insideAngle(reflex, {0, 0.5}));

    const auto slit =
        DiscreteBuilder().loop(rectangleNodes({-3, -3}, {3, 3}, 6)).chain({{0, 0}, {1, 0}}).region(1, 36.0).build();
    const GenerationFront slitFront(*slit);
    const SlotId tip = slotAt(slitFront, {0, 0});
    CHECK(slitFront.insideAngle(tip, {-1, 0}));
    CHECK(slitFront.insideAngle(tip, {1, 0.001}));
    CHECK_FALSE(slitFront.insideAngle(tip, {2, 0}));
}

TEST_CASE("BaseOrder: shortest first, ties by serial, deferred segments last") {
    const auto domain = DiscreteBuilder().loop({{0, 0}, {3, 0}, {3, 1}, {0, 1}}).region(1, 3.0).build();
    GenerationFront front(*domain);
    BaseOrder order;
    order.rebuild(front);
    const SlotId first = order.take(front);
    CHECK(front[first].length == 1.0);
    front.setFailureClass(first, 1);
    order.offer(front, first);
    const SlotId second = order.take(front);
    CHECK(front[second].length == 1.0);
    CHECK(second != first);
    const SlotId third = order.take(front);
    const SlotId fourth = order.take(front);
    CHECK(front[third].length == 3.0);
    CHECK(front[third].mark.serial < front[fourth].mark.serial);
    CHECK(order.take(front) == first);
    CHECK(order.take(front) == kNoSlot);
}

TEST_CASE("BaseOrder: similar lengths come in batches, oldest batch first, the shortest of a batch first") {
    // Segments of several batches in a row, with lengths spread over two octaves.
    constexpr std::uint32_t kSegments = 40'000;
    GenerationFront front(*DiscreteBuilder().loop({{0, 0}, {3e5, 0}, {3e5, 1}}).region(1, 1.5e5).build());
    std::mt19937_64 random(4);
    SlotId last{0};
    double x = 0.0;
    for (std::uint32_t i = 0; i < kSegments; ++i) {
        x += std::exp2(2.0 * static_cast<double>(random() >> 11) * 0x1p-53);
        last = front.insertAfter(last, {x, 0}, NodeId{3 + i});
    }
    struct Expected {
        double about; ///< the length cut off after five binary digits
        std::uint32_t portion;
        std::int64_t key; ///< of its length
        std::uint32_t serial;
        SlotId slot;
        auto operator<=>(const Expected &) const = default;
    };
    std::vector<Expected> expected;
    std::size_t older = 0;
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        const FrontSlot &slot = front[SlotId{i}];
        const double step = std::exp2(std::ilogb(slot.length) - 4);
        const std::uint32_t portion = slot.mark.serial / 16384;
        expected.push_back(
            {std::floor(slot.length / step) * step, portion, orderKey(slot.length), slot.mark.serial, SlotId{i}});
        older += portion > 1 ? 1 : 0;
    }
    REQUIRE(older > 1000);
    std::sort(expected.begin(), expected.end());
    BaseOrder order;
    order.rebuild(front);
    for (const Expected &next : expected) {
        REQUIRE(order.take(front) == next.slot);
    }
    CHECK(order.take(front) == kNoSlot);

    // Deferred segments are ordered by length alone, in any batch.
    std::vector<std::pair<double, SlotId>> deferred;
    for (const std::size_t k : {expected.size() / 2, expected.size() / 3, std::size_t{5}, expected.size() - 9}) {
        const SlotId id = expected[k].slot;
        front.setFailureClass(id, 1);
        order.offer(front, id);
        deferred.emplace_back(front[id].length, id);
    }
    std::sort(deferred.begin(), deferred.end());
    for (const auto &[length, id] : deferred) {
        CHECK(order.take(front) == id);
    }
}
