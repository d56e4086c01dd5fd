#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

using namespace forefront;
using namespace forefront::testing;

namespace {

constexpr int kJunkFamilies = 6;

/// Positions of nodes that are hard to repair, for a different reason in each family.
Vec2 junkPlace(int family, RandomSource &random) {
    const auto grid = [&](int size) { return static_cast<double>(random.integer(0, size)); };
    const double ulp = std::numeric_limits<double>::epsilon();
    switch (family) {
    case 0: // anywhere
        return {random.unit(), random.unit()};
    case 1: // a lattice, some last digits off
        return {grid(6) * (1.0 + ulp * grid(2)), grid(6) * (1.0 + ulp * grid(2))};
    case 2: // far away: crossings round coarsely
        return {3e8 + random.unit(), -7e8 + random.unit()};
    case 3: { // nearly on one line
        const double t = random.unit();
        return {0.1 + t * 0.7, 0.3 + t * 1.1};
    }
    case 4: // clusters a millionth as large as the whole
        return random.chance(0.5) ? Vec2{random.unit(), random.unit()}
                                  : Vec2{0.5 + 1e-6 * random.unit(), 0.5 + 1e-6 * random.unit()};
    default: { // opposite places: lines nearly through one point
        const double t = 0.1 * random.integer(0, 31);
        return {0.3 + std::cos(t), 0.7 + std::sin(t)};
    }
    }
}

Domain junk(std::uint64_t seed) {
    RandomSource random(seed);
    const int family = static_cast<int>(seed % kJunkFamilies);
    Domain domain;
    for (int i = random.integer(3, 40); i > 0; --i) {
        const bool again = !domain.nodes.empty() && random.chance(0.1);
        domain.nodes.push_back(again ? domain.nodes[random.integer(0, static_cast<int>(domain.nodes.size()) - 1)]
                                     : junkPlace(family, random));
    }
    const auto anyNode = [&] {
        return static_cast<std::uint32_t>(random.integer(0, static_cast<int>(domain.nodes.size()) - 1));
    };
    for (int i = random.integer(1, 40); i > 0; --i) {
        const std::uint32_t a = anyNode(), b = anyNode();
        domain.segments.push_back({a, b, static_cast<std::int32_t>(domain.segments.size() + 1),
                                   random.chance(0.5) ? SegmentRole::Boundary : SegmentRole::Constraint});
    }
    for (int i = random.integer(0, 3); i > 0; --i) {
        domain.points.push_back({anyNode(), 1});
    }
    domain.insideRule = random.chance(0.5) ? InsideRule::EvenOdd : InsideRule::HoleMarkers;
    return domain;
}

bool same(const Domain &first, const Domain &second) {
    const auto equalSegment = [](const DomainSegment &s, const DomainSegment &t) {
        return s.a == t.a && s.b == t.b && s.tag == t.tag && s.role == t.role;
    };
    return first.nodes == second.nodes && std::ranges::equal(first.segments, second.segments, equalSegment) &&
           std::ranges::equal(first.points, second.points, {}, &ConstraintPoint::node, &ConstraintPoint::node);
}

double distanceToAny(const Domain &domain, Vec2 p) {
    double minimum = std::numeric_limits<double>::infinity();
    for (const DomainSegment &s : domain.segments) {
        minimum = std::min(minimum, distanceToSegment(domain.nodes[s.a], domain.nodes[s.b], p));
    }
    return minimum;
}

const std::set<std::string> kRepairable{"zero-length",       "duplicate-node",    "duplicate-segment",
                                        "crossing-segments", "touching-segments", "overlapping-segments",
                                        "unreferenced-node"};

} // namespace

