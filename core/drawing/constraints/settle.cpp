#include "core/drawing/constraints/settle.hpp"

#include "core/drawing/constraints/conflict.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/constraint_equations.hpp"
#include "core/drawing/constraints/fewest_moves.hpp"
#include "core/drawing/constraints/firm_numbers.hpp"
#include "core/drawing/constraints/moved_parts.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/drawing/constraints/settled_shape.hpp"
#include "core/drawing/constraints/sketch_parts.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/sketch/sketch_drag.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using Role = ShapeUnknown::Role;

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
    Settler(const Document &before, const Document &next, const JointSource &joints)
        : before_(before), next_(next), changedConstraints_(changedConstraints(before, next)),
          sketch_(sketchOf(next, before, joints)), values_(sketch_.system.values) {
        findMoved();
    }

    Result<Document> run() {
        for (const std::vector<std::uint32_t> &part : independentParts(sketch_.system)) {
            if (!isChanged(part) || rests(part)) {
                continue;
            }
            const std::optional<std::vector<double>> solved = solve(only(part));
            if (!solved) {
                return conflict(part);
            }
            take(part, *solved);
        }
        return checked();
    }

  private:
    /// Takes the solution of a part. Numbers with given values get these exactly, not up to the tolerance, and numbers
    /// that must be equal the same bits.
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
        alignJoints(sketch_, part, values_, [&](std::uint32_t unknown) { // where the command put it
            return moved_[unknown] && values_[unknown] == sketch_.system.values[unknown] ? 1 : 2;
        });
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
        if (std::any_of(part.begin(), part.end(), [&](std::uint32_t k) {
                return endBeyond(sketch_.system.equations[k], sketch_.system.values).has_value();
            })) {
            return false;
        }
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

    /// Solves a part. What the command moved stays where it is and keeps its other numbers, if its neighbours can
    /// follow; what stands by it moves only if it must.
    std::optional<std::vector<double>> solve(const SketchSystem &system) const {
        std::optional<SketchSolution> solution = solveAround(system);
        if (solution) {
            return std::move(solution->values);
        }
        SketchSystem firm = system;
        bool any = false;
        for (const std::uint32_t unknown : sketch_.standing) {
            any = any || !firm.held[unknown];
            firm.held[unknown] = firm.held[unknown] || !moved_[unknown];
        }
        solution = any ? solveWithin(firm, SolveEffort::Plain) : std::nullopt;
        if (!solution || solution->flips > 0) {
            std::optional<SketchSolution> free = solveWithin(system, SolveEffort::Full);
            if (free && (!solution || free->flips < solution->flips)) {
                solution = std::move(free);
            }
        }
        return solution ? std::optional(std::move(solution->values)) : std::nullopt;
    }

    /// Solves a part whose numbers were moved, not its constraints, so that only neighbours follow. Where joints alone
    /// tie several moved shapes, those first in the drawing keep their numbers.
    std::optional<SketchSolution> solveAround(const SketchSystem &system) const {
        if (hasChangedConstraint(system)) {
            return std::nullopt;
        }
        const SystemSolver solver = [this](const SketchSystem &some) {
            return solveLimited(some, SolveEffort::Plain, [](const SketchSystem &limited, SolveEffort effort) {
                return solveSketch(limited, effort);
            });
        };
        FirmNumbers numbers{std::vector<bool>(system.values.size(), false), sketch_.isStanding()};
        const std::vector<std::uint32_t> firm = numbersOfMoved(system);
        for (const std::uint32_t unknown : firm) {
            numbers.firm[unknown] = true;
        }
        std::optional<SketchSolution> solution = solveAroundFirm(system, numbers, solver);
        const bool onlyJoints =
            std::all_of(system.equations.begin(), system.equations.end(), [&](const auto &equation) {
                return equation.constraint == 0 || system.isJoint(equation.constraint);
            });
        if (!solution && onlyJoints) {
            numbers.firm = keepInOrder(system, firm, solver);
            solution = solveAroundFirm(system, numbers, solver);
        }
        return solution;
    }

    /// Returns the unknowns in a system of shapes that the command moved, by shape.
    std::vector<std::uint32_t> numbersOfMoved(const SketchSystem &system) const {
        std::vector<bool> used(system.values.size(), false);
        for (const SketchEquation &equation : system.equations) {
            for (const std::uint32_t unknown : equation.used()) {
                used[unknown] = true;
            }
        }
        std::set<std::uint32_t> shapes;
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            if (moved_[index]) {
                shapes.insert(unknown.shape);
            }
        }
        std::vector<std::uint32_t> numbers;
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            if (used[index] && shapes.contains(unknown.shape)) {
                numbers.push_back(index);
            }
        }
        return numbers;
    }

    /// Solves a system, with points on Bézier curves and ends of lines on segments between the ends of these.
    std::optional<SketchSolution> solveWithin(const SketchSystem &system, SolveEffort effort) const {
        return solveLimited(system, effort,
                            [this](const SketchSystem &some, SolveEffort tried) { return solveFreely(some, tried); });
    }

    template <class Solver>
    std::optional<SketchSolution> solveLimited(SketchSystem system, SolveEffort effort, const Solver &solver) const {
        std::optional<SketchSolution> solution = solver(system, effort);
        if (!solution || !limit(system, solution->values)) {
            return solution;
        }
        system.values = std::move(solution->values);
        return solveSketch(system, effort);
    }

    /// Holds what a solution has put beyond the ends of a curve at its nearest end. Returns false if there is none.
    bool limit(SketchSystem &system, std::vector<double> &values) const {
        bool beyond = false;
        for (SketchEquation &equation : system.equations) {
            if (equation.kind == EquationKind::OnCubic) {
                double &t = values[equation.unknowns[1]];
                if (std::clamp(t, 0.0, 1.0) != t) {
                    t = std::clamp(t, 0.0, 1.0);
                    system.held[equation.unknowns[1]] = beyond = true;
                }
            }
        }
        std::vector<SketchEquation> ends;
        for (SketchEquation &equation : system.equations) {
            if (const std::optional<std::size_t> end = endBeyond(equation, values)) {
                const auto &u = equation.unknowns;
                ends.push_back(makeEqual(u[1], u[2 * *end + 3]));
                ends.back().constraint = equation.constraint;
                const std::uint32_t constraint = equation.constraint;
                equation = makeEqual(u[0], u[2 * *end + 2]);
                equation.constraint = constraint;
                beyond = true;
            }
        }
        system.equations.insert(system.equations.end(), ends.begin(), ends.end());
        return beyond;
    }

    /// Returns the end, 0 or 1, of a segment beyond which a solution has put the end of an open path that was on it.
    std::optional<std::size_t> endBeyond(const SketchEquation &equation, const std::vector<double> &values) const {
        const std::uint32_t joint = equation.constraint - sketch_.jointId(0);
        if (equation.kind != EquationKind::PointLine || joint >= sketch_.joints.size()) {
            return std::nullopt;
        }
        const SketchPart &node = sketch_.joints[joint].node;
        const Shape &shape = *findShape(next_, node.shape);
        if (!shape.isPolyline() || (node.index != 0 && node.index + 1 != shape.nodes.size())) {
            return std::nullopt;
        }
        const auto place = [&](std::size_t k) {
            return Vec2{values[equation.unknowns[k]], values[equation.unknowns[k + 1]]};
        };
        const Vec2 a = place(2), along = place(4) - a;
        const double t = dot(place(0) - a, along) / lengthSquared(along);
        constexpr double kBeyond = 1e-9;
        return t < -kBeyond        ? std::optional<std::size_t>(0)
               : t > 1.0 + kBeyond ? std::optional<std::size_t>(1)
                                   : std::nullopt;
    }

    std::optional<SketchSolution> solveFreely(const SketchSystem &system, SolveEffort effort) const {
        if (hasChangedConstraint(system)) {
            std::optional<SketchSolution> placed = solveChanged(system);
            return placed ? std::move(placed) : solveSketch(system, effort);
        }
        // What the command put somewhere stays there, if possible in both directions, and the rest follows from where
        // it was.
        SketchSystem firm = system;
        for (std::size_t k = 0; k < firm.values.size(); ++k) {
            firm.held[k] = firm.held[k] || moved_[k];
            firm.values[k] = moved_[k] ? system.values[k] : start_[k];
        }
        if (std::optional<SketchSolution> placed = solveWithPlaced(firm)) {
            return placed;
        }
        std::optional<SketchSolution> followed = solveSketch(firm, SolveEffort::Plain);
        if (followed && followed->flips == 0) {
            return followed;
        }
        if (std::optional<std::vector<double>> dragged = drag(system)) {
            return SketchSolution{*std::move(dragged), 0};
        }
        return followed || effort == SolveEffort::Plain ? std::move(followed) : solveSketch(firm);
    }

    /// Solves a system with changed constraints so that what the command put somewhere stays there, or so that only one
    /// shape moves; none if there is no such solution without flips.
    std::optional<SketchSolution> solveChanged(SketchSystem system) const {
        if (std::find(moved_.begin(), moved_.end(), true) == moved_.end()) {
            return solveMovingOne(sketch_, system, shapesOfNew(system));
        }
        for (std::size_t k = 0; k < system.held.size(); ++k) {
            system.held[k] = system.held[k] || moved_[k];
        }
        std::optional<SketchSolution> solution = solveSketch(system, SolveEffort::Plain);
        return solution && solution->flips == 0 ? solution : std::nullopt;
    }

    /// Returns the shapes that new constraints in a system name.
    std::set<std::uint32_t> shapesOfNew(const SketchSystem &system) const {
        std::set<std::uint32_t> shapes;
        for (const SketchEquation &equation : system.equations) {
            const SketchConstraint *const constraint = findConstraint(next_, equation.constraint);
            if (constraint != nullptr && findConstraint(before_, constraint->id) == nullptr) {
                for (const SketchPart &part : constraint->parts) {
                    shapes.insert(part.shape);
                }
            }
        }
        return shapes;
    }

    /// Solves a system without moving nodes in the direction in which the command has left them; none if there is no
    /// such direction or no such solution without flips.
    std::optional<SketchSolution> solveWithPlaced(SketchSystem system) const {
        bool any = false;
        for (const auto &[unknown, index] : sketch_.unknowns()) {
            if (!moved_[index] || unknown.role > Role::Y || findShape(next_, unknown.shape)->is<RectangleForm>()) {
                continue;
            }
            const Role other = unknown.role == Role::X ? Role::Y : Role::X;
            const std::optional<std::uint32_t> across = sketch_.find({unknown.shape, other, unknown.index});
            if (across && !system.held[*across]) {
                system.held[*across] = any = true;
            }
        }
        std::optional<SketchSolution> solution = any ? solveSketch(system, SolveEffort::Plain) : std::nullopt;
        return solution && solution->flips == 0 ? solution : std::nullopt;
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

    /// Names constraints and joints of a part that cannot hold together, as few as possible; or those that no solution
    /// was found for.
    Diagnostics conflict(const std::vector<std::uint32_t> &part) const {
        const Clash clash = smallestClash(only(part), changedConstraints_);
        const std::string names = namedConstraints(relationNames(sketch_, clash.ids), clash.ids);
        const std::string held = sketch_.holdsNumbers() ? " where formulas and locked shapes hold their parts" : "";
        const bool several = clash.ids.size() > 1;
        const bool onlyOne = clash.ids.empty() || (!several && *clash.ids.begin() < sketch_.jointId(0));
        const std::string advice = onlyOne ? "change it or remove it" : clashAdvice(sketch_, clash.ids);
        Diagnostics faults =
            clash.certain
                ? error("constraint-conflict", names + " cannot hold" + (several ? " together" : "") + held, advice)
                : error("constraint-conflict",
                        "no solution was found near by for " + names + (several ? " together" : "") + held,
                        "change a value in smaller steps; or " + advice);
        std::copy_if(clash.ids.begin(), clash.ids.end(), std::back_inserter(faults.front().ids),
                     [&](std::uint32_t id) { return id < sketch_.jointId(0); });
        return faults;
    }

    /// Puts "constraint" or "constraints" before names of which the first is that of a constraint.
    std::string namedConstraints(const std::string &names, const std::set<std::uint32_t> &ids) const {
        const auto count = std::count_if(ids.begin(), ids.end(), [&](auto id) { return id < sketch_.jointId(0); });
        return (count > 1 ? "constraints " : count == 1 ? "constraint " : "") + names;
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
                // A constraint may ask for it; numbers and places do not.
                if (changedConstraints_.empty() && isTurnedOver(*next_.shapes[k], *settled.shapes[k])) {
                    return degenerate(settled.shapes[k]->id, "it would be turned over");
                }
                if (const auto segment = vanishedSegment(*next_.shapes[k], *settled.shapes[k])) {
                    return degenerate(settled.shapes[k]->id,
                                      "segment " + std::to_string(*segment + 1) + " would have no length");
                }
            }
        }
        return settled;
    }

    Diagnostics degenerate(std::uint32_t shape, const std::string &why) const {
        const bool joints = next_.constraints.empty();
        return error("constraint-conflict",
                     std::string(joints ? "the joints" : "the constraints") + " would make " +
                         displayName(*findShape(next_, shape)) + " invalid: " + why,
                     joints ? "enter another value, or detach the shapes by dragging a node with Alt"
                            : "enter another value, or remove a constraint");
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
    return Settler(before, next, {.places = &next}).run();
}

Result<Document> settleTogether(const Document &before, const Document &next) {
    if (before.constraints == next.constraints && before.shapes == next.shapes) {
        return next;
    }
    const std::vector<SketchPart> moved = movedParts(before, next);
    const JointSource joints{.places = &before, .moved = {moved.begin(), moved.end()}};
    if (next.constraints.empty() && joints.moved.empty()) {
        return next;
    }
    return Settler(before, next, joints).run();
}

} // namespace forefront
