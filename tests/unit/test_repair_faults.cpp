#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/unit/arrangement_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

using namespace forefront;
using namespace forefront::testing;

namespace {

/// Kinds of faults to put into a valid domain; none changes what it means.
enum class Fault : std::uint8_t {
    RepeatedNode,
    NearNode,
    RepeatedSegment,
    EmptySegment,
    UnusedNode,
    Overlap,
    Crossing
};
constexpr int kFaults = 7;

/// A valid domain with faults that a repair must mend.
class FaultyDomain {
  public:
    FaultyDomain(std::uint64_t seed, double tolerancePart) : random_(seed), clean(randomDomain(seed)), faulty(clean) {
        clean.boundaryNames = faulty.boundaryNames = {{1, "shore"}, {3, "pier"}};
        clean.regionNames = faulty.regionNames = {{2, "mud"}};
        tolerance = tolerancePart * clean.bounds().diagonal();
        if (random_.chance(0.2)) { // the whole boundary twice
            for (const DomainSegment &segment : clean.segments) {
                if (segment.role == SegmentRole::Boundary) {
                    faulty.segments.push_back(segment);
                }
            }
        }
        for (int i = random_.integer(1, 12); i > 0; --i) {
            add(static_cast<Fault>(random_.integer(0, kFaults - 1)));
        }
    }

  private:
    RandomSource random_;

    DomainSegment &anySegment(Domain &domain) {
        return domain
            .segments[static_cast<std::size_t>(random_.integer(0, static_cast<int>(domain.segments.size()) - 1))];
    }
    std::uint32_t addNode(Vec2 at) {
        faulty.nodes.push_back(at);
        return static_cast<std::uint32_t>(faulty.nodes.size() - 1);
    }
    Vec2 nudge() { return 0.3 * tolerance * Vec2{random_.between(-1.0, 1.0), random_.between(-1.0, 1.0)}; }
    void addLine(Vec2 a, Vec2 b) {
        const std::uint32_t from = addNode(a), to = addNode(b);
        faulty.segments.push_back({from, to, 9, SegmentRole::Constraint});
    }

    void add(Fault fault) {
        switch (fault) {
        case Fault::RepeatedNode:
        case Fault::NearNode: {
            DomainSegment &segment = anySegment(faulty);
            const Vec2 at = faulty.nodes[segment.a];
            segment.a = addNode(fault == Fault::NearNode ? at + nudge() : at);
            break;
        }
        case Fault::RepeatedSegment: {
            DomainSegment copy = anySegment(clean);
            std::swap(copy.a, copy.b);
            copy.role = SegmentRole::Constraint;
            copy.tag = 8;
            faulty.segments.push_back(copy);
            break;
        }
        case Fault::EmptySegment: {
            const std::uint32_t node = addNode(faulty.nodes[anySegment(faulty).a]);
            faulty.segments.push_back({node, node, 7, SegmentRole::Boundary});
            break;
        }
        case Fault::UnusedNode:
            addNode(clean.bounds().centre() + nudge());
            break;
        case Fault::Overlap: { // a line along a segment, off by rounding or a part of the tolerance
            const DomainSegment &segment = anySegment(clean);
            const Vec2 a = clean.nodes[segment.a], b = clean.nodes[segment.b];
            addLine(lerp(a, b, random_.between(0.0, 0.4)) + nudge(), lerp(a, b, random_.between(0.6, 1.0)) + nudge());
            break;
        }
        case Fault::Crossing: {
            const Box2 box = clean.bounds();
            const auto place = [&] {
                return Vec2{random_.between(box.min.x, box.max.x), random_.between(box.min.y, box.max.y)};
            };
            const Vec2 from = place();
            addLine(from, place());
            break;
        }
        }
    }

