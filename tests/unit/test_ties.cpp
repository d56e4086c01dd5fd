#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/front/base_order.hpp"
#include "core/engine/front/order_key.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/discrete_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace forefront;
using forefront::edit_test::documentOf;
using forefront::edit_test::makeShape;

namespace {

/// A change of position and unit that leaves shapes as they are: mirrored, scaled, then shifted.
struct Motion {
    std::string name;
    double factor = 1.0;
    Vec2 shift;
    bool mirrored = false;

    Vec2 operator()(Vec2 p) const { return factor * Vec2{mirrored ? -p.x : p.x, p.y} + shift; }
    std::vector<Vec2> operator()(std::vector<Vec2> nodes) const {
        for (Vec2 &p : nodes) {
            p = (*this)(p);
        }
        return nodes;
    }
};

const std::vector<Motion> kMotions = {
    {"shifted a little", 1.0, {100.1, 33.3}},
    {"shifted far", 1.0, {1000, -500}},
    {"scaled by 3.3", 3.3, {}},
    {"scaled by 3", 3.0, {}},
    {"scaled by 0.1", 0.1, {}},
    {"scaled by 1000", 1e3, {}},
    {"scaled by 1e-9", 1e-9, {}},
    {"scaled by 1e9", 1e9, {}},
    {"scaled by 1e-50", 1e-50, {}},
    {"scaled and shifted", 0.7, {-3.3, 0.1}},
    {"in inches", 1.0 / 25.4, {17, 4}},
};

Shape closedShape(const Motion &at, std::vector<Vec2> nodes, ShapeUse use = ShapeUse::Boundary) {
    return makeShape(ShapeKind::Polygon, at(std::move(nodes)), use);
}
Shape box(const Motion &at, Vec2 low, Vec2 high, ShapeUse use = ShapeUse::Boundary) {
    return closedShape(at, {low, {high.x, low.y}, high, {low.x, high.y}}, use);
}
Shape circle(const Motion &at, Vec2 centre, double radius) {
    return makeShape(ShapeKind::Circle, at({centre, centre + Vec2{radius, 0}}));
}

SizeSource source(const Motion &at, Vec2 centre, double radius, double size, double growth) {
    SizeSource made;
    made.shape = radius > 0.0 ? SourceShape::Circle : SourceShape::Point;
    made.a = at(centre);
    made.radius = at.factor * radius;
    made.size = at.factor * size;
    made.growth = growth;
    return made;
}

MeshingJob jobWithSize(const Motion &at, std::vector<Shape> shapes, double size, std::vector<SizeSource> sources = {}) {
    Document document = documentOf(std::move(shapes));
    document.spacing.size = at.factor * size;
    document.spacing.sources = std::move(sources);
    return jobOf(document);
}

MeshingJob ring(const Motion &at) {
    return jobWithSize(at, {box(at, {0, 0}, {8, 6}), box(at, {3, 2.5}, {5, 3.5})}, 1.0);
}

/// The blade of the lessons: a long thin hole whose sides stay as they are drawn.
MeshingJob blade(const Motion &at) {
    std::vector<Vec2> outline;
    const Vec2 corners[] = {{0, 0}, {8, 0}, {8, 5}, {0, 5}};
    for (unsigned k = 0; k < 4; ++k) {
        const Vec2 a = corners[k], b = corners[(k + 1) % 4];
        const int pieces = static_cast<int>(distance(a, b));
        for (int i = 0; i < pieces; ++i) {
            outline.push_back(lerp(a, b, static_cast<double>(i) / pieces));
        }
    }
    MeshingJob job = jobWithSize(at, {closedShape(at, outline), closedShape(at, {{2, 2.5}, {6, 2.45}, {6, 2.6}})}, 1.0);
    job.options.keepBoundary = true;
    return job;
}

MeshingJob plate(const Motion &at) {
    return jobWithSize(at, {box(at, {0, 0}, {20, 14}), circle(at, {10, 7}, 2.5)}, 2.0,
                       {source(at, {10, 7}, 2.5, 0.35, 0.2)});
}

MeshingJob fineRing(const Motion &at, double gradation) {
    MeshingJob job = jobWithSize(at, {box(at, {0, 0}, {20, 14})}, 2.0, {source(at, {10, 7}, 1.5, 0.3, 5.0)});
    job.spacing.gradation = gradation;
    return job;
}
MeshingJob gentle(const Motion &at) {
    return fineRing(at, 0.2);
}
MeshingJob steep(const Motion &at) {
    return fineRing(at, 3.0);
}

MeshingJob crack(const Motion &at) {
    return jobWithSize(
        at,
        {box(at, {-50, -50}, {50, 50}),
         makeShape(ShapeKind::Polyline, at({{-16, -5}, {-6, -2}, {4, 1}, {16, 6}}), ShapeUse::Constraint)},
        6.0, {source(at, {-16, -5}, 0.0, 0.25, 0.16), source(at, {16, 6}, 0.0, 0.25, 0.16)});
}

MeshingJob ell(const Motion &at) {
    return jobWithSize(at, {closedShape(at, {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}})}, 0.25);
}

