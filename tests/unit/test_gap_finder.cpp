#include "core/engine/domain/add_loop.hpp"
#include "core/engine/spacing/parts/automatic/gap_finder.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace forefront;
using testing::RandomSource;

namespace {

std::vector<Gap> gapsOf(const Domain &domain, double longest) {
    const SegmentIndex index(placedSegments(domain));
    return GapFinder(domain, LazyFaces(domain), index, longest, 1e-4 * spacingBox(domain).diagonal(), {}).find();
}

/// Returns the total length of the parts that face something.
double lengthOf(const std::vector<Gap> &gaps) {
    double sum = 0.0;
    for (const Gap &gap : gaps) {
        sum += distance(gap.a, gap.b);
    }
    return sum;
}

void reverse(Domain &domain) {
    for (DomainSegment &segment : domain.segments) {
        std::swap(segment.a, segment.b);
    }
}

} // namespace

TEST_CASE("GapFinder: the direction of segments does not matter at sharp corners") {
    RandomSource random(11);
    constexpr int kRuns = 500;
    int same = 0; // rounding decides where a width is at a limit, which is rare
    for (int run = 0; run < kRuns; ++run) {
        const Vec2 tip{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
        const double angle = random.between(0.0, 6.0), opening = random.between(0.4, 0.9);
        const auto at = [&](double direction) {
            return tip + random.between(0.5, 2.0) * Vec2{std::cos(direction), std::sin(direction)};
        };
        const Vec2 first = at(angle), second = at(angle + opening);
        Domain domain;
        addLoop(domain, {tip, first, second});
        const double longest = random.between(0.2, 0.45); // parts of half the segments and so on would be borderline
        const std::vector<Gap> gaps = gapsOf(domain, longest);
        reverse(domain);
        const std::vector<Gap> reversed = gapsOf(domain, longest);
        same += reversed.size() == gaps.size() && std::fabs(lengthOf(reversed) - lengthOf(gaps)) < 1e-9 ? 1 : 0;
    }
    CHECK(same >= kRuns - kRuns / 100);
}

TEST_CASE("GapFinder: sides that open like a corner do not face each other, however many segments lie between") {
    // A square with nodes on its sides, and with corners cut off; a channel with the same segments.
    const auto loop = [](const std::vector<Vec2> &corners, double part, double cut) {
        std::vector<Vec2> nodes;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec2 a = corners[k], along = corners[(k + 1) % corners.size()] - a;
            const double size = length(along);
            for (double at = cut; at < size - 0.5 * part; at += part) {
                nodes.push_back(a + (at / size) * along);
            }
            if (cut > 0.0) {
                nodes.push_back(a + ((size - cut) / size) * along);
            }
        }
        Domain domain;
        addLoop(domain, nodes);
        return domain;
    };
    for (const double cut : {0.0, 0.03, 0.07}) {
        CAPTURE(cut);
        CHECK(gapsOf(loop({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.1, cut), 0.1).empty());
        CHECK(lengthOf(gapsOf(loop({{0, 0}, {2, 0}, {2, 0.15}, {0, 0.15}}, 0.1, cut), 0.1)) > 3.0);
    }
}

TEST_CASE("GapFinder: finds gaps only inside the domain, for any order and direction of its segments") {
    RandomSource random(5);
    // A plate with a slot along its lower side: 0.1 of the plate is left below, and a bay outside is as wide.
    Domain domain;
    addLoop(domain, {{0, 0}, {4, 0}, {4, 3}, {2.1, 3}, {2.1, 1}, {2, 1}, {2, 3}, {0, 3}});
    addLoop(domain, {{0.5, 0.1}, {0.5, 0.4}, {3.5, 0.4}, {3.5, 0.1}});
    for (int run = 0; run < 50; ++run) {
        CAPTURE(run);
        for (std::size_t i = domain.segments.size(); i > 1; --i) {
            const auto j = static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1));
            std::swap(domain.segments[i - 1], domain.segments[j]);
            if (random.chance(0.5)) {
                std::swap(domain.segments[i - 1].a, domain.segments[i - 1].b);
            }
        }
        double narrow = 0.0;
        for (const Gap &gap : gapsOf(domain, 10.0)) {
            CHECK(gap.width >= 0.1 * (1.0 - 1e-12));
            if (gap.width < 0.11) {
                CHECK((gap.a.y < 1.0 && gap.b.y < 1.0)); // nothing in the bay, which is outside
                narrow += distance(gap.a, gap.b);
            }
        }
        CHECK(narrow == doctest::Approx(6.0).epsilon(0.05)); // both sides of the strip below the slot
    }
}