  public:
    Domain clean, faulty;
    double tolerance = 0.0;
};

/// Returns the length of the boundary by tag.
std::map<std::int32_t, double> boundaryLengths(const Domain &domain) {
    std::map<std::int32_t, double> lengths;
    for (const DomainSegment &segment : domain.segments) {
        if (segment.role == SegmentRole::Boundary) {
            lengths[segment.tag] += distance(domain.nodes[segment.a], domain.nodes[segment.b]);
        }
    }
    return lengths;
}

bool sameSegments(const Domain &a, const Domain &b) {
    return std::ranges::equal(a.segments, b.segments, [](const DomainSegment &s, const DomainSegment &t) {
        return s.a == t.a && s.b == t.b && s.tag == t.tag && s.role == t.role;
    });
}

/// Checks that the repaired domain means what the clean one did.
void checkMeaning(const FaultyDomain &given, const Domain &repaired) {
    const Box2 box = given.clean.bounds();
    const double slack = 4.0 * given.tolerance + 1e-9 * box.diagonal() + 1e-13 * length(box.max);
    double perimeter = 0.0;
    const auto lengths = boundaryLengths(repaired), expected = boundaryLengths(given.clean);
    REQUIRE(lengths.size() == expected.size());
    for (const auto &[tag, length] : expected) {
        perimeter += length;
        REQUIRE(lengths.contains(tag));
        const double nodes = static_cast<double>(repaired.nodes.size());
        REQUIRE(std::fabs(lengths.at(tag) - length) <= nodes * slack);
    }
    REQUIRE(std::fabs(insideArea(repaired) - insideArea(given.clean)) <= perimeter * slack);
    REQUIRE(repaired.regionMarkers == given.faulty.regionMarkers);
    REQUIRE(repaired.boundaryNames == given.faulty.boundaryNames);
    REQUIRE(repaired.regionNames == given.faulty.regionNames);
    REQUIRE(repaired.points.size() == given.clean.points.size());
}

/// Checks that each segment of the result follows its source, with its tag.
void checkSources(const FaultyDomain &given, const Repaired &repaired) {
    const double limit = given.tolerance * (1.0 + 1e-9) + 1e-14 * given.clean.bounds().diagonal() +
                         1e-14 * length(given.clean.bounds().max);
    REQUIRE(repaired.segmentSource.size() == repaired.domain.segments.size());
    for (std::size_t s = 0; s < repaired.domain.segments.size(); ++s) {
        const DomainSegment &segment = repaired.domain.segments[s];
        const DomainSegment &source = given.faulty.segments[repaired.segmentSource[s]];
        REQUIRE(segment.tag == source.tag);
        for (const std::uint32_t end : {segment.a, segment.b}) {
            REQUIRE(distanceToSegment(given.faulty.nodes[source.a], given.faulty.nodes[source.b],
                                      repaired.domain.nodes[end]) <= limit);
        }
    }
    for (const ArrangementChange &change : repaired.changes) {
        REQUIRE(change.displacement <= limit);
    }
}

void checkRepairs(double tolerancePart, int runs) {
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(runs); ++seed) {
        CAPTURE(seed);
        const FaultyDomain given(seed, tolerancePart);
        const auto repaired = repair(given.faulty, given.tolerance);
        REQUIRE(repaired.ok());
        for (const Diagnostic &fault : validate(repaired->domain)) {
            FAIL(toString(fault));
        }
        if (given.tolerance == 0.0) {
            REQUIRE(hasErrors(validate(given.faulty)) == !repaired->changes.empty());
        }
        checkMeaning(given, repaired->domain);
        checkSources(given, *repaired);
        const auto twice = repair(repaired->domain, repaired->radius);
        REQUIRE(twice.ok());
        REQUIRE(twice->changes.empty());
        REQUIRE(twice->domain.nodes == repaired->domain.nodes);
        REQUIRE(sameSegments(twice->domain, repaired->domain));
    }
}

} // namespace

TEST_CASE("repair: fixes faults put into random domains, without welding") {
    checkRepairs(0.0, 1000);
}

TEST_CASE("repair: fixes faults and gaps within the tolerance, and moves nothing farther") {
    checkRepairs(1e-7, 1000);
}

