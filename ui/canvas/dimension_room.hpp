#pragma once

#include "ui/canvas/camera.hpp"
#include "ui/input/pixels.hpp"

#include <vector>

namespace forefront {

/// The lines of the dimensions in a picture, in pixels, so that further ones find a place beside them.
class DimensionRoom {
  public:
    /// `gap`: least distance between two parallel dimension lines.
    explicit DimensionRoom(double gap) : gap_(gap) {}

    /// Takes a dimension line, which others keep away from.
    void takeLine(Pixel a, Pixel b) { lines_.push_back({a, b}); }
    /// Takes an extension line or leader, which only texts keep away from.
    void takeSide(Pixel a, Pixel b) { sides_.push_back({a, b}); }
    /// Returns true if a dimension line runs along no other one.
    bool isLineFree(Pixel a, Pixel b) const;
    /// Returns true if a text lies on none of the lines.
    bool isTextFree(const PixelRect &rect) const;

  private:
    struct Line {
        Pixel a, b;
    };
    bool runsAlong(const Line &line, Pixel a, Pixel b) const;

    double gap_;
    std::vector<Line> lines_, sides_;
};

} // namespace forefront
