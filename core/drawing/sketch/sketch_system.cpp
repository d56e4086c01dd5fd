#include "core/drawing/sketch/sketch_system.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace forefront {
namespace {

/// Disjoint sets of unknowns; the smallest of each is its root.
class UnknownSets {
  public:
    explicit UnknownSets(std::size_t count) : up_(count) { std::iota(up_.begin(), up_.end(), 0U); }

    std::uint32_t root(std::uint32_t k) {
        while (up_[k] != k) {
            k = up_[k] = up_[up_[k]];
        }
        return k;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        up_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> up_;
};

} // namespace

std::uint32_t SketchSystem::addUnknown(double value, UnknownKind kind) {
    values.push_back(value);
    kinds.push_back(kind);
    held.push_back(false);
    return static_cast<std::uint32_t>(values.size() - 1);
}

SketchPoint SketchSystem::addPoint(Vec2 at) {
    const std::uint32_t x = addUnknown(at.x, UnknownKind::X);
    return {x, addUnknown(at.y, UnknownKind::Y)};
}

SketchPoint SketchSystem::addOffset(Vec2 offset) {
    const std::uint32_t x = addUnknown(offset.x, UnknownKind::Offset);
    return {x, addUnknown(offset.y, UnknownKind::Offset)};
}

void SketchSystem::addEquation(SketchEquation equation, std::uint32_t constraint) {
    equation.constraint = constraint;
    equations.push_back(equation);
}

double SketchSystem::residual(const SketchEquation &equation) const {
    std::array<double, kEquationUnknowns> local{};
    std::size_t k = 0;
    for (const std::uint32_t unknown : equation.used()) {
        local[k++] = values[unknown];
    }
    return residualOf(equation, local.data(), nullptr);
}

std::vector<std::vector<std::uint32_t>> independentParts(const SketchSystem &system) {
    UnknownSets sets(system.values.size());
    constexpr auto kNone = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> first(system.equations.size(), kNone); // free unknown of each equation
    for (std::size_t k = 0; k < system.equations.size(); ++k) {
        for (const std::uint32_t unknown : system.equations[k].used()) {
            if (!system.held[unknown]) {
                first[k] = first[k] == kNone ? unknown : first[k];
                sets.join(first[k], unknown);
            }
        }
    }
    std::vector<std::vector<std::uint32_t>> parts;
    std::vector<std::uint32_t> partOf(system.values.size(), kNone);
    for (std::uint32_t k = 0; k < system.equations.size(); ++k) {
        if (first[k] == kNone) {
            parts.push_back({k});
            continue;
        }
        std::uint32_t &part = partOf[sets.root(first[k])];
        if (part == kNone) {
            part = static_cast<std::uint32_t>(parts.size());
            parts.emplace_back();
        }
        parts[part].push_back(k);
    }
    return parts;
}

double turnAt(Vec2 a, Vec2 b, Vec2 c) {
    const double scale = std::sqrt(lengthSquared(a - b) * lengthSquared(c - b));
    return scale > 0.0 ? cross(a - b, c - b) / scale : 0.0;
}

} // namespace forefront
