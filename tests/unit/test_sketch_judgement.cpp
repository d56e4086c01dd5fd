// Whether a constraint can be added to a sketch, and with which others it conflicts.
#include "core/drawing/sketch/judge_constraint.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"
#include "tests/support/random_sketch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace forefront;
using namespace forefront::tests;

namespace {

/// A rectangle of horizontal and vertical sides (constraints 1 to 4), 4 by 3 (5 and 6).
struct ConstrainedRectangle {
    SketchSystem system;
    SketchPoint a = system.addPoint({0.0, 0.0}), b = system.addPoint({4.0, 0.0}), c = system.addPoint({4.0, 3.0}),
                d = system.addPoint({0.0, 3.0});

    explicit ConstrainedRectangle(bool sized) {
        system.addEquation(makeEqual(a.y, b.y), 1);
        system.addEquation(makeEqual(b.x, c.x), 2);
        system.addEquation(makeEqual(c.y, d.y), 3);
        system.addEquation(makeEqual(d.x, a.x), 4);
        if (sized) {
            system.addEquation(makeDistance(a, b, 4.0), 5);
            system.addEquation(makeDistance(b, c, 3.0), 6);
        }
    }

    ConstraintJudgement judge(const SketchEquation &equation) {
        system.addEquation(equation, 9);
        return judgeConstraint(system, 9);
    }
};

using Names = std::vector<std::uint32_t>;

/// Returns the equations of some constraints, one more, and the forms of shapes.
std::vector<std::uint32_t> equationsOf(const SketchSystem &system, const Names &constraints, std::uint32_t judged) {
    std::vector<std::uint32_t> list;
    for (std::uint32_t k = 0; k < system.equations.size(); ++k) {
        const std::uint32_t id = system.equations[k].constraint;
        if (id == 0 || id == judged || std::find(constraints.begin(), constraints.end(), id) != constraints.end()) {
            list.push_back(k);
        }
    }
    return list;
}

} // namespace

TEST_CASE("Sketch judgement: the opposite side of a rectangle") {
    ConstrainedRectangle same(true);
    ConstraintJudgement judgement = same.judge(makeDistance(same.c, same.d, 4.0));
    CHECK(judgement.verdict == ConstraintVerdict::Redundant);
    CHECK(judgement.with == Names{1, 2, 3, 4, 5});

    ConstrainedRectangle other(true);
    judgement = other.judge(makeDistance(other.c, other.d, 5.0));
    CHECK(judgement.verdict == ConstraintVerdict::Conflict);
    CHECK(judgement.with == Names{2, 3, 4, 5}); // a slanting first side would be longer than 4, too
}

TEST_CASE("Sketch judgement: diagonal, direction and corner of a rectangle") {
    ConstrainedRectangle implied(true);
    ConstraintJudgement judgement = implied.judge(makeDistance(implied.a, implied.c, 5.0));
    CHECK(judgement.verdict == ConstraintVerdict::Redundant);
    CHECK(judgement.with == Names{1, 2, 5, 6});

    ConstrainedRectangle wrong(true);
    judgement = wrong.judge(makeDistance(wrong.a, wrong.c, 6.0));
    CHECK(judgement.verdict == ConstraintVerdict::Conflict);
    CHECK(judgement.with == Names{1, 2, 5, 6});

    ConstrainedRectangle parallel(true);
    judgement = parallel.judge(makeAngle(parallel.a, parallel.b, parallel.d, parallel.c, 0.0));
    CHECK(judgement.verdict == ConstraintVerdict::Redundant);
    CHECK(judgement.with == Names{1, 3});

    ConstrainedRectangle corner(false);
    judgement = corner.judge(makeAngle(corner.a, corner.b, corner.b, corner.c, std::numbers::pi / 3.0));
    CHECK(judgement.verdict == ConstraintVerdict::Conflict);
    CHECK(judgement.with == Names{1, 2});

    ConstrainedRectangle free(false);
    CHECK(free.judge(makeDistance(free.a, free.c, 7.0)).verdict == ConstraintVerdict::Fine);
}

