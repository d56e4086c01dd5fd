#include "core/drawing/constraints/conflict.hpp"

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/sketch/solve_sketch.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace forefront {
namespace {

std::string jointName(const DocumentSketch &sketch, const SketchJoint &joint) {
    const std::string first = displayName(*findShape(sketch.document(), joint.node.shape)),
                      second = displayName(*findShape(sketch.document(), joint.other.shape));
    return "the joint of " + (first == second ? first : first + " and " + second) + " at " + placeText(joint.at);
}

/// Returns true if each independent part of a system has a solution near its values.
bool hasSolution(const SketchSystem &system) {
    const auto parts = independentParts(system);
    return std::all_of(parts.begin(), parts.end(), [&](const std::vector<std::uint32_t> &part) {
        return holds(system, part) || solvable(system, part);
    });
}

/// Returns a system with the form of the shapes and some of its constraints.
SketchSystem onlyOf(const SketchSystem &system, const std::set<std::uint32_t> &ids) {
    SketchSystem fewer = system;
    std::erase_if(fewer.equations, [&](const SketchEquation &equation) {
        return equation.constraint != 0 && !ids.contains(equation.constraint);
    });
    return fewer;
}

/// Thins a set of constraints that cannot hold together.
class ClashFilter {
  public:
    ClashFilter(const SketchSystem &system, const std::set<std::uint32_t> &changed)
        : system_(system), nearest_(nearestValues(system)), flipped_(hasSolution(atNearest(system))),
          changed_(changed) {}

    /// First thins by what has a solution near by, which is quick. What this leaves can still have one far away: then
    /// others are to blame.
    Clash run() {
        const auto clashesNearBy = [this](const Ids &some) { return clashes(some); };
        Ids clash = listed(nearest_);
        if (!clashesNearBy(clash)) {
            clash = listed({});
        }
        clash = thinned(std::move(clash), clashesNearBy);
        const auto clashesAtAll = [this](const Ids &some) { return cannotHoldInTime(some); };
        if (clashesAtAll(clash)) {
            return {{clash.begin(), clash.end()}, true};
        }
        const Ids all = listed({});
        if (!clashesAtAll(all)) {
            return {{clash.begin(), clash.end()}, false};
        }
        clash = thinned(all, clashesAtAll);
        return {{clash.begin(), clash.end()}, true};
    }

  private:
    using Ids = std::vector<std::uint32_t>;

    /// Leaves out constraints without which a list still clashes: halves first, then smaller pieces.
    template <class Clashes>
    static Ids thinned(Ids clash, const Clashes &stillClashes) {
        for (std::size_t chunk = std::max<std::size_t>(1, clash.size() / 2);;) {
            const std::size_t before = clash.size();
            for (std::size_t k = 0; k < clash.size();) {
                Ids fewer = clash;
                const auto first = fewer.begin() + static_cast<std::ptrdiff_t>(k);
                fewer.erase(first, first + static_cast<std::ptrdiff_t>(std::min(chunk, clash.size() - k)));
                if (!fewer.empty() && stillClashes(fewer)) {
                    clash = std::move(fewer);
                } else {
                    k += chunk;
                }
            }
            if (chunk == 1 && clash.size() == before) {
                return clash;
            }
            chunk = std::max<std::size_t>(1, chunk / 2);
        }
    }

    /// Returns true if no solution is found for some constraints, however far away. After much work none is looked for.
    bool cannotHoldInTime(const Ids &some) {
        constexpr std::size_t kMostFarWork = 30'000; // equations: about a second
        const std::set<std::uint32_t> ids(some.begin(), some.end());
        farWork_ += static_cast<std::size_t>(
            std::count_if(system_.equations.begin(), system_.equations.end(), [&](const SketchEquation &equation) {
                return equation.constraint == 0 || ids.contains(equation.constraint);
            }));
        return farWork_ <= kMostFarWork && cannotHold(system_, ids, nearest_);
    }

    /// Returns the constraints that do not hold at some values, or all without values; those that were changed last, so
    /// that they are named where several sets are minimal. At the nearest values, the residuals are in balance: those
    /// that are in each other's way do not hold.
    Ids listed(const std::vector<double> &values) const {
        SketchSystem at = system_;
        at.values = values.empty() ? at.values : values;
        std::set<std::uint32_t> ids;
        for (const SketchEquation &equation : at.equations) {
            constexpr double kClear = 1e-6;
            if (equation.constraint != 0 && (values.empty() || std::fabs(at.residual(equation)) > kClear)) {
                ids.insert(equation.constraint);
            }
        }
        Ids list(ids.begin(), ids.end());
        std::stable_partition(list.begin(), list.end(), [&](std::uint32_t id) { return !changed_.contains(id); });
        return list;
    }

    /// Returns true if no solution is found for some constraints. After much work none is looked for.
    bool clashes(const Ids &some) {
        const SketchSystem fewer = onlyOf(system_, {some.begin(), some.end()});
        constexpr std::size_t kMostWork = 20'000; // about a second
        work_ += fewer.equations.size();
        return work_ <= kMostWork && !hasSolution(fewer) &&
               !(flipped_ ? hasCleanSolution(fewer, nearest_) : hasSolution(atNearest(fewer)));
    }

    SketchSystem atNearest(SketchSystem system) const {
        system.values = nearest_;
        return system;
    }

    const SketchSystem &system_;
    std::vector<double> nearest_;
    bool flipped_; ///< near these values there is a solution of all, with corners turned over
    const std::set<std::uint32_t> &changed_;
    std::size_t work_ = 0;    ///< equations of all systems that were tried near by
    std::size_t farWork_ = 0; ///< the same far away
};

} // namespace

std::string relationNames(const DocumentSketch &sketch, const std::set<std::uint32_t> &ids) {
    std::vector<std::string> names;
    for (const auto &constraint : sketch.document().constraints) {
        if (ids.contains(constraint->id)) {
            names.push_back(constraint->name);
        }
    }
    for (std::size_t k = 0; k < sketch.joints.size(); ++k) {
        if (ids.contains(sketch.jointId(k))) {
            names.push_back(jointName(sketch, sketch.joints[k]));
        }
    }
    constexpr std::size_t kMost = 12;
    if (names.size() > kMost) {
        const std::size_t more = names.size() - kMost;
        names.resize(kMost);
        names.push_back(std::to_string(more) + " more");
    }
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k) {
        text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
    }
    return text;
}

std::string clashAdvice(const DocumentSketch &sketch, const std::set<std::uint32_t> &ids) {
    const bool joints = !ids.empty() && *ids.rbegin() >= sketch.jointId(0);
    const bool others = !ids.empty() && *ids.begin() < sketch.jointId(0);
    const std::string detach = "detach the shapes by dragging a node with Alt";
    return !joints ? "change or remove one of them" : others ? "change or remove one of them, or " + detach : detach;
}

bool cannotHold(const SketchSystem &system, const std::set<std::uint32_t> &ids, const std::vector<double> &nearest) {
    const SketchSystem some = onlyOf(system, ids);
    SketchSystem atNearest = some;
    atNearest.values = nearest;
    const auto parts = independentParts(some);
    return !std::all_of(parts.begin(), parts.end(), [&](const std::vector<std::uint32_t> &part) {
        return holds(atNearest, part) || solvable(atNearest, part) || solvableFromAfar(some, part);
    });
}

Clash smallestClash(const SketchSystem &system, const std::set<std::uint32_t> &changed) {
    return ClashFilter(system, changed).run();
}

} // namespace forefront
