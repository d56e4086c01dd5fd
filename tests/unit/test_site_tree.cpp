#include "core/engine/spacing/sites/site_set.hpp"
#include "core/engine/spacing/sites/site_tree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

using namespace forefront;

namespace {

constexpr Box2 kBox{{-10.0, -6.0}, {10.0, 6.0}};

/// Statistics that compare the values of a tree with the minimum over all sites.
struct Accuracy {
    double low = 1e300, high = 0.0; ///< extreme ratios
    double shareOver5 = 0.0;        ///< of the places, more than 5 % too large
};

Accuracy accuracyOf(const std::vector<SizeSite> &sites, unsigned seed) {
    const auto tree = SiteTree::build(sites, kBox, {}, {.many = kManySites});
    REQUIRE(tree.has_value());
    CHECK(tree->bytes() < 60'000'000 + 300 * sites.size());
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(kBox.min.x, kBox.max.x), y(kBox.min.y, kBox.max.y), near(-3.0, 3.0);
    constexpr int kPlaces = 6000;
    Accuracy accuracy;
    std::vector<Vec2> places;
    std::vector<double> values;
    for (int i = 0; i < kPlaces; ++i) {
        Vec2 p{x(random), y(random)};
        if (i % 2 == 0) { // near a site, where leaves are small
            const SizeSite &s = sites[random() % sites.size()];
            p = s.a + s.size * Vec2{near(random), near(random)};
            p = {std::clamp(p.x, kBox.min.x, kBox.max.x), std::clamp(p.y, kBox.min.y, kBox.max.y)};
        }
        const double value = tree->at(p), ratio = value / tree->sites()[tree->winner(p)].at(p);
        places.push_back(p);
        values.push_back(value);
        accuracy.low = std::min(accuracy.low, ratio);
        accuracy.high = std::max(accuracy.high, ratio);
        accuracy.shareOver5 += ratio > 1.05 ? 1.0 / kPlaces : 0.0;
        REQUIRE(value >= tree->minimum() * (1.0 - 1e-6));
        REQUIRE(value <= tree->maximum() * (1.0 + 1e-6));
    }
    std::vector<double> together(places.size(), std::numeric_limits<double>::infinity());
    tree->lowerMany(places, together);
    CHECK(together == values);
    std::fill(together.begin(), together.end(), 0.5 * tree->minimum());
    tree->lowerMany(places, together);
    CHECK(together == std::vector<double>(places.size(), 0.5 * tree->minimum()));
    return accuracy;
}

} // namespace

TEST_CASE("SiteSet: keeps the sites that a pass in the order of their sizes keeps") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const std::size_t count : {std::size_t{1}, std::size_t{300}, kManySites, kManySites + 1}) {
        const double slack = count > kManySites ? 1.5 : 1.0;
        SiteSet set;
        for (std::uint32_t i = 0; i < count; ++i) { // in clusters, some along a line, many of equal size
            const Vec2 at{std::floor(8.0 * unit(random)) + 0.2 * unit(random), i % 3 == 0 ? 0.01 * i : unit(random)};
            const double size = i % 5 == 0 ? 0.05 : 0.01 * std::exp2(6.0 * unit(random));
            set.add(SizeSite::segment(at, at + size * Vec2{unit(random), i % 2 == 0 ? 0.0 : 1.0}, size, 0.2),
                    {{}, {}, i});
        }
        std::vector<std::uint32_t> order(count), expected, kept;
        std::iota(order.begin(), order.end(), 0U);
        std::stable_sort(order.begin(), order.end(),
                         [&](auto i, auto j) { return set.sites[i].size < set.sites[j].size; });
        std::vector<std::uint32_t> before; // those that count
        for (const std::uint32_t i : order) {
            const SizeSite &weak = set.sites[i];
            const bool dominated = std::any_of(before.begin(), before.end(), [&](std::uint32_t j) {
                const SizeSite &strong = set.sites[j];
                return strong.at(weak.a) <= slack * weak.size && strong.at(weak.a + weak.ab) <= slack * weak.size;
            });
            if (!dominated) {
                expected.push_back(i);
            }
            if (!dominated || slack == 1.0) {
                before.push_back(i);
            }
        }
        std::sort(expected.begin(), expected.end());
        set.dropDominated();
        for (const SiteLabel &label : set.labels) {
            kept.push_back(label.index);
        }
        CAPTURE(count);
        CHECK(kept == expected);
        CHECK((count == 1 || kept.size() < count));
    }
}