TEST_CASE("Sketch judgement: triangles") {
    const auto triangle = [](Vec2 top, double third) {
        SketchSystem system;
        const SketchPoint a = system.addPoint({0.0, 0.0}), b = system.addPoint({1.0, 0.0}), c = system.addPoint(top);
        system.addEquation(makeDistance(a, b, 1.0), 1);
        system.addEquation(makeDistance(b, c, distance({1.0, 0.0}, top)), 2);
        system.addEquation(makeDistance(a, c, third), 3);
        return judgeConstraint(system, 3);
    };
    const ConstraintJudgement tooLong = triangle({0.5, 0.8}, 3.0);
    CHECK(tooLong.verdict == ConstraintVerdict::Conflict);
    CHECK(tooLong.with == Names{1, 2});
    CHECK(triangle({2.0, 0.0}, 1.5).verdict == ConstraintVerdict::Fine); // flat, but it can bend
    CHECK(triangle({2.0, 0.0}, 2.0).verdict == ConstraintVerdict::Fine); // independent elsewhere
}

TEST_CASE("Sketch judgement: what already is so of held points") {
    SketchSystem system;
    const SketchPoint a = system.addPoint({0.0, 0.0}), b = system.addPoint({1.0, 0.0});
    for (const std::uint32_t unknown : {a.x, a.y, b.x, b.y}) {
        system.held[unknown] = true;
    }
    system.addEquation(makeEqual(a.y, b.y), 1);
    CHECK(judgeConstraint(system, 1).verdict == ConstraintVerdict::Redundant);
    CHECK(judgeConstraint(system, 1).with.empty());
    system.addEquation(makeDistance(a, b, 2.0), 2);
    CHECK(judgeConstraint(system, 2).verdict == ConstraintVerdict::Conflict);
}

TEST_CASE("Sketch judgement: implied and independent constraints of random sketches are told apart") {
    std::size_t implied = 0, free = 0;
    for (std::size_t k = 0; k < 300; ++k) {
        CAPTURE(k);
        SketchDice dice(9000 + k);
        RandomSketch sketch = randomShapes(dice);
        constrain(sketch, dice, 0.7);
        IndependentRows rows(sketch.system.values.size());
        for (const SketchEquation &equation : sketch.system.equations) {
            REQUIRE(rows.add(sketch.system, {equation}, 1e-9));
        }
        std::size_t tried = 0;
        for (const SketchCandidate &candidate : candidatesOf(sketch, dice)) {
            if (!candidate.dimension || tried == 8) {
                continue;
            }
            ++tried;
            RandomSketch with = sketch;
            with.add(candidate.equations);
            const ConstraintVerdict verdict = judgeConstraint(with.system, with.constraints).verdict;
            IndependentRows more = rows;
            if (more.add(sketch.system, candidate.equations, 1e-3)) {
                CHECK(verdict == ConstraintVerdict::Fine);
                ++free;
            } else if (more = rows; !more.add(sketch.system, candidate.equations, 1e-8)) {
                CHECK(verdict == ConstraintVerdict::Redundant);
                ++implied;
            }
        }
    }
    CHECK(free > 1000);
    CHECK(implied > 300);
}

TEST_CASE("Sketch judgement: each wrong dimension of a determined sketch has a minimal conflict") {
    for (std::size_t k = 0; k < 60; ++k) {
        CAPTURE(k);
        SketchDice dice(11000 + k);
        RandomSketch sketch = randomShapes(dice);
        constrain(sketch, dice, 1.0);
        const std::vector<SketchCandidate> candidates = candidatesOf(sketch, dice);
        const auto distance =
            std::find_if(candidates.rbegin(), candidates.rend(), [](const SketchCandidate &candidate) {
                return candidate.equations[0].kind == EquationKind::Distance;
            });
        REQUIRE(distance != candidates.rend());
        sketch.add(distance->equations);
        CHECK(judgeConstraint(sketch.system, sketch.constraints).verdict == ConstraintVerdict::Redundant);
        sketch.system.equations.back().value *= 1.1;
        const ConstraintJudgement judgement = judgeConstraint(sketch.system, sketch.constraints);
        CHECK(judgement.verdict == ConstraintVerdict::Conflict);
        CHECK_FALSE(solvable(sketch.system, equationsOf(sketch.system, judgement.with, sketch.constraints)));
        for (const std::uint32_t left : judgement.with) {
            Names fewer = judgement.with;
            fewer.erase(std::find(fewer.begin(), fewer.end(), left));
            CHECK(solvable(sketch.system, equationsOf(sketch.system, fewer, sketch.constraints)));
        }
    }
}