TEST_CASE("GapFinder: a line that ends on a finely divided outline at 70 degrees or more is beside no gap") {
    for (const double degrees : {70.0, 80.0, 90.0, 110.0}) {
        for (const bool turned : {false, true}) {
            CAPTURE(degrees);
            Domain domain; // a square whose lower side consists of short segments
            std::vector<Vec2> outline;
            for (int k = 0; k <= 40; ++k) {
                outline.push_back({2.5 * k, 0.0});
            }
            outline.insert(outline.end(), {{100, 100}, {0, 100}});
            addLoop(domain, outline);
            const double angle = degrees * 0.017453292519943295;
            domain.nodes.push_back({50 + 40 * std::cos(angle), 40 * std::sin(angle)});
            const auto tip = static_cast<std::uint32_t>(domain.nodes.size() - 1);
            domain.segments.push_back({20, tip, 2, SegmentRole::Constraint});
            if (turned) {
                reverse(domain);
            }
            CHECK(gapsOf(domain, 10.0).empty());
            // A second line beside the first one, which does not end on the outline, leaves a gap.
            domain.nodes.insert(domain.nodes.end(), {domain.nodes[tip] + Vec2{1, 0},
                                                     lerp(Vec2{51, 0}, domain.nodes[tip] + Vec2{1, 0}, 0.5)});
            domain.segments.push_back({tip + 1, tip + 2, 2, SegmentRole::Constraint});
            CHECK(lengthOf(gapsOf(domain, 10.0)) > 20.0);
        }
    }
}

TEST_CASE("GapFinder: the outline on both sides of a place where a line ends is beside no gap") {
    Domain domain; // a regular polygon with a line from its centre to a corner
    std::vector<Vec2> outline;
    for (int k = 0; k < 60; ++k) {
        outline.push_back({50 * std::cos(0.10471975511965977 * k), 50 * std::sin(0.10471975511965977 * k)});
    }
    addLoop(domain, outline);
    domain.nodes.push_back({0, 0});
    domain.segments.push_back({60, 7, 2, SegmentRole::Constraint});
    CHECK(gapsOf(domain, 5.0).empty()); // farther away, the outline turns back
}

TEST_CASE("GapFinder: of many lines that end at one node, those that face each other are found") {
    RandomSource random(5);
    std::size_t checked = 0;
    for (int run = 0; run < 5; ++run) {
        Domain domain;
        addLoop(domain, {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}});
        const auto centre = static_cast<std::uint32_t>(domain.nodes.size());
        domain.nodes.push_back({0.1, 0.2});
        for (int k = 0; k < 40; ++k) {
            const double angle = random.between(0.0, 6.28), size = random.between(0.5, 5.0);
            domain.nodes.push_back(domain.nodes[centre] + size * Vec2{std::cos(angle), std::sin(angle)});
            const auto end = static_cast<std::uint32_t>(domain.nodes.size() - 1);
            DomainSegment line{k % 2 == 0 ? centre : end, k % 2 == 0 ? end : centre, 2};
            line.role = SegmentRole::Constraint;
            domain.segments.push_back(line);
        }
        const SegmentIndex index(placedSegments(domain));
        const std::vector<Gap> gaps =
            GapFinder(domain, LazyFaces(domain), index, 4.0, 1e-3, {}, {.across = 2.0, .everywhere = true}).find();
        for (const Gap &gap : gaps) {
            const PlacedSegment &own = index.segments[gap.segment];
            if (gap.segment < 4 || distance(gap.a, gap.b) < 1e-3) {
                continue;
            }
            const Vec2 normal = (1.0 / own.length()) * leftNormal(own.b - own.a);
            double nearest = 1e9; // among lines that end where this one does, at most 60 degrees off the normal
            for (const PlacedSegment &other : index.segments) {
                if (other.index < 4 || other.index == own.index) {
                    continue;
                }
                const auto consider = [&](Vec2 p, Vec2 q) {
                    const double gapHere = distance(p, q);
                    if (gapHere > 0.0 && std::fabs(dot(q - p, normal)) >= 0.5 * gapHere) {
                        nearest = std::min(nearest, gapHere);
                    }
                };
                const SizeSite part = SizeSite::segment(gap.a, gap.b, 1.0, 0.0);
                const SizeSite line = SizeSite::segment(other.a, other.b, 1.0, 0.0);
                consider(gap.a, line.nearest(gap.a));
                consider(gap.b, line.nearest(gap.b));
                consider(part.nearest(other.a), other.a);
                consider(part.nearest(other.b), other.b);
            }
            // The closest places of two lines may be too far off the normal where other places of them are not.
            CHECK(gap.width >= nearest * (1.0 - 1e-9));
            checked += gap.width <= nearest * (1.0 + 1e-9) ? 1 : 0;
        }
    }
    CHECK(checked > 50);
}
