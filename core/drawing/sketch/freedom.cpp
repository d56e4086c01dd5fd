#include "core/drawing/sketch/freedom.hpp"

#include "core/drawing/sketch/row_space.hpp"
#include "core/drawing/sketch/scaled_part.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace forefront {
namespace {

/// Returns true if the row at an index depends on the rows before it.
bool dependsOnEarlier(const SketchRows &rows, int index) {
    const RowSpace earlier(SketchRows(rows.topRows(index)));
    const SketchVector row = SketchVector(rows.row(index));
    return earlier.split(row).outside.norm() <= kDependent;
}

/// Collects the constraints of a part that have a row, all of whose rows depend on earlier ones.
void addRedundant(const SketchSystem &system, const ScaledPart &part, const SketchRows &rows, const RowSpace &space,
                  std::set<std::uint32_t> &redundant) {
    constexpr double kTakesPart = 1e-4; // a circuit of n rows gives each about 1/n
    const SketchVector dependence = space.dependence();
    std::set<std::uint32_t> needed;
    for (int k = 0; k < rows.rows(); ++k) {
        const std::uint32_t constraint = part.equations()[static_cast<std::size_t>(k)].constraint;
        if (constraint == 0 || system.isJoint(constraint)) {
            continue;
        }
        const bool depends = dependence[k] > kTakesPart && dependsOnEarlier(rows, k);
        (depends ? redundant : needed).insert(constraint);
    }
    for (const std::uint32_t constraint : needed) {
        redundant.erase(constraint);
    }
}

} // namespace

SketchFreedom freedomOf(const SketchSystem &system) {
    SketchFreedom freedom;
    freedom.determined = system.held;
    std::vector<bool> used(system.values.size(), false);
    std::set<std::uint32_t> redundant;
    double free = 0.0;
    for (const std::vector<std::uint32_t> &equations : independentParts(system)) {
        const ScaledPart part(system, equations);
        const SketchRows rows = unitRows(part.slopes(part.x));
        const RowSpace space(rows);
        for (int k = 0; k < part.x.size(); ++k) {
            const double outside = space.split(SketchVector::Unit(part.x.size(), k)).outside.norm();
            const std::uint32_t unknown = part.unknowns()[static_cast<std::size_t>(k)];
            used[unknown] = true;
            freedom.determined[unknown] = outside <= kDependent;
            free += outside * outside; // the trace of the projection to the null space is its dimension
        }
        addRedundant(system, part, rows, space, redundant);
    }
    freedom.redundant.assign(redundant.begin(), redundant.end());
    freedom.degrees = static_cast<std::size_t>(std::lround(free));
    for (std::size_t k = 0; k < used.size(); ++k) {
        freedom.degrees += !used[k] && !system.held[k] ? 1 : 0;
    }
    return freedom;
}

} // namespace forefront
