#pragma once

#include "core/drawing/sketch/linear_algebra.hpp"
#include "core/drawing/sketch/sketch_system.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Some equations of a sketch with their free unknowns, in units of their own size about their own centre: solving is
/// then the same in micrometres and in coordinates of a map. Held unknowns are constants.
class ScaledPart {
  public:
    ScaledPart(const SketchSystem &system, std::span<const std::uint32_t> equations);

    SketchVector x; ///< the free unknowns

    /// Returns the free unknowns, as indices of the sketch, in order.
    const std::vector<std::uint32_t> &unknowns() const { return unknowns_; }
    const std::vector<SketchEquation> &equations() const { return equations_; } ///< one a row
    /// Returns the size of the part, by which lengths are divided.
    double size() const { return size_; }
    /// Returns the index in x of an unknown of the sketch; -1 if it is held or in no equation.
    int indexOf(std::uint32_t unknown) const;
    /// Converts a value of an unknown of the sketch to units of the part.
    double scaled(double value, UnknownKind kind) const;
    /// Copies x to the values of a sketch.
    void write(std::vector<double> &values) const;
    /// Returns the residuals at a place.
    SketchVector residuals(const SketchVector &place) const;
    /// Returns the derivatives of the residuals at a place.
    SketchRows slopes(const SketchVector &place) const;

    /// Returns true if x gives every line of an equation a direction and every radius a length. Lines that shrink to
    /// nothing would fit any angle.
    bool sound() const;

    /// Limits steps from x, so that a solver keeps to the solution that the user sees: corners whose sine of the turn
    /// is above `least` must keep their side, and an unknown moves at most by `share` of the shortest edge or radius
    /// that it belongs to.
    void guard(const SketchSystem &system, double least, double share);
    /// Returns weights of changes: the inverse square of the shortest edge or radius that an unknown belongs to, in
    /// sizes of the part. Short edges then turn no more than long ones.
    SketchVector localWeights(const SketchSystem &system) const;
    /// Returns true if all guarded corners keep their side at a place.
    bool keepsCorners(const SketchVector &place) const;
    /// Returns the share of a step, at most 1, that the guards allow.
    double allowedShare(const SketchVector &step) const;
    bool guarded() const { return room_.size() > 0; }

  private:
    struct Guard {
        std::array<int, 6> place{}; ///< of the coordinates of the corner: indices of x, or -1 - index of a constant
        double side = 1.0;
    };

    SketchVector roomOf(const SketchSystem &system, double share, double most, double least) const;
    void collectUnknowns(const SketchSystem &system);
    void setScale(const SketchSystem &system);
    double turn(const Guard &guard, const SketchVector &place) const;
    bool place(const SketchCorner &corner, Guard &guard) const;

    std::vector<SketchEquation> equations_; ///< their unknowns are slots: indices of x, then of constants_
    std::vector<std::uint32_t> unknowns_, constantUnknowns_;
    std::vector<UnknownKind> kinds_;
    std::vector<double> constants_;
    std::vector<Guard> guards_;
    SketchVector room_;
    double size_ = 1.0;
    Vec2 centre_;
};

} // namespace forefront
