#include "core/drawing/sketch/solve_sketch.hpp"

#include "core/drawing/sketch/part_solver.hpp"
#include "core/drawing/sketch/scatter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace forefront {
namespace {

constexpr double kClearTurn = 0.02; // sine of a turn that the eye sees

/// Counts what a solution of a part spoils: corners that flip, edges and radii that shrink below 1 %.
class Spoiled {
  public:
    /// `whole`: counts only corners and edges all of whose points belong to the part.
    Spoiled(const SketchSystem &system, const ScaledPart &part, bool whole) : system_(system) {
        const auto moves = [&part](SketchPoint p) { return part.indexOf(p.x) >= 0 || part.indexOf(p.y) >= 0; };
        const auto counts = [&](std::initializer_list<SketchPoint> points) {
            return whole ? std::all_of(points.begin(), points.end(), moves)
                         : std::any_of(points.begin(), points.end(), moves);
        };
        for (const SketchCorner &corner : system.corners) {
            if (counts({corner.a, corner.b, corner.c}) && std::fabs(turn(system.values, corner)) >= kClearTurn) {
                corners_.push_back(corner);
            }
        }
        for (const auto &edge : system.edges) {
            if (counts({edge.first, edge.second})) {
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

// Weights keep short edges from turning, but let long ones move so far that others turn over. So the last ways, for
// what has no other solution, have none.
constexpr int kWeightedWays = 12, kWays = 14;

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
    case kWeightedWays:
        return satisfy(part);
    case kWeightedWays + 1:
        part.guard(system, kClearTurn, kShare);
        return follow(part, 8);
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
          spoiled_(system, start_, false) {}

    /// Returns the best solution, in the values of the sketch; none if there is none near by.
    std::optional<SketchSolution> run(SolveEffort effort) {
        const int ways = effort == SolveEffort::Plain ? 1 : kWays;
        for (int way = 0; way < ways && !(best_ && best_->flips == 0); ++way) {
            if (way >= kWeightedWays && best_) {
                break;
            }
            ScaledPart part = start_;
            if (solveBy(system_, part, way)) {
                std::vector<double> values = system_.values;
                part.write(values);
                offer(std::move(values), way >= kWeightedWays);
            }
        }
        return std::move(best_);
    }

    /// Returns true if there is a solution without flips near the values of the sketch or near others.
    bool hasCleanSolution(const std::vector<double> &others) const {
        struct Start {
            bool other;
            double spread; ///< in sizes of the part
        };
        // Where the rest of a figure does not follow, its corners say nothing.
        const Spoiled spoiled(system_, start_, true);
        for (const auto [other, spread] :
             {Start{true, 0.0}, Start{false, 0.0}, Start{true, 0.05}, Start{true, 0.15}, Start{false, 0.15}}) {
            ScaledPart part = start_;
            for (std::size_t k = 0; other && k < part.unknowns().size(); ++k) {
                const std::uint32_t unknown = part.unknowns()[k];
                part.x[static_cast<int>(k)] = part.scaled(others[unknown], system_.kinds[unknown]);
            }
            constexpr std::uint64_t kSeed = 5;
            scatter(part.x, kSeed, spread);
            if (satisfy(part)) {
                std::vector<double> values = system_.values;
                part.write(values);
                if (spoiled.count(values) == 0) {
                    return true;
                }
            }
        }
        return false;
    }

  private:
    void offer(std::vector<double> values, bool onlyWithoutFlips) {
        SketchSolution found{std::move(values), 0};
        found.flips = spoiled_.count(found.values);
        if (onlyWithoutFlips && found.flips > 0) {
            return;
        }
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

std::vector<double> nearestValues(const SketchSystem &system) {
    std::vector<double> values = system.values;
    for (const std::vector<std::uint32_t> &equations : independentParts(system)) {
        if (!holds(system, equations)) {
            ScaledPart part(system, equations);
            approach(part);
            part.write(values);
        }
    }
    return values;
}

bool hasCleanSolution(const SketchSystem &system, const std::vector<double> &others) {
    const auto parts = independentParts(system);
    return std::all_of(parts.begin(), parts.end(), [&](const std::vector<std::uint32_t> &equations) {
        return holds(system, equations) || PartSearch(system, equations).hasCleanSolution(others);
    });
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

bool solvableFromAfar(const SketchSystem &system, std::span<const std::uint32_t> equations) {
    if (holds(system, equations) || solvable(system, equations)) {
        return true;
    }
    struct Start {
        double scale;
        double spread; ///< in sizes of the part
    };
    // A dimension that has grown much leads to places far away, which a figure of that size comes near to. Scattered
    // starts find solutions with other turns.
    static constexpr std::array kStarts{Start{2.0, 0.0}, Start{4.0, 0.0}, Start{0.5, 0.0},  Start{8.0, 0.0},
                                        Start{0.2, 0.0}, Start{1.0, 1.0}, Start{4.0, 0.4},  Start{1.0, 3.0},
                                        Start{2.0, 4.0}, Start{8.0, 1.0}, Start{16.0, 0.0}, Start{4.0, 8.0}};
    const ScaledPart start(system, equations);
    std::uint64_t seed = 1;
    return std::any_of(kStarts.begin(), kStarts.end(), [&](const Start &from) {
        ScaledPart part = start;
        part.x *= from.scale;
        scatter(part.x, seed++, from.spread);
        return satisfy(part);
    });
}

} // namespace forefront
