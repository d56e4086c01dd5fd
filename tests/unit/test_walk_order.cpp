#include "core/engine/front/walk_order.hpp"
#include "tests/support/discrete_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::uint64_t hashOf(const WalkOrder &order) {
    Hash64 hash;
    order.addTo(hash);
    return hash.value();
}

/// A thin saw: segments of many lengths, all different.
GenerationFront saw(int teeth, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> exponent(-6.0, 3.0);
    std::vector<Vec2> nodes{{0, 0}, {1000, 0}, {1000, 50}};
    for (int i = 0; i < teeth; ++i) {
        nodes.push_back({1000.0 - 900.0 * (i + 1) / teeth, 20.0 + std::exp2(exponent(random))});
    }
    nodes.push_back({0, 60});
    return GenerationFront(*DiscreteBuilder().loop(nodes).region(1, 1.0).build());
}

std::vector<SlotId> all(const GenerationFront &front) {
    std::vector<SlotId> slots;
    for (std::uint32_t i = 0; i < front.capacity(); ++i) {
        slots.push_back(SlotId{i});
    }
    return slots;
}

} // namespace

TEST_CASE("WalkOrder: classes follow the lengths, from the smallest double to the largest") {
    for (const bool fine : {false, true}) {
        CAPTURE(fine);
        WalkOrder order;
        order.clear({fine, 0});
        CHECK(order.level(0.0) == 0);
        std::uint32_t last = 0;
        for (double length = std::numeric_limits<double>::denorm_min(); std::isfinite(length); length *= 1.003) {
            const double next = std::nextafter(length, std::numeric_limits<double>::max());
            REQUIRE(order.level(length) >= last);
            REQUIRE(order.level(next) >= order.level(length));
            last = order.level(next);
            length = next;
        }
        std::set<std::uint32_t> octave;
        for (double length = 8.0; length < 16.0; length += 1.0 / 64.0) {
            octave.insert(order.level(length));
        }
        CHECK(octave.size() == (fine ? 64 : 2));
        const bool differ = order.level(0x1.6A09p3) < order.level(0x1.6A0Ap3); // the root of 2 lies between
        CHECK(differ == !fine);
    }
}

TEST_CASE("WalkOrder: segments between boundary nodes count as half as long, also in a copy without history") {
    GenerationFront front = saw(300, 5);
    const std::vector<SlotId> slots = all(front);
    constexpr std::uint32_t kNodes = 100;
    const auto ofBoundary = [&](SlotId id) {
        return index(front[id].node) < kNodes && index(front[front.next(id)].node) < kNodes;
    };
    WalkOrder order;
    order.clear({true, kNodes});
    for (const SlotId id : slots) {
        CHECK(order.levelOf(front, id) == order.level(ofBoundary(id) ? 0.5 * front[id].length : front[id].length));
        order.offer(front, id);
    }
    for (std::size_t k = 0; k < slots.size() / 2; ++k) {
        order.take(front);
    }
    WalkOrder copy = order.withoutHistory();
    std::uint32_t last = 0;
    for (SlotId id = order.take(front); id != kNoSlot; id = order.take(front)) {
        CHECK(copy.take(front) == id);
        CHECK(copy.levelOf(front, id) == order.levelOf(front, id));
        CHECK(order.levelOf(front, id) >= last);
        last = order.levelOf(front, id);
    }
    CHECK(copy.empty());
}

TEST_CASE("WalkOrder: shorter classes first, first in first out within a class, deferred segments last") {
    for (const bool fine : {false, true}) {
        CAPTURE(fine);
        GenerationFront front = saw(300, 5);
        std::vector<SlotId> offered = all(front);
        std::shuffle(offered.begin(), offered.end(), std::mt19937_64(7));
        front.setFailureClass(offered[10], 1);
        front.setFailureClass(offered[20], 2);
        WalkOrder order;
        order.clear({fine, 0});
        CHECK(order.empty());
        std::vector<std::size_t> rank(front.capacity());
        for (std::size_t i = 0; i < offered.size(); ++i) {
            order.offer(front, offered[i]);
            rank[index(offered[i])] = i;
        }
        std::vector<SlotId> taken;
        for (SlotId id = order.take(front); id != kNoSlot; id = order.take(front)) {
            taken.push_back(id);
        }
        CHECK(order.empty());
        REQUIRE(taken.size() == offered.size());
        const auto later = [&](SlotId p, SlotId q) { // p is to come after q
            const bool deferredP = front[p].mark.failureClass > 0, deferredQ = front[q].mark.failureClass > 0;
            const std::uint32_t levelP = order.level(front[p].length), levelQ = order.level(front[q].length);
            return deferredP != deferredQ ? deferredP
                   : levelP != levelQ     ? levelP > levelQ
                                          : rank[index(p)] > rank[index(q)];
        };
        for (std::size_t i = 1; i < taken.size(); ++i) {
            REQUIRE(later(taken[i], taken[i - 1]));
        }
    }
}

TEST_CASE("WalkOrder: skips segments that are gone or were deferred since") {
    GenerationFront front = saw(40, 9);
    WalkOrder order;
    order.clear({true, 0});
    for (const SlotId id : all(front)) {
        order.offer(front, id);
    }
    const SlotId changed{4}, deferred{9};
    front.insertAfter(changed, 0.5 * (front.start(changed) + front.end(changed)), NodeId{1000}); // another segment now
    front.setFailureClass(deferred, 1);
    std::set<SlotId> taken;
    for (SlotId id = order.take(front); id != kNoSlot; id = order.take(front)) {
        taken.insert(id);
    }
    CHECK(taken.size() == front.segments() - 3); // nor was the new one offered
    CHECK(taken.count(changed) == 0);
    CHECK(taken.count(deferred) == 0);
}

TEST_CASE("WalkOrder: rolls back its log exactly") {
    for (const bool fine : {false, true}) {
        const GenerationFront front = saw(200, 3);
        WalkOrder order;
        order.clear({fine, 0});
        const std::vector<SlotId> slots = all(front);
        for (std::size_t i = 0; i < slots.size(); i += 2) {
            order.offer(front, slots[i]);
        }
        for (int i = 0; i < 30; ++i) {
            order.take(front); // before the log begins: forgotten
        }
        order.keepLog(true);
        std::mt19937_64 random(11);
        std::vector<std::uint64_t> hashes;
        std::vector<std::size_t> sizes;
        for (int i = 0; i < 500; ++i) {
            hashes.push_back(hashOf(order));
            sizes.push_back(order.logSize());
            if (random() % 2 == 0) {
                order.offer(front, slots[random() % slots.size()]);
            } else {
                order.take(front);
            }
        }
        for (std::size_t i = hashes.size(); i-- > 0;) {
            order.rollBack(sizes[i]);
            REQUIRE(hashOf(order) == hashes[i]);
        }
        CHECK(order.logSize() == 0);
    }
}