TEST_CASE("Site tree: many sites along wavy coasts of very different sizes give nearly their minimum everywhere") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<SizeSite> sites;
    for (int coast = 0; coast < 12; ++coast) {
        const Vec2 centre{16.0 * share(random) - 8.0, 10.0 * share(random) - 5.0};
        const double radius = 0.02 * std::pow(100.0, share(random));
        constexpr int kNodes = 500;
        const auto place = [&](int i) {
            const double turn = 2.0 * std::numbers::pi * i / kNodes;
            return centre + radius * (1.0 + 0.2 * std::sin(7.0 * turn)) * Vec2{std::cos(turn), std::sin(turn)};
        };
        for (int i = 0; i < kNodes; ++i) {
            sites.push_back(SizeSite::segment(place(i), place(i + 1), distance(place(i), place(i + 1)), 0.25));
        }
    }
    REQUIRE(sites.size() > kManySites);
    const Accuracy accuracy = accuracyOf(sites, 1);
    CHECK(accuracy.low > 0.97);
    CHECK(accuracy.high < 1.3);
    CHECK(accuracy.shareOver5 < 0.01);
}

TEST_CASE("Site tree: many points of random sizes give nearly their minimum everywhere") {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<SizeSite> sites;
    for (std::size_t i = 0; i < 2 * kManySites; ++i) {
        // Some lie outside the box.
        const Vec2 at{22.0 * share(random) - 11.0, 14.0 * share(random) - 7.0};
        sites.push_back(SizeSite::point(at, 1e-4 * std::pow(3000.0, share(random)), 0.25, i % 3 == 0 ? 0.01 : 0.0));
    }
    const Accuracy accuracy = accuracyOf(sites, 2);
    CHECK(accuracy.low > 0.97);
    CHECK(accuracy.high < 1.4);
    CHECK(accuracy.shareOver5 < 0.01);
}

TEST_CASE("Site tree: many sites at one place, far finer than the cells can be, do not exhaust memory") {
    std::vector<SizeSite> sites;
    for (std::size_t i = 0; i < 2 * kManySites; ++i) {
        const double x = 1e-9 * static_cast<double>(i);
        sites.push_back(SizeSite::segment({x, 0.0}, {x, 11.0}, 1e-12, 0.25));
    }
    CHECK(accuracyOf(sites, 3).low > 0.97);
}

TEST_CASE("Site tree: many sites that grow differently give nearly their minimum everywhere") {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<SizeSite> sites;
    for (std::size_t i = 0; i < 2 * kManySites; ++i) {
        const Vec2 at{20.0 * share(random) - 10.0, 12.0 * share(random) - 6.0};
        sites.push_back(SizeSite::point(at, 0.01 + 0.3 * share(random), 0.1 + 0.4 * share(random)));
    }
    const Accuracy accuracy = accuracyOf(sites, 4);
    CHECK(accuracy.low > 0.97);
    CHECK(accuracy.high < 1.05);
}

TEST_CASE("Site tree: sites far longer than the box take no longer than others") {
    std::mt19937 random(10);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<SizeSite> sites;
    for (std::size_t i = 0; i < 2 * kManySites; ++i) {
        const Vec2 at{20.0 * share(random) - 10.0, 12.0 * share(random) - 6.0};
        sites.push_back(SizeSite::point(at, 0.01 + 0.3 * share(random), 0.25));
    }
    sites.push_back(SizeSite::segment({-1e14, 3.0}, {1e14, 3.0}, 1e-3, 0.25));
    sites.push_back(SizeSite::segment({-1e12, -1e12}, {1e12, 1e12}, 1e-3, 0.25));
    sites.push_back(SizeSite::segment({12.0, -1e15}, {12.0, 1e15}, 1e-3, 0.25)); // beside the box
    const Accuracy accuracy = accuracyOf(sites, 5);
    CHECK(accuracy.low > 0.97);
    CHECK(accuracy.high < 1.3);
    CHECK(accuracy.shareOver5 < 0.01);
}
