#include "core/drawing/constraints/settle.hpp"

#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/sketch/judge_constraint.hpp"
#include "core/drawing/sketch/sketch_drag.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns the ids of constraints that a document does not have in the same form.
std::set<std::uint32_t> changedConstraints(const Document &before, const Document &next) {
    std::map<std::uint32_t, const SketchConstraint *> known;
    for (const auto &constraint : before.constraints) {
        known.emplace(constraint->id, constraint.get());
    }
    std::set<std::uint32_t> changed;
    for (const auto &constraint : next.constraints) {
        const auto found = known.find(constraint->id);
        SketchConstraint same = found != known.end() ? *found->second : SketchConstraint{};
        same.name = constraint->name;
        same.label = constraint->label;
        if (found == known.end() || (found->second != constraint.get() && same != *constraint)) {
            changed.insert(constraint->id);
        }
    }
    return changed;
}

/// Solves what a command changed, one independent part of the sketch at a time.
class Settler {
  public:
    Settler(const Document &before, const Document &next)
        : before_(before), next_(next), changedConstraints_(changedConstraints(before, next)),
          sketch_(sketchOf(next, before)), values_(sketch_.system.values) {
        findMoved();
    }

    Result<Document> run() {
        for (const std::vector<std::uint32_t> &part : independentParts(sketch_.system)) {
            if (!isChanged(part) || rests(part)) {
                continue;
            }
            const std::optional<std::vector<double>> solved = solve(part);
            if (!solved) {
                return conflict(part);
            }
            take(part, *solved);
        }
        return checked();
    }

  private:
    /// Takes the solution of a part. Numbers with given values get these exactly, not up to the tolerance, and numbers
    /// that must be equal the same bits: coincident nodes are one node of the domain only then.
    void take(const std::vector<std::uint32_t> &part, const std::vector<double> &solved) {
        for (const std::uint32_t k : part) {
            for (const std::uint32_t unknown : sketch_.system.equations[k].used()) {
                values_[unknown] = solved[unknown];
            }
        }
        for (const std::uint32_t k : part) {
            const SketchEquation &equation = sketch_.system.equations[k];
            if (equation.kind == EquationKind::Value && !sketch_.system.held[equation.unknowns[0]]) {
                values_[equation.unknowns[0]] = equation.value;
            }
        }
        equalise(part);
    }

    /// Gives the unknowns of each group that equations make equal the value of one of them.
    void equalise(const std::vector<std::uint32_t> &part) {
        std::map<std::uint32_t, std::uint32_t> leader;
        std::set<std::uint32_t> given;
        const auto leaderOf = [&](std::uint32_t unknown) {
            for (auto up = leader.find(unknown); up != leader.end(); up = leader.find(unknown)) {
                unknown = up->second;
            }
            return unknown;
        };
        for (const std::uint32_t k : part) {
            const SketchEquation &equation = sketch_.system.equations[k];
            if (equation.kind == EquationKind::Value) {
                given.insert(equation.unknowns[0]);
            }
        }
        // What is held or given leads, then what the command put where it is.
        const auto rank = [&](std::uint32_t unknown) {
            const bool fixed = sketch_.system.held[unknown] || given.contains(unknown);
            return fixed ? 0 : moved_[unknown] && values_[unknown] == sketch_.system.values[unknown] ? 1 : 2;
        };
        for (const std::uint32_t k : part) {
            const SketchEquation &equation = sketch_.system.equations[k];
            if (equation.kind != EquationKind::Equal) {
                continue;
            }
            std::uint32_t a = leaderOf(equation.unknowns[0]), b = leaderOf(equation.unknowns[1]);
            if (a != b) {
                if (std::pair(rank(b), b) < std::pair(rank(a), a)) {
                    std::swap(a, b);
                }
                leader[b] = a;
            }
        }
        for (const auto &[unknown, above] : leader) {
            if (!sketch_.system.held[unknown]) {
                values_[unknown] = values_[leaderOf(above)];
            }
        }
    }