TEST_CASE("repair: a gap in the outline is closed if it is within the tolerance, and stays open otherwise") {
    Domain domain;
    domain.nodes = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0.01}};
    domain.segments = {{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 4, 4}};
    const auto open = repair(domain);
    REQUIRE(open.ok());
    CHECK(open->changes.empty());
    CHECK(hasErrors(validate(open->domain)));
    const auto closed = repair(domain, 0.02);
    REQUIRE(closed.ok());
    CHECK(validate(closed->domain).empty());
    REQUIRE(closed->changes.size() == 1);
    CHECK(closed->changes.front().kind == ChangeKind::WeldedNodes);
    CHECK(closed->changes.front().displacement == doctest::Approx(0.01));
    CHECK(closed->domain.segments.size() == 4);
}

TEST_CASE("repair: segments keep their parts of a curve, also where they are split") {
    constexpr std::uint32_t kChords = 12;
    Domain domain;
    domain.curves = {Curve::circle({1, 2}, {4, 2})};
    domain.curveTolerance = 0.01;
    for (std::uint32_t k = 0; k < kChords; ++k) {
        const double t0 = static_cast<double>(k) / kChords, t1 = static_cast<double>(k + 1) / kChords;
        domain.nodes.push_back(domain.curves[0].point(t0));
        domain.segments.push_back({k, (k + 1) % kChords, 3, SegmentRole::Boundary, {0, t0, t1}});
    }
    const auto same = repair(domain);
    REQUIRE(same.ok());
    for (std::size_t s = 0; s < kChords; ++s) {
        CHECK(same->domain.segments[s].stretch == domain.segments[s].stretch);
    }
    domain.nodes.insert(domain.nodes.end(), {{1, 2}, {9, 3}}); // a line across the outline
    domain.segments.push_back({kChords, kChords + 1, 4, SegmentRole::Constraint});
    const auto split = repair(domain);
    REQUIRE(split.ok());
    CHECK(validate(split->domain).empty());
    CHECK(split->domain.curves == domain.curves);
    CHECK(split->domain.curveTolerance == 0.01);
    double range = 0.0;
    for (const DomainSegment &segment : split->domain.segments) {
        if (segment.role == SegmentRole::Boundary) {
            range += segment.stretch.t1 - segment.stretch.t0;
            CHECK(segment.stretch.curve == 0);
            CHECK(distance(domain.curves[0].point(segment.stretch.t0), split->domain.nodes[segment.a]) < 0.11);
            CHECK(distance(domain.curves[0].point(segment.stretch.t1), split->domain.nodes[segment.b]) < 0.11);
        }
    }
    CHECK(range == doctest::Approx(1.0));
    CHECK(split->domain.segments.size() == kChords + 2);
}

TEST_CASE("repair: parts outside disappear, but nothing does while the boundary is open") {
    Domain domain;
    domain.nodes = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {3, 1}, {6, 1}, {8, 8}};
    domain.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}, {4, 5, 5, SegmentRole::Constraint}};
    domain.points = {{6, 3}};
    const auto closed = repair(domain);
    REQUIRE(closed.ok());
    CHECK(validate(closed->domain).empty());
    CHECK(closed->domain.points.empty());
    CHECK(closed->domain.nodes.size() == 6); // four corners, one end of the line, its crossing
    domain.segments.erase(domain.segments.begin() + 3);
    const auto open = repair(domain);
    REQUIRE(open.ok());
    CHECK(open->domain.points.size() == 1);
    CHECK(open->domain.segments.size() == 6);
}

TEST_CASE("repair: holes stay holes by their markers; one that is open to the outside loses its marker") {
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    domain.nodes = {{0, 0}, {6, 0}, {6, 4}, {0, 4}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {4, 0}, {5, 0}, {5, 1}, {4, 1}};
    const auto loop = [&](std::initializer_list<std::uint32_t> nodes, std::int32_t tag) {
        std::uint32_t last = *(nodes.end() - 1);
        for (const std::uint32_t node : nodes) {
            domain.segments.push_back({last, node, tag});
            last = node;
        }
    };
    loop({0, 1, 2, 3}, 1);
    loop({4, 5, 6, 7}, 2);
    loop({8, 9, 10, 11}, 3); // a hole on the outline
    domain.holeMarkers = {{1.5, 1.5}, {4.5, 0.5}};
    domain.regionMarkers = {{{0.5, 0.5}, 4}};
    const auto repaired = repair(domain);
    REQUIRE(repaired.ok());
    CHECK(validate(repaired->domain).empty());
    CHECK(insideArea(repaired->domain) == doctest::Approx(22.0));
    CHECK(repaired->domain.holeMarkers == std::vector<Vec2>{{1.5, 1.5}});
    CHECK(repaired->domain.regionMarkers == domain.regionMarkers);
    CHECK(boundaryLengths(repaired->domain).at(3) == doctest::Approx(3.0));
}

