#include "core/drawing/constraints/fewest_moves.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns the unknowns of one shape; without its radii and axes if only its nodes are to move.
std::vector<bool> unknownsOfShape(const DocumentSketch &sketch, std::uint32_t shape, bool onlyNodes) {
    std::vector<bool> of(sketch.system.values.size(), false);
    for (const auto &[unknown, index] : sketch.unknowns()) {
        of[index] = unknown.shape == shape && (!onlyNodes || unknown.role <= ShapeUnknown::Role::Y);
    }
    return of;
}

double squaredWay(const SketchSystem &system, const std::vector<double> &values) {
    double sum = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double by = values[k] - system.values[k];
        sum += system.kinds[k] == UnknownKind::Parameter ? 0.0 : by * by;
    }
    return sum;
}

std::optional<SketchSolution> solveMoving(const DocumentSketch &sketch, const SketchSystem &system, std::uint32_t shape,
                                          bool onlyNodes) {
    const std::vector<bool> free = unknownsOfShape(sketch, shape, onlyNodes);
    SketchSystem alone = system;
    for (const auto &[unknown, index] : sketch.unknowns()) {
        alone.held[index] = alone.held[index] || !free[index]; // points that equations define follow
    }
    std::optional<SketchSolution> solution = solveSketch(alone, SolveEffort::Plain);
    return solution && solution->flips == 0 ? std::move(solution) : std::nullopt;
}

} // namespace

std::optional<SketchSolution> solveMovingOne(const DocumentSketch &sketch, const SketchSystem &system,
                                             const std::set<std::uint32_t> &shapes) {
    if (shapes.size() < 2) {
        return std::nullopt;
    }
    for (const bool onlyNodes : {true, false}) {
        std::optional<SketchSolution> best;
        double least = 0.0;
        for (const std::uint32_t shape : shapes) {
            std::optional<SketchSolution> solution = solveMoving(sketch, system, shape, onlyNodes);
            const double way = solution ? squaredWay(system, solution->values) : 0.0;
            constexpr double kRounding = 1e-9;
            if (solution && (!best || way <= least * (1.0 + kRounding))) {
                best = std::move(solution);
                least = way;
            }
        }
        if (best) {
            return best;
        }
    }
    return std::nullopt;
}

} // namespace forefront
