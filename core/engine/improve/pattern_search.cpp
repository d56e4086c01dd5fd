#include "core/engine/improve/pattern_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {

namespace {

// The order of the directions decides between places that are equally good.
constexpr double kDiagonal = 0.7071067811865476;
constexpr std::array<double, 8> kDirectionX = {1, 0, -1, 0, kDiagonal, -kDiagonal, -kDiagonal, kDiagonal};
constexpr std::array<double, 8> kDirectionY = {0, 1, 0, -1, kDiagonal, kDiagonal, -kDiagonal, -kDiagonal};
constexpr double kFirstStep = 0.16; ///< in units of the distance of the farthest node
constexpr double kEnough = 1.02;    ///< The search ends slightly beyond the goal.
constexpr double kUnbounded = 1e300;

/// Returns the maximum. By halves, which take half as many instructions as a walk through the numbers.
double highest(std::array<double, 8> numbers) {
    for (std::size_t half = 4; half > 0; half /= 2) {
        for (std::size_t k = 0; k < half; ++k) {
            numbers[k] = numbers[k] > numbers[k + half] ? numbers[k] : numbers[k + half];
        }
    }
    return numbers[0];
}

} // namespace

Vec2 PatternSearch::bestMove(const ImproveWorkspace &work, NodeId node, const Limits &limits) {
    take(work, node);
    best_ = {};
    bestMeasure_ = measureHere();
    if (bestMeasure_ >= 1.0) {
        return best_;
    }
    double step = kFirstStep;
    for (int tries = 0; tries < limits.patterns && step > limits.minStep && bestMeasure_ < kEnough; ++tries) {
        if (!tryPattern(step * reach_)) {
            step *= 0.5;
        }
    }
    return best_;
}

/// Copies the surroundings of a free node.
void PatternSearch::take(const ImproveWorkspace &work, NodeId node) {
    const Vec2 centre = work.at(node);
    count_ = first_ = 0;
    double farthest = 0.0;
    work.aroundFree(node, [&](HalfEdge h) {
        nodes_[count_] = work.at(work.to(h)) - centre;
        farthest = std::max(farthest, lengthSquared(nodes_[count_]));
        elements_[count_++] = static_cast<std::uint32_t>(elementOf(h));
    });
    nodes_[count_] = nodes_[0];
    for (std::size_t i = 0; i < count_; ++i) {
        sides_[i] = distanceSquared(nodes_[i], nodes_[i + 1]);
    }
    reach_ = std::sqrt(farthest);
}

double PatternSearch::measureHere() const {
    double minimum = kUnbounded;
    for (std::size_t i = 0; i < count_; ++i) {
        minimum = std::min(minimum, measure_.of(nodes_[i], nodes_[i + 1], sides_[i]));
    }
    return minimum;
}

/// Tries the places at a distance from the best one. Returns true if one of them is better.
bool PatternSearch::tryPattern(double step) {
    Lanes x, y, worst;
    for (std::size_t k = 0; k < kDirections; ++k) {
        x[k] = best_.x + step * kDirectionX[k];
        y[k] = best_.y + step * kDirectionY[k];
        worst[k] = kUnbounded;
    }
    const bool allPositive = bestMeasure_ > 0.0; // the measures that count, and so all sides opposite the node
    double top = bestMeasure_;
    for (std::size_t n = 0, i = first_; n < count_; ++n, i = i + 1 < count_ ? i + 1 : 0) {
        const Vec2 a = nodes_[i], b = nodes_[i + 1];
        const double side = sides_[i];
        if (allPositive) {
            for (std::size_t k = 0; k < kDirections; ++k) {
                const double measure = measure_.ifPositive({a.x - x[k], a.y - y[k]}, {b.x - x[k], b.y - y[k]}, side);
                worst[k] = measure < worst[k] ? measure : worst[k];
            }
        } else {
            for (std::size_t k = 0; k < kDirections; ++k) {
                worst[k] = std::min(worst[k], measure_.of(a - Vec2{x[k], y[k]}, b - Vec2{x[k], y[k]}, side));
            }
        }
        top = highest(worst);
        if (top <= bestMeasure_) {
            first_ = i;
            return false;
        }
    }
    const auto k = static_cast<std::size_t>(std::find(worst.begin(), worst.end(), top) - worst.begin());
    bestMeasure_ = top;
    best_ = {x[k], y[k]};
    return true;
}

} // namespace forefront
