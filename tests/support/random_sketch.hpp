#pragma once

#include "core/drawing/sketch/sketch_system.hpp"

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace forefront::tests {

/// Random numbers that are the same with every standard library.
class SketchDice {
  public:
    explicit SketchDice(std::uint64_t seed) : engine_(seed) {}
    /// Returns a number in [a, b).
    double number(double a = 0.0, double b = 1.0);
    /// Returns a whole number in [0, n).
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
    template <class T>
    void shuffle(std::vector<T> &list) {
        for (std::size_t k = list.size(); k > 1; --k) {
            std::swap(list[k - 1], list[below(k)]);
        }
    }

  private:
    std::mt19937_64 engine_;
};

/// A drawing whose coordinates satisfy its equations.
struct RandomSketch {
    SketchSystem system;
    std::vector<SketchPoint> points; ///< without the centres of rounded corners
    std::uint32_t constraints = 0;   ///< number of constraints, with ids from 1

    void add(std::vector<SketchEquation> equations);
};

/// Returns a stepped profile, a star, a plate with holes or a truss with some rounded corners, without constraints.
RandomSketch randomShapes(SketchDice &dice);

/// A constraint that holds.
struct SketchCandidate {
    std::vector<SketchEquation> equations;
    bool dimension = false;
};
/// Returns constraints that hold, in random order, geometric ones first.
std::vector<SketchCandidate> candidatesOf(const RandomSketch &sketch, SketchDice &dice);

/// Rows that a matrix may get while they are independent.
class IndependentRows {
  public:
    explicit IndependentRows(std::size_t columns) : columns_(columns) {}
    /// Adds the rows of equations if each is independent of those before by `least`, of a length of 1.
    bool add(const SketchSystem &system, const std::vector<SketchEquation> &equations, double least);
    std::size_t size() const { return rows_.size(); }

  private:
    std::size_t columns_;
    std::vector<std::vector<double>> rows_; ///< orthonormal
};

/// Adds independent constraints that hold until they take a share of the degrees of freedom; place and direction are
/// fixed if the share is 1.
void constrain(RandomSketch &sketch, SketchDice &dice, double share);

/// Returns the values, each moved by up to a share of the shortest edge or radius that it belongs to.
std::vector<double> perturbed(const SketchSystem &system, SketchDice &dice, double share);

/// Counts corners with a clear turn that have the same side in the known and the start values, and another at the end.
std::size_t flips(const SketchSystem &system, const std::vector<double> &known, const std::vector<double> &start,
                  const std::vector<double> &end);

/// Returns a profile of steps with rounded corners and holes: one connected part of about `constraints` constraints.
/// The height of the risers and the radius are free.
RandomSketch steppedProfile(std::size_t constraints);

} // namespace forefront::tests