    /// Finds the unknowns that the command changed, and their values before it.
    void findMoved() {
        const std::size_t count = sketch_.system.values.size();
        moved_.assign(count, false);
        start_ = sketch_.system.values;
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            const Shape *const old = findShape(before_, unknown.shape);
            const Shape *const now = findShape(next_, unknown.shape);
            if (old == now) {
                continue;
            }
            const std::optional<double> value =
                old != nullptr && old->form.index() == now->form.index() && handleCount(*old) == handleCount(*now)
                    ? valueOf(*old, unknown.role, unknown.index)
                    : std::nullopt;
            moved_[index] = value != sketch_.system.values[index];
            start_[index] = value.value_or(sketch_.system.values[index]);
        }
    }

    bool isChanged(const std::vector<std::uint32_t> &part) const {
        return std::any_of(part.begin(), part.end(), [&](std::uint32_t k) {
            const SketchEquation &equation = sketch_.system.equations[k];
            return changedConstraints_.contains(equation.constraint) ||
                   std::any_of(equation.used().begin(), equation.used().end(),
                               [&](std::uint32_t unknown) { return moved_[unknown]; });
        });
    }

    /// Returns true if a part needs no solution. Points that coincide have no size to compare with.
    bool rests(const std::vector<std::uint32_t> &part) const {
        constexpr double kRounding = 1e-14;
        return std::all_of(part.begin(), part.end(),
                           [&](std::uint32_t k) {
                               return holdsWithin(sketch_.system, sketch_.system.equations[k], kRounding, scale_);
                           }) ||
               holds(sketch_.system, part);
    }

    bool hasChangedConstraint(const SketchSystem &system) const {
        return std::any_of(system.equations.begin(), system.equations.end(), [&](const SketchEquation &equation) {
            return changedConstraints_.contains(equation.constraint);
        });
    }

    /// Returns the sketch with the equations of one part alone.
    SketchSystem only(const std::vector<std::uint32_t> &part) const {
        SketchSystem system = sketch_.system;
        system.equations.clear();
        for (const std::uint32_t k : part) {
            system.equations.push_back(sketch_.system.equations[k]);
        }
        return system;
    }

    /// Solves a part, with points on Bézier curves between the ends of these.
    std::optional<std::vector<double>> solve(const std::vector<std::uint32_t> &part) const {
        SketchSystem system = only(part);
        std::optional<std::vector<double>> solved = solveFreely(system);
        if (!solved) {
            return solved;
        }
        bool beyond = false;
        for (const SketchEquation &equation : system.equations) {
            const std::uint32_t t = equation.unknowns[1];
            if (equation.kind == EquationKind::OnCubic && std::clamp((*solved)[t], 0.0, 1.0) != (*solved)[t]) {
                (*solved)[t] = std::clamp((*solved)[t], 0.0, 1.0);
                system.held[t] = beyond = true;
            }
        }
        if (!beyond) {
            return solved;
        }
        system.values = *std::move(solved);
        std::optional<SketchSolution> within = solveSketch(system);
        return within ? std::optional(std::move(within->values)) : std::nullopt;
    }

    std::optional<std::vector<double>> solveFreely(const SketchSystem &system) const {
        if (hasChangedConstraint(system)) {
            std::optional<SketchSolution> solution = solveSketch(system);
            return solution ? std::optional(std::move(solution->values)) : std::nullopt;
        }
        // What the command put somewhere stays there, and the rest follows from where it was.
        SketchSystem firm = system;
        for (std::size_t k = 0; k < firm.values.size(); ++k) {
            firm.held[k] = firm.held[k] || moved_[k];
            firm.values[k] = moved_[k] ? system.values[k] : start_[k];
        }
        const auto valuesOf = [](std::optional<SketchSolution> solution) {
            return solution ? std::optional(std::move(solution->values)) : std::nullopt;
        };
        std::optional<SketchSolution> followed = solveSketch(firm, SolveEffort::Plain);
        if (followed && followed->flips == 0) {
            return valuesOf(std::move(followed));
        }
        std::optional<std::vector<double>> dragged = drag(system);
        return dragged ? dragged : valuesOf(followed ? std::move(followed) : solveSketch(firm));
    }

    /// Pulls the moved unknowns to their places, as far as the constraints let them go.
    std::optional<std::vector<double>> drag(SketchSystem system) const {
        std::vector<SketchPull> pulls;
        for (std::uint32_t k = 0; k < system.values.size(); ++k) {
            if (moved_[k] && system.held[k]) {
                return std::nullopt; // a formula holds it at the new place
            }
            if (moved_[k]) {
                pulls.push_back({k, system.values[k]});
            }
        }
        system.values = start_;
        std::vector<std::uint32_t> all(system.equations.size());
        for (std::uint32_t k = 0; k < all.size(); ++k) {
            all[k] = k;
        }
        if (!holds(system, all)) { // it was violated before, or points of no shape are elsewhere
            const std::optional<SketchSolution> start = solveSketch(system);
            if (!start) {
                return std::nullopt;
            }
            system.values = start->values;
        }
        SketchDrag drag(std::move(system));
        return drag.pull(pulls) ? std::optional(drag.values()) : std::nullopt;
    }

    /// Names constraints of a part that cannot hold together, as few as possible.
    Diagnostics conflict(const std::vector<std::uint32_t> &part) const {
        const SketchSystem system = only(part);
        std::set<std::uint32_t> candidates, all;
        for (const SketchEquation &equation : system.equations) {
            if (equation.constraint != 0) {
                all.insert(equation.constraint);
            }
        }
        std::set_intersection(all.begin(), all.end(), changedConstraints_.begin(), changedConstraints_.end(),
                              std::inserter(candidates, candidates.end()));
        std::set<std::uint32_t> smallest = all;
        for (const std::uint32_t id : candidates.empty() ? violated(system) : candidates) {
            const ConstraintJudgement judgement = judgeConstraint(system, id);
            if (judgement.verdict == ConstraintVerdict::Conflict && judgement.with.size() + 1 <= smallest.size()) {
                smallest.clear();
                smallest.insert(judgement.with.begin(), judgement.with.end());
                smallest.insert(id);
            }
        }
        const std::string names = constraintNames(next_, smallest);
        const std::string held = sketch_.holdsNumbers() ? " where formulas and locked shapes hold their parts" : "";
        return smallest.size() == 1
                   ? error("constraint-conflict", "constraint " + names + " cannot hold" + held,
                           "change it or remove it")
                   : error("constraint-conflict", "constraints " + names + " cannot hold together" + held,
                           "change or remove one of them");
    }

    static std::set<std::uint32_t> violated(const SketchSystem &system) {
        constexpr double kClear = 1e-9;
        std::set<std::uint32_t> ids;
        for (const SketchEquation &equation : system.equations) {
            if (equation.constraint != 0 && std::fabs(system.residual(equation)) > kClear) {
                ids.insert(equation.constraint);
            }
        }
        return ids;
    }

    /// Returns the solved document, if its shapes are valid.
    Result<Document> checked() const {
        if (values_ == sketch_.system.values) {
            return next_;
        }
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            const bool radius = unknown.role == ShapeUnknown::Role::Radius;
            const bool rounding = radius && findShape(next_, unknown.shape)->is<RectangleForm>();
            if (radius && !(values_[index] > 0.0) && !rounding) {
                return degenerate(unknown.shape, "its radius would not be above 0");
            }
        }
        Document settled = sketch_.withValues(values_);
        for (std::size_t k = 0; k < settled.shapes.size(); ++k) {
            if (settled.shapes[k] != next_.shapes[k]) {
                const Diagnostics faults = checkShape(*settled.shapes[k]);
                if (!faults.empty()) {
                    return degenerate(settled.shapes[k]->id, faults.front().message);
                }
                if (const auto segment = vanishedSegment(*next_.shapes[k], *settled.shapes[k])) {
                    return degenerate(settled.shapes[k]->id,
                                      "segment " + std::to_string(*segment + 1) + " would have no length");
                }
            }
        }
        return settled;
    }

    /// Returns the first segment of a path that has lost its length.
    static std::optional<std::size_t> vanishedSegment(const Shape &before, const Shape &after) {
        constexpr double kVanished = 1e-6; // of the length before
        if (!isPath(before) || before.nodes.size() != after.nodes.size()) {
            return std::nullopt;
        }
        const std::size_t count = before.nodes.size() - (isClosed(before) ? 0 : 1);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t end = (k + 1) % before.nodes.size();
            const double length = distance(before.nodes[k], before.nodes[end]);
            if (length > 0.0 && distance(after.nodes[k], after.nodes[end]) <= kVanished * length) {
                return k;
            }
        }
        return std::nullopt;
    }

    Diagnostics degenerate(std::uint32_t shape, const std::string &why) const {
        return error("constraint-conflict",
                     "the constraints would make " + displayName(*findShape(next_, shape)) + " invalid: " + why,
                     "enter another value, or remove a constraint");
    }

    const Document &before_, &next_;
    std::set<std::uint32_t> changedConstraints_;
    DocumentSketch sketch_;
    double scale_ = drawingScale(next_);
    std::vector<double> values_, start_;
    std::vector<bool> moved_;
};

} // namespace

Result<Document> settle(const Document &before, const Document &next) {
    if (next.constraints.empty() ||
        (before.constraints == next.constraints && before.shapes == next.shapes && before.formulas == next.formulas)) {
        return next;
    }
    return Settler(before, next).run();
}

std::string constraintNames(const Document &document, const std::set<std::uint32_t> &ids) {
    std::vector<std::string> names;
    for (const auto &constraint : document.constraints) {
        if (ids.contains(constraint->id)) {
            names.push_back(constraint->name);
        }
    }
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
    }
    return text;
}

} // namespace forefront
