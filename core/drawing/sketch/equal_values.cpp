#include "core/drawing/sketch/equal_values.hpp"

#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace forefront {

void equaliseValues(const SketchSystem &system, std::span<const std::uint32_t> equations, std::vector<double> &values,
                    const std::function<int(std::uint32_t)> &rank) {
    std::map<std::uint32_t, std::uint32_t> leader;
    std::set<std::uint32_t> given;
    const auto leaderOf = [&](std::uint32_t unknown) {
        for (auto up = leader.find(unknown); up != leader.end(); up = leader.find(unknown)) {
            unknown = up->second;
        }
        return unknown;
    };
    for (const std::uint32_t k : equations) {
        const SketchEquation &equation = system.equations[k];
        if (equation.kind == EquationKind::Value) {
            given.insert(equation.unknowns[0]);
        }
    }
    const auto order = [&](std::uint32_t unknown) {
        const bool fixed = system.held[unknown] || given.contains(unknown);
        return std::tuple(fixed ? 0 : 1, fixed ? 0 : rank(unknown), unknown);
    };
    for (const std::uint32_t k : equations) {
        const SketchEquation &equation = system.equations[k];
        if (equation.kind != EquationKind::Equal) {
            continue;
        }
        std::uint32_t a = leaderOf(equation.unknowns[0]), b = leaderOf(equation.unknowns[1]);
        if (a != b) {
            if (order(b) < order(a)) {
                std::swap(a, b);
            }
            leader[b] = a;
        }
    }
    for (const auto &[unknown, above] : leader) {
        if (!system.held[unknown]) {
            values[unknown] = values[leaderOf(above)];
        }
    }
}

} // namespace forefront
