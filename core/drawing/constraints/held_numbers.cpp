#include "core/drawing/constraints/held_numbers.hpp"

#include "core/drawing/constraints/conflict.hpp"
#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/sketch/judge_constraint.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using Role = ShapeUnknown::Role;

/// A number that is not as wanted.
struct MissedNumber {
    ShapeUnknown unknown;
    std::uint32_t index = 0; ///< in the sketch
    double wanted = 0.0;
};

std::optional<double> numberIn(const Document &document, const Shape &like, const ShapeUnknown &unknown) {
    const Shape *const shape = findShape(document, unknown.shape);
    const bool same =
        shape != nullptr && shape->form.index() == like.form.index() && handleCount(*shape) == handleCount(like);
    return same ? valueOf(*shape, unknown.role, unknown.index) : std::nullopt;
}

std::vector<MissedNumber> missedNumbers(const DocumentSketch &sketch, const Document &wanted, const Document &settled) {
    constexpr double kNear = 1e-8; // of the drawing; solutions are that exact
    const double near = kNear * drawingScale(sketch.document());
    std::vector<MissedNumber> missed;
    for (const auto &[unknown, index] : sketch.unknowns()) {
        const Shape *const before = findShape(sketch.document(), unknown.shape);
        if (findShape(wanted, unknown.shape) == before) {
            continue;
        }
        const std::optional<double> goal = numberIn(wanted, *before, unknown);
        const std::optional<double> now = numberIn(settled, *before, unknown);
        if (goal && now && *goal != sketch.system.values[index] && std::fabs(*now - *goal) > near) {
            missed.push_back({unknown, index, *goal});
        }
    }
    return missed;
}

/// Returns numbers of one kind of place, such as "x = 5 and y = 2 of node 3".
std::string textOf(const Document &document, const std::vector<MissedNumber> &missed) {
    const ShapeUnknown &first = missed.front().unknown;
    std::string text;
    for (const MissedNumber &number : missed) {
        const Role role = number.unknown.role;
        const char *const word = role == Role::X        ? "x = "
                                 : role == Role::Y      ? "y = "
                                 : role == Role::Radius ? "radius = "
                                                        : nullptr;
        const bool together = number.unknown.shape == first.shape && number.unknown.index == first.index;
        if (word != nullptr && together) {
            text += (text.empty() ? "" : " and ") + (word + numberText(number.wanted, 6));
        }
    }
    const Shape &shape = *findShape(document, first.shape);
    const bool ofNode = first.role <= Role::Y && isPath(shape);
    return (text.empty() ? "the form" : text) + " of " +
           (ofNode ? "node " + std::to_string(first.index + 1) : displayName(shape));
}

/// Returns the constraints and joints of a sketch that its numbers cannot be as wanted with.
std::set<std::uint32_t> holding(const DocumentSketch &sketch, const std::vector<MissedNumber> &missed) {
    constexpr std::size_t kMostEquations = 250;
    if (sketch.system.equations.size() > kMostEquations) {
        return {};
    }
    SketchSystem system = sketch.system;
    const std::uint32_t id = sketch.jointId(sketch.joints.size());
    for (const MissedNumber &number : missed) {
        system.addEquation(makeValue(number.index, number.wanted), id);
    }
    const ConstraintJudgement judgement = judgeConstraint(system, id);
    return judgement.verdict == ConstraintVerdict::Conflict
               ? std::set<std::uint32_t>(judgement.with.begin(), judgement.with.end())
               : std::set<std::uint32_t>();
}

} // namespace

std::optional<HeldNumbers> heldNumbers(const Document &before, const Document &wanted, const Document &settled) {
    if (before.constraints.empty()) {
        return std::nullopt;
    }
    const DocumentSketch sketch = sketchOf(before, before, {.places = &before});
    const std::vector<MissedNumber> missed = missedNumbers(sketch, wanted, settled);
    if (missed.empty()) {
        return std::nullopt;
    }
    const std::set<std::uint32_t> by = holding(sketch, missed);
    HeldNumbers held{textOf(before, missed), relationNames(sketch, by), {}};
    std::copy_if(by.begin(), by.end(), std::back_inserter(held.ids),
                 [&](std::uint32_t id) { return id < sketch.jointId(0); });
    return held;
}

Diagnostics heldNumbersFault(const Document &before, const Document &wanted, const Document &settled) {
    const std::optional<HeldNumbers> held = heldNumbers(before, wanted, settled);
    if (!held) {
        return {};
    }
    Diagnostics faults = held->names.empty()
                             ? error("constraint-conflict", held->numbers + " cannot hold with the constraints",
                                     "enter another value, or remove constraints")
                             : error("constraint-conflict", held->numbers + " cannot hold together with " + held->names,
                                     "enter another value, or change or remove one of them");
    faults.front().ids = held->ids;
    return faults;
}

} // namespace forefront
