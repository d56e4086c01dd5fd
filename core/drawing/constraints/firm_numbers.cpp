#include "core/drawing/constraints/firm_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace forefront {
namespace {

std::optional<SketchSolution> withoutFlips(std::optional<SketchSolution> solution) {
    return solution && solution->flips == 0 ? std::move(solution) : std::nullopt;
}

/// The unknowns around equations that do not hold, ring by ring.
class EquationRings {
  public:
    explicit EquationRings(const SketchSystem &system) : system_(system), inside_(system.values.size(), false) {
        for (std::uint32_t k = 0; k < system.equations.size(); ++k) {
            const std::array<std::uint32_t, 1> one{k};
            if (!holds(system, one)) {
                enter(system.equations[k]);
            }
        }
    }

    const std::vector<bool> &inside() const { return inside_; }

    /// Takes in the unknowns of equations that have one inside already. Returns false if there are no others.
    bool grow() {
        const std::vector<bool> before = inside_;
        for (const SketchEquation &equation : system_.equations) {
            const auto used = equation.used();
            if (std::any_of(used.begin(), used.end(), [&](std::uint32_t k) { return before[k]; })) {
                enter(equation);
            }
        }
        return inside_ != before;
    }

  private:
    void enter(const SketchEquation &equation) {
        for (const std::uint32_t unknown : equation.used()) {
            inside_[unknown] = true;
        }
    }

    const SketchSystem &system_;
    std::vector<bool> inside_;
};

/// Tries which unknowns can be held together: all, or else each half by itself.
class OrderedKeeper {
  public:
    OrderedKeeper(const SketchSystem &system, const SystemSolver &solver) : system_(system), solver_(solver) {}

    void keep(std::span<const std::uint32_t> unknowns) {
        constexpr int kMostAttempts = 64;
        if (unknowns.empty() || ++attempts_ > kMostAttempts) {
            return;
        }
        const std::vector<bool> before = system_.held;
        for (const std::uint32_t unknown : unknowns) {
            system_.held[unknown] = true;
        }
        if (withoutFlips(solver_(system_))) {
            return;
        }
        system_.held = before;
        if (unknowns.size() > 1) {
            const std::size_t half = (unknowns.size() + 1) / 2;
            keep(unknowns.first(half));
            keep(unknowns.subspan(half));
        }
    }

    const std::vector<bool> &held() const { return system_.held; }

  private:
    SketchSystem system_;
    const SystemSolver &solver_;
    int attempts_ = 0;
};

} // namespace

std::optional<SketchSolution> solveAroundFirm(const SketchSystem &system, const FirmNumbers &numbers,
                                              const SystemSolver &solver) {
    EquationRings around(system);
    std::vector<bool> released(system.values.size(), false), last;
    for (int rings = 1;; rings *= 2) {
        SketchSystem held = system;
        for (std::size_t k = 0; k < held.held.size(); ++k) {
            held.held[k] = held.held[k] || numbers.firm[k] || (numbers.standing[k] && !released[k]);
        }
        if (held.held != last) {
            if (std::optional<SketchSolution> solution = withoutFlips(solver(held))) {
                return solution;
            }
        }
        last = held.held;
        if (released == around.inside() && !around.grow()) {
            return std::nullopt;
        }
        for (int k = 1; k < rings / 2 && around.grow(); ++k) {
        }
        released = around.inside();
    }
}

std::vector<bool> keepInOrder(const SketchSystem &system, std::span<const std::uint32_t> unknowns,
                              const SystemSolver &solver) {
    OrderedKeeper keeper(system, solver);
    keeper.keep(unknowns);
    return keeper.held();
}

} // namespace forefront