/// All angles are 60 or 120 degrees: nodes of a triangular grid fit, and every choice is a tie.
MeshingJob hexagon(const Motion &at) {
    std::vector<Vec2> outer, inner;
    for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3.0;
        outer.push_back({6.0 * std::cos(angle), 6.0 * std::sin(angle)});
        inner.push_back({2.0 * std::cos(angle), 2.0 * std::sin(angle)});
    }
    return jobWithSize(at, {closedShape(at, outer), closedShape(at, inner)}, 0.5);
}

MeshingJob comb(const Motion &at) {
    std::vector<Vec2> nodes{{0, 3}, {0, 0}};
    for (int tooth = 0; tooth < 4; ++tooth) {
        const double x = 2.0 * tooth + 1.0;
        nodes.insert(nodes.end(), {{x, 0}, {x, 2}, {x + 1, 2}, {x + 1, 0}});
    }
    nodes.insert(nodes.end(), {{9, 0}, {9, 3}});
    return jobWithSize(at, {closedShape(at, nodes)}, 0.2);
}

MeshingJob disc(const Motion &at) {
    return jobWithSize(at, {circle(at, {0, 0}, 1.0)}, 0.1);
}

MeshingJob regions(const Motion &at) {
    return jobWithSize(at,
                       {box(at, {0, 0}, {3, 3}), box(at, {1, 1}, {2, 2}, ShapeUse::Constraint),
                        makeShape(ShapeKind::Point, at({{0.5, 0.5}}), ShapeUse::Constraint)},
                       0.125);
}

/// The size varies smoothly by a function of the position.
MeshingJob wave(const Motion &at) {
    MeshingJob job = jobWithSize(at, {box(at, {0, 0}, {9, 6})}, 1.0);
    job.spacing.size.reset();
    job.spacing.function = [at](Vec2 p) {
        const Vec2 q = (1.0 / at.factor) * (p - at.shift);
        return at.factor * (0.3 + 0.03 * std::fabs(at.mirrored ? -q.x : q.x) + 0.1 * std::cos(q.y));
    };
    return job;
}

struct NamedDrawing {
    const char *name;
    MeshingJob (*at)(const Motion &);
};
const std::vector<NamedDrawing> kDrawings = {
    {"ring", ring}, {"blade", blade},     {"plate", plate}, {"gentle", gentle}, {"steep", steep},     {"crack", crack},
    {"ell", ell},   {"hexagon", hexagon}, {"comb", comb},   {"disc", disc},     {"regions", regions}, {"wave", wave}};

/// What a run has counted; without the work that depends on the grid.
struct Tally {
    std::size_t triangles = 0, nodes = 0;
    std::uint64_t advances = 0, frontSum = 0, candidates = 0, deferrals = 0, forced = 0;
    bool operator==(const Tally &) const = default;
};

