#pragma once

#include "ui/canvas/camera.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// Returns true if a part of the line from a to b lies in a rectangle.
bool meets(const PixelRect &rect, Pixel a, Pixel b);

/// The parts of a canvas that labels must keep clear of, in pixels.
class LabelSpace {
  public:
    /// Keeps labels inside `room`. Lines are stored in cells of `cell` pixels, so a label keeps up to that distance.
    void open(const PixelRect &room, double cell);
    void take(const PixelRect &rect) { taken_.push_back(rect); }
    void takeLine(Pixel a, Pixel b);
    /// Returns true if a label may lie there; without `lines`, it may cover lines.
    bool isFree(const PixelRect &rect, bool lines) const;
    /// Moves a rectangle into the room by as little as possible.
    PixelRect inside(PixelRect rect) const;
    bool holds(Pixel p) const;

  private:
    bool coversLine(const PixelRect &rect) const;

    std::optional<PixelRect> room_; ///< empty: there is no limit, and lines do not count
    double cell_ = 1.0;
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<std::uint8_t> lineCells_; ///< by row; empty: there are no lines
    std::vector<PixelRect> taken_;
};

} // namespace forefront
