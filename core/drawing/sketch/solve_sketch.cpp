#include "core/drawing/sketch/solve_sketch.hpp"

#include "core/drawing/sketch/part_solver.hpp"
#include "core/drawing/sketch/scatter.hpp"

#include <cmath>

namespace forefront {
namespace {

constexpr double kClearTurn = 0.02; // sine of a turn that the eye sees

/// Counts what a solution of a part spoils: corners that flip, edges and radii that shrink below 1 %.
class Spoiled {
  public:
    Spoiled(const SketchSystem &system, const ScaledPart &part) : system_(system) {
        const auto moves = [&part](SketchPoint p) { return part.indexOf(p.x) >= 0 || part.indexOf(p.y) >= 0; };
        for (const SketchCorner &corner : system.corners) {
            if ((moves(corner.a) || moves(corner.b) || moves(corner.c)) &&
                std::fabs(turn(system.values, corner)) >= kClearTurn) {
                corners_.push_back(corner);
            }
        }
        for (const auto &edge : system.edges) {
            if (moves(edge.first) || moves(edge.second)) {
                edges_.push_back(edge);
            }
        }
        for (const auto &[centre, radius] : system.circles) {
            if (part.indexOf(radius) >= 0) {
                radii_.push_back(radius);
            }
        }
    }

    std::size_t count(const std::vector<double> &values) const {
        constexpr double kVanished = 0.01; // of the length before
        std::size_t count = 0;
        for (const SketchCorner &corner : corners_) {
            count += turn(values, corner) * turn(system_.values, corner) <= 0.0 ? 1 : 0;
        }
        for (const auto &[a, b] : edges_) {
            count += lengthOf(values, a, b) <= kVanished * lengthOf(system_.values, a, b) &&
                             lengthOf(system_.values, a, b) > 0.0
                         ? 1
                         : 0;
        }
        for (const std::uint32_t radius : radii_) {
            count += values[radius] <= kVanished * system_.values[radius] ? 1 : 0;
        }
        return count;
    }

  private:
    static Vec2 at(const std::vector<double> &values, SketchPoint p) { return {values[p.x], values[p.y]}; }
    static double turn(const std::vector<double> &values, const SketchCorner &c) {
        return turnAt(at(values, c.a), at(values, c.b), at(values, c.c));
    }
    static double lengthOf(const std::vector<double> &values, SketchPoint a, SketchPoint b) {
        return distance(at(values, a), at(values, b));
    }

    const SketchSystem &system_;
    std::vector<SketchCorner> corners_;
    std::vector<std::pair<SketchPoint, SketchPoint>> edges_;
    std::vector<std::uint32_t> radii_;
};

/// Solves a part in one of several ways.
bool solveBy(const SketchSystem &system, ScaledPart &part, int way) {
    const SketchVector weights = part.localWeights(system);
    constexpr double kShare = 0.5, kFirm = 0.1;
    switch (way) {
    case 0:
        return satisfy(part, {.weights = &weights});
    case 1:
    case 2:
        part.guard(system, way == 1 ? kFirm : kClearTurn, kShare);
        return satisfy(part, {.weights = &weights});
    case 3:
    case 4:
        part.guard(system, kClearTurn, kShare);
        return follow(part, way == 3 ? 8 : 32, &weights);
    case 5:
        return project(part, SketchVector(part.x), weights);
    case 6:
    case 7:
        return follow(part, way == 6 ? 8 : 32, &weights);
    default: {
        constexpr double kScatter = 0.02;
        scatter(part.x, static_cast<std::uint64_t>(way), kScatter * (way - 7));
        return satisfy(part, {.weights = &weights});
    }
    }
}

/// Looks for the solution of one part that spoils least.
class PartSearch {
  public:
    PartSearch(const SketchSystem &system, std::span<const std::uint32_t> equations)
        : system_(system), equations_(equations.begin(), equations.end()), start_(system, equations),
          spoiled_(system, start_) {}

    /// Returns the best solution, in the values of the sketch; none if there is none near by.
    std::optional<SketchSolution> run(SolveEffort effort) {
        const int ways = effort == SolveEffort::Plain ? 1 : 12;
        for (int way = 0; way < ways && !(best_ && best_->flips == 0); ++way) {
            ScaledPart part = start_;
            if (solveBy(system_, part, way)) {
                std::vector<double> values = system_.values;
                part.write(values);
                offer(std::move(values));
            }
        }
        return std::move(best_);
    }

  private:
    void offer(std::vector<double> values) {
        SketchSolution found{std::move(values), 0};
        found.flips = spoiled_.count(found.values);
        if (!best_ || found.flips < best_->flips) {
            best_ = std::move(found);
        }
    }

    const SketchSystem &system_;
    std::vector<std::uint32_t> equations_;
    ScaledPart start_;
    Spoiled spoiled_;
    std::optional<SketchSolution> best_;
};

} // namespace

bool holds(const SketchSystem &system, std::span<const std::uint32_t> equations) {
    const ScaledPart part(system, equations);
    double farthest = 0.0;
    for (const std::uint32_t k : equations) {
        for (const std::uint32_t unknown : system.equations[k].used()) {
            farthest = std::max(farthest, std::fabs(system.values[unknown]));
        }
    }
    constexpr double kRounding = 1e-15; // of coordinates, which may be far from the origin
    const double limit = kSketchHolds + kRounding * farthest / part.size();
    const SketchVector residuals = part.residuals(part.x);
    return residuals.size() == 0 || residuals.lpNorm<forefront_eigen::Infinity>() <= limit;
}

std::optional<SketchSolution> solveSketch(const SketchSystem &system, SolveEffort effort) {
    SketchSolution solution{system.values, 0};
    for (const std::vector<std::uint32_t> &part : independentParts(system)) {
        if (holds(system, part)) {
            continue;
        }
        const std::optional<SketchSolution> found = PartSearch(system, part).run(effort);
        if (!found) {
            return std::nullopt;
        }
        for (const std::uint32_t equation : part) {
            for (const std::uint32_t unknown : system.equations[equation].used()) {
                solution.values[unknown] = found->values[unknown];
            }
        }
        solution.flips += found->flips;
    }
    return solution;
}

bool solvable(const SketchSystem &system, std::span<const std::uint32_t> equations) {
    const ScaledPart start(system, equations);
    // A refusal needs all starts to fail; in a large part each takes long, and is less likely to help.
    constexpr std::size_t kLarge = 150;
    const int starts = equations.size() > kLarge ? 2 : 6;
    double spread = 0.0;
    for (int k = 0; k < starts; ++k) {
        ScaledPart part = start;
        scatter(part.x, static_cast<std::uint64_t>(k), spread);
        if (satisfy(part)) {
            return true;
        }
        spread = k == 0 ? 0.02 : 2.0 * spread; // in sizes of the part
    }
    return false;
}

} // namespace forefront