doctest::String toString(const Tally &tally) {
    return ("[" + std::to_string(tally.triangles) + " triangles, " + std::to_string(tally.nodes) + " nodes, " +
            std::to_string(tally.advances) + " advances, sum of fronts " + std::to_string(tally.frontSum) + "]")
        .c_str();
}

Tally tallyOf(MeshingJob job, ImproveLevel level) {
    job.options.method = Method::Classic;
    job.options.improve = level;
    job.options.threads = 1;
    const Result<MeshingOutcome> outcome = meshDomain(job);
    REQUIRE_MESSAGE(outcome.ok(), outcome.faults().front().message);
    const WorkCounters &work = outcome->work;
    return {outcome->mesh.triangles().size(),
            outcome->mesh.nodes.size(),
            work.advances,
            work.frontSum,
            work.candidates,
            work.deferrals,
            work.forced};
}

} // namespace

TEST_CASE("Ties: the classic front is the same wherever a drawing lies and whatever its unit is") {
    for (const NamedDrawing &drawing : kDrawings) {
        CAPTURE(std::string(drawing.name));
        const Tally still = tallyOf(drawing.at({}), ImproveLevel::None);
        REQUIRE(still.triangles < 10'000);
        for (const Motion &motion : kMotions) {
            CAPTURE(motion.name);
            CHECK(tallyOf(drawing.at(motion), ImproveLevel::None) == still);
        }
    }
}

TEST_CASE("Ties: improvement keeps the number of triangles equal, too") {
    for (const NamedDrawing &drawing : kDrawings) {
        CAPTURE(std::string(drawing.name));
        const Tally still = tallyOf(drawing.at({}), ImproveLevel::Default);
        for (const Motion &motion : kMotions) {
            if (motion.factor > 1e-30) { // improvement gives up on some elements far below that
                CAPTURE(motion.name);
                CHECK(tallyOf(drawing.at(motion), ImproveLevel::Default) == still);
            }
        }
    }
}

TEST_CASE("Ties: mirrored drawings get about as many triangles, since the order of equals is another one") {
    // Bases run along the boundary as it was drawn, which a mirror reverses, and curves are cut from the other end.
    for (const NamedDrawing &drawing : kDrawings) {
        CAPTURE(std::string(drawing.name));
        const Tally still = tallyOf(drawing.at({}), ImproveLevel::None);
        const Tally mirrored = tallyOf(drawing.at({"mirrored", 1.0, {}, true}), ImproveLevel::None);
        CHECK(static_cast<double>(mirrored.triangles) ==
              doctest::Approx(static_cast<double>(still.triangles)).epsilon(0.03));
    }
}

namespace {

/// Returns the captions of all moments in which a step of a run of the classic method begins.
std::vector<std::string> captionsOf(MeshingJob job, Step step) {
    job.options.method = Method::Classic;
    const Result<PreparedJob> prepared = prepare(job);
    REQUIRE(prepared.ok());
    const auto mesher = Mesher::create(prepared->boundary, prepared->spacing, job.options);
    std::vector<std::string> captions;
    for (; !mesher->finished(); mesher->advance(1)) {
        const AdvanceExplanation explanation = mesher->explainNext();
        for (std::size_t k = 0; k < explanation.events.size(); ++k) {
            if (explanation.events[k].step == step) {
                const std::string text = caption(explanation, k);
                captions.push_back(text.substr(text.find(": ") + 2));
            }
        }
    }
    return captions;
}

} // namespace

TEST_CASE("Ties: captions say how many segments or candidates were equal") {
    const std::vector<std::string> bases = captionsOf(ring({}), Step::TakeBase);
    REQUIRE(bases.size() == 100);
    CHECK(bases[0] == "the oldest of the 34 shortest segments of the front, taken as base AB");
    CHECK(bases[31] == "the shortest segment of the front, taken as base AB");
    const std::vector<std::string> best = captionsOf(ring({}), Step::Sort);
    CHECK(best[0] == "best first: node 31");
    CHECK(best[70] == "best first, of 2 equal ones the lowest number: node 54");
    const std::vector<std::string> deferring = captionsOf(blade({}), Step::TakeBase);
    REQUIRE(deferring.size() == 93);
    CHECK(deferring[78] ==
          "the oldest of the 2 shortest segments of the front, leaving out those deferred, taken as base AB");
}

TEST_CASE("orderKey: keeps the order, and numbers that differ by rounding are equal") {
    const double numbers[] = {-2.0,
                              -1.0,
                              -1e-3,
                              0.0,
                              1e-300,
                              0.1,
                              0.3,
                              1.0 / 3.0,
                              0.5,
                              0.7,
                              0.9,
                              1.0,
                              std::numbers::sqrt2,
                              std::numbers::sqrt3,
                              2.0,
                              3.3,
                              10.0,
                              1e9,
                              1e300};
    for (std::size_t k = 0; k + 1 < std::size(numbers); ++k) {
        CHECK(orderKey(numbers[k]) < orderKey(numbers[k + 1]));
        CHECK(orderKey(numbers[k], 0) < orderKey(numbers[k + 1], 0));
    }
    for (const double number : numbers) {
        CAPTURE(number);
        for (const double error : {1e-13, -1e-13, 1e-10, -1e-10}) {
            CHECK(orderKey(number * (1.0 + error)) == orderKey(number));
        }
        CHECK((number == 0.0 || orderKey(number * (1.0 + 3e-8)) != orderKey(number)));
        CHECK((number == 0.0 || orderKey(number * (1.0 + 1e-15), 0) != orderKey(number, 0)));
    }
    CHECK(orderKey(-0.0) == orderKey(0.0));
    CHECK(orderKey(std::nextafter(2.0, 0.0)) == orderKey(2.0)); // across a power of two
    CHECK(orderKey(std::numeric_limits<double>::infinity()) > orderKey(1e300));
    // Multiples of simple numbers, as lengths in a scaled drawing are, stay equal however they were rounded.
    for (int q = 1; q <= 16; ++q) {
        for (int p = 1; p <= 64; ++p) {
            const double number = static_cast<double>(p) / q;
            CHECK(orderKey(number * (1.0 + 1e-12)) == orderKey(number * (1.0 - 1e-12)));
        }
    }
}

TEST_CASE("BaseOrder: of lengths that differ only by rounding the oldest comes first, also where classes meet") {
    using forefront::testing::DiscreteBuilder;
    for (const double length : {1.0, 1.5, 3.0, 0.1, std::numbers::sqrt2}) {
        CAPTURE(length);
        const double longer = length * (1.0 + 4e-16);
        // Three sides, the second of which is shorter by its last bit, and two long ones.
        const auto domain =
            DiscreteBuilder()
                .loop({{0, 0}, {longer, 0}, {longer, length}, {0, length}, {-5.0 * length, 0.5 * length}})
                .region(1, 1.0)
                .build();
        GenerationFront front(*domain);
        const SlotId first{0}, second{1}, third{2}, fourth{3};
        REQUIRE(front[first].length > front[second].length);
        BaseOrder order;
        order.rebuild(front);
        CHECK(firstBases(front, {}, first).equal == 3);
        CHECK(firstBases(front, {}, fourth).equal == 0);
        CHECK_FALSE(firstBases(front, {}, first).earlierDeferred);
        for (const SlotId side : {first, second, third}) {
            CHECK(order.take(front) == side);
            front.setFailureClass(side, 1);
            order.offer(front, side);
        }
        CHECK(firstBases(front, {}, first).equal == 0);
        CHECK(firstBases(front, {}, fourth).equal == 2);
        CHECK(firstBases(front, {}, fourth).earlierDeferred);
        CHECK(order.take(front) == fourth);
    }
}