TEST_CASE("repair: leaves no repairable fault in random junk, and a second repair finds nothing") {
    std::size_t changes = 0;
    for (std::uint64_t seed = 0; seed < 1800; ++seed) {
        CAPTURE(seed);
        const Domain domain = junk(seed);
        const auto once = repair(domain);
        REQUIRE(once.ok());
        for (const Diagnostic &fault : validate(once->domain, 100000)) {
            CAPTURE(toString(fault));
            REQUIRE_FALSE(kRepairable.contains(fault.code));
            REQUIRE((domain.insideRule == InsideRule::HoleMarkers || !repairable(fault)));
        }
        const auto again = repair(domain), twice = repair(once->domain);
        REQUIRE(same(once->domain, again->domain));
        REQUIRE(same(once->domain, twice->domain));
        REQUIRE(twice->changes.empty());
        for (const ArrangementChange &change : once->changes) {
            changes += change.count;
        }
    }
    CHECK(changes > 100000);
}

TEST_CASE("repair: each kind of change is one note with its count, its first places and the part involved") {
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        CAPTURE(seed);
        const Domain domain = junk(seed);
        const auto result = repair(domain);
        REQUIRE(result.ok());
        const Diagnostics notes = notesOf(result->changes);
        std::set<std::string> codes;
        for (std::size_t k = 0; k < notes.size(); ++k) {
            CAPTURE(toString(notes[k]));
            REQUIRE(codes.insert(notes[k].code).second);
            REQUIRE(notes[k].severity == Severity::Note);
            REQUIRE(notes[k].at == result->changes[k].places.front());
            REQUIRE(result->changes[k].places.size() == std::min<std::size_t>(3, result->changes[k].count));
            REQUIRE(notes[k].parts.size() == 1);
            const DomainPart &part = notes[k].parts.front();
            const std::size_t known = part.kind == DomainPartKind::Node      ? domain.nodes.size()
                                      : part.kind == DomainPartKind::Segment ? domain.segments.size()
                                                                             : domain.points.size();
            REQUIRE(part.index < known);
        }
    }
}

TEST_CASE("repair: the drawing stays in place, and no part of it is lost") {
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        CAPTURE(seed);
        Domain domain = junk(seed);
        for (DomainSegment &segment : domain.segments) { // without a boundary nothing is outside, so all of it stays
            segment.role = SegmentRole::Constraint;
        }
        domain.insideRule = InsideRule::EvenOdd;
        const auto result = repair(domain);
        REQUIRE(result.ok());
        const Box2 box = domain.bounds();
        const double tolerance = 1e-11 * box.diagonal() + 1e-14 * (std::fabs(box.min.x) + std::fabs(box.min.y));
        for (const DomainSegment &piece : result->domain.segments) {
            const DomainSegment &source = domain.segments[static_cast<std::size_t>(piece.tag - 1)];
            for (const std::uint32_t end : {piece.a, piece.b}) {
                REQUIRE(distanceToSegment(domain.nodes[source.a], domain.nodes[source.b], result->domain.nodes[end]) <=
                        tolerance);
            }
        }
        for (const DomainSegment &segment : domain.segments) {
            const Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
            if (distance(a, b) > tolerance) { // shorter ones may become a point
                for (const double t : {0.0, 0.1, 0.37, 0.5, 0.81, 1.0}) {
                    REQUIRE(distanceToAny(result->domain, lerp(a, b, t)) <= tolerance);
                }
            }
        }
    }
}

TEST_CASE("repair: refuses coordinates that leave no room for nodes") {
    for (const double scale : {1e300, 1e61, 1e-61, 1e-310}) {
        Domain domain;
        domain.nodes = {{0, 0}, {scale, scale}, {scale, 0}, {0, scale}};
        domain.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
        const auto result = repair(domain);
        REQUIRE_FALSE(result.ok());
        CHECK(result.faults()[0].code == "out-of-range");
    }
}

TEST_CASE("repair: nearly collinear segments are cut at their ends, without new nodes") {
    Domain domain;
    RandomSource random(7);
    for (std::uint32_t i = 0; i < 60; ++i) {
        const double t = random.unit();
        domain.nodes.push_back({0.1 + t * 0.7, 0.3 + t * 1.1});
        if (i % 2 == 1) {
            domain.segments.push_back({i - 1, i, 1, SegmentRole::Constraint});
        }
    }
    const auto result = repair(domain);
    REQUIRE(result.ok());
    CHECK(result->domain.nodes.size() == 60);
}
