#include "core/drawing/sketch/judge_constraint.hpp"

#include "core/drawing/sketch/part_solver.hpp"
#include "core/drawing/sketch/row_space.hpp"
#include "core/drawing/sketch/scatter.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace forefront {
namespace {

using Constraints = std::vector<std::uint32_t>;

/// Judges one constraint against the others of the independent parts that it belongs to.
class Judge {
  public:
    Judge(const SketchSystem &system, std::uint32_t constraint) : system_(system), judged_(constraint) {
        std::set<std::uint32_t> others;
        for (const std::vector<std::uint32_t> &part : independentParts(system)) {
            const auto ofJudged = [&](std::uint32_t k) { return system.equations[k].constraint == judged_; };
            if (std::any_of(part.begin(), part.end(), ofJudged)) {
                equations_.insert(equations_.end(), part.begin(), part.end());
            }
        }
        std::sort(equations_.begin(), equations_.end());
        for (const std::uint32_t k : equations_) {
            const std::uint32_t other = system.equations[k].constraint;
            (other == judged_ ? own_ : system.isJoint(other) ? joints_ : rest_).push_back(k);
            others.insert(other);
        }
        others.erase(judged_);
        others.erase(0);
        others_.assign(others.begin(), others.end());
    }

    ConstraintJudgement run() {
        if (forefront::holds(system_, own_)) {
            Constraints with, generic;
            bool dependent = depends(system_, rest_, with);
            if (dependent) { // a place of a special form, such as three points in line, may hide independence
                dependent = dependsElsewhere(generic);
                with = generic.size() > with.size() ? generic : with;
            }
            return dependent ? ConstraintJudgement{ConstraintVerdict::Redundant, thinnedReason(std::move(with))}
                             : ConstraintJudgement{};
        }
        if (solvable(system_, equations_)) {
            return {};
        }
        std::vector<std::uint32_t> rest = rest_;
        rest.insert(rest.end(), joints_.begin(), joints_.end());
        Constraints with;
        depends(system_, rest, with);
        return {ConstraintVerdict::Conflict, thinnedClash(std::move(with))};
    }

  private:
    /// Returns true if all rows of the judged constraint depend on those of the rest; adds the constraints that a
    /// dependent row needs.
    bool depends(const SketchSystem &at, const std::vector<std::uint32_t> &rest, Constraints &with) const {
        std::vector<std::uint32_t> ordered = rest;
        ordered.insert(ordered.end(), own_.begin(), own_.end());
        const ScaledPart part(at, ordered);
        const SketchRows rows = unitRows(part.slopes(part.x));
        const RowSpace space(SketchRows(rows.topRows(static_cast<int>(rest.size()))));
        std::set<std::uint32_t> needed;
        bool all = true;
        for (std::size_t k = 0; k < own_.size(); ++k) {
            const RowSpace::Split split = space.split(SketchVector(rows.row(static_cast<int>(rest.size() + k))));
            if (split.outside.norm() > kDependent) {
                all = false;
                continue;
            }
            constexpr double kNeeded = 1e-6;
            for (std::size_t row = 0; row < rest.size(); ++row) {
                if (std::fabs(split.coefficients[static_cast<int>(row)]) > kNeeded) {
                    needed.insert(system_.equations[rest[row]].constraint);
                }
            }
        }
        needed.erase(0);
        with.assign(needed.begin(), needed.end());
        return all;
    }

    bool dependsElsewhere(Constraints &with) const {
        constexpr double kSpread = 0.02;
        ScaledPart part(system_, rest_);
        scatter(part.x, 7, kSpread);
        if (!satisfy(part)) {
            return true;
        }
        SketchSystem moved = system_;
        part.write(moved.values);
        return depends(moved, rest_, with);
    }

    /// Returns the equations of constraints, with those of the forms of shapes.
    std::vector<std::uint32_t> equationsOf(const Constraints &constraints, bool withJudged) const {
        std::vector<std::uint32_t> list;
        for (const std::uint32_t k : equations_) {
            const std::uint32_t id = system_.equations[k].constraint;
            if (id == judged_ ? withJudged
                              : id == 0 || std::binary_search(constraints.begin(), constraints.end(), id)) {
                list.push_back(k);
            }
        }
        return list;
    }

    /// Returns true if the judged constraint holds at several places near by that satisfy some constraints.
    bool implied(const Constraints &constraints) const {
        const std::vector<std::uint32_t> equations = equationsOf(constraints, false);
        bool any = false;
        for (const std::uint64_t seed : {11U, 12U, 13U}) {
            SketchSystem moved = system_;
            ScaledPart everything(system_, equations_);
            constexpr double kSpread = 0.03;
            scatter(everything.x, seed, kSpread);
            everything.write(moved.values);
            ScaledPart part(moved, equations);
            if (!satisfy(part)) {
                continue;
            }
            part.write(moved.values);
            const ScaledPart own(moved, own_);
            constexpr double kClear = 1e-7; // in sizes of the constraint's parts
            if (own.residuals(own.x).norm() * own.size() > kClear * everything.size()) {
                return false;
            }
            any = true;
        }
        return any;
    }

    /// Removes constraints while a claim about the set holds; of all constraints if it does not hold for the set.
    template <class Claim>
    static Constraints thinned(Constraints set, const Constraints &all, const Claim &claim) {
        if (!claim(set)) {
            set = all;
            if (!claim(set)) {
                return set;
            }
        }
        // Halves first: a reason is mostly a small part of a large sketch. The last pass goes one by one.
        for (std::size_t chunk = std::max<std::size_t>(1, set.size() / 2);;) {
            const std::size_t before = set.size();
            for (std::size_t k = 0; k < set.size();) {
                Constraints fewer = set;
                const std::size_t end = std::min(k + chunk, set.size());
                fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k),
                            fewer.begin() + static_cast<std::ptrdiff_t>(end));
                if (claim(fewer)) {
                    set = std::move(fewer);
                } else {
                    k += chunk;
                }
            }
            if (chunk == 1 && set.size() == before) {
                break;
            }
            chunk = std::max<std::size_t>(1, chunk / 2);
        }
        return set;
    }

    Constraints thinnedReason(Constraints set) const {
        Constraints all = others_;
        std::erase_if(all, [this](std::uint32_t id) { return system_.isJoint(id); });
        return thinned(std::move(set), all, [this](const Constraints &some) { return implied(some); });
    }

    Constraints thinnedClash(Constraints set) const {
        return thinned(std::move(set), others_,
                       [this](const Constraints &some) { return !solvable(system_, equationsOf(some, true)); });
    }

    const SketchSystem &system_;
    std::uint32_t judged_;
    std::vector<std::uint32_t> equations_, own_, rest_, joints_; ///< all; of the judged constraint; of others
    Constraints others_;
};

} // namespace

ConstraintJudgement judgeConstraint(const SketchSystem &system, std::uint32_t constraint) {
    return Judge(system, constraint).run();
}

} // namespace forefront
