#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/predicates.hpp"
#include "tests/support/domain_builder.hpp"
#include "tests/support/random_domains.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>

using namespace forefront;
using namespace forefront::testing;

namespace {

std::uint32_t addNode(Domain &domain, Vec2 at) {
    domain.nodes.push_back(at);
    return static_cast<std::uint32_t>(domain.nodes.size() - 1);
}

void addConstraint(Domain &domain, Vec2 a, Vec2 b) {
    const std::uint32_t from = addNode(domain, a), to = addNode(domain, b);
    domain.segments.push_back({from, to, 2, SegmentRole::Constraint});
}

std::string codeList(const Diagnostics &faults) {
    std::string text;
    for (const Diagnostic &fault : faults) {
        text += (text.empty() ? "" : " ") + fault.code;
    }
    return text;
}

const Diagnostic *find(const Diagnostics &faults, const char *code) {
    const auto found = std::find_if(faults.begin(), faults.end(), [&](const Diagnostic &f) { return f.code == code; });
    return found != faults.end() ? &*found : nullptr;
}

std::vector<std::uint32_t> indices(const Diagnostic &fault) {
    std::vector<std::uint32_t> list;
    for (const DomainPart &part : fault.parts) {
        list.push_back(part.index);
    }
    return list;
}

void checkOne(const Domain &domain, const char *code, Vec2 at, const std::vector<std::uint32_t> &ids) {
    const Diagnostics faults = validate(domain);
    REQUIRE(codeList(faults) == code);
    CHECK(faults[0].at == at);
    CHECK(indices(faults[0]) == ids);
    CHECK_FALSE(faults[0].advice.empty());
    CHECK(faults[0].severity == Severity::Error);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("validate: thousands of random domains of every family have no fault") {
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        CAPTURE(seed);
        REQUIRE(codeList(validate(randomDomain(seed))) == "");
    }
}

TEST_CASE("validate: distinguishes crossing, touching and overlapping segments, with their places") {
    Domain crossing = squareDomain(4);
    addConstraint(crossing, {1, 1}, {3, 3});
    addConstraint(crossing, {1, 3}, {3, 1});
    checkOne(crossing, "crossing-segments", {2, 2}, {4, 5});
    Domain touching = squareDomain(4);
    addConstraint(touching, {1, 1}, {4, 2});
    checkOne(touching, "touching-segments", {4, 2}, {5, 1});
    Domain overlapping = squareDomain(4);
    addConstraint(overlapping, {1, 1}, {3, 1});
    addConstraint(overlapping, {2, 1}, {3.5, 1});
    checkOne(overlapping, "overlapping-segments", {2.5, 1}, {4, 5});
}

TEST_CASE("validate: a constraint point on a segment touches it, but one at a corner does not") {
    Domain domain = squareDomain(4);
    domain.points = {{1, 5}};
    CHECK(codeList(validate(domain)) == "");
    domain.points.push_back({addNode(domain, {2, 0}), 1});
    checkOne(domain, "touching-segments", {2, 0}, {4, 0});
}

TEST_CASE("validate: reports duplicate nodes and segments and segments without length") {
    Domain nodes = squareDomain(4);
    nodes.segments[3] = {3, addNode(nodes, {0, 0})};
    checkOne(nodes, "duplicate-node", {0, 0}, {0, 4});
    Domain segments = squareDomain(4);
    segments.segments.push_back({2, 1});
    checkOne(segments, "duplicate-segment", {4, 2}, {1, 4});
    Domain empty = squareDomain(4);
    empty.segments.push_back({2, 2});
    checkOne(empty, "zero-length", {4, 4}, {4});
}

TEST_CASE("validate: reports open chains and odd numbers of boundary segments at a node") {
    Domain open = squareDomain(4);
    open.segments.pop_back();
    const Diagnostics faults = validate(open);
    CHECK(codeList(faults) == "open-chain open-chain");
    CHECK(indices(faults[0]) == std::vector<std::uint32_t>{0});
    CHECK(indices(faults[1]) == std::vector<std::uint32_t>{3});
    CHECK(faults[0].message == faults[1].message);
    Domain tee = squareDomain(4);
    tee.segments.push_back({0, 2});
    CHECK(codeList(validate(tee)) == "open-chain open-chain");
    tee.segments.back().role = SegmentRole::Constraint;
    CHECK(codeList(validate(tee)) == "");
}

TEST_CASE("validate: a boundary of very many loose segments is refused with a list of limited length") {
    Domain loose;
    constexpr std::uint32_t kSegments = 200'000; // must not take time quadratic in their number
    for (std::uint32_t k = 0; k < kSegments; ++k) {
        const double x = k;
        loose.nodes.insert(loose.nodes.end(), {{x, 0.0}, {x + 0.5, 1.0}});
        loose.segments.push_back({2 * k, 2 * k + 1});
    }
    const Diagnostics faults = validate(loose, 10);
    REQUIRE(faults.size() == 11);
    CHECK(faults[0].code == "open-chain");
    CHECK(faults[10].message == "399990 more faults are not listed");
}

TEST_CASE("validate: reports the distance from an open end to the nearest other end, and advises welding only for "
          "narrow gaps") {
    const auto faultsOf = [](double gap) {
        Domain open = squareDomain(4);
        open.segments.pop_back();
        open.nodes[3] = {open.nodes[0].x, open.nodes[0].y + gap};
        return validate(open);
    };
    const double size = squareDomain(4).bounds().diagonal();
    for (const Diagnostic &fault : faultsOf(0.001 * size)) {
        CHECK(fault.message == "the boundary ends at a node, " + numberText(0.001 * size, 3) +
                                   " from the nearest other end; expected a closed loop");
        CHECK(fault.advice.find("repair the domain with a weld tolerance of " + numberText(0.0011 * size, 2)) !=
              std::string::npos);
    }
    for (const Diagnostic &fault : faultsOf(0.02 * size)) {
        CHECK(fault.message.find("from the nearest other end") != std::string::npos);
        CHECK(fault.advice.find("weld") == std::string::npos);
    }
}

TEST_CASE("validate: numbers that are not finite, indices out of range and tags below 1 are refused") {
    Domain number = squareDomain(4);
    number.nodes[2].y = kNan;
    checkOne(number, "non-finite", {4, 0}, {2});
    Domain index = squareDomain(4);
    index.segments[1].b = 77;
    CHECK(indices(*find(validate(index), "bad-index")) == std::vector<std::uint32_t>{1});
    index = squareDomain(4);
    index.points.push_back({5, 1});
    CHECK(codeList(validate(index)) == "bad-index");
    Domain tag = squareDomain(4);
    tag.segments[2].tag = 0;
    checkOne(tag, "bad-tag", {2, 4}, {2});
    Domain marker = squareDomain(4);
    marker.regionMarkers.push_back({{kNan, 1}, 1});
    CHECK(codeList(validate(marker)) == "non-finite");
    CHECK(codeList(validate(squareDomain(1e70))) == "out-of-range out-of-range out-of-range");
    CHECK(codeList(validate(squareDomain(1e-70))) == "out-of-range");
}

TEST_CASE("validate: a domain too far from the origin to tell its nodes apart is refused") {
    Domain domain = squareDomain(4);
    for (Vec2 &p : domain.nodes) {
        p += {1e12, -1e12};
    }
    CHECK(codeList(validate(domain)) == "");
    for (Vec2 &p : domain.nodes) {
        p += {1e13, 0};
    }
    CHECK(codeList(validate(domain)) == "out-of-range");
    CHECK_FALSE(validate(domain)[0].advice.empty());
}

TEST_CASE("validate: places of faults are finite for any coordinates") {
    for (const double bad : {kNan, std::numeric_limits<double>::infinity(), 1.7e308, -1e200}) {
        for (std::size_t n = 0; n < 4; ++n) {
            Domain domain = squareDomain(1.6e308);
            domain.nodes[n] = {bad, bad};
            domain.segments[n].tag = -1;
            domain.segments.push_back({0, 2});
            domain.segments.push_back({1, 3});
            domain.segments.push_back({static_cast<std::uint32_t>(n), 99});
            domain.holeMarkers = {{bad, 0}};
            const Diagnostics faults = validate(domain);
            CHECK(faults.size() > 4);
            for (const Diagnostic &fault : faults) {
                REQUIRE((!fault.at || isFinite(*fault.at)));
            }
        }
    }
}

TEST_CASE("validate: reports unreferenced nodes and parts outside the domain") {
    Domain node = squareDomain(4);
    addNode(node, {1, 1});
    checkOne(node, "unreferenced-node", {1, 1}, {4});
    Domain point = squareDomain(4);
    point.points.push_back({addNode(point, {5, 1}), 1});
    checkOne(point, "point-outside", {5, 1}, {4});
    Domain segment = squareDomain(4);
    addConstraint(segment, {5, 1}, {7, 1});
    checkOne(segment, "segment-outside", {6, 1}, {4});
    Domain marker = squareDomain(4);
    marker.regionMarkers = {{{2, 2}, 1}, {{9, 9}, 3}};
    checkOne(marker, "region-marker-outside", {9, 9}, {1});
    marker.regionMarkers[1].at = {4, 1};
    checkOne(marker, "region-marker-outside", {4, 1}, {1});
    marker.regionMarkers[1].at = {3, 3};
    checkOne(marker, "region-marker-conflict", {3, 3}, {0, 1});
    marker.regionMarkers[1].tag = 1;
    CHECK(codeList(validate(marker)) == "");
}

TEST_CASE("validate: under HoleMarkers holes need markers in bounded parts, and free ends may lie inside") {
    Domain domain = squareDomain(4);
    domain.insideRule = InsideRule::HoleMarkers;
    domain.segments.push_back({0, addNode(domain, {2, 2})});
    CHECK(codeList(validate(domain)) == "");
    domain.holeMarkers = {{9, 9}};
    checkOne(domain, "hole-outside", {9, 9}, {0});
    domain = squareDomain(4);
    domain.insideRule = InsideRule::HoleMarkers;
    domain.holeMarkers = {{1, 3}};
    CHECK(codeList(validate(domain)) == "empty-domain");
    domain.holeMarkers.clear();
    domain.segments.erase(domain.segments.begin() + 2); // open: nothing is bounded
    CHECK(codeList(validate(domain)) == "open-chain open-chain");
}

TEST_CASE("validate: an empty domain is refused") {
    CHECK(codeList(validate({})) == "empty-domain");
    Domain nodes;
    nodes.nodes = {{0, 0}, {1, 1}};
    CHECK(find(validate(nodes), "empty-domain") != nullptr);
    Domain line;
    line.nodes = {{0, 0}, {1, 1}};
    line.segments = {{0, 1, 1, SegmentRole::Constraint}};
    checkOne(line, "empty-domain", {1, 1}, {0});
    CHECK(validate(line).front().advice.find("draw a closed outline") == 0);
}

TEST_CASE("validate: faults of different kinds are all reported at once") {
    Domain domain = squareDomain(4);
    addConstraint(domain, {1, 1}, {3, 3});
    addConstraint(domain, {1, 3}, {3, 1});
    domain.segments.push_back({0, 0});
    domain.segments.push_back({1, 0});
    domain.segments[2].tag = -4;
    addNode(domain, {1, 2});
    addNode(domain, {kNan, 2});
    domain.points.push_back({99, 1});
    domain.segments.push_back({2, addNode(domain, {3.5, 3.5}), 1, SegmentRole::Boundary});
    const Diagnostics faults = validate(domain);
    for (const char *code : {"crossing-segments", "zero-length", "duplicate-segment", "bad-tag", "unreferenced-node",
                             "non-finite", "bad-index", "open-chain"}) {
        CAPTURE(code);
        CHECK(find(faults, code) != nullptr);
    }
}

TEST_CASE("validate: lists faults up to the limit and counts the rest") {
    Domain domain = squareDomain(1000.0);
    for (int i = 1; i <= 30; ++i) {
        addConstraint(domain, {10.0 * i, 5}, {10.0 * i, 995});
        addConstraint(domain, {5, 10.0 * i}, {995, 10.0 * i});
    }
    CHECK(validate(domain, 1000).size() == 900);
    const Diagnostics some = validate(domain, 50);
    REQUIRE(some.size() == 51);
    CHECK(some.back().severity == Severity::Note);
    CHECK(some.back().message.find("850") != std::string::npos);
}

TEST_CASE("validate: random junk yields exactly the pairs that brute force finds") {
    RandomSource random(99);
    std::size_t crossings = 0, overlaps = 0;
    for (int round = 0; round < 400; ++round) {
        Domain domain;
        const int nodes = random.integer(4, 30), size = random.integer(3, 30);
        std::set<std::pair<double, double>> places;
        while (static_cast<int>(domain.nodes.size()) < std::min(nodes, size * size)) {
            const Vec2 p{1.0 * random.integer(0, size), 1.0 * random.integer(0, size)};
            if (places.emplace(p.x, p.y).second) {
                domain.nodes.push_back(p);
            }
        }
        const int last = static_cast<int>(domain.nodes.size()) - 1;
        std::set<std::pair<std::uint32_t, std::uint32_t>> spans;
        for (int i = 0; i < 40; ++i) {
            const auto a = static_cast<std::uint32_t>(random.integer(0, last));
            const auto b = static_cast<std::uint32_t>(random.integer(0, last));
            if (a != b && spans.emplace(std::min(a, b), std::max(a, b)).second) {
                domain.segments.push_back({a, b, 1, SegmentRole::Constraint});
            }
        }
        std::set<std::pair<std::uint32_t, std::uint32_t>> crossing, overlapping, listedCrossing, listedOverlapping;
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            for (std::uint32_t t = s + 1; t < domain.segments.size(); ++t) {
                const auto at = [&](std::uint32_t node) { return domain.nodes[node]; };
                const auto kind = meet(at(domain.segments[s].a), at(domain.segments[s].b), at(domain.segments[t].a),
                                       at(domain.segments[t].b));
                if (kind == SegmentMeeting::Crossing) {
                    crossing.emplace(s, t);
                } else if (kind == SegmentMeeting::Overlapping) {
                    overlapping.emplace(s, t);
                }
            }
        }
        for (const Diagnostic &fault : validate(domain, 100000)) {
            if (fault.code == "crossing-segments") {
                listedCrossing.emplace(fault.parts[0].index, fault.parts[1].index);
            } else if (fault.code == "overlapping-segments") {
                listedOverlapping.emplace(fault.parts[0].index, fault.parts[1].index);
            } else if (fault.code == "touching-segments") {
                const DomainSegment &segment = domain.segments[fault.parts[1].index];
                REQUIRE(
                    onSegment(domain.nodes[segment.a], domain.nodes[segment.b], domain.nodes[fault.parts[0].index]));
            }
        }
        REQUIRE(listedCrossing == crossing);
        REQUIRE(listedOverlapping == overlapping);
        crossings += crossing.size();
        overlaps += overlapping.size();
    }
    CHECK(crossings > 1000);
    CHECK(overlaps > 100);
}

TEST_CASE("validate: a hundred thousand segments that all cross are refused without quadratic work") {
    Domain domain;
    const std::uint32_t count = 100000;
    for (std::uint32_t i = 0; i < count; ++i) { // chords through the neighbourhood of one point
        addConstraint(domain, {-1.0, 1e-5 * i}, {1.0, 1.0 - 1.1e-5 * i});
    }
    const Diagnostics faults = validate(domain);
    CHECK(faults.size() == 201);
    CHECK(faults[0].code == "crossing-segments");
    CHECK(faults.back().message.find("at least") != std::string::npos);
}
