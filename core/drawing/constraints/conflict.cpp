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

/// Thins a set of constraints that cannot hold together.
class ClashFilter {
  public:
    ClashFilter(const SketchSystem &system, const std::set<std::uint32_t> &changed)
        : system_(system), nearest_(nearestValues(system)), flipped_(hasSolution(atNearest(system))),
          changed_(changed) {}

    std::vector<std::uint32_t> run() {
        std::vector<std::uint32_t> clash = listed(nearest_);
        if (!clashes(clash)) {
            clash = listed({});
        }
        for (std::size_t chunk = std::max<std::size_t>(1, clash.size() / 2);;) {
            const std::size_t before = clash.size();
            for (std::size_t k = 0; k < clash.size();) {
                std::vector<std::uint32_t> fewer = clash;
                const auto first = fewer.begin() + static_cast<std::ptrdiff_t>(k);
                fewer.erase(first, first + static_cast<std::ptrdiff_t>(std::min(chunk, clash.size() - k)));
                if (!fewer.empty() && clashes(fewer)) {
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

  private:
    /// Returns the constraints that do not hold at some values, or all without values; those that were changed last, so
    /// that they are named where several sets are minimal. At the nearest values, the residuals are in balance: those
    /// that are in each other's way do not hold.
    std::vector<std::uint32_t> listed(const std::vector<double> &values) const {
        SketchSystem at = system_;
        at.values = values.empty() ? at.values : values;
        std::set<std::uint32_t> ids;
        for (const SketchEquation &equation : at.equations) {
            constexpr double kClear = 1e-6;
            if (equation.constraint != 0 && (values.empty() || std::fabs(at.residual(equation)) > kClear)) {
                ids.insert(equation.constraint);
            }
        }
        std::vector<std::uint32_t> list(ids.begin(), ids.end());
        std::stable_partition(list.begin(), list.end(), [&](std::uint32_t id) { return !changed_.contains(id); });
        return list;
    }

    /// Returns true if no solution is found for some constraints. After much work none is looked for.
    bool clashes(const std::vector<std::uint32_t> &some) {
        const std::set<std::uint32_t> kept(some.begin(), some.end());
        SketchSystem fewer = system_;
        std::erase_if(fewer.equations, [&](const SketchEquation &equation) {
            return equation.constraint != 0 && !kept.contains(equation.constraint);
        });
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
    std::size_t work_ = 0; ///< equations of all systems that were tried
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

std::set<std::uint32_t> smallestClash(const SketchSystem &system, const std::set<std::uint32_t> &changed) {
    const std::vector<std::uint32_t> clash = ClashFilter(system, changed).run();
    return {clash.begin(), clash.end()};
}

} // namespace forefront
