#pragma once

#include "core/drawing/sketch/equation.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace forefront {

/// A corner that should keep its turn: from a to b to c.
struct SketchCorner {
    SketchPoint a, b, c;
};

/// The unknowns of a sketch with their equations: what the solver knows of a drawing.
struct SketchSystem {
    std::vector<double> values;     ///< of the unknowns, in units of the drawing
    std::vector<UnknownKind> kinds; ///< of the unknowns
    std::vector<bool> held;         ///< unknowns that must not change, such as those of locked shapes
    std::vector<SketchEquation> equations;
    std::vector<SketchCorner> corners;                          ///< whose flip makes a solution worse
    std::vector<std::pair<SketchPoint, SketchPoint>> edges;     ///< that must not vanish
    std::vector<std::pair<SketchPoint, std::uint32_t>> circles; ///< centres with radii, which must stay above 0
    /// Id from which on constraints are joints, which the drawing implies. They hold like others and can be part of a
    /// conflict, but never make another constraint redundant, nor are redundant themselves.
    std::uint32_t firstJoint = static_cast<std::uint32_t>(-1);

    bool isJoint(std::uint32_t constraint) const { return constraint >= firstJoint; }

    std::uint32_t addUnknown(double value, UnknownKind kind);
    SketchPoint addPoint(Vec2 at);
    SketchPoint addOffset(Vec2 offset);
    /// Appends an equation of a constraint; 0 for the form of a shape.
    void addEquation(SketchEquation equation, std::uint32_t constraint);
    Vec2 place(SketchPoint point) const { return {values[point.x], values[point.y]}; }
    /// Returns the residual of an equation at the values, in units of the drawing.
    double residual(const SketchEquation &equation) const;
};

/// Returns the independent parts: indices of the equations that share free unknowns, directly or through others. Parts
/// and their equations are in the order of the equations. Equations without a free unknown are parts of their own.
std::vector<std::vector<std::uint32_t>> independentParts(const SketchSystem &system);

/// Returns the sine of the turn at a corner; 0 where an edge has no length.
double turnAt(Vec2 a, Vec2 b, Vec2 c);

} // namespace forefront