TEST_CASE("repair: a hole that crosses the outline takes nothing beyond it into the domain") {
    const auto loop = [](Domain &domain, std::initializer_list<Vec2> nodes) {
        const auto first = static_cast<std::uint32_t>(domain.nodes.size());
        domain.nodes.insert(domain.nodes.end(), nodes.begin(), nodes.end());
        const auto count = static_cast<std::uint32_t>(nodes.size());
        for (std::uint32_t k = 0; k < count; ++k) {
            domain.segments.push_back({first + k, first + (k + 1) % count, 1});
        }
    };
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    loop(domain, {{0, 0}, {8, 0}, {8, 8}, {0, 8}});
    loop(domain, {{6, 2}, {10, 2}, {10, 4}, {6, 4}}); // beyond the right side
    loop(domain, {{1, 1}, {3, 1}, {3, 3}, {1, 3}});   // inside
    loop(domain, {{2, 5}, {4, 5}, {4, 10}, {2, 10}}); // beyond the top, with an island that stays
    loop(domain, {{2.5, 5.5}, {3.5, 5.5}, {3.5, 6.5}, {2.5, 6.5}});
    domain.holeMarkers = {{7, 3}, {2, 2}, {2.25, 6}};
    const auto repaired = repair(domain);
    REQUIRE(repaired.ok());
    CHECK_MESSAGE(validate(repaired->domain).empty(), repaired->domain.segments.size());
    CHECK(insideArea(repaired->domain) == doctest::Approx(64.0 - 4.0 - 4.0 - 6.0 + 1.0));
    CHECK(repaired->domain.holeMarkers == std::vector<Vec2>{{2, 2}});
    CHECK(repaired->holeMarkerSource == std::vector<std::uint32_t>{1});
    const Diagnostics notes = notesOf(repaired->changes);
    const auto note = std::find_if(notes.begin(), notes.end(), [](const auto &n) { return n.code == "hole-crosses"; });
    REQUIRE(note != notes.end());
    CHECK(note->message.find("left out 2 parts of holes beyond the outlines that they cross") == 0);
    // An outline that another one crosses is no hole, and stays.
    domain.holeMarkers = {{2, 2}};
    const auto joined = repair(domain);
    REQUIRE(joined.ok());
    CHECK(insideArea(joined->domain) == doctest::Approx(64.0 - 4.0 + 4.0 + 4.0));
}

TEST_CASE("repair: with hole markers, a second outline with a gap is not taken for a line outside") {
    Domain domain;
    domain.insideRule = InsideRule::HoleMarkers;
    domain.nodes = {{0, 0}, {1, 0}, {0, 1}, {5, 0}, {6, 0}, {5, 1}};
    domain.segments = {{0, 1}, {1, 2}, {2, 0}, {3, 4, 1, SegmentRole::Constraint}, {4, 5, 1, SegmentRole::Constraint}};
    const auto repaired = repair(domain);
    REQUIRE(repaired.ok());
    CHECK(repaired->changes.empty());
    const Diagnostics faults = validate(repaired->domain);
    REQUIRE(faults.size() == 2);
    CHECK(faults.front().code == "segment-outside");
    domain.nodes[5] = {7, 0.1}; // no longer near its beginning
    const auto dropped = repair(domain);
    REQUIRE(dropped.ok());
    CHECK(validate(dropped->domain).empty());
    CHECK(dropped->domain.segments.size() == 3);
}
